#include "hgp/optimize/untangle.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "hgp/optimize/fold_barrier.h"
#include "hgp/optimize/kernels.h"
#include "solved.h"
#include "support/random.h"

namespace hgp {
namespace {

double freeValue(Complex similar, Complex anti, double epsilon) {
  const double P = std::norm(similar), Q = std::norm(anti);
  return barrierValue(P + Q, P - Q, 0.3, epsilon);
}

double framedValue(Complex similar, Complex anti, double epsilon) {
  const double A = similar.real(), Q = std::norm(anti);
  return barrierValue(std::norm(similar) + Q, A * std::sqrt(A * A + epsilon) - Q, 0.3, epsilon);
}

TEST(FoldBarrier, SlopesAreThoseOfTheValueAndModelsAreConvex) {
  const double step = 1e-6;
  for (const Complex similar : {Complex(1.2, 0.0), Complex(0.4, 0.7), Complex(-0.6, 0.2)})
    for (const double b : {0.1, 0.5, 1.4})
      for (const double epsilon : {0.3, 1.0}) {
        Eigen::Vector4d slope;
        const Eigen::Matrix4d framed = framedModel(similar, b, 0.3, epsilon, slope);
        const auto framedAt = [&](Complex s, double anti) { return framedValue(s, anti, epsilon); };
        EXPECT_NEAR(slope[0],
                    (framedAt(similar + step, b) - framedAt(similar - step, b)) / (2 * step),
                    1e-4 * (1.0 + std::abs(slope[0])));
        const Complex up(0.0, step);
        EXPECT_NEAR(slope[1], (framedAt(similar + up, b) - framedAt(similar - up, b)) / (2 * step),
                    1e-4 * (1.0 + std::abs(slope[1])));
        EXPECT_NEAR(slope[2],
                    (framedAt(similar, b + step) - framedAt(similar, b - step)) / (2 * step),
                    1e-4 * (1.0 + std::abs(slope[2])));
        const double a = std::abs(similar);
        const Eigen::Matrix4d free = freeModel(a, b, 0.3, epsilon, slope);
        const auto freeAt = [&](double s, double anti) { return freeValue(s, anti, epsilon); };
        EXPECT_NEAR(slope[0], (freeAt(a + step, b) - freeAt(a - step, b)) / (2 * step),
                    1e-4 * (1.0 + std::abs(slope[0])));
        EXPECT_NEAR(slope[2], (freeAt(a, b + step) - freeAt(a, b - step)) / (2 * step),
                    1e-4 * (1.0 + std::abs(slope[2])));
        for (const Eigen::Matrix4d& model : {framed, free}) {
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(model);
          EXPECT_GE(eigen.eigenvalues().minCoeff(), -1e-9 * eigen.eigenvalues().maxCoeff());
        }
      }
}

TEST(Untangle, UnfoldsACertifiedMapThatWasPerturbed) {
  const test::SeamlessProblem p = test::sphereProblem(6, 4, std::vector<int>(8, 3));
  const ProgramResult solved = p.solve(p.frames(), p.weightedOptions());
  ASSERT_TRUE(p.certify(solved.z).isCertified);
  std::mt19937 random(3);
  Eigen::VectorXcd shaken = solved.x;
  const auto noise = [&] { return (test::randomBelow(random, 2001) - 1000) * 1e-3; };
  double edge = 0.0;
  for (FaceId f : p.surface.mesh.faces()) edge += std::abs(p.partsOf(f, solved.z).first);
  edge /= p.surface.mesh.faceCount();
  for (Complex& x : shaken) x += edge * Complex(noise(), noise());
  const Eigen::VectorXcd z = p.unknowns.copies * shaken;
  const std::vector<Complex> folded(z.data(), z.data() + z.size());
  const int before = static_cast<int>(p.certify(folded).orientation.notPositive.size());
  ASSERT_GT(before, 20) << "an example that shows nothing";

  UntangleOptions options;
  options.u = p.surface.field.u;
  options.kept = p.frames().faces;
  const UntangleResult result = untangle(p.system(), shaken, options);
  EXPECT_EQ(result.flipped, 0);
  const Eigen::VectorXcd unfolded = p.unknowns.copies * result.x;
  EXPECT_TRUE(p.certify({unfolded.data(), unfolded.data() + unfolded.size()}).isCertified);
}

/// Three vertices, on the seam or beside cones as well as elsewhere, leave their rings.
Eigen::VectorXcd crushed(const test::SeamlessProblem& p, const ProgramResult& solved, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  Eigen::VectorXcd x = solved.x;
  const auto noise = [&] { return (test::randomBelow(random, 2001) - 1000) * 1e-3; };
  for (int moved = 0; moved < 3; ++moved) {
    const VertexId v(test::randomBelow(random, p.surface.mesh.vertexCount()));
    const int unknown = p.unknowns.vertexUnknown[v];
    if (unknown < 0) continue;
    double edge = 0.0;
    for (HalfedgeId h : outgoingHalfedges(p.surface.mesh, v))
      edge = std::max(edge, std::abs(p.partsOf(TriMesh::face(h), solved.z).first));
    x[unknown] += 3.0 * edge * Complex(noise(), noise());
  }
  return x;
}

TEST(Kernels, TakeVerticesThatLeftTheirRingsBackAndKeepSeamsAndAngles) {
  const test::SeamlessProblem p = test::sphereProblem(6, 4, std::vector<int>(8, 3));
  const ProgramResult solved = p.solve(p.frames(), p.weightedOptions());
  const auto mapOf = [&](const Eigen::VectorXcd& x) {
    const Eigen::VectorXcd z = p.unknowns.copies * x;
    return std::vector<Complex>(z.data(), z.data() + z.size());
  };
  int folded = 0, mended = 0;
  for (int seed = 0; seed < 40; ++seed) {
    UntangleResult result;
    result.x = crushed(p, solved, seed);
    result.flipped = static_cast<int>(p.certify(mapOf(result.x)).orientation.notPositive.size());
    if (result.flipped == 0) continue;
    ++folded;
    const UntangleResult before = result;
    moveIntoKernels(p.system(), result);
    const Certificate after = p.certify(mapOf(result.x));
    EXPECT_EQ(result.flipped, static_cast<int>(after.orientation.notPositive.size()));
    EXPECT_TRUE(result.flipped == 0 || result.x == before.x) << "all or nothing";
    mended += after.isCertified;
  }
  EXPECT_GE(folded, 20) << "examples that show nothing";
  EXPECT_GE(mended, folded - 2);
}

TEST(Untangle, StopsWhenCancelled) {
  const test::SeamlessProblem p = test::sphereProblem(4, 4, std::vector<int>(8, 3));
  UntangleOptions options;
  options.u = p.surface.field.u;
  options.progress = [](int, double) { return false; };
  const UntangleResult result =
      untangle(p.system(), Eigen::VectorXcd::Random(p.unknowns.count), options);
  EXPECT_TRUE(result.isCancelled);
  EXPECT_EQ(result.iterations, 0);
}

}  // namespace
}  // namespace hgp
