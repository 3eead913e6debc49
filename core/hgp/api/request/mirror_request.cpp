#include "hgp/api/request/mirror_request.h"

#include <algorithm>

#include "hgp/api/model/mirrors.h"
#include "hgp/base/check.h"
#include "hgp/mesh/finite.h"

namespace hgp::api {
namespace {

Failure refuse(ErrorCode code, std::string message, std::vector<Where> where = {}) {
  return {code, "symmetric", std::move(message), std::move(where)};
}

Status checkPossible(const SolveOptions& options, const Request& request) {
  const auto clash = [](const char* text) { return refuse(ErrorCode::kUsage, text); };
  if (options.boundary != BoundaryKind::kFree)
    return clash("a convex boundary or a rectangle is not made symmetric; leave out either");
  for (const ComponentRequest& component : request.components)
    if (!component.spec.corners.empty())
      return clash("corners of the boundary do not go with a symmetric map; leave out either");
  if (options.refines) return clash("a refined mesh is not symmetric; leave out either");
  if (options.convexPolygons)
    return clash("convex polygons would move uv on one side only; leave out either");
  if (request.q != 4)
    return refuse(ErrorCode::kUsage,
                  formatText("a symmetric map needs q = 4; these cones have q = %d", request.q));
  return Done{};
}

Failure notSymmetric(const Model& model, const ModelMirror& mirror) {
  const NoMirror& missing = mirror.missing;
  const ModelComponent& component = model.components[at(missing.component)];
  const std::string of =
      model.components.size() == 1 ? "" : formatText(" of component %d", missing.component);
  Failure failure = refuse(
      ErrorCode::kUnsupported,
      formatText("the mesh is not symmetric across %s: %d of %d triangles%s have a mirror image, "
                 "with vertices within %g of the bounding box's diagonal and joined by the same "
                 "triangles.",
                 planeText(mirror.plane).c_str(), missing.matched, component.mesh.faceCount(),
                 of.c_str(), kMirrorTolerance),
      {{Where::Kind::kFace, missing.without.i}});
  return toSurfaceIds(model, component, std::move(failure));
}

/// The plane that is asked for, or the best of all.
ModelMirror mirrorFor(const Model& model, Symmetry symmetry) {
  const std::vector<MirrorPlane> planes = likelyPlanes(model.mesh);
  if (symmetry != Symmetry::kAuto)
    return mirrorAcross(
        model, planes[static_cast<std::size_t>(symmetry) - static_cast<std::size_t>(Symmetry::kX)]);
  std::optional<ModelMirror> best;
  for (const MirrorPlane& plane : planes) {
    ModelMirror mirror = mirrorAcross(model, plane);
    const bool isWhole = mirror.missing.component < 0;
    // A plane that no edges cross needs no other triangles.
    if (isWhole && mirror.across == 0) return mirror;
    const auto rank = [](const ModelMirror& m) {
      return m.missing.component < 0 ? 1 << 30 : m.missing.matched;
    };
    if (!best || rank(mirror) > rank(*best)) best = std::move(mirror);
  }
  return std::move(*best);
}

void addTo(const TriMesh& mesh, const std::shared_ptr<const Mirror>& mirror,
           ComponentRequest& request) {
  std::vector<EdgeId>& features = request.spec.features;
  const std::vector<EdgeId> plane = edgesInPlane(mesh, mirror->own);
  features.insert(features.end(), plane.begin(), plane.end());
  for (EdgeId e : mesh.edges())
    if (mesh.isBoundary(mesh.halfedge(e))) features.push_back(e);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  request.mirror = mirror;
}

Status take(const Model& model, const ModelMirror& mirror, Request& request) {
  if (mirror.missing.component >= 0) return notSymmetric(model, mirror);
  for (std::size_t p = 0; p < model.components.size(); ++p)
    if (!mirror.own[p])
      return refuse(
          ErrorCode::kUnsupported,
          formatText("components %d and %d are mirror images of each other across %s, "
                     "and none of them is one of itself; parametrize one of them and "
                     "mirror it",
                     static_cast<int>(p), mirror.image[p], planeText(mirror.plane).c_str()));
  for (std::size_t p = 0; p < model.components.size(); ++p)
    addTo(model.components[p].mesh, mirror.own[p], request.components[p]);
  request.plane = mirror.plane;
  return Done{};
}

}  // namespace

Status addMirror(const Model& model, const SolveOptions& options, Request& request) {
  if (options.symmetry == Symmetry::kNone) return Done{};
  if (Status possible = checkPossible(options, request); !possible) return possible;
  const ModelMirror mirror = mirrorFor(model, options.symmetry);
  if (Status done = take(model, mirror, request); !done) return done;
  request.notes.push_back(
      Note("symmetric", {{"plane", planeText(mirror.plane)},
                         {"off", mirror.distance / diagonal(finiteBoxOf(model.mesh.positions))}}));
  return Done{};
}

Status setMirrors(const Model& model, Request& request) {
  return request.plane ? take(model, mirrorAcross(model, *request.plane), request) : Status(Done{});
}

bool crossesPlane(const Model& model, const Request& request) {
  for (std::size_t p = 0; p < request.components.size(); ++p)
    if (const auto& mirror = request.components[p].mirror)
      if (!edgesAcross(model.components[p].mesh, mirror->own).empty()) return true;
  return false;
}

}  // namespace hgp::api
