#include "hgp/optimize/program.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/optimize/solved.h"
#include "hgp/optimize/harmonic_basis.h"

namespace hgp {
namespace {

using socp::SolveStatus;

/// Problems of several kinds that the weighted program certifies at once.
std::vector<test::SeamlessProblem> easyProblems() {
  std::vector<test::SeamlessProblem> problems;
  problems.push_back(test::sphereProblem(4, 4, {3, 3, 3, 3, 3, 3, 3, 3}));
  problems.push_back(test::sphereProblem(4, 6, {4, 4, 4, 4, 5, 5, 5, 5}));
  for (const test::Shape& shape : {test::doubleTorus(2), test::cube(3)}) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    HolonomySpec spec;
    for (VertexId v : mesh.vertices()) {
      const int k = static_cast<int>(std::lround(geometry.angleSum[v] * 2 / kPi));
      if (k != 4) spec.cones.push_back({v, k});
    }
    problems.push_back(test::problemOf(*test::cutSurface(shape.name, mesh, spec)));
  }
  problems.push_back(test::problemOf(*test::cutSurface("disk", test::disk(5).mesh(), {})));
  problems.push_back(
      test::problemOf(*test::cutSurface("annulus", test::annulus(12, 3).mesh(), {})));
  problems.push_back(test::problemOf(*test::cutSurface("torus", test::torus(12, 8).mesh(), {})));
  return problems;
}

TEST(Program, FulfilsEveryFrameConditionAndEverySeam) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    const Frames frames = p.frames();
    const ProgramOptions options = p.weightedOptions();
    const ProgramResult result = p.solve(frames, options);
    EXPECT_EQ(result.status, SolveStatus::kOptimal) << p.surface.name;
    ASSERT_EQ(static_cast<int>(result.z.size()), p.surface.cut.vertexCount());
    for (std::size_t j = 0; j < frames.faces.size(); ++j) {
      const auto [similarity, antisimilarity] = p.partsOf(frames.faces[j], result.z);
      double scale = 0.0;
      for (VertexId v : p.surface.mesh.corners(frames.faces[j])) scale += options.u[v] / 3;
      const double left =
          (similarity * std::polar(1.0, frames.angles[j])).real() - std::abs(antisimilarity);
      EXPECT_GT(left, 0.999 * options.margin * std::exp(scale)) << p.surface.name;
    }
    double extent = 0.0;
    for (const Complex& value : result.z) extent = std::max(extent, std::abs(value));
    const CutMesh& cut = p.surface.cut;
    for (HalfedgeId h : p.surface.mesh.halfedges()) {
      if (p.surface.mesh.isBoundary(h)) continue;
      const auto at = [&](HalfedgeId g) {
        return result.z[static_cast<std::size_t>(cut.copy[g].i)];
      };
      const HalfedgeId twin = p.surface.mesh.twin(h);
      const Complex turned =
          rotation(p.surface.seams.rotation[h], p.surface.seams.q) * (at(TriMesh::next(h)) - at(h));
      EXPECT_LT(std::abs(at(twin) - at(TriMesh::next(twin)) - turned), 1e-12 * extent)
          << p.surface.name;
    }
    EXPECT_TRUE(p.certify(result.z).isCertified) << p.surface.name;
  }
}

/// L z at the rows whose vertex no face of `frames` touches, the largest of them.
double residualAway(const test::SeamlessProblem& p, const std::vector<FaceId>& faces,
                    const std::vector<Complex>& z) {
  PerVertex<char> isTouched(static_cast<std::size_t>(p.surface.mesh.vertexCount()), 0);
  for (FaceId f : faces)
    for (VertexId v : p.surface.mesh.corners(f)) isTouched[v] = 1;
  double largest = 0.0;
  for (VertexId v : p.harmonic.rowVertex) {
    if (isTouched[v]) continue;
    Complex sum = 0.0;
    double total = 0.0;
    for (HalfedgeId h : outgoingHalfedges(p.surface.mesh, v)) {
      const auto at = [&](HalfedgeId g) {
        return z[static_cast<std::size_t>(p.surface.cut.copy[g].i)];
      };
      const CornerWeights w = meanValueWeights(p.surface.context.geometry, h);
      const Complex back = rotation(-p.unknowns.turn[p.surface.cut.copy[h]], p.surface.seams.q);
      sum += back * (w.toHead * (at(h) - at(TriMesh::next(h))) +
                     w.toThird * (at(h) - at(TriMesh::previous(h))));
      total += w.toHead + w.toThird;
    }
    largest = std::max(largest, std::abs(sum) / total);
  }
  return largest;
}

