#include "hgp/api/model/mirrors.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

/// Pairs of components are looked for among at most so many.
constexpr std::size_t kPaired = 1000;

Vec3 meanOf(const TriMesh& mesh) {
  Vec3 sum{0.0, 0.0, 0.0};
  for (VertexId v : mesh.vertices()) sum = add(sum, mesh.position(v));
  return scaled(sum, 1.0 / mesh.vertexCount());
}

class Finder {
 public:
  Finder(const Model& model, const MirrorPlane& plane)
      : model_(model), tolerance_(kMirrorTolerance * diagonal(finiteBoxOf(model.mesh.positions))) {
    out_.plane = plane;
    for (const ModelComponent& component : model.components)
      mean_.push_back(meanOf(component.mesh));
  }

  ModelMirror run() {
    const std::size_t count = model_.components.size();
    out_.image.assign(count, -1);
    out_.own.resize(count);
    for (std::size_t p = 0; p < count; ++p) {
      if (isFound(p, p)) continue;
      std::size_t o = count <= kPaired ? 0 : count;
      while (o < count && (o == p || !isFound(p, o))) ++o;
      if (o < count) continue;
      out_.missing.component = static_cast<int>(p);
      break;
    }
    return std::move(out_);
  }

 private:
  bool isFound(std::size_t p, std::size_t o) {
    const TriMesh &from = model_.components[p].mesh, &to = model_.components[o].mesh;
    if (p != o && (from.faceCount() != to.faceCount() ||
                   distance(mirrored(out_.plane, mean_[p]), mean_[o]) > tolerance_))
      return false;
    ReflectionSearch search = findReflection(from, to, out_.plane, tolerance_);
    if (p == o) out_.missing = {-1, search.matched, search.without};
    if (!search.reflection) return false;
    out_.image[p] = static_cast<int>(o);
    out_.distance = std::max(out_.distance, search.reflection->distance);
    if (p != o) return true;
    out_.inPlane += static_cast<int>(edgesInPlane(from, *search.reflection).size());
    out_.across += static_cast<int>(edgesAcross(from, *search.reflection).size());
    out_.own[p] = std::make_shared<Mirror>(Mirror{out_.plane, std::move(*search.reflection)});
    return true;
  }

  const Model& model_;
  const double tolerance_;
  std::vector<Vec3> mean_;
  ModelMirror out_;
};

}  // namespace

ModelMirror mirrorAcross(const Model& model, const MirrorPlane& plane) {
  return Finder(model, plane).run();
}

std::vector<ModelMirror> findMirrors(const Model& model) {
  std::vector<ModelMirror> found;
  for (const MirrorPlane& plane : likelyPlanes(model.mesh)) {
    ModelMirror mirror = mirrorAcross(model, plane);
    if (mirror.missing.component < 0) found.push_back(std::move(mirror));
  }
  return found;
}

std::string planeText(const MirrorPlane& plane) {
  if (!plane.name.empty()) return formatText("%s = %.6g", plane.name.c_str(), plane.offset);
  const Vec3& n = plane.normal;
  return formatText("(%.6g, %.6g, %.6g) · p = %.6g", n[0], n[1], n[2], plane.offset);
}

}  // namespace hgp::api
