#include "hgp/api/model/mirrors.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

/// The image of a component is looked for among at most so many with as many triangles at its mirrored place.
constexpr int kMaxImages = 16;
/// A component may be off by this fraction of the whole's diagonal, which positions in single precision are.
constexpr double kRounding = 3e-7;

Vec3 meanOf(const TriMesh& mesh) {
  Vec3 sum{0.0, 0.0, 0.0};
  for (HalfedgeId h : mesh.halfedges()) sum = add(sum, mesh.position(mesh.tail(h)));
  return scaled(sum, 1.0 / mesh.halfedgeCount());
}

class Finder {
 public:
  Finder(const Model& model, const MirrorPlane& plane) : model_(model) {
    out_.plane = plane;
    Box<3> whole;
    for (const ModelComponent& component : model.components) {
      const Box<3> box = boxOfCorners(component.mesh);
      tolerance_.push_back(kMirrorTolerance * diagonal(box));
      whole.add(box.low);
      whole.add(box.high);
    }
    for (double& tolerance : tolerance_)
      tolerance = std::max(tolerance, kRounding * diagonal(whole));
  }

  ModelMirror run() {
    out_.mirrors.resize(tolerance_.size());
    for (std::size_t p = 0; p < tolerance_.size(); ++p) {
      if (out_.mirrors[p]) continue;
      const TriMesh& mesh = model_.components[p].mesh;
      std::optional<Reflection> own = findIn(p, p);
      if (own && hasTwoSides(mesh, *own)) {
        out_.inPlane += static_cast<int>(edgesInPlane(mesh, *own).size());
        out_.across += static_cast<int>(edgesAcross(mesh, *own).size());
        keep(std::move(*own), p, -1);
      } else if (!pair(p)) {
        out_.missing = {static_cast<int>(p), own.has_value(), tolerance_[p]};
        break;
      }
    }
    return std::move(out_);
  }

 private:
  std::optional<Reflection> findIn(std::size_t p, std::size_t o) const {
    return findReflection(model_.components[p].mesh, model_.components[o].mesh, out_.plane,
                          tolerance_[p]);
  }
  void keep(Reflection image, std::size_t p, int of) {
    out_.distance = std::max(out_.distance, image.distance);
    out_.mirrors[p] = std::make_shared<Mirror>(Mirror{out_.plane, std::move(image), of});
  }
  /// Looks for the image of a component among those after it.
  bool pair(std::size_t p) {
    if (means_.empty())
      for (const ModelComponent& component : model_.components)
        means_.push_back(meanOf(component.mesh));
    const Vec3 there = mirrored(out_.plane, means_[p]);
    const int faces = model_.components[p].mesh.faceCount();
    int tried = 0;
    for (std::size_t o = p + 1; o < means_.size() && tried < kMaxImages; ++o) {
      if (out_.mirrors[o] || model_.components[o].mesh.faceCount() != faces ||
          !(distance(there, means_[o]) <= tolerance_[p]))
        continue;
      ++tried;
      std::optional<Reflection> image = findIn(p, o);
      if (!image) continue;
      keep(std::move(*image), o, static_cast<int>(p));
      return true;
    }
    return false;
  }

  const Model& model_;
  std::vector<double> tolerance_;  ///< per component
  std::vector<Vec3> means_;        ///< of corners, per component; empty until pairs are looked for
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