double extentOf(const std::vector<Complex>& z) {
  double extent = 0.0;
  for (const Complex& value : z) extent = std::max(extent, std::abs(value));
  return extent;
}

TEST(Program, TheExactFormIsHarmonicWhereNoFrameReaches) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    const Frames frames = p.frames();
    ProgramOptions options = p.weightedOptions();
    options.objective = ExactObjective(p.surface.context.tree);
    const ProgramResult result = p.solve(frames, options);
    ASSERT_FALSE(result.z.empty()) << p.surface.name;
    EXPECT_LT(residualAway(p, frames.faces, result.z), 1e-11 * extentOf(result.z))
        << p.surface.name;
    EXPECT_TRUE(p.certify(result.z).isCertified) << p.surface.name;
  }
}

/// What the exact form minimises: ‖D L z‖² + the tie-break's distortion of the frames' faces.
double exactObjective(const test::SeamlessProblem& p, const Frames& frames,
                      const ProgramOptions& options, const Eigen::VectorXcd& x) {
  double value = 0.0;
  const Eigen::VectorXcd residual = p.harmonic.rows * x;
  for (Eigen::Index r = 0; r < residual.size(); ++r)
    value += std::exp(-2.0 * options.u[p.harmonic.rowVertex[static_cast<std::size_t>(r)]]) *
             std::norm(residual[r]);
  const Eigen::VectorXcd copies = p.unknowns.copies * x;
  const std::vector<Complex> z(copies.data(), copies.data() + copies.size());
  for (FaceId f : frames.faces) {
    double u = 0.0;
    for (VertexId v : p.surface.mesh.corners(f)) u += options.u[v] / 3.0;
    const auto [similar, anti] = p.partsOf(f, z);
    const Complex turned = similar * std::polar(1.0, p.surface.seams.frameAngle[f]);
    value += options.tieBreak * p.surface.context.geometry.area[f] * std::exp(-2.0 * u) *
             (std::norm(turned - std::exp(u)) + std::norm(anti));
  }
  return value;
}

TEST(Program, NoFeasibleNeighbourOfTheExactFormIsBetter) {
  // Cones of very different angle, so that u, by which rows are weighted, ranges widely.
  const test::SeamlessProblem p = test::sphereProblem(4, 4, {1, 2, 3, 3, 5, 6, 3, 1});
  const Frames frames = p.frames();
  ProgramOptions options = p.weightedOptions();
  options.objective = ExactObjective(p.surface.context.tree);
  const ProgramResult best = p.solve(frames, options);
  ASSERT_EQ(best.status, SolveStatus::kOptimal);
  const double minimum = exactObjective(p, frames, options, best.x);
  for (double factor : {1.2, 2.0}) {
    for (double tieBreak : {1e-6, 1e-3, 1e-1}) {
      ProgramOptions other = options;
      other.margin *= factor;
      other.tieBreak = tieBreak;
      const ProgramResult rival = p.solve(frames, other);
      ASSERT_EQ(rival.status, SolveStatus::kOptimal);
      for (double share : {1e-2, 0.1, 1.0}) {
        const Eigen::VectorXcd mixed = best.x + share * (rival.x - best.x);
        EXPECT_GE(exactObjective(p, frames, options, mixed), minimum * (1 - 1e-5))
            << factor << " " << tieBreak << " " << share;
      }
    }
  }
}

