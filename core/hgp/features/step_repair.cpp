#include "hgp/features/step_repair.h"

#include <algorithm>

#include "hgp/base/stable_order.h"
#include "hgp/features/index_flow.h"

namespace hgp {
namespace {

/// Longer runs are no steps.
constexpr std::size_t kLongestRun = 200;

int indexAt(const TriMesh& mesh, const AlignedField& field, HalfedgeId corner) {
  return field.index[at(field.sectors.node(mesh, corner))];
}

/// The feature halfedge that begins the sector in which `into` ends, and the one that ends the sector that `out` begins.
HalfedgeId after(const AlignedField& field, HalfedgeId into) {
  return field.sectors.list[at(field.sectors.of[TriMesh::next(into)])].first;
}
HalfedgeId before(const AlignedField& field, HalfedgeId out) {
  return field.sectors.list[at(field.sectors.of[out])].last;
}

}  // namespace

std::vector<HalfedgeId> straightRun(const TriMesh& mesh, const AlignedField& field, HalfedgeId h) {
  std::vector<HalfedgeId> run{h};
  while (run.size() < kLongestRun && indexAt(mesh, field, run.front()) == 2)
    run.insert(run.begin(), before(field, run.front()));
  while (run.size() < kLongestRun && indexAt(mesh, field, TriMesh::next(run.back())) == 2)
    run.push_back(after(field, run.back()));
  return run;
}

std::vector<FeatureStep> findSteps(const TriMesh& mesh, const Geometry& geometry,
                                   const AlignedField& field,
                                   const std::vector<HalfedgeId>& edges) {
  struct Found {
    double length;
    FeatureStep step;
  };
  std::vector<Found> found;
  for (HalfedgeId edge : edges)
    for (const HalfedgeId h : {edge, mesh.twin(edge)}) {
      if (!h.isValid()) continue;
      FeatureStep step{straightRun(mesh, field, h), 0};
      const int tail = indexAt(mesh, field, step.run.front());
      const int head = indexAt(mesh, field, TriMesh::next(step.run.back()));
      if (tail == 1 && head >= 3) step.units = -1;
      if (head == 1 && tail >= 3) step.units = 1;
      if (step.units == 0) continue;
      double length = 0.0;
      for (HalfedgeId g : step.run) length += geometry.length[g];
      const auto isSame = [&](const Found& f) { return f.step.run == step.run; };
      if (std::none_of(found.begin(), found.end(), isSame))
        found.push_back({length, std::move(step)});
    }
  sortStably(found, [](const Found& a, const Found& b) { return a.length < b.length; });
  std::vector<FeatureStep> steps;
  steps.reserve(found.size());
  for (Found& f : found) steps.push_back(std::move(f.step));
  return steps;
}

AlignedField withoutStep(const TriMesh& mesh, AlignedField field, const FeatureStep& step) {
  for (HalfedgeId h : step.run) moveUnit(mesh, h, step.units, field);
  return field;
}

}  // namespace hgp
