#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/parametrize/strategy/moves/moves.h"

namespace hgp {
namespace {

/// The paper's runs took at most four programs.
constexpr int kIterations = 10;

Complex cornerOf(const Problem& problem, const Attempt& attempt, FaceId f, int k) {
  const int copy = problem.setup->cut.copy[TriMesh::halfedge(f, k)].i;
  return attempt.program.z[static_cast<std::size_t>(copy)];
}

/// The surface's geometry with lengths and angles that the map induces.
Geometry inducedGeometry(const Problem& problem, const Attempt& attempt) {
  Geometry geometry = problem.setup->context->geometry;
  for (FaceId f : problem.mesh.faces())
    for (int k = 0; k < 3; ++k) {
      const Complex a =
          cornerOf(problem, attempt, f, (k + 1) % 3) - cornerOf(problem, attempt, f, k);
      const Complex b =
          cornerOf(problem, attempt, f, (k + 2) % 3) - cornerOf(problem, attempt, f, k);
      const HalfedgeId h = TriMesh::halfedge(f, k);
      geometry.length[h] = portable::abs(a);
      geometry.cornerAngle[h] = std::abs(portable::arg(std::conj(a) * b));
    }
  return geometry;
}

}  // namespace

std::optional<State> iterateFrames(const Problem& problem, const State& state,
                                   const std::shared_ptr<const Attempt>& attempt) {
  if (problem.method != Method::kPrinted || state.growth >= kIterations) return {};
  if (!attempt->isFeasible() || attempt->program.z.empty() || !attempt->program.x.allFinite())
    return {};
  State next = state;
  ++next.growth;
  next.from = attempt;
  Frames frames;
  for (FaceId f : problem.base) {
    const LinearParts parts = linearParts(problem.setup->context->geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k)
      similarity +=
          parts.similarity[static_cast<std::size_t>(k)] * cornerOf(problem, *attempt, f, k);
    frames.faces.push_back(f);
    frames.angles.push_back(-portable::arg(similarity));
  }
  next.directions = std::make_shared<const Frames>(std::move(frames));
  next.harmonic = std::make_shared<const HarmonicSystem>(
      harmonicSystem(problem.mesh, inducedGeometry(problem, *attempt), problem.setup->cut,
                     problem.setup->unknowns, problem.setup->seams.q, problem.setup->cones));
  return next;
}

}  // namespace hgp