/// Σ A e^{−2u} (|f_z − e^u d|² + |f_z̄|²) over all faces.
double distortionOf(const test::SeamlessProblem& p, const ProgramOptions& options,
                    const std::vector<Complex>& z) {
  double value = 0.0;
  for (FaceId f : p.surface.mesh.faces()) {
    double u = 0.0;
    for (VertexId v : p.surface.mesh.corners(f)) u += options.u[v] / 3.0;
    const auto [similar, anti] = p.partsOf(f, z);
    const Complex turned = similar * std::polar(1.0, p.surface.seams.frameAngle[f]);
    value += p.surface.context.geometry.area[f] * std::exp(-2.0 * u) *
             (std::norm(turned - std::exp(u)) + std::norm(anti));
  }
  return value;
}

bool isFlatTorus(const test::SeamlessProblem& p) {
  return p.surface.cones.empty() && p.surface.context.topology.loops.empty();
}

TEST(Program, TheHarmonicFormIsHarmonicAtEveryVertexAndOfLeastDistortion) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    ProgramOptions options = p.weightedOptions();
    const auto basis = HarmonicBasis::make(p.system(), options.u, p.surface.context.tree);
    ASSERT_TRUE(basis) << p.surface.name;
    options.objective = HarmonicObjective{basis};
    const ProgramResult free = p.solve({}, options), framed = p.solve(p.frames(), options);
    for (const ProgramResult* result : {&free, &framed}) {
      ASSERT_FALSE(result->z.empty()) << p.surface.name;
      EXPECT_LT(residualAway(p, {}, result->z), 1e-11 * extentOf(result->z)) << p.surface.name;
    }
    EXPECT_TRUE(p.certify(framed.z).isCertified) << p.surface.name;
    const double least = distortionOf(p, options, free.z);
    EXPECT_GE(distortionOf(p, options, framed.z), least * (1 - 1e-9) - 1e-20) << p.surface.name;
    for (int draw = 0; draw < 5; ++draw) {
      const Eigen::VectorXcd y = Eigen::VectorXcd::Random(basis->count());
      const Eigen::VectorXcd other = p.unknowns.copies * (free.x + 1e-3 * basis->expand(y));
      EXPECT_GT(distortionOf(p, options, {other.data(), other.data() + other.size()}), least)
          << p.surface.name;
    }
  }
}

TEST(Program, AFlatTorusHasHarmonicMapsForWeightsThatAreEqualAtBothEndsOfAnEdge) {
  // The weights of regular triangles are equal by symmetry.
  for (const auto& [amount, hasMeanValue] : {std::pair{0.0, true}, {0.05, false}}) {
    const test::Shape shape = test::jittered(test::torus(12, 8), amount);
    test::SeamlessProblem p = test::problemOf(*test::cutSurface(shape.name, shape.mesh(), {}));
    const test::CutSurface& s = p.surface;
    const auto meanValue = HarmonicBasis::make(p.system(), p.weightedOptions().u, s.context.tree);
    EXPECT_EQ(meanValue != nullptr, hasMeanValue);
    p.harmonic = harmonicSystem(s.mesh, s.context.geometry, s.cut, p.unknowns, s.seams.q, s.cones,
                                WeightKind::kCotangent);
    ProgramOptions options = p.weightedOptions();
    const auto basis = HarmonicBasis::make(p.system(), options.u, s.context.tree);
    ASSERT_TRUE(basis) << s.name;
    EXPECT_EQ(basis->count(), 2) << "its translations";
    EXPECT_EQ(HarmonicBasis::countOf(p.system()), 2);
    options.objective = HarmonicObjective{basis};
    const ProgramResult result = p.solve({}, options);
    const Eigen::VectorXcd residual = p.harmonic.rows * result.x;
    EXPECT_EQ(residual.size(), s.mesh.vertexCount()) << "the row of the held vertex as well";
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-12 * extentOf(result.z)) << s.name;
    EXPECT_TRUE(p.certify(result.z).isCertified) << s.name;
  }
}

