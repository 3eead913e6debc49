#include "hgp/io/polygon/obj_scan.h"

#include <algorithm>
#include <optional>
#include <string>

#include "hgp/base/check.h"
#include "hgp/base/ids.h"
#include "hgp/base/parallel.h"
#include "hgp/io/polygon/obj_scanner.h"

namespace hgp::io {
namespace {

/// A thread scans this many bytes or more.
constexpr std::size_t kMinPiece = std::size_t{1} << 19;

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Result<ObjText> ObjScanner::scan() {
  if (const std::string_view mark = text_.substr(0, 2); mark == "\xFF\xFE" || mark == "\xFE\xFF")
    return text::malformedByte(0, "the text is UTF-16; save the file as UTF-8");
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
    const std::size_t vertices = out_.polygons.positions.size();
    return Failure{ErrorCode::kMalformed,
                   "read",
                   vertices == 0
                       ? "not an OBJ mesh: there are no v and f lines"
                       : std::to_string(vertices) +
                             " vertices and no face of three corners; points and lines have no "
                             "surface",
                   {}};
  }
  if (!hasUv_) out_.cornerUv.clear();
  addNotes();
  return std::move(out_);
}

/// The end of the line that is at `position`, if no other one continues it; otherwise of a later one.
std::size_t ObjScanner::endOfLine(std::size_t position) const {
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
bool ObjScanner::scanPieces(std::size_t begin) {
  const std::size_t most = text_.size() / kMinPiece;
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
void ObjScanner::take(const ObjScanner& next) {
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

/// Checks positive indices at the end, because they may refer to later lines.
bool ObjScanner::checkRanges() {
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

void ObjScanner::addNotes() {
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

Result<ObjText> scanObj(std::string_view text, std::uint64_t maxTriangles) {
  return ObjScanner(text, maxTriangles).scan();
}

}  // namespace hgp::io
