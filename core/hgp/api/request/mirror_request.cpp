#include "hgp/api/request/mirror_request.h"

#include <algorithm>
#include <climits>

#include "hgp/api/model/mirrors.h"
#include "hgp/api/request/feature_request.h"
#include "hgp/api/request/mirror_pairs.h"
#include "hgp/base/check.h"
#include "hgp/parametrize/stage_clock.h"

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
  if (choosesCones(options))
    return clash(
        "cones of a symmetric map are those of a field; leave out their number, purpose "
        "and alignment");
  if (request.q != 4)
    return refuse(ErrorCode::kUsage,
                  formatText("a symmetric map needs q = 4; these cones have q = %d", request.q));
  return Done{};
}

/// How near a plane comes to a symmetry: the images in the component that has none.
MirrorImages imagesIn(const Model& model, const ModelMirror& mirror) {
  const auto& [p, isMirrored, tolerance] = mirror.missing;
  return mirrorImages(model.components[at(p)].mesh, mirror.plane, tolerance);
}

/// Why there are no two sides of the plane. @param next  what to do
Failure notSymmetric(const Model& model, const ModelMirror& mirror, const std::string& next = "") {
  const bool isMirrored = mirror.missing.isMirrored;
  const MirrorImages images = imagesIn(model, mirror);
  const ModelComponent& component = model.components[at(mirror.missing.component)];
  const std::string plane = planeText(mirror.plane);
  const int faces = component.mesh.faceCount();
  if (isMirrored || !images.without.isValid())
    return toSurfaceIds(
        model, component,
        refuse(ErrorCode::kUnsupported,
               formatText(
                   "all %d triangles have mirror images across %s, but %s.", faces, plane.c_str(),
                   isMirrored ? "they are not two sides: the plane does not cut them apart"
                              : "they are not joined like these: vertices are split elsewhere") +
                   next));
  return toSurfaceIds(
      model, component,
      refuse(ErrorCode::kUnsupported,
             formatText("the mesh is not symmetric across %s: %d of %d triangles have a mirror "
                        "image, with vertices within %g of its diagonal and joined by the same "
                        "triangles. Replace one side by the image of the other.",
                        plane.c_str(), images.count, faces, kMirrorTolerance) +
                 next,
             {{Where::Kind::kFace, images.without.i}}));
}

/// The images of features are features, and so are the edges in the plane and rims.
void addFeatures(const TriMesh& mesh, const Mirror& mirror, std::vector<EdgeId>& features) {
  for (std::size_t i = 0, own = features.size(); i < own; ++i)
    features.push_back(mesh.edge(mirror.image.halfedge[mesh.halfedge(features[i])]));
  const std::vector<EdgeId> plane = edgesInPlane(mesh, mirror.image);
  features.insert(features.end(), plane.begin(), plane.end());
  for (EdgeId e : mesh.edges())
    if (mesh.isBoundary(mesh.halfedge(e))) features.push_back(e);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
}

Status take(const Model& model, const ModelMirror& mirror, Request& request) {
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const std::shared_ptr<const Mirror>& own = mirror.mirrors[p];
    request.components[p].mirror = own;
    if (!own) continue;
    if (own->of < 0)
      addFeatures(model.components[p].mesh, *own, request.components[p].spec.features);
    else if (Status joined = joinPair(model, p, request); !joined)
      return joined;
  }
  request.plane = mirror.plane;
  return Done{};
}

/// Sets the plane that is asked for, or the best of all.
Status takePlane(const Model& model, const SolveOptions& options, Request& request) {
  std::vector<MirrorPlane> planes = likelyPlanes(model.mesh);
  const bool isAuto = options.symmetry == Symmetry::kAuto;
  if (!isAuto)
    planes = {planes[static_cast<std::size_t>(options.symmetry) -
                     static_cast<std::size_t>(Symmetry::kX)]};
  std::optional<ModelMirror> best;
  int bestRank = -1;
  // A plane that no edges cross needs no other triangles.
  const auto rank = [&](const ModelMirror& m) {
    return m.missing.component >= 0 ? imagesIn(model, m).count : INT_MAX - (m.across > 0 ? 1 : 0);
  };
  for (const MirrorPlane& plane : planes) {
    if (!report(options.progress, {Stage::kPrepare, 0.0})) return cancelled(Stage::kPrepare);
    ModelMirror mirror = mirrorAcross(model, plane);
    const int own = rank(mirror);
    if (own <= bestRank) continue;
    best = std::move(mirror);
    bestRank = own;
    if (bestRank == INT_MAX) break;
  }
  if (best->missing.component >= 0)
    return notSymmetric(
        model, *best,
        isAuto ? formatText(" None of %zu planes that were tried comes nearer.", planes.size())
               : " See the planes that inspect lists.");
  return take(model, *best, request);
}

}  // namespace

Status addMirror(const Model& model, const SolveOptions& options, Request& request) {
  if (options.symmetry == Symmetry::kNone) return Done{};
  if (Status possible = checkPossible(options, request); !possible) return possible;
  return takePlane(model, options, request);
}

Status setMirrors(const Model& model, Request& request) {
  if (!request.plane) return Done{};
  const ModelMirror mirror = mirrorAcross(model, *request.plane);
  if (mirror.missing.component >= 0) return notSymmetric(model, mirror);
  return take(model, mirror, request);
}

Note mirrorNote(const Model& model, const Request& request) {
  double off = 0.0;
  int pairs = 0;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const auto& mirror = request.components[p].mirror;
    if (!mirror) continue;
    const double size = diagonal(boxOfCorners(model.components[p].mesh));
    off = std::max(off, mirror->image.distance / size);
    pairs += mirror->of >= 0 ? 1 : 0;
  }
  return Note("symmetric", {{"plane", planeText(*request.plane)}, {"off", off}, {"pairs", pairs}});
}

bool crossesPlane(const Model& model, const Request& request) {
  for (std::size_t p = 0; p < request.components.size(); ++p)
    if (const auto& mirror = request.components[p].mirror; mirror && mirror->of < 0)
      if (!edgesAcross(model.components[p].mesh, mirror->image).empty()) return true;
  return false;
}

}  // namespace hgp::api