TEST(Program, TheHarmonicMapOfAPenaltyFormIsThatOfTheHarmonicForm) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    if (isFlatTorus(p)) continue;
    ProgramOptions options = p.weightedOptions();
    options.objective =
        HarmonicObjective{HarmonicBasis::make(p.system(), options.u, p.surface.context.tree)};
    const ProgramResult dense = p.solve({}, options);
    options.objective = PenaltyObjective{1e-4, WholeSurface{}, nullptr, true};
    const ProgramResult sparse = p.solve({}, options);
    ASSERT_EQ(sparse.z.size(), dense.z.size()) << p.surface.name;
    const double extent = extentOf(dense.z);
    EXPECT_LT(residualAway(p, {}, sparse.z), 1e-11 * extent) << p.surface.name;
    // The two forms hold different vertices at 0.
    for (std::size_t i = 0; i < dense.z.size(); ++i)
      EXPECT_LT(std::abs((sparse.z[i] - sparse.z[0]) - (dense.z[i] - dense.z[0])), 1e-6 * extent)
          << p.surface.name;
  }
}

TEST(Program, TheHarmonicFormFulfilsFrameConditionsThatBind) {
  const test::SeamlessProblem p = test::sphereProblem(4, 4, {1, 2, 3, 3, 5, 6, 3, 1});
  ProgramOptions options = p.weightedOptions();
  options.margin = 0.5;
  options.objective =
      HarmonicObjective{HarmonicBasis::make(p.system(), options.u, p.surface.context.tree)};
  const Frames frames = p.frames();
  const ProgramResult free = p.solve({}, options), framed = p.solve(frames, options);
  ASSERT_EQ(framed.status, SolveStatus::kOptimal);
  const auto least = [&](const ProgramResult& result) {
    double smallest = 1e300;
    for (std::size_t j = 0; j < frames.faces.size(); ++j) {
      const auto [similar, anti] = p.partsOf(frames.faces[j], result.z);
      double u = 0.0;
      for (VertexId v : p.surface.mesh.corners(frames.faces[j])) u += options.u[v] / 3.0;
      smallest = std::min(
          smallest,
          ((similar * std::polar(1.0, frames.angles[j])).real() - std::abs(anti)) * std::exp(-u));
    }
    return smallest;
  };
  EXPECT_LT(least(free), options.margin) << "an example that shows nothing";
  EXPECT_GT(least(framed), 0.99 * options.margin);
  EXPECT_LT(residualAway(p, {}, framed.z), 1e-11 * extentOf(framed.z));
}

TEST(Program, SoftFrameConstraintsNeedNoIteration) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    const std::vector<FaceId> faces = p.frames().faces;
    for (const bool isExact : {false, true}) {
      ProgramOptions options = p.weightedOptions();
      if (isExact) options.objective = ExactObjective(p.surface.context.tree);
      options.soft = {faces, 0.3};
      const ProgramResult result = p.solve({}, options);
      ASSERT_FALSE(result.z.empty()) << p.surface.name;
      EXPECT_LE(result.iterations, 1) << p.surface.name;
      if (isExact) {
        EXPECT_LT(residualAway(p, faces, result.z), 1e-11 * extentOf(result.z)) << p.surface.name;
      }
    }
  }
}

/// The vertices within `rings` of the middle one.
Patch partAround(const test::SeamlessProblem& p, int rings, const Eigen::VectorXcd& x) {
  Patch part{std::vector<char>(static_cast<std::size_t>(p.unknowns.count), 0), x};
  const FaceId middle(p.surface.mesh.faceCount() / 2);
  for (FaceId f : growFaces(p.surface.mesh, {middle}, rings))
    for (VertexId v : p.surface.mesh.corners(f))
      if (p.unknowns.vertexUnknown[v] >= 0)
        part.isFree[static_cast<std::size_t>(p.unknowns.vertexUnknown[v])] = 1;
  return part;
}

