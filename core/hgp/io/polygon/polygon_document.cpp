#include "hgp/io/polygon/polygon_document.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/ids.h"
#include "hgp/base/parallel.h"
#include "hgp/io/polygon/obj_text.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/finite.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Lines that a thread writes at a time.
constexpr int kLinesAtOnce = 4096;

/// A file with these polygons; new uv are interpolated as positions are.
PolygonFile fileOf(RefinedPolygons refined, std::vector<Vec2> uv,
                   const std::vector<int>& cornerUv) {
  PolygonFile file;
  file.uv = std::move(uv);
  if (!cornerUv.empty()) {
    const std::vector<Vec2> before = file.uv;
    MeanValues means(static_cast<int>(before.size()));
    for (const VertexPair& c : refined.corners)
      file.cornerUv.push_back(means.of(cornerUv[static_cast<std::size_t>(c[0])],
                                       cornerUv[static_cast<std::size_t>(c[1])]));
    for (const VertexPair& pair : means.pairs()) {
      const Vec2 &a = before[static_cast<std::size_t>(pair[0])],
                 &b = before[static_cast<std::size_t>(pair[1])];
      file.uv.push_back({0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1]});
    }
  }
  file.polygons = std::move(refined.polygons);
  return file;
}

}  // namespace

Result<DocumentPtr> PolygonDocument::make(const char* format, PolygonFile file) {
  std::unique_ptr<PolygonDocument> document(new PolygonDocument(format));
  if (Status taken = document->take(std::move(file)); !taken) return taken.error();
  return DocumentPtr(std::move(document));
}

Status PolygonDocument::take(PolygonFile file) {
  polygons_ = std::move(file.polygons);
  uv_ = std::move(file.uv);
  cornerUv_ = std::move(file.cornerUv);
  Result<TriangleCorners> corners = triangulate(polygons_);
  if (!corners) return corners.error();
  corners_ = std::move(*corners);
  Surface surface;
  surface.mesh = triangleMesh(polygons_, corners_);
  surface.isWelded = file.storedVertexCount >= 0;
  surface.storedVertexCount =
      surface.isWelded ? file.storedVertexCount : static_cast<int>(polygons_.positions.size());
  surface.notes = std::move(file.notes);
  const bool isComplete = std::find(cornerUv_.begin(), cornerUv_.end(), -1) == cornerUv_.end();
  if (!cornerUv_.empty() && isComplete) surface.uvSets = {0};
  if (!cornerUv_.empty() && !isComplete) {
    surface.notes.push_back(Note("read-uv-incomplete"));
  }
  surfaces_.push_back(std::move(surface));
  return Done{};
}

UvMap PolygonDocument::storedUv() const {
  UvMap map;
  map.uv = uv_;
  map.cornerUv.resize(static_cast<std::size_t>(polygons_.triangleCount()));
  for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t c = corners_.empty() ? 3 * t + k : static_cast<std::size_t>(corners_[t][k]);
      map.cornerUv[t][k] = cornerUv_[c];
    }
  }
  return map;
}

std::optional<UvMap> PolygonDocument::existingUv(int surface, int set) const {
  if (surface != 0 || set != 0 || surfaces_[0].uvSets.empty()) return std::nullopt;
  UvMap map = storedUv();
  if (uv_.size() >= cornerUv_.size()) joinEqualCopies(surfaces_[0].mesh, map);  // one per corner
  return map;
}

std::optional<UvMap> PolygonDocument::incompleteUv(int) const {
  if (cornerUv_.empty() || !surfaces_[0].uvSets.empty()) return std::nullopt;
  return storedUv();
}

UvMap PolygonDocument::asStored(int, const UvMap& map, const std::vector<int>& partOf) const {
  return keepPolygonsWhole(polygons_, corners_, map, partOf).map;
}

PolygonsView PolygonDocument::polygons(int) const {
  return polygons_.isTriangles() ? PolygonsView{} : PolygonsView{&polygons_, &corners_};
}

Result<std::optional<prescription::Prescription>> PolygonDocument::embeddedCones(int) const {
  return std::optional<prescription::Prescription>();
}

std::vector<int> PolygonDocument::polygonCornerUv(const UvMap& map) const {
  if (map.cornerUv.size() != static_cast<std::size_t>(polygons_.triangleCount())) return {};
  std::vector<int> cornerUv(polygons_.cornerVertex.size(), -1);
  const int count = static_cast<int>(map.uv.size());
  for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = map.cornerUv[t][k];
      const std::size_t c = corners_.empty() ? 3 * t + k : static_cast<std::size_t>(corners_[t][k]);
      if (i < 0 || i >= count || (cornerUv[c] >= 0 && cornerUv[c] != i)) return {};
      cornerUv[c] = i;
    }
  }
  return cornerUv;
}

Result<Written> PolygonDocument::write(int, const UvMap& map, const WriteOptions& options) const {
  const std::vector<int> cornerUv = polygonCornerUv(map);
  if (cornerUv.empty()) {
    return Failure{ErrorCode::kInternal, "write", "the map does not fit this document", {}};
  }
  Written written;
  written.files.push_back({options.name, writePolygonObj(polygons_, map.uv, cornerUv, options)});
  written.notes.push_back(Note("write-as-obj"));
  return written;
}

