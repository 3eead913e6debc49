// budget: one scanner for every kind of line, alone or in pieces of the text
#include "hgp/io/polygon/obj_text.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/ids.h"
#include "hgp/base/parallel.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/not_finite.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

constexpr std::size_t kMaxLine = std::size_t{1} << 20;
/// A thread scans this many bytes or more.
constexpr std::size_t kLeastPiece = std::size_t{1} << 19;

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

bool takeIndexText(const char*& p, const char* end, std::string_view& out) {
  const char* begin = p;
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* digits = p;
  while (p != end && text::isDigit(*p)) ++p;
  out = std::string_view(begin, static_cast<std::size_t>(p - begin));
  return p != digits;
}

class ObjScanner {
 public:
  ObjScanner(std::string_view text, std::uint64_t maxTriangles)
      : text_(text), maxTriangles_(maxTriangles), eol_(text::lineEndOf(text)) {}

  Result<ObjText> scan() {
    if (const std::size_t nul = text_.find('\0'); nul != std::string_view::npos) {
      return text::malformedByte(nul, "a NUL byte: this is not an OBJ text");
    }
    const std::size_t begin = text_.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
    if (!scanPieces(begin) && !scanLines(begin, text_.size())) return std::move(failure_);
    if (!checkRanges()) return std::move(failure_);
    if (const auto used = firstUsed(notFinite_, out_.polygons))
      return notFiniteFailure(text::lineAt(text_, static_cast<std::size_t>(used->where)),
                              used->vertex);
    if (out_.polygons.positions.empty() || out_.polygons.polygonCount() == 0) {
      return Failure{
          ErrorCode::kMalformed, "read", "not an OBJ mesh: there are no v and f lines", {}};
    }
    if (!hasUv_) out_.cornerUv.clear();
    addNotes();
    return std::move(out_);
  }

 private:
  bool scanLines(std::size_t begin, std::size_t end) {
    position_ = begin;
    reserve(end - begin);
    while (position_ < end)
      if (!takeLine()) return false;
    return true;
  }

  /// The end of the line that is at `position`, if no other one continues it; otherwise of a later one.
  std::size_t endOfLine(std::size_t position) const {
    while (position < text_.size()) {
      const char* end = lineEnd(text_.data() + position);
      position = nextLine(end);
      if (end[-1] == '\r') --end;
      if (end == text_.data() || end[-1] != '\\') break;
    }
    return position;
  }

  /// Scans pieces of the text in several threads, as if each were a text of its own. False, with nothing changed, where the
  /// text is short, or where a piece is wrong or refers to others by relative indices: then all must be read in order.
  bool scanPieces(std::size_t begin) {
    const std::size_t most = text_.size() / kLeastPiece;
    const int count = static_cast<int>(std::min<std::size_t>(most, at(threadCount())));
    if (count < 2) return false;
    std::vector<std::size_t> start{begin};
    for (int i = 1; i < count; ++i)
      start.push_back(std::max(start.back(), endOfLine(text_.size() / at(count) * at(i))));
    start.push_back(text_.size());
    std::vector<std::optional<ObjScanner>> pieces(at(count));
    parallelFor(count, 1, [&](int i) {
      ObjScanner piece(text_, maxTriangles_);
      if (piece.scanLines(start[at(i)], start[at(i) + 1]) && !piece.isRelative_)
        pieces[at(i)].emplace(std::move(piece));
    });
    std::uint64_t triangles = 0;
    for (const auto& piece : pieces) {
      if (!piece) return false;
      triangles += piece->triangles_;
    }
    if (triangles > maxTriangles_) return false;
    reserve(text_.size());
    for (auto& piece : pieces) {
      take(*piece);
      piece.reset();
    }
    return true;
  }

