// Other triangles for a mesh of a glTF: split edges, and quads.
#include <algorithm>
#include <map>

#include "hgp/base/ids.h"
#include "hgp/io/gltf/document.h"
#include "hgp/io/gltf/pack/pack.h"
#include "hgp/io/gltf/patch/remesh.h"
#include "hgp/io/limits.h"
#include "hgp/io/remesh.h"
#include "hgp/mesh/barycentric.h"

namespace hgp::io {
namespace {

Failure repairedApart() {
  return {ErrorCode::kUnsupported,
          "write",
          "the mesh has repairs that are not yet in the file; write the repaired mesh first",
          {}};
}

/// A distance below this share of a polygon's diagonal is a rounding error.
constexpr double kRounding = 1e-9;

/// The triangles of polygons on the primitives that have their materials.
class OnPrimitives {
 public:
  OnPrimitives(const std::vector<GltfPrimitive>& primitives, const GltfSurface& part,
               const MeshData& welded, const Remesh& remesh)
      : primitives_(primitives), part_(part), welded_(welded), remesh_(remesh) {
    hasPolygons_.resize(part.runs.size());
    for (const int t : remesh.triangle) hasPolygons_[runOf(t)] = 1;
    if (part.pools.size() < 2) return;
    trianglesAt_.resize(welded.positions.size());
    for (std::size_t t = 0; t < welded.triangles.size(); ++t)
      for (const int v : welded.triangles[t]) trianglesAt_[at(v)].push_back(static_cast<int>(t));
  }

  /// Corners of polygons that lie on no triangle of a primitive with their attributes.
  int elsewhere() const { return elsewhere_; }

  GltfRemesh make() {
    out_.triangles.resize(part_.runs.size());
    for (int p = 0; p < remesh_.polygons.polygonCount(); ++p) {
      const std::size_t run = runOf(remesh_.triangle[at(p)]);
      const std::size_t first = remesh_.polygons.start[at(p)],
                        end = remesh_.polygons.start[at(p) + 1];
      std::vector<std::uint32_t> vertices;
      for (std::size_t c = first; c < end; ++c) vertices.push_back(vertexAt(c, first, end, run));
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k)
        for (const std::size_t corner : {std::size_t{0}, k, k + 1})
          out_.triangles[run].push_back(vertices[corner]);
    }
    return std::move(out_);
  }

 private:
  std::size_t runOf(int triangle) const {
    const auto after =
        std::upper_bound(part_.runs.begin(), part_.runs.end(), triangle,
                         [](int t, const GltfRun& run) { return t < run.firstTriangle; });
    // Runs without triangles begin where the next one does.
    return static_cast<std::size_t>(after - part_.runs.begin()) - 1;
  }
  /// Whether vertices of one run can be vertices of the other with everything that they have.
  bool areAlike(std::size_t a, std::size_t b) const {
    if (part_.runs[a].pool == part_.runs[b].pool) return true;
    const GltfPrimitive &x = primitives_[at(part_.runs[a].primitive)],
                        &y = primitives_[at(part_.runs[b].primitive)];
    return hasPolygons_[a] != 0 && x.material == y.material &&
           x.targets.size() == y.targets.size() &&
           std::equal(x.attributes.begin(), x.attributes.end(), y.attributes.begin(),
                      y.attributes.end(),
                      [](const auto& one, const auto& other) { return one.first == other.first; });
  }

  /// Where a corner lies on a triangle of another primitive, the nearest point of the triangles of its own: those there, and
  /// those that the polygon's corners have.
  FacePoint pointAt(std::size_t c, std::size_t first, std::size_t end, std::size_t run) {
    const FacePoint& here = remesh_.at[c];
    if (areAlike(runOf(here.triangle), run)) return here;
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return remesh_.polygons.positions[at(remesh_.polygons.cornerVertex[k])];
    };
    const Vec3& p = corner(c);
    FacePoint best = here;
    double least = -1;
    const auto take = [&](int t) {
      if (!areAlike(runOf(t), run)) return;
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = welded_.positions[at(welded_.triangles[at(t)][k])];
      const std::array<double, 3> weight = weightsIn(corners, p);
      Vec3 there{};
      for (std::size_t k = 0; k < 3; ++k) there = add(there, scaled(corners[k], weight[k]));
      const double away = distance(there, p);
      if (least >= 0 && away >= least) return;
      least = away;
      best = {t, weight};
    };
    for (std::size_t other = first; other < end; ++other) take(remesh_.at[other].triangle);
    for (std::size_t k = 0; k < 3; ++k)
      if (here.weight[k] > 0)
        for (const int t : trianglesAt_[at(welded_.triangles[at(here.triangle)][k])]) take(t);
    const double diagonal = distance(p, corner(first + (c - first + 2) % (end - first)));
    if (!(least >= 0 && least <= kRounding * diagonal)) ++elsewhere_;
    return best;
  }