Result<PlainFile> PolygonDocument::plain(int) const {
  PlainFile file;
  MeshData& mesh = file.surfaces.emplace_back().mesh;
  mesh = surfaces_[0].mesh;
  const std::vector<int> unplaced = unusedNotFinite(mesh);  // glTF allows only finite numbers
  for (const int v : unplaced) mesh.positions[static_cast<std::size_t>(v)] = {0, 0, 0};
  if (!unplaced.empty())
    file.lost.push_back(Note("convert-unused-placed", {{"vertices", unplaced.size()}}));
  if (!polygons_.isTriangles()) file.lost.push_back(Note("convert-polygons-cut"));
  if (!cornerUv_.empty()) file.lost.push_back(Note("convert-uv-lost"));
  return file;
}

Result<DocumentPtr> PolygonDocument::rewritten(RefinedPolygons refined) const {
  const auto added = static_cast<int>(refined.parents.size());
  PolygonFile file = fileOf(std::move(refined), uv_, cornerUv_);
  file.notes = surfaces_[0].notes;
  if (surfaces_[0].isWelded) file.storedVertexCount = surfaces_[0].storedVertexCount + added;
  return make(format_, std::move(file));
}

Result<DocumentPtr> PolygonDocument::refined(int, const std::vector<VertexPair>& edges) const {
  return rewritten(splitEdges(polygons_, corners_, surfaces_[0].mesh, edges));
}

Result<DocumentPtr> PolygonDocument::repaired(int, const FaceEdits& edits) const {
  return rewritten(editFaces(polygons_, corners_, edits));
}

void appendUvLines(std::string& out, const std::vector<Vec2>& uv, std::string_view lineEnd) {
  const auto appendLine = [&](std::string& to, const Vec2& p) {
    to += "vt ";
    text::appendDouble(to, p[0]);
    to += ' ';
    text::appendDouble(to, p[1]);
    to += lineEnd;
  };
  if (threadCount() == 1) {
    for (const Vec2& p : uv) appendLine(out, p);
    return;
  }
  const int count = static_cast<int>(uv.size());
  std::vector<std::string> pieces(at(count) / at(kLinesAtOnce) + 1);
  parallelBlocks(count, kLinesAtOnce, [&](int begin, int end) {
    std::string& piece = pieces[at(begin / kLinesAtOnce)];
    for (int i = begin; i < end; ++i) appendLine(piece, uv[at(i)]);
  });
  for (const std::string& piece : pieces) out += piece;
}

void appendEmbeddedCones(std::string& out, const WriteOptions& options, std::string_view lineEnd) {
  if (!options.cones) return;
  out += kEmbeddedConesMark;
  for (char c : *options.cones) out += c == '\n' || c == '\r' ? ' ' : c;
  out += lineEnd;
}

Bytes writePolygonObj(const PolygonMesh& polygons, const std::vector<Vec2>& uv,
                      const std::vector<int>& cornerUv, const WriteOptions& options,
                      const VertexExtras& extras) {
  std::string out;
  const bool hasColors = extras.colors.size() == polygons.positions.size();
  const bool hasNormals = extras.normals.size() == polygons.positions.size();
  const auto append = [&](const auto& numbers, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      out += ' ';
      text::appendDouble(out, numbers[k]);
    }
  };
  out.reserve(polygons.positions.size() * 56 + uv.size() * 42 + polygons.cornerVertex.size() * 14);
  if (!options.generator.empty()) out += "# " + options.generator + "\n";
  appendEmbeddedCones(out, options, "\n");
  for (std::size_t v = 0; v < polygons.positions.size(); ++v) {
    out += 'v';
    append(polygons.positions[v], 3);
    if (hasColors) append(extras.colors[v], 3);
    out += '\n';
  }
  appendUvLines(out, uv, "\n");
  for (std::size_t v = 0; hasNormals && v < extras.normals.size(); ++v) {
    out += "vn";
    append(extras.normals[v], 3);
    out += '\n';
  }
  for (std::size_t p = 0; p + 1 < polygons.start.size(); ++p) {
    out += 'f';
    for (std::size_t c = polygons.start[p]; c < polygons.start[p + 1]; ++c) {
      out += ' ';
      text::appendInt(out, polygons.cornerVertex[c] + 1);
      if (cornerUv.empty() && !hasNormals) continue;
      out += '/';
      if (!cornerUv.empty()) text::appendInt(out, cornerUv[c] + 1);
      if (!hasNormals) continue;
      out += '/';
      text::appendInt(out, polygons.cornerVertex[c] + 1);
    }
    out += '\n';
  }
  return asBytes(out);
}

Bytes writePlainObj(const MeshData& mesh, const UvMap& map, const std::string& generator) {
  PolygonMesh polygons;
  polygons.positions = mesh.positions;
  std::vector<int> cornerUv;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      polygons.cornerVertex.push_back(mesh.triangles[t][k]);
      if (!map.cornerUv.empty()) cornerUv.push_back(map.cornerUv[t][k]);
    }
    polygons.start.push_back(static_cast<std::uint32_t>(3 * (t + 1)));
  }
  WriteOptions options;
  options.generator = generator;
  return writePolygonObj(polygons, map.uv, cornerUv, options);
}

}  // namespace hgp::io