  /// Appends what another scanner found after this one's text.
  void take(const ObjScanner& next) {
    ObjText& out = out_;
    const ObjText& more = next.out_;
    const auto vertices = static_cast<int>(out.polygons.positions.size());
    for (const NotFiniteVertex& v : next.notFinite_)
      notFinite_.push_back({v.vertex + vertices, v.where});
    const auto corners = static_cast<std::uint32_t>(out.polygons.cornerVertex.size());
    for (std::size_t p = 1; p < more.polygons.start.size(); ++p)
      out.polygons.start.push_back(corners + more.polygons.start[p]);
    append(out.polygons.positions, more.polygons.positions);
    append(out.polygons.cornerVertex, more.polygons.cornerVertex);
    append(out.uv, more.uv);
    append(out.cornerUv, more.cornerUv);
    append(out.faceLines, more.faceLines);
    for (const TextSpan& run : more.uvLines) addUvLines(run);
    append(out.elementLines, more.elementLines);
    append(out.coneLines, more.coneLines);
    if (more.embedded.end > 0) out.embedded = more.embedded;
    hasUv_ = hasUv_ || next.hasUv_;
    hasCommands_ = hasCommands_ || next.hasCommands_;
    skippedFaces_ += next.skippedFaces_;
    missingUv_ += next.missingUv_;
    triangles_ += next.triangles_;
  }

  void addUvLines(const TextSpan& span) {
    if (!out_.uvLines.empty() && out_.uvLines.back().end == span.begin)
      out_.uvLines.back().end = span.end;
    else
      out_.uvLines.push_back(span);
  }

  void reserve(std::size_t bytes) {
    // Lines have about 30 bytes, and there are about half as many vertices as faces. A wrong estimate only costs
    // a reallocation.
    const std::size_t lines = bytes / 40;
    out_.polygons.positions.reserve(lines / 3);
    out_.polygons.cornerVertex.reserve(2 * lines);
    out_.polygons.start.reserve(2 * lines / 3);
    out_.faceLines.reserve(2 * lines / 3);
  }

  bool fail(const std::string& message) {
    failure_ = text::malformedLine(text::lineAt(text_, lineBegin_), message);
    return false;
  }

  /// Reads one logical line: a backslash at its end joins the next line, except in comments.
  bool takeLine() {
    lineBegin_ = position_;
    const char* begin = text_.data() + position_;
    const char* end = lineEnd(begin);
    if (!isContinued(begin, end)) {
      position_ = nextLine(end);
      return takeStatement(begin, end, begin);
    }
    const char* first = begin;
    while (isContinued(begin, end) && nextLine(end) < text_.size()) {
      begin = text_.data() + nextLine(end);
      end = lineEnd(begin);
    }
    position_ = nextLine(end);
    joined_.assign(first, end);  // line ends become blanks, so that offsets do not change
    for (char& c : joined_) {
      if (c == eol_ || c == '\\') c = ' ';
    }
    return takeStatement(joined_.data(), joined_.data() + joined_.size(), first);
  }

  const char* lineEnd(const char* p) const {
    const char* stop = text_.data() + text_.size();
    const void* found = std::memchr(p, eol_, static_cast<std::size_t>(stop - p));
    return found ? static_cast<const char*>(found) : stop;
  }
  std::size_t nextLine(const char* end) const {
    const std::size_t offset = static_cast<std::size_t>(end - text_.data());
    return offset < text_.size() ? offset + 1 : offset;
  }
  static bool isContinued(const char* begin, const char* end) {
    if (end != begin && end[-1] == '\r') --end;
    if (end == begin || end[-1] != '\\') return false;
    return std::memchr(begin, '#', static_cast<std::size_t>(end - begin)) == nullptr;
  }

  bool takeStatement(const char* p, const char* end, const char* original) {
    text::skipBlanks(p, end);
    if (p == end) return true;
    if (*p == '#') return takeComment(p, end, original);
    const char* word = p;
    while (p != end && !text::isBlank(*p)) ++p;
    const std::size_t length = static_cast<std::size_t>(p - word);
    // Lines with names (o, g, usemtl …) may be of any length: they are not read.
    const bool isRead = length <= 2 && *word != 'o' && *word != 'g';
    if (isRead && static_cast<std::size_t>(end - p) > kMaxLine) {
      return fail("the line is longer than 1 MiB");
    }
    const TextSpan span{lineBegin_, position_};
    if (length == 1 && *word == 'v') return takeVertex(p, end);
    if (length == 2 && word[0] == 'v' && word[1] == 't') return takeUv(p, end, span);
    if ((length == 1 && *word == 'f') || (length == 2 && word[0] == 'f' && word[1] == 'o')) {
      return takeFace(p, end, span);
    }
    if (length == 1 && *word == 'l' && std::memchr(p, '/', static_cast<std::size_t>(end - p))) {
      out_.elementLines.push_back(span);
    } else if ((length == 1 && *word == 'c') || (length == 2 && word[0] == 's' && word[1] == 'm')) {
      out_.coneLines.push_back(span);
    } else if ((length == 4 && std::memcmp(word, "call", 4) == 0) ||
               (length == 3 && std::memcmp(word, "csh", 3) == 0)) {
      hasCommands_ = true;
    }
    return true;
  }

