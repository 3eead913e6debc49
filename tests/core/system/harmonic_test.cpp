#include "hgp/system/harmonic.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <set>

#include "support/seamless.h"

namespace hgp {
namespace {

struct System {
  const test::CutSurface* surface;
  ReducedUnknowns unknowns;
  HarmonicSystem harmonic;
};

System systemOf(const test::CutSurface& s) {
  System system{&s, reduceUnknowns(s.mesh, s.cut, s.seams), {}};
  system.harmonic =
      harmonicSystem(s.mesh, s.context.geometry, s.cut, system.unknowns, s.seams.q, s.cones);
  return system;
}

const std::vector<System>& systems() {
  const std::vector<test::CutSurface>& surfaces = test::cutSurfaces();
  static const std::vector<System> all = [&] {
    std::vector<System> list;
    for (const test::CutSurface& s : surfaces) list.push_back(systemOf(s));
    return list;
  }();
  return all;
}

/// The unknowns of a map given by its copies.
Eigen::VectorXcd unknownsOf(const System& system, const Eigen::VectorXcd& z) {
  const test::CutSurface& s = *system.surface;
  Eigen::VectorXcd x = Eigen::VectorXcd::Zero(system.unknowns.count);
  for (VertexId v : s.mesh.vertices())
    if (system.unknowns.vertexUnknown[v] >= 0)
      x[system.unknowns.vertexUnknown[v]] = z[s.cut.firstCopy[v].i];
  for (std::size_t c = 0; c < s.cut.chains.size(); ++c) {
    if (system.unknowns.chainUnknown[c] < 0) continue;
    const HalfedgeId h = s.cut.chains[c].left[0];
    const Complex right = z[s.cut.copy[TriMesh::next(s.mesh.twin(h))].i];
    x[system.unknowns.chainUnknown[c]] =
        right - rotation(s.seams.rotation[h], s.seams.q) * z[s.cut.copy[h].i];
  }
  return x;
}

/// One row per interior vertex that is not a cone, (14) as Appendix A prints it: sectors between
/// seam edges, N*(v^s) = N(v^s) − {u^b_{s−1}}, corrections r_0 = 0, r_s = Σ θ_j.
Complex paperRow(const test::CutSurface& s, VertexId v, const Eigen::VectorXcd& z) {
  const Geometry& geometry = s.context.geometry;
  const auto weight = [&](HalfedgeId out) {  // Floater's w_ij along an edge leaving v
    const double alpha = geometry.cornerAngle[out];
    const double beta = geometry.cornerAngle[TriMesh::next(s.mesh.twin(out))];
    return (std::tan(alpha / 2) + std::tan(beta / 2)) / geometry.length[out];
  };
  std::vector<HalfedgeId> ring;
  for (HalfedgeId h : outgoingHalfedges(s.mesh, v)) ring.push_back(h);
  const std::size_t n = ring.size();
  const auto isSeam = [&](std::size_t i) { return s.cut.isSeam[s.mesh.edge(ring[i % n])] != 0; };
  std::size_t start = 0;  // where sector 0 begins
  while (start < n && !isSeam(start)) ++start;
  const bool hasSeam = start < n;
  if (!hasSeam) start = 0;
  int correction = 0;
  Complex sum = 0.0;
  double total = 0.0;
  for (std::size_t m = 0; m < n; ++m) {
    const HalfedgeId out = ring[(start + m) % n];
    if (m > 0 && isSeam(start + m)) {
      // θ: from the edge v^j → u^b_{j−1} to the edge v^{j−1} → u^a_{j−1}, that is from the face on
      // the left of the seam edge to the one on its right.
      correction += s.seams.rotation[out];
    }
    // The neighbour along `out` as the sector left of it sees it is u^b when `out` is a seam edge,
    // and left out there; the sector to its right has it as u^a, in its own turn.
    const HalfedgeId right = s.mesh.twin(out);
    const double w = weight(out);
    total += w;
    if (!isSeam(start + m)) {
      sum += w * rotation(correction, s.seams.q) *
             (z[s.cut.copy[out].i] - z[s.cut.copy[TriMesh::next(out)].i]);
      continue;
    }
    const int before = m == 0 ? 0 : correction - s.seams.rotation[out];
    if (m == 0) continue;  // closes the last sector, below
    sum += w * rotation(before, s.seams.q) *
           (z[s.cut.copy[TriMesh::next(right)].i] - z[s.cut.copy[right].i]);
  }
  if (hasSeam) {  // u_{d−1}: the edge after the last sector
    const HalfedgeId right = s.mesh.twin(ring[start]);
    sum += weight(ring[start]) * rotation(correction, s.seams.q) *
           (z[s.cut.copy[TriMesh::next(right)].i] - z[s.cut.copy[right].i]);
  }
  return sum / total;
}

TEST(HarmonicRows, AreThePapersFormulaForEveryDegree) {
  std::mt19937 random(67);
  std::set<int> degrees;
  for (const System& system : systems()) {
    const test::CutSurface& s = *system.surface;
    Eigen::VectorXcd x(system.unknowns.count);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = {test::randomReal(random), test::randomReal(random)};
    const Eigen::VectorXcd z = system.unknowns.copies * x;
    const Eigen::VectorXcd rows = system.harmonic.rows * x;
    for (std::size_t row = 0; row < system.harmonic.rowVertex.size(); ++row) {
      const VertexId v = system.harmonic.rowVertex[row];
      degrees.insert(s.seamDegree(v));
      EXPECT_LT(std::abs(rows[static_cast<Eigen::Index>(row)] - paperRow(s, v, z)),
                1e-11 * (1.0 + z.cwiseAbs().maxCoeff()))
          << s.name << " vertex " << v.i << " of degree " << s.seamDegree(v);
    }
  }
  for (int d : {0, 2, 3}) EXPECT_TRUE(degrees.count(d)) << "no vertex of degree " << d;
}

TEST(HarmonicRows, AreThoseOfInteriorVerticesWithoutACone) {
  for (const System& system : systems()) {
    const test::CutSurface& s = *system.surface;
    std::vector<VertexId> expected;
    for (VertexId v : s.mesh.vertices())
      if (!s.mesh.isBoundary(v) && !s.isCone(v)) expected.push_back(v);
    EXPECT_EQ(system.harmonic.rowVertex, expected) << s.name;
    EXPECT_EQ(system.harmonic.rows.rows(), static_cast<Eigen::Index>(expected.size()));
    EXPECT_EQ(system.harmonic.rows.cols(), system.unknowns.count);
  }
}

TEST(HarmonicRows, AnnihilateConstants) {
  for (const System& system : systems()) {
    const Eigen::VectorXcd z =
        Eigen::VectorXcd::Constant(system.surface->cut.vertexCount(), {2, 3});
    const Eigen::VectorXcd x = unknownsOf(system, z);
    EXPECT_LT((system.unknowns.copies * x - z).norm(), 1e-11) << system.surface->name;
    EXPECT_LT((system.harmonic.rows * x).norm(), 1e-11) << system.surface->name;
  }
}

TEST(HarmonicRows, CommuteWithRotationAndScale) {
  // L is complex linear: a similarity of the map multiplies Lz.
  std::mt19937 random(71);
  const System& system = systems()[systems().size() / 2];
  Eigen::VectorXcd x(system.unknowns.count);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = {test::randomReal(random), test::randomReal(random)};
  const Complex a(0.3, -1.7);
  EXPECT_LT((system.harmonic.rows * (a * x) - a * (system.harmonic.rows * x)).norm(), 1e-12);
}

/// The surface laid out with its own lengths, every face turned by its frame: the map whose f_z is
/// e^{−iθ} everywhere, where the surface is flat but for its cones.
Eigen::VectorXcd isometricMap(const test::CutSurface& s) {
  std::vector<Complex> z(static_cast<std::size_t>(s.cut.vertexCount()));
  std::vector<char> isSet(z.size(), 0);
  std::vector<FaceId> stack{FaceId(0)};
  PerFace<char> isSeen(static_cast<std::size_t>(s.mesh.faceCount()), 0);
  isSeen[FaceId(0)] = 1;
  isSet[static_cast<std::size_t>(s.cut.copy[HalfedgeId(0)].i)] = 1;
  while (!stack.empty()) {
    const FaceId f = stack.back();
    stack.pop_back();
    const auto& p = s.context.geometry.corner[f];
    const auto copy = [&](int k) {
      return static_cast<std::size_t>(s.cut.copy[TriMesh::halfedge(f, k)].i);
    };
    int known = 0;
    while (!isSet[copy(known)]) ++known;
    const auto at = static_cast<std::size_t>(known);
    for (int k = 0; k < 3; ++k) {
      z[copy(k)] = z[copy(known)] + std::polar(1.0, -s.seams.frameAngle[f]) *
                                        (p[static_cast<std::size_t>(k)] - p[at]);
      isSet[copy(k)] = 1;
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (s.mesh.isBoundary(h) || s.cut.isSeam[s.mesh.edge(h)]) continue;
      const FaceId g = TriMesh::face(s.mesh.twin(h));
      if (isSeen[g]) continue;
      isSeen[g] = 1;
      stack.push_back(g);
    }
  }
  return Eigen::Map<Eigen::VectorXcd>(z.data(), static_cast<Eigen::Index>(z.size()));
}

TEST(HarmonicRows, HaveLinearPrecisionAcrossSeams) {
  // Surfaces of unit cubes with their own cones, and flat pieces: the isometric layout is seamless
  // and harmonic, whatever the cut.
  for (const test::Shape& shape : {test::cube(3), test::doubleTorus(2), test::pretzel(3, 2),
                                   test::grid(6, 5), test::disk(4), test::annulus(9, 3)}) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    HolonomySpec spec;
    for (VertexId v : mesh.vertices()) {
      const int k = static_cast<int>(std::lround(geometry.angleSum[v] * 2 / kPi));
      if (!mesh.isBoundary(v) && k != 4) spec.cones.push_back({v, k});
    }
    // Flat pieces keep the turning that they have: 2π outside, −2π around a hole.
    for (const BoundaryLoop& loop : computeTopology(mesh).loops) {
      double turned = 0.0;
      for (HalfedgeId h : loop.halfedges) turned += curvature(mesh, geometry, mesh.tail(h));
      spec.turning.emplace_back(static_cast<int>(std::lround(turned * 2 / kPi)));
    }
    const auto s = test::cutSurface(shape.name, mesh, spec);
    ASSERT_TRUE(s) << shape.name;
    ASSERT_LT(s->field.scaleRange, 1e-9) << shape.name;
    const System system = systemOf(*s);
    const Eigen::VectorXcd z = isometricMap(*s);
    const Eigen::VectorXcd x = unknownsOf(system, z);
    EXPECT_LT((system.unknowns.copies * x - z).norm(), 1e-9) << shape.name << ": (12)";
    EXPECT_LT((system.harmonic.rows * x).norm(), 1e-9) << shape.name << ": (14)";
  }
}

}  // namespace
}  // namespace hgp
