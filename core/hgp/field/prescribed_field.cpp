#include "hgp/field/prescribed_field.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/field/nearest_lattice_point.h"
#include "hgp/field/open_turning.h"

namespace hgp {
namespace {

/// Transport along each generator without the harmonic part.
Eigen::VectorXd coexactTransport(const TriMesh& mesh, const FieldContext& context,
                                 const PerEdge<double>& coexact) {
  Eigen::VectorXd natural =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(context.handles.loops.size()));
  for (Eigen::Index i = 0; i < natural.size(); ++i)
    for (HalfedgeId h : context.handles.loops[static_cast<std::size_t>(i)].crossed) {
      const double side = mesh.halfedge(mesh.edge(h)) == h ? 1.0 : -1.0;
      natural[i] += transport(mesh, context.geometry, h) + side * coexact[mesh.edge(h)];
    }
  return natural;
}

/// By how much each generator's transport must change. Open rotations are chosen by the smoothest connection and
/// written to `handles`.
Eigen::VectorXd handleCorrections(const Eigen::MatrixXd& periods, const Eigen::VectorXd& natural,
                                  int q, std::vector<std::optional<int>>& handles) {
  const Eigen::Index count = natural.size();
  Eigen::VectorXd offset(count), step(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::optional<int>& r = handles[static_cast<std::size_t>(i)];
    offset[i] = turnAngle(r.value_or(0), q) - natural[i];
    step[i] = 2.0 * kPi / (r ? 1 : q);
  }
  const Eigen::VectorXd correction = NearestLatticePoint(periods, step).round(offset);
  for (Eigen::Index i = 0; i < count; ++i) {
    std::optional<int>& r = handles[static_cast<std::size_t>(i)];
    if (!r)
      r = reduceTurn(static_cast<int>(std::lround((natural[i] + correction[i]) * q / (2.0 * kPi))),
                     q);
  }
  return correction;
}

/// Coefficients c of the harmonic forms that give generator j the transport 2π r_j/q.
Eigen::VectorXd handleCoefficients(const TriMesh& mesh, const FieldContext& context,
                                   const PerEdge<double>& coexact, const HolonomySpec& spec) {
  const std::size_t count = context.handles.loops.size();
  if (count == 0) return {};
  // A closed torus without cones must have trivial holonomy: with a rotation, every harmonic map is constant.
  const bool isFlatTorus =
      context.topology.genus == 1 && spec.cones.empty() && context.topology.loops.empty();
  std::vector<std::optional<int>> handles = spec.handles;
  handles.resize(count);
  if (isFlatTorus) handles.assign(count, 0);
  const Eigen::MatrixXd& periods = context.handles.periods;
  const Eigen::VectorXd natural = coexactTransport(mesh, context, coexact);
  const bool isComplete =
      std::all_of(handles.begin(), handles.end(), [](const auto& r) { return r.has_value(); });
  if (!isComplete) handleCorrections(periods, natural, spec.q, handles);
  // Computed from the completed rotations, even if they were open, so that prescribing them gives the same bits.
  return periods.ldlt().solve(handleCorrections(periods, natural, spec.q, handles));
}

/// The cone metric of a spec whose turnings are complete, and the part of the adjustment that comes from it.
struct ConeMetric {
  Eigen::VectorXd u;      ///< per node
  PerEdge<double> omega;  ///< w (u_head − u_tail)
};

ConeMetric coneMetricOf(const TriMesh& mesh, const FieldContext& context,
                        const HolonomySpec& spec) {
  const FilledSurface& surface = context.surface;
  Eigen::VectorXd gap = curvatureGap(surface, spec);
  HGP_CHECK(std::abs(gap.sum()) < 1e-6 * surface.nodeCount,
            "Gauss–Bonnet was checked, yet %g is left", gap.sum());
  gap.array() -= gap.mean();
  ConeMetric metric{context.laplacian.solve(gap),
                    PerEdge<double>(static_cast<std::size_t>(mesh.edgeCount()), 0.0)};
  const auto at = [&](VertexId v) { return metric.u[surface.node[v]]; };
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (!mesh.isBoundary(h))
      metric.omega[e] = surface.weight[e] * (at(mesh.head(h)) - at(mesh.tail(h)));
  }
  return metric;
}