  bool takeComment(const char* p, const char* end, const char* original) {
    const std::string_view rest(p, static_cast<std::size_t>(end - p));
    if (rest.substr(0, kEmbeddedConesMark.size()) == kEmbeddedConesMark &&
        original == text_.data() + lineBegin_) {
      out_.embedded = {lineBegin_, position_};
    }
    return true;
  }

  bool takeVertex(const char* p, const char* end) {
    Vec3 v;
    for (double& x : v) {
      text::skipBlanks(p, end);
      if (!takeNumber(p, end, x)) {
        return fail("a v line needs three decimal numbers, with points and not commas");
      }
    }
    if (!isFinite(v)) {
      notFinite_.push_back({static_cast<int>(out_.polygons.positions.size()),
                            static_cast<std::int64_t>(lineBegin_)});
    }
    out_.polygons.positions.push_back(v);
    return true;
  }

  /// A number must be followed by a blank, so that "1,5" is not read as 1.
  static bool takeNumber(const char*& p, const char* end, double& out) {
    return text::readAnyDouble(p, end, out) && (p == end || text::isBlank(*p) || *p == '#');
  }

  bool takeUv(const char* p, const char* end, const TextSpan& span) {
    Vec2 uv{0, 0};
    text::skipBlanks(p, end);
    constexpr const char* kRule = "a vt line needs decimal numbers, with points and not commas";
    if (!takeNumber(p, end, uv[0])) return fail(kRule);
    text::skipBlanks(p, end);
    if (p != end && *p != '#' && !takeNumber(p, end, uv[1])) return fail(kRule);
    out_.uv.push_back(uv);
    addUvLines(span);
    return true;
  }

  /// One index of a corner, made absolute and 0-based.
  bool takeIndex(const char*& p, const char* end, std::size_t count, int& out) {
    std::int64_t index = 0;
    if (!text::readInt(p, end, index)) return fail("a corner of this f line is not a number");
    if (index == 0) return fail("index 0; OBJ counts from 1");
    if (index < 0) {
      isRelative_ = true;
      const auto relative = static_cast<long long>(index);
      index += static_cast<std::int64_t>(count);
      if (index < 0) {
        return fail(formatText("relative index %lld, but only %zu v lines precede this line",
                               relative, count));
      }
    } else {
      --index;
    }
    if (index > INT32_MAX) {
      return fail(formatText("index %lld is out of range", static_cast<long long>(index) + 1));
    }
    out = static_cast<int>(index);
    return true;
  }

  /// An index of a vt line that does not exist counts as none; checkRanges() checks forward references.
  bool takeUvIndex(const char*& p, const char* end, int& out) {
    std::int64_t index = 0;
    if (!text::readInt(p, end, index)) return fail("a corner of this f line is not a number");
    isRelative_ = isRelative_ || index < 0;
    index += index < 0 ? static_cast<std::int64_t>(out_.uv.size()) : -1;
    const bool isThere = index >= 0 && index <= INT32_MAX;
    out = isThere ? static_cast<int>(index) : -1;
    missingUv_ += !isThere;
    hasUv_ = hasUv_ || isThere;
    return true;
  }

