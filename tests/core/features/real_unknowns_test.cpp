// Real unknowns.  Laws: equal coordinates have equal bits, whatever the unknowns; every map that satisfies the equations
// is one of them; seams hold.
#include "hgp/features/real_unknowns.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "hgp/cut/seam_rotation.h"
#include "hgp/features/field_along.h"
#include "hgp/features/sum_relations.h"
#include "hgp/system/reduced_unknowns.h"
#include "support/creases.h"
#include "support/random.h"

namespace hgp {
namespace {

using Rows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;
using Columns = Eigen::SparseMatrix<Complex>;

struct Straight {
  std::string name;
  ReducedUnknowns reduced;
  std::vector<EqualCoordinate> equations;
  RealUnknowns unknowns;
};

Straight straighten(const test::CreasedShape& shape) {
  const TriMesh& mesh = shape.mesh;
  Straight out;
  out.name = shape.name;
  const FieldContext context = prepareSurface(mesh);
  const Result<AlignedField> field = alignedField(mesh, context, shape.features);
  EXPECT_TRUE(field) << shape.name;
  std::vector<VertexId> cones;
  for (const ConePoint& cone :
       specOf(mesh, context.topology, handleGenerators(mesh), *field, shape.features).cones)
    cones.push_back(cone.vertex);
  const CutMesh cut =
      cutToDisk(mesh, seamGraph(mesh, context.geometry, context.surface, cones), cones);
  const SeamRotations seams = seamRotations(mesh, cut, field->field);
  out.reduced = reduceUnknowns(mesh, cut, seams);
  std::vector<char> isShared(at(out.reduced.count), 1);
  for (VertexId v : mesh.vertices())
    if (out.reduced.vertexUnknown[v] >= 0) isShared[at(out.reduced.vertexUnknown[v])] = 0;
  for (EdgeId e : shape.features) {
    const HalfedgeId h = mesh.halfedge(e);
    const long combed = std::lround(
        (seams.frameAngle[TriMesh::face(h)] - field->field.angle[TriMesh::face(h)]) / (kPi / 2.0));
    out.equations.push_back(
        {cut.copy[h].i, cut.copy[TriMesh::next(h)].i, reduceTurn(field->axis[h] - combed, 2) == 0});
  }
  std::optional<RealUnknowns> unknowns =
      equateCoordinates(out.reduced.copies, isShared, out.equations);
  EXPECT_TRUE(unknowns) << shape.name;
  if (unknowns) out.unknowns = std::move(*unknowns);
  return out;
}

const std::vector<Straight>& straightShapes() {
  static const std::vector<Straight> all = [] {
    std::vector<Straight> list;
    for (const test::CreasedShape& shape : test::creasedShapes()) list.push_back(straighten(shape));
    return list;
  }();
  return all;
}

Eigen::VectorXd randomVector(Eigen::Index n, std::mt19937& random) {
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = test::randomReal(random);
  return x;
}

TEST(RealUnknowns, KeepEqualCoordinatesEqualToTheLastBit) {
  std::mt19937 random(71);
  for (const Straight& s : straightShapes()) {
    const Eigen::VectorXd z = s.unknowns.rows * randomVector(s.unknowns.count, random);
    for (const EqualCoordinate& e : s.equations)
      EXPECT_EQ(z[2 * e.a + e.isImaginary], z[2 * e.b + e.isImaginary]) << s.name;
  }
}

TEST(RealUnknowns, AreSeamlessMaps) {
  std::mt19937 random(73);
  for (const Straight& s : straightShapes()) {
    const Eigen::VectorXd y = randomVector(s.unknowns.count, random);
    const Eigen::VectorXd z = s.unknowns.rows * y;
    // The complex unknowns of the same map, by least squares: they reproduce it only if it is seamless.
    Eigen::VectorXcd copies(z.size() / 2);
    for (Eigen::Index c = 0; c < copies.size(); ++c) copies[c] = {z[2 * c], z[2 * c + 1]};
    const Rows& A = s.reduced.copies;
    const Eigen::SimplicialLDLT<Columns> normal(Columns(A.adjoint() * A));
    const Eigen::VectorXcd x = normal.solve(A.adjoint() * copies);
    EXPECT_LT((A * x - copies).norm(), 1e-8 * copies.norm()) << s.name;
  }
}

TEST(RealUnknowns, LeaveOutOneUnknownPerEquationThatIsNotRedundant) {
  for (const Straight& s : straightShapes()) {
    Eigen::MatrixXd equations =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(s.equations.size()), 2 * s.reduced.count);
    for (std::size_t n = 0; n < s.equations.size(); ++n) {
      const EqualCoordinate& e = s.equations[n];
      for (const auto& [copy, sign] : {std::pair(e.a, 1.0), std::pair(e.b, -1.0)})
        for (Rows::InnerIterator it(s.reduced.copies, copy); it; ++it) {
          const Complex value = sign * it.value();
          const auto row = static_cast<Eigen::Index>(n);
          equations(row, 2 * it.col()) += e.isImaginary ? value.imag() : value.real();
          equations(row, 2 * it.col() + 1) += e.isImaginary ? value.real() : -value.imag();
        }
    }
    const Eigen::Index rank = equations.colPivHouseholderQr().rank();
    EXPECT_EQ(s.unknowns.count, 2 * s.reduced.count - rank) << s.name;
  }
}

TEST(SumRelations, AreSolvedInHalves) {
  // a + b = 0, 2a + c − d = 0, and their sum, which is redundant.
  const auto solved = solveSums({{{0, 1.0}, {1, 1.0}},
                                 {{0, 2.0}, {2, 1.0}, {3, -1.0}},
                                 {{0, 3.0}, {1, 1.0}, {2, 1.0}, {3, -1.0}}});
  ASSERT_TRUE(solved);
  EXPECT_EQ(solved->size(), 2u);
  // Whatever the free ones are, the relations hold.
  std::map<int, double> value{{0, 0.5}, {1, -7.0}, {2, 3.0}, {3, 11.0}};
  for (const auto& [variable, sum] : *solved) {
    value[variable] = 0.0;
    for (const auto& [other, factor] : sum) {
      EXPECT_FALSE(solved->contains(other));
      value[variable] += factor * value[other];
    }
  }
  EXPECT_EQ(value[0] + value[1], 0.0);
  EXPECT_EQ(2.0 * value[0] + value[2] - value[3], 0.0);
}

TEST(SumRelations, RefuseFactorsThatAreNotExact) {
  EXPECT_FALSE(solveSums({{{0, 3.0}, {1, 5.0}}}));
  EXPECT_TRUE(solveSums({{{0, 2.0}, {1, 5.0}}}));
}

}  // namespace
}  // namespace hgp