TEST(Program, ADisturbedPartReturnsToTheMinimumAndTheRestStays) {
  for (const test::SeamlessProblem& p : easyProblems()) {
    for (const bool isBound : {false, true}) {
      ProgramOptions options = p.weightedOptions();
      Frames frames = p.frames();
      const double quality = isBound ? 1e-2 : 0.0;
      if (!isBound) {
        options.soft = {frames.faces, 0.3};
        frames = {};
      } else {
        options.objective = PenaltyObjective{quality, WholeSurface{}};
      }
      const ProgramResult whole = p.solve(frames, options);
      Patch part = partAround(p, 1, whole.x);
      int freeCount = 0;
      for (std::size_t i = 0; i < part.isFree.size(); ++i) {
        if (!part.isFree[i]) continue;
        part.x[static_cast<Eigen::Index>(i)] += Complex(0.3 * (freeCount % 3), -0.2);
        ++freeCount;
      }
      ASSERT_GT(freeCount, 0) << p.surface.name;
      ASSERT_LT(freeCount, p.unknowns.count) << p.surface.name;
      options.objective = PenaltyObjective{quality, part};
      Frames within;
      for (std::size_t j = 0; j < frames.faces.size(); ++j) {
        bool isTouched = false;
        for (VertexId v : p.surface.mesh.corners(frames.faces[j])) {
          const int unknown = p.unknowns.vertexUnknown[v];
          isTouched |= unknown >= 0 && part.isFree[static_cast<std::size_t>(unknown)];
        }
        if (!isTouched) continue;
        within.faces.push_back(frames.faces[j]);
        within.angles.push_back(frames.angles[j]);
      }
      const ProgramResult again = p.solve(within, options);
      const double extent = extentOf(whole.z), tolerance = isBound ? 1e-4 : 1e-10;
      for (int i = 0; i < p.unknowns.count; ++i) {
        if (part.isFree[static_cast<std::size_t>(i)])
          EXPECT_LT(std::abs(again.x[i] - whole.x[i]), tolerance * extent) << p.surface.name;
        else
          EXPECT_EQ(again.x[i], whole.x[i]) << p.surface.name;
      }
    }
  }
}

TEST(Program, ReportsTheLaplacianEnergyOfItsMap) {
  // ‖Lz‖² row by row, from the map alone: (14) over the copies.
  for (const test::SeamlessProblem& p : easyProblems()) {
    const ProgramResult result = p.solve(p.frames(), p.weightedOptions());
    const Geometry& geometry = p.surface.context.geometry;
    double energy = 0.0;
    for (VertexId v : p.harmonic.rowVertex) {
      Complex sum = 0.0;
      double total = 0.0;
      for (HalfedgeId h : outgoingHalfedges(p.surface.mesh, v)) {
        const auto at = [&](HalfedgeId g) {
          return result.z[static_cast<std::size_t>(p.surface.cut.copy[g].i)];
        };
        const CornerWeights w = meanValueWeights(geometry, h);
        const Complex back = rotation(-p.unknowns.turn[p.surface.cut.copy[h]], p.surface.seams.q);
        sum += back * (w.toHead * (at(h) - at(TriMesh::next(h))) +
                       w.toThird * (at(h) - at(TriMesh::previous(h))));
        total += w.toHead + w.toThird;
      }
      energy += std::norm(sum / total);
    }
    EXPECT_NEAR(result.laplacianEnergy, energy, 1e-9 * (1e-6 + energy)) << p.surface.name;
  }
}

TEST(Program, IsHarmonicWhereAHarmonicMapExists) {
  // Three cones on a sphere, a disk, a torus: the printed program has minimum 0.
  std::vector<test::SeamlessProblem> problems;
  problems.push_back(test::sphereProblem(4, 3, {1, 1, 1}));
  problems.push_back(test::problemOf(*test::cutSurface("disk", test::disk(4).mesh(), {})));
  problems.push_back(test::problemOf(*test::cutSurface("torus", test::torus(9, 6).mesh(), {})));
  for (const test::SeamlessProblem& p : problems) {
    ProgramOptions options = p.plainOptions();
    options.tieBreak = 1e-9;
    const ProgramResult result = p.solve(p.frames(), options);
    double size = 0.0;
    for (FaceId f : p.surface.mesh.faces()) size += std::norm(p.partsOf(f, result.z).first);
    EXPECT_LT(result.laplacianEnergy, 1e-8 * size) << p.surface.name;
  }
}