  std::uint32_t vertexAt(std::size_t c, std::size_t first, std::size_t end, std::size_t run) {
    const FacePoint point = pointAt(c, first, end, run);
    const int vertex = remesh_.polygons.cornerVertex[c];
    const Blend blend = blendOf(part_.stored[at(point.triangle)], point.weight);
    const auto [found, isNew] =
        found_.try_emplace({vertex, blend}, static_cast<std::uint32_t>(out_.vertices.size()));
    if (isNew) {
      out_.vertices.push_back(blend);
      out_.positions.push_back(remesh_.polygons.positions[at(vertex)]);
    }
    return found->second;
  }

  const std::vector<GltfPrimitive>& primitives_;
  const GltfSurface& part_;
  const MeshData& welded_;
  const Remesh& remesh_;
  std::vector<char> hasPolygons_;  ///< by run
  std::vector<std::vector<int>>
      trianglesAt_;  ///< by vertex of the surface; empty where all share their vertices
  int elsewhere_ = 0;
  GltfRemesh out_;
  std::map<std::pair<int, Blend>, std::uint32_t> found_;
};

}  // namespace

Result<Written> Document::remeshed(int, const Remesh&, const Resolver&) const {
  return Failure{
      ErrorCode::kUnsupported, "write", "only a glTF is written with other triangles", {}};
}

Resolver GltfDocument::resolverWith(std::vector<OutputFile> sides, Resolver others) const {
  return [store = store_, sides = std::move(sides),
          others = std::move(others)](const std::string& name) -> Result<Bytes> {
    for (const OutputFile& side : sides)
      if (side.name == name) return side.bytes;
    for (const GltfBuffer& buffer : store->buffers)
      if (buffer.kind == GltfBufferKind::kFile && buffer.name == name)
        return Bytes(buffer.bytes.begin(), buffer.bytes.end());
    if (others) return others(name);
    return Failure{ErrorCode::kMalformed, "read", "'" + name + "' is not given here", {}};
  };
}

WriteOptions GltfDocument::likeThis() const {
  WriteOptions options;
  options.name = format() == std::string_view("glb") ? "mesh.glb" : "mesh.gltf";
  options.isCompressedLater = true;
  options.isSideFileNoted = false;
  return options;
}

Result<DocumentPtr> GltfDocument::refined(int surface,
                                          const std::vector<std::array<int, 2>>& edges) const {
  const GltfSurface& part = parts_[at(surface)];
  if (!part.copy.empty()) return repairedApart();
  Result<Written> written = remeshGltf(
      *store_, part, splitGltfEdges(part, surfaces_[at(surface)].mesh, edges), likeThis());
  if (!written) return written.error();
  FileSet files;
  files.name = store_->name;
  files.main = std::move(written->files.front().bytes);
  written->files.erase(written->files.begin());
  files.resolve = resolverWith(std::move(written->files), {});
  files.decoders = decoders_;
  return readGltf(std::move(files), Limits());
}

Result<Written> GltfDocument::remeshed(int surface, const Remesh& remesh,
                                       const Resolver& resolve) const {
  const GltfSurface& part = parts_[at(surface)];
  if (!part.copy.empty()) return repairedApart();
  OnPrimitives made(store_->model.meshes[at(part.mesh)].primitives, part,
                    surfaces_[at(surface)].mesh, remesh);
  Result<Written> written = remeshGltf(*store_, part, made.make(), likeThis());
  if (!written) return written;
  if (made.elsewhere() > 0)
    written->notes.push_back(Note("quads-nearest", {{"corners", made.elsewhere()}}));
  if (store_->container.isBinary) return written;
  FileSet files;
  files.name = "mesh.gltf";
  files.main = std::move(written->files.front().bytes);
  written->files.erase(written->files.begin());
  files.resolve = resolverWith(std::move(written->files), resolve);
  Written packed;
  packed.notes = std::move(written->notes);
  Result<Bytes> glb = gltfAsGlb(files, Limits(), packed.notes);
  if (!glb) return glb.error();
  packed.files = {{"mesh.glb", std::move(*glb)}};
  return packed;
}

}  // namespace hgp::io