  bool takeFace(const char* p, const char* end, const TextSpan& span) {
    PolygonMesh& polygons = out_.polygons;
    const std::size_t first = polygons.cornerVertex.size();
    for (text::skipBlanks(p, end); p != end && *p != '#'; text::skipBlanks(p, end)) {
      int v = -1, vt = -1;
      std::int64_t vn = 0;
      if (!takeIndex(p, end, polygons.positions.size(), v)) return false;
      if (p != end && *p == '/') {
        ++p;
        if (p != end && *p != '/' && !text::isBlank(*p)) {
          if (!takeUvIndex(p, end, vt)) return false;
        }
        // Indices of vn lines need no check: they are written as they were.
        if (p != end && *p == '/' && ++p != end && !text::isBlank(*p) &&
            !text::readInt(p, end, vn)) {
          return fail("a corner of this f line is not a number");
        }
      }
      if (p != end && !text::isBlank(*p) && *p != '#')
        return fail("a corner of this f line is not v/vt/vn");
      polygons.cornerVertex.push_back(v);
      out_.cornerUv.push_back(vt);
    }
    const std::size_t corners = polygons.cornerVertex.size() - first;
    if (corners < 3) return skipFace(first, span);
    if (corners > static_cast<std::size_t>(kMaxPolygonCorners)) {
      return fail(
          formatText("a face of %zu corners; at most %d are supported: triangulate it first",
                     corners, kMaxPolygonCorners));
    }
    polygons.start.push_back(static_cast<std::uint32_t>(polygons.cornerVertex.size()));
    out_.faceLines.push_back(span);
    triangles_ += corners - 2;
    if (triangles_ <= maxTriangles_) return true;
    failure_ = tooManyTriangles(maxTriangles_);
    return false;
  }

  /// Skips a face with fewer than three corners: its line stays in the file, without references to the vt lines
  /// that are replaced.
  bool skipFace(std::size_t first, const TextSpan& span) {
    out_.polygons.cornerVertex.resize(first);
    out_.cornerUv.resize(first);
    const std::string_view line = text_.substr(span.begin, span.end - span.begin);
    if (line.find('/') != std::string_view::npos) out_.elementLines.push_back(span);
    ++skippedFaces_;
    return true;
  }

  /// Checks positive indices at the end, because they may refer to later lines.
  bool checkRanges() {
    const PolygonMesh& polygons = out_.polygons;
    const int vertices = static_cast<int>(polygons.positions.size());
    const int uvs = static_cast<int>(out_.uv.size());
    for (std::size_t p = 0; p + 1 < polygons.start.size(); ++p) {
      for (std::size_t c = polygons.start[p]; c < polygons.start[p + 1]; ++c) {
        if (out_.cornerUv[c] >= uvs) {  // not an error, since the uv are replaced
          out_.cornerUv[c] = -1;
          ++missingUv_;
        }
        if (polygons.cornerVertex[c] < vertices) continue;
        lineBegin_ = out_.faceLines[p].begin;
        return fail(formatText("vertex %d is out of range (there are %d)",
                               polygons.cornerVertex[c] + 1, vertices));
      }
    }
    return true;
  }

  void addNotes() {
    int large = 0;
    const auto& start = out_.polygons.start;
    for (std::size_t p = 0; p + 1 < start.size(); ++p) large += start[p + 1] - start[p] > 3;
    if (large > 0) {
      out_.notes.push_back(Note("read-polygons", {{"polygons", large}}));
    }
    if (hasCommands_) out_.notes.push_back(Note("read-commands-skipped"));
    if (skippedFaces_ > 0) {
      out_.notes.push_back(Note("read-small-lines-skipped", {{"lines", skippedFaces_}}));
    }
    if (missingUv_ > 0) {
      out_.notes.push_back(Note("read-uv-missing", {{"corners", missingUv_}}));
    }
    if (eol_ == '\r') out_.notes.push_back(Note("read-line-ends"));
  }

  std::string_view text_;
  std::uint64_t maxTriangles_;
  char eol_;
  ObjText out_;
  Failure failure_;
  std::string joined_;
  std::vector<NotFiniteVertex> notFinite_;
  std::size_t position_ = 0;
  std::size_t lineBegin_ = 0;
  std::uint64_t triangles_ = 0;
  bool hasUv_ = false;
  bool hasCommands_ = false;
  bool isRelative_ = false;  ///< an index counts backwards
  int skippedFaces_ = 0, missingUv_ = 0;
};

}  // namespace

Result<ObjText> scanObj(std::string_view text, std::uint64_t maxTriangles) {
  return ObjScanner(text, maxTriangles).scan();
}

bool takeObjCorner(const char*& p, const char* end, ObjCorner& corner) {
  corner = {};
  if (!takeIndexText(p, end, corner.vertex)) return false;
  if (p == end || *p != '/') return true;
  ++p;
  if (p != end && *p != '/') takeIndexText(p, end, corner.uv);
  if (p == end || *p != '/') return true;
  ++p;
  takeIndexText(p, end, corner.normal);
  return true;
}

}  // namespace hgp::io