TEST(Program, ScalesWithTheConformalFactor) {
  // u + c everywhere: the map becomes e^c times larger, nothing else.
  const test::SeamlessProblem p = test::sphereProblem(3, 4, {3, 3, 3, 3, 3, 3, 3, 3});
  ProgramOptions options = p.weightedOptions();
  const ProgramResult small = p.solve(p.frames(), options);
  for (double& value : options.u.raw()) value += std::log(7.0);
  const ProgramResult large = p.solve(p.frames(), options);
  const Complex origin = small.z[0], far = large.z[0];
  double extent = 0.0;
  for (const Complex& value : large.z) extent = std::max(extent, std::abs(value - far));
  for (std::size_t c = 0; c < small.z.size(); ++c)
    EXPECT_LT(std::abs(7.0 * (small.z[c] - origin) - (large.z[c] - far)), 1e-4 * extent);
}

TEST(Program, NoFeasibleNeighbourIsBetter) {
  // A convex program: moving towards any other feasible map must not lower the objective.
  const test::SeamlessProblem p = test::sphereProblem(3, 4, {2, 3, 3, 3, 3, 3, 3});
  ProgramOptions options = p.plainOptions();
  constexpr double kQuality = 1e-2;
  options.objective = PenaltyObjective{kQuality, WholeSurface{}};
  const ProgramResult best = p.solve(p.frames(), options);
  ASSERT_EQ(best.status, SolveStatus::kOptimal);
  const auto objective = [&](const std::vector<Complex>& z) {
    double value = 0.0;
    for (FaceId f : p.surface.mesh.faces()) {
      const auto [similarity, antisimilarity] = p.partsOf(f, z);
      value += 0.5 * kQuality * p.surface.context.geometry.area[f] *
               (std::norm(similarity * std::polar(1.0, p.surface.seams.frameAngle[f]) - 1.0) +
                std::norm(antisimilarity));
    }
    Eigen::VectorXcd x = Eigen::VectorXcd::Zero(p.unknowns.count);
    for (VertexId v : p.surface.mesh.vertices())
      if (p.unknowns.vertexUnknown[v] >= 0)
        x[p.unknowns.vertexUnknown[v]] = z[static_cast<std::size_t>(p.surface.cut.firstCopy[v].i)];
    for (std::size_t c = 0; c < p.surface.cut.chains.size(); ++c) {
      if (p.unknowns.chainUnknown[c] < 0) continue;
      const HalfedgeId h = p.surface.cut.chains[c].left[0];
      const HalfedgeId twin = p.surface.mesh.twin(h);
      x[p.unknowns.chainUnknown[c]] =
          z[static_cast<std::size_t>(p.surface.cut.copy[TriMesh::next(twin)].i)] -
          rotation(p.surface.seams.rotation[h], p.surface.seams.q) *
              z[static_cast<std::size_t>(p.surface.cut.copy[h].i)];
    }
    return value + 0.5 * (p.harmonic.rows * x).squaredNorm();
  };
  const double minimum = objective(best.z);
  for (double other : {1e-4, 1e-3, 0.1, 1.0}) {
    ProgramOptions different = options;
    different.objective = PenaltyObjective{other, WholeSurface{}};
    const ProgramResult rival = p.solve(p.frames(), different);
    for (double share : {1e-3, 0.1, 1.0}) {
      std::vector<Complex> mixed = best.z;
      for (std::size_t c = 0; c < mixed.size(); ++c) mixed[c] += share * (rival.z[c] - best.z[c]);
      EXPECT_GE(objective(mixed), minimum * (1 - 1e-6)) << other << " " << share;
    }
  }
}

TEST(Program, FramesThatContradictEachOtherAreNotCalledSolved) {
  // Two faces of one flat piece asked to turn into opposite directions, with all between them.
  const test::SeamlessProblem p =
      test::problemOf(*test::cutSurface("disk", test::disk(3).mesh(), {}));
  Frames frames;
  for (FaceId f : p.surface.mesh.faces()) {
    frames.faces.push_back(f);
    frames.angles.push_back(p.surface.seams.frameAngle[f]);
  }
  // Around the centre the frames turn once more than the plane does.
  int n = 0;
  for (HalfedgeId h : outgoingHalfedges(p.surface.mesh, VertexId(0)))
    frames.angles[static_cast<std::size_t>(TriMesh::face(h).i)] += 2 * kPi * (n++) / 6;
  const ProgramResult result = p.solve(frames, p.plainOptions());
  EXPECT_NE(result.status, SolveStatus::kOptimal);
  EXPECT_NE(result.status, SolveStatus::kAlmost);
  if (result.status != SolveStatus::kInfeasible) return;  // a short step may end it first
  ASSERT_FALSE(result.strained.empty());
  int near = 0;
  for (FaceId f : result.strained)
    for (VertexId v : p.surface.mesh.corners(f)) near += v == VertexId(0);
  EXPECT_GT(near, 0);
}

