#include "hgp/api/request/rectangles.h"

#include <algorithm>
#include <string>

#include "hgp/api/request/feature_request.h"
#include "hgp/base/counted.h"
#include "hgp/features/rectangle_corners.h"

namespace hgp::api {
namespace {

Failure refused(ErrorCode code, std::string message, Notes advice = {}) {
  return {code, "features", std::move(message), {}, std::move(advice)};
}

/// @param name  of the component in messages
Status makeRectangle(const ModelComponent& component, const std::string& name,
                     ComponentRequest& request) {
  const TriMesh& mesh = component.mesh;
  const Topology& topology = component.topology;
  HolonomySpec& spec = request.spec;
  if (topology.genus != 0 || topology.loops.size() != 1)
    return refused(
        ErrorCode::kUnsupported,
        formatText("A rectangle needs a disk (genus 0, one boundary loop); %s has genus %d and %s.",
                   name.c_str(), topology.genus, counted(topology.loops.size(), "loop").c_str()),
        {Note("use-cones")});
  if (spec.q != 4)
    return refused(ErrorCode::kUsage,
                   formatText("A rectangle needs q = 4; these cones have q = %d.", spec.q));
  request.isAutomatic = false;
  if (!spec.turning.empty() && spec.turning[0].value_or(spec.q) != spec.q)
    return refused(ErrorCode::kPrescription,
                   formatText("The boundary of a rectangle turns by %d quarters, not by %d; leave "
                              "out the turning.",
                              spec.q, *spec.turning[0]));
  addRims(mesh, spec);
  if (!spec.cones.empty())
    return refused(ErrorCode::kUsage,
                   "A rectangle has no cones inside, only four corners; leave out either.");
  if (spec.corners.empty()) {
    const auto chosen = rectangleCorners(mesh, computeGeometry(mesh), topology.loops[0]);
    if (!chosen)
      return refused(
          ErrorCode::kUnsupported,
          "A rectangle needs four corners, and the boundary of " + name + " has fewer vertices.",
          {Note("use-cones")});
    for (VertexId v : *chosen) spec.corners.push_back({v, 1});
  }
  const bool areRight =
      std::all_of(spec.corners.begin(), spec.corners.end(), [](auto& c) { return c.k == 1; });
  if (spec.corners.size() != 4 || !areRight)
    return refused(ErrorCode::kUsage, "A rectangle has four corners of 90° (k = 1); " +
                                          counted(spec.corners.size(), "corner is", "corners are") +
                                          (areRight ? " given." : " given, not all of 90°."));
  return Done{};
}

}  // namespace

Status makeRectangles(const Model& model, const SolveOptions& options, Request& request) {
  if (options.boundary != BoundaryKind::kRectangle) return Done{};
  std::size_t refusals = 0;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    ComponentRequest& component = request.components[p];
    const Status done = makeRectangle(
        model.components[p],
        model.components.size() == 1 ? "this surface" : "component " + std::to_string(p),
        component);
    if (done) continue;
    const bool isLeftOut = options.keepsGoing && done.error().code == ErrorCode::kUnsupported;
    if (!isLeftOut || ++refusals == model.components.size()) return done.error();
    component.refusal = done.error();
  }
  return Done{};
}

}  // namespace hgp::api
