#include "hgp/api/session/kept_runs.h"

#include <tuple>

namespace hgp::api {
namespace {

template <class T, class Same>
bool areSame(const std::vector<T>& a, const std::vector<T>& b, const Same& same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}
template <class T, class Same>
bool areSame(const std::optional<T>& a, const std::optional<T>& b, const Same& same) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

// Structured bindings name every member, so that a new one is not forgotten here: it does not compile.
auto tie(const prescription::PrescribedCone& c) {
  const auto& [vertex, k, position, triangle] = c;
  return std::tie(vertex, k, position, triangle);
}
auto tie(const prescription::PrescribedTurning& t) {
  const auto& [loop, l, anchor] = t;
  return std::tie(loop, l, anchor);
}
auto tie(const prescription::PrescribedHandle& h) {
  const auto& [generator, r] = h;
  return std::tie(generator, r);
}
auto tie(const Matching& m) {
  const auto& [from, to, tail, head, turn] = m;
  return std::tie(from, to, tail, head, turn);
}
auto tie(const ImproveOptions& improve) {
  const auto& [balance, relativeDecrease, maxSteps, maxMultiplyAdds] = improve;
  return std::tie(balance, relativeDecrease, maxSteps, maxMultiplyAdds);
}
auto tie(const GridOptions& grid) {
  const auto& [cells, spacing, mode] = grid;
  return std::tie(cells, spacing, mode);
}
constexpr auto kTied = [](const auto& a, const auto& b) { return tie(a) == tie(b); };

bool isSameField(const FieldData& a, const FieldData& b) {
  const auto& [order, directions, matchings, hasMatchings] = a;
  return order == b.order && directions == b.directions && hasMatchings == b.hasMatchings &&
         areSame(matchings, b.matchings, kTied);
}

auto tie(const prescription::PrescribedLine& line) {
  const auto& [vertices, positions] = line;
  return std::tie(vertices, positions);
}
bool isSameFeatures(const prescription::PrescribedFeatures& a,
                    const prescription::PrescribedFeatures& b) {
  const auto& [hasRims, creaseDegrees, marks, lines, sides, sha256] = a;
  return std::tie(hasRims, creaseDegrees, marks, sides, sha256) ==
             std::tie(b.hasRims, b.creaseDegrees, b.marks, b.sides, b.sha256) &&
         areSame(lines, b.lines, [](const auto& c, const auto& d) { return tie(c) == tie(d); });
}

bool isSamePrescription(const prescription::Prescription& a, const prescription::Prescription& b) {
  const auto& [q, hasCones, cones, boundaries, handles, field, features, totalAngles, vertexCount,
               triangleCount, sha256, notes] = a;
  return std::tie(q, hasCones, totalAngles, vertexCount, triangleCount, sha256, notes) ==
             std::tie(b.q, b.hasCones, b.totalAngles, b.vertexCount, b.triangleCount, b.sha256,
                      b.notes) &&
         areSame(cones, b.cones, kTied) && areSame(boundaries, b.boundaries, kTied) &&
         areSame(handles, b.handles, kTied) && areSame(field, b.field, isSameField) &&
         isSameFeatures(features, b.features);
}

bool isSameOptions(const SolveOptions& a, const SolveOptions& b) {
  const auto& [q, coneCount, conesFor, alignToCurvature, boundary, maxRounds, method, improve,
               frames, scale, keepsGoing, refines, convexPolygons, grid, choosesCells, symmetry,
               progress] = a;
  static_cast<void>(progress);
  return std::tie(q, coneCount, conesFor, alignToCurvature, boundary, maxRounds, method, frames,
                  scale, keepsGoing, refines, convexPolygons, choosesCells, symmetry) ==
             std::tie(b.q, b.coneCount, b.conesFor, b.alignToCurvature, b.boundary, b.maxRounds,
                      b.method, b.frames, b.scale, b.keepsGoing, b.refines, b.convexPolygons,
                      b.choosesCells, b.symmetry) &&
         kTied(grid, b.grid) && areSame(improve, b.improve, kTied);
}

}  // namespace

bool isSame(const RunKey& a, const RunKey& b) {
  return a.isReproducible == b.isReproducible && isSameOptions(a.options, b.options) &&
         areSame(a.prescription, b.prescription, isSamePrescription);
}

}  // namespace hgp::api
