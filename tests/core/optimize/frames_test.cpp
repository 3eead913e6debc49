#include "hgp/optimize/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "hgp/verify/orientation.h"
#include "support/seamless.h"

namespace hgp {
namespace {

TEST(LinearParts, SplitAnAffineMapIntoSimilarityAndAntisimilarity) {
  std::mt19937 random(97);
  const auto any = [&] { return Complex(test::randomReal(random), test::randomReal(random)); };
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Geometry geometry = computeGeometry(mesh);
    for (FaceId f : mesh.faces()) {
      const Complex a = any(), b = any(), c = any();
      const LinearParts parts = linearParts(geometry, f);
      Complex similarity = 0.0, antisimilarity = 0.0, sums[2] = {};
      for (std::size_t k = 0; k < 3; ++k) {
        const Complex p = geometry.corner[f][k];
        const Complex z = a * p + b * std::conj(p) + c;
        similarity += parts.similarity[k] * z;
        antisimilarity += parts.antisimilarity[k] * z;
        sums[0] += parts.similarity[k];
        sums[1] += parts.antisimilarity[k];
        EXPECT_EQ(parts.similarity[k], std::conj(parts.antisimilarity[k]));
      }
      EXPECT_LT(std::abs(similarity - a), 1e-10) << shape.name;
      EXPECT_LT(std::abs(antisimilarity - b), 1e-10) << shape.name;
      EXPECT_LT(std::abs(sums[0]) + std::abs(sums[1]), 1e-10);  // translations do not matter
    }
  }
}

TEST(FrameCondition, ImpliesAPositiveTriangle) {
  std::mt19937 random(101);
  const TriMesh mesh = test::jittered(test::icosphere(2), 0.1).mesh();
  const Geometry geometry = computeGeometry(mesh);
  int held = 0;
  for (int round = 0; round < 4000; ++round) {
    const FaceId f(test::randomBelow(random, mesh.faceCount()));
    Complex z[3];
    for (Complex& value : z) value = {test::randomReal(random), test::randomReal(random)};
    const LinearParts parts = linearParts(geometry, f);
    Complex similarity = 0.0, antisimilarity = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      similarity += parts.similarity[k] * z[k];
      antisimilarity += parts.antisimilarity[k] * z[k];
    }
    const double theta = kPi * test::randomReal(random);
    const bool holds =
        (similarity * std::polar(1.0, theta)).real() - std::abs(antisimilarity) > 1e-12;
    const int sign = orientationSign({z[0].real(), z[0].imag()}, {z[1].real(), z[1].imag()},
                                     {z[2].real(), z[2].imag()});
    if (holds) {
      EXPECT_EQ(sign, 1);
      ++held;
    }
    // And the other way round: a positive triangle fulfils it for its own frame d = f_z / |f_z|.
    if (sign > 0) {
      EXPECT_GT(std::abs(similarity) - std::abs(antisimilarity), -1e-12);
    }
  }
  EXPECT_GT(held, 300);
}

TEST(Frames, CoverTheTrianglesOfConesAndBoundaries) {
  for (const test::CutSurface& s : test::cutSurfaces()) {
    const std::vector<FaceId> faces = coneAndBoundaryFaces(s.mesh, s.cones);
    EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
    std::set<FaceId> expected;
    for (FaceId f : s.mesh.faces())
      for (VertexId v : s.mesh.corners(f))
        if (s.mesh.isBoundary(v) || s.isCone(v)) expected.insert(f);
    if (expected.empty()) expected.insert(FaceId(0));  // a torus: one reference
    EXPECT_EQ(faces, std::vector<FaceId>(expected.begin(), expected.end())) << s.name;
    const Frames frames = fieldFrames(s.seams, faces);
    ASSERT_EQ(frames.angles.size(), faces.size());
    for (std::size_t j = 0; j < faces.size(); ++j)
      EXPECT_EQ(frames.angles[j], s.seams.frameAngle[faces[j]]);
  }
}

}  // namespace
}  // namespace hgp
