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

/// The triangles of polygons on the primitives that have their materials.
class OnPrimitives {
 public:
  OnPrimitives(const GltfSurface& part, const MeshData& welded, const Remesh& remesh)
      : part_(part), welded_(welded), remesh_(remesh) {}

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
  int poolOf(int triangle) const { return part_.runs[runOf(triangle)].pool; }

  /// Where a corner lies on a triangle of another pool, the nearest point of one that a corner of the same polygon has.
  FacePoint pointAt(std::size_t c, std::size_t first, std::size_t end, int pool) const {
    const Vec3& p = remesh_.polygons.positions[at(remesh_.polygons.cornerVertex[c])];
    FacePoint best = remesh_.at[c];
    double least = -1;
    for (std::size_t other = first; other < end; ++other) {
      const int t = remesh_.at[other].triangle;
      if (poolOf(t) != pool) continue;
      if (other == c) return remesh_.at[c];
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = welded_.positions[at(welded_.triangles[at(t)][k])];
      const std::array<double, 3> weight = weightsIn(corners, p);
      Vec3 there{};
      for (std::size_t k = 0; k < 3; ++k) there = add(there, scaled(corners[k], weight[k]));
      const double away = distance(there, p);
      if (least >= 0 && away >= least) continue;
      least = away;
      best = {t, weight};
    }
    return best;
  }

  std::uint32_t vertexAt(std::size_t c, std::size_t first, std::size_t end, std::size_t run) {
    const FacePoint point = pointAt(c, first, end, part_.runs[run].pool);
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

  const GltfSurface& part_;
  const MeshData& welded_;
  const Remesh& remesh_;
  GltfRemesh out_;
  std::map<std::pair<int, Blend>, std::uint32_t> found_;
};

}  // namespace

Result<Written> Document::remeshed(int, const Remesh&) const {
  return Failure{
      ErrorCode::kUnsupported, "write", "only a glTF is written with other triangles", {}};
}

Resolver GltfDocument::resolverWith(std::vector<OutputFile> sides) const {
  return [store = store_, sides = std::move(sides)](const std::string& name) -> Result<Bytes> {
    for (const OutputFile& side : sides)
      if (side.name == name) return side.bytes;
    for (const GltfBuffer& buffer : store->buffers)
      if (buffer.kind == GltfBufferKind::kFile && buffer.name == name)
        return Bytes(buffer.bytes.begin(), buffer.bytes.end());
    return Failure{ErrorCode::kMalformed, "read", "'" + name + "' is no buffer of the file", {}};
  };
}

WriteOptions GltfDocument::likeThis() const {
  WriteOptions options;
  options.name = format() == std::string_view("glb") ? "mesh.glb" : "mesh.gltf";
  options.isCompressedLater = true;
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
  files.resolve = resolverWith(std::move(written->files));
  files.decoders = decoders_;
  return readGltf(std::move(files), Limits());
}

Result<Written> GltfDocument::remeshed(int surface, const Remesh& remesh) const {
  const GltfSurface& part = parts_[at(surface)];
  if (!part.copy.empty()) return repairedApart();
  Result<Written> written = remeshGltf(
      *store_, part, OnPrimitives(part, surfaces_[at(surface)].mesh, remesh).make(), likeThis());
  if (!written || store_->container.isBinary) return written;
  FileSet files;
  files.name = "mesh.gltf";
  files.main = std::move(written->files.front().bytes);
  written->files.erase(written->files.begin());
  files.resolve = resolverWith(std::move(written->files));
  Written packed;
  Result<Bytes> glb = gltfAsGlb(files, Limits(), packed.notes);
  if (!glb) return glb.error();
  packed.files = {{"mesh.glb", std::move(*glb)}};
  return packed;
}

}  // namespace hgp::io