TEST(Program, AConflictNamesTheFramesThatContradictEachOtherAndNoOthers) {
  // Two neighbours asked to turn their common edge in opposite directions, and one frame far away.
  const test::SeamlessProblem p =
      test::problemOf(*test::cutSurface("disk", test::disk(4).mesh(), {}));
  const TriMesh& mesh = p.surface.mesh;
  const HalfedgeId h = mesh.outgoing(VertexId(0));
  std::vector<FaceId> opposed{TriMesh::face(h), TriMesh::face(mesh.twin(h))};
  std::sort(opposed.begin(), opposed.end());
  FaceId far(0);
  for (FaceId f : mesh.faces())
    for (VertexId v : mesh.corners(f))
      if (mesh.isBoundary(v)) far = f;
  Frames frames;
  frames.faces = {opposed[0], opposed[1], far};
  std::sort(frames.faces.begin(), frames.faces.end());
  for (FaceId f : frames.faces)
    frames.angles.push_back(p.surface.seams.frameAngle[f] + (f == opposed[0] ? kPi : 0.0));
  const ProgramResult result = p.solve(frames, p.plainOptions());
  ASSERT_EQ(result.status, SolveStatus::kInfeasible) << socp::statusName(result.status);
  std::vector<FaceId> strained = result.strained;
  std::sort(strained.begin(), strained.end());
  EXPECT_EQ(strained, opposed);
}

TEST(Program, SolvesASurfaceWhoseVerticesAreAllCones) {
  // No vertex is free to be held: four corners of π, the tetrahedron's own, unfold isometrically.
  HolonomySpec spec;
  for (int i = 0; i < 4; ++i) spec.cones.push_back({VertexId(i), 2});
  const test::SeamlessProblem p =
      test::problemOf(*test::cutSurface("tetrahedron", test::tetrahedron().mesh(), spec));
  for (VertexId v : p.surface.mesh.vertices()) ASSERT_LT(p.unknowns.vertexUnknown[v], 0);
  const ProgramResult result = p.solve(p.frames(), p.plainOptions());
  EXPECT_EQ(result.status, SolveStatus::kOptimal) << socp::statusName(result.status);
  const Certificate certificate = p.certify(result.z);
  EXPECT_TRUE(certificate.isCertified);
  EXPECT_LT(certificate.distortion.maxMu, 1e-3);
}

TEST(Program, CancelIsReported) {
  const test::SeamlessProblem p = test::sphereProblem(3, 4, {3, 3, 3, 3, 3, 3, 3, 3});
  ProgramOptions options = p.plainOptions();
  options.progress = [](int, double) { return false; };
  EXPECT_EQ(p.solve(p.frames(), options).status, SolveStatus::kCancelled);
  options.margin = 0.9;  // binds: iterations are needed
  options.progress = [](int iteration, double) { return iteration < 1; };
  EXPECT_EQ(p.solve(p.frames(), options).status, SolveStatus::kCancelled);
}

TEST(Program, TheDistortionTermHasNoEffectWhereAnExactlyHarmonicMapExists) {
  for (const test::SeamlessProblem& p :
       {test::sphereProblem(3, 4, {2, 2, 2, 2}), test::sphereProblem(3, 2, {1, 1, 1, 1})}) {
    ProgramOptions options = p.weightedOptions();
    const ProgramResult light = p.solve(p.frames(), options);
    options.tieBreak *= 10.0;
    const ProgramResult heavy = p.solve(p.frames(), options);
    EXPECT_LT(light.laplacianEnergy, 1e-20) << p.surface.name;
    EXPECT_LT(heavy.laplacianEnergy, 1e-20) << p.surface.name;
  }
}

}  // namespace
}  // namespace hgp
