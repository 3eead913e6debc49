#include "hgp/io/polygon/obj_scanner.h"

#include <cstring>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/limits.h"

namespace hgp::io {
namespace {

constexpr std::size_t kMaxLine = std::size_t{1} << 20;

/// A number must be followed by a blank, so that "1,5" is not read as 1.
bool takeNumber(const char*& p, const char* end, double& out) {
  return text::readAnyDouble(p, end, out) && (p == end || text::isBlank(*p) || *p == '#');
}

}  // namespace

bool ObjScanner::scanLines(std::size_t begin, std::size_t end) {
  position_ = begin;
  reserve(end - begin);
  while (position_ < end)
    if (!takeLine()) return false;
  return true;
}

void ObjScanner::reserve(std::size_t bytes) {
  // Lines have about 30 bytes, and there are about half as many vertices as faces. A wrong estimate only costs
  // a reallocation.
  const std::size_t lines = bytes / 40;
  out_.polygons.positions.reserve(lines / 3);
  out_.polygons.cornerVertex.reserve(2 * lines);
  out_.polygons.start.reserve(2 * lines / 3);
  out_.faceLines.reserve(2 * lines / 3);
}

bool ObjScanner::fail(const std::string& message) {
  failure_ = text::malformedLine(text::lineAt(text_, lineBegin_), message);
  return false;
}

/// Reads one logical line: a backslash at its end joins the next line, except in comments.
bool ObjScanner::takeLine() {
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

const char* ObjScanner::lineEnd(const char* p) const {
  const char* stop = text_.data() + text_.size();
  const void* found = std::memchr(p, eol_, static_cast<std::size_t>(stop - p));
  return found ? static_cast<const char*>(found) : stop;
}

std::size_t ObjScanner::nextLine(const char* end) const {
  const std::size_t offset = static_cast<std::size_t>(end - text_.data());
  return offset < text_.size() ? offset + 1 : offset;
}

bool ObjScanner::isContinued(const char* begin, const char* end) {
  if (end != begin && end[-1] == '\r') --end;
  if (end == begin || end[-1] != '\\') return false;
  return std::memchr(begin, '#', static_cast<std::size_t>(end - begin)) == nullptr;
}

bool ObjScanner::takeStatement(const char* p, const char* end, const char* original) {
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

bool ObjScanner::takeComment(const char* p, const char* end, const char* original) {
  const std::string_view rest(p, static_cast<std::size_t>(end - p));
  if (rest.substr(0, kEmbeddedConesMark.size()) == kEmbeddedConesMark &&
      original == text_.data() + lineBegin_) {
    out_.embedded = {lineBegin_, position_};
  }
  return true;
}

bool ObjScanner::takeVertex(const char* p, const char* end) {
  Vec3 v;
  for (double& x : v) {
    text::skipBlanks(p, end);
    if (!takeNumber(p, end, x)) {
      return fail("a v line needs three decimal numbers, with points and not commas");
    }
  }
  if (!isFinite(v)) {
    notFinite_.push_back(
        {static_cast<int>(out_.polygons.positions.size()), static_cast<std::int64_t>(lineBegin_)});
  }
  out_.polygons.positions.push_back(v);
  return true;
}

bool ObjScanner::takeUv(const char* p, const char* end, const TextSpan& span) {
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

void ObjScanner::addUvLines(const TextSpan& span) {
  if (!out_.uvLines.empty() && out_.uvLines.back().end == span.begin)
    out_.uvLines.back().end = span.end;
  else
    out_.uvLines.push_back(span);
}

/// One index of a corner, made absolute and 0-based.
bool ObjScanner::takeIndex(const char*& p, const char* end, std::size_t count, int& out) {
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
bool ObjScanner::takeUvIndex(const char*& p, const char* end, int& out) {
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

bool ObjScanner::takeFace(const char* p, const char* end, const TextSpan& span) {
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
      if (p != end && *p == '/' && ++p != end && !text::isBlank(*p) && !text::readInt(p, end, vn)) {
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
    return fail(formatText("a face of %zu corners; at most %d are supported: triangulate it first",
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
bool ObjScanner::skipFace(std::size_t first, const TextSpan& span) {
  out_.polygons.cornerVertex.resize(first);
  out_.cornerUv.resize(first);
  const std::string_view line = text_.substr(span.begin, span.end - span.begin);
  if (line.find('/') != std::string_view::npos) out_.elementLines.push_back(span);
  ++skippedFaces_;
  return true;
}

}  // namespace hgp::io