/// Integrates the field along a breadth-first dual tree and computes the matchings, which are integers because the
/// connection is trivial.
void integrateField(const TriMesh& mesh, const Geometry& geometry, const PerEdge<double>& omega,
                    FrameField& field) {
  field.angle = PerFace<double>(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  field.matching = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  const auto turned = [&](HalfedgeId h) {
    const double side = mesh.halfedge(mesh.edge(h)) == h ? 1.0 : -1.0;
    return field.angle[TriMesh::face(h)] + transport(mesh, geometry, h) +
           side * omega[mesh.edge(h)];
  };
  PerFace<char> isSeen(static_cast<std::size_t>(mesh.faceCount()), 0);
  std::vector<FaceId> queue{FaceId(0)};
  isSeen[FaceId(0)] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(queue[next], k);
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.isValid() || isSeen[TriMesh::face(twin)]) continue;
      isSeen[TriMesh::face(twin)] = 1;
      field.angle[TriMesh::face(twin)] = principalAngle(turned(h));
      queue.push_back(TriMesh::face(twin));
    }
  }
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const HalfedgeId twin = mesh.twin(h);
    if (!twin.isValid()) continue;
    const double steps = (turned(h) - field.angle[TriMesh::face(twin)]) * field.q / (2.0 * kPi);
    field.matching[h] = static_cast<int>(std::lround(steps));
    field.matching[twin] = -field.matching[h];
    HGP_CHECK(std::abs(steps - std::round(steps)) < 1e-3,
              "a trivial connection has integer matchings, not %g", steps);
  }
}

}  // namespace

Result<PrescribedField> prescribedField(const TriMesh& mesh, const FieldContext& context,
                                        const HolonomySpec& spec) {
  PrescribedField result;
  HolonomySpec full = spec;
  const Result<std::vector<int>> turning = completeTurning(mesh, context, spec);
  if (!turning) return turning.error();
  full.turning.assign(turning->begin(), turning->end());

  const FilledSurface& surface = context.surface;
  auto [u, omega] = coneMetricOf(mesh, context, full);
  const Eigen::VectorXd c = handleCoefficients(mesh, context, omega, spec);
  const PerEdge<double> harmonic = combineForms(mesh, surface, context.handles, c);
  for (EdgeId e : mesh.edges()) {
    omega[e] += surface.weight[e] * harmonic[e];
    result.largestTurn = std::max(result.largestTurn, std::abs(omega[e]));
  }

  result.field.q = spec.q;
  integrateField(mesh, context.geometry, omega, result.field);
  result.spec.q = spec.q;
  result.spec.turning = *turning;
  for (const ConePoint& cone : spec.cones)
    if (cone.k != spec.q) result.spec.cones.push_back(cone);
  sortCones(result.spec.cones);
  for (const DualLoop& loop : context.handles.loops)
    result.spec.handles.push_back(loopHolonomy(result.field, loop));
  result.u = PerVertex<double>(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (VertexId v : mesh.vertices())
    if (surface.node[v] >= 0) result.u[v] = u[surface.node[v]];
  result.scaleRange = u.maxCoeff() - u.minCoeff();
  return result;
}

std::vector<std::vector<int>> otherHandles(const TriMesh& mesh, const FieldContext& context,
                                           const HolonomySpec& asked, const CompleteSpec& chosen) {
  const Eigen::MatrixXd& periods = context.handles.periods;
  const PerEdge<double> omega = coneMetricOf(mesh, context, toSpec(chosen)).omega;
  const Eigen::VectorXd natural = coexactTransport(mesh, context, omega);
  struct Choice {
    double energy;
    std::vector<int> handles;
  };
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < chosen.handles.size(); ++i) {
    if (i < asked.handles.size() && asked.handles[i]) continue;
    for (int step = 1; step < std::min(chosen.q, 3); ++step) {
      Choice choice{0.0, chosen.handles};
      choice.handles[i] = reduceTurn(choice.handles[i] + (step == 1 ? 1 : -1), chosen.q);
      std::vector<std::optional<int>> given(choice.handles.begin(), choice.handles.end());
      const Eigen::VectorXd change = handleCorrections(periods, natural, chosen.q, given);
      choice.energy = change.dot(periods.ldlt().solve(change));
      choices.push_back(std::move(choice));
    }
  }
  sortStably(choices, [](const Choice& a, const Choice& b) { return a.energy < b.energy; });
  std::vector<std::vector<int>> out;
  out.reserve(choices.size());
  for (Choice& choice : choices) out.push_back(std::move(choice.handles));
  return out;
}

}  // namespace hgp
