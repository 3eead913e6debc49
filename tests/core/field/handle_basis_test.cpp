#include "hgp/field/handle_basis.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "hgp/field/prescribed_field.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// ξ along h, from tail to head.
double along(const TriMesh& mesh, const PerEdge<double>& form, HalfedgeId h) {
  return mesh.halfedge(mesh.edge(h)) == h ? form[mesh.edge(h)] : -form[mesh.edge(h)];
}

TEST(HandleBasis, FormsAreClosedOnFacesAndCoclosedAtNodes) {
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context) << shape.name;
    const auto count = static_cast<Eigen::Index>(context->handles.loops.size());
    ASSERT_EQ(count, 2 * shape.genus);
    for (Eigen::Index i = 0; i < count; ++i) {
      const PerEdge<double> form =
          combineForms(mesh, context->surface, context->handles, Eigen::VectorXd::Unit(count, i));
      for (FaceId f : mesh.faces()) {
        double around = 0.0;
        for (int k = 0; k < 3; ++k) around += along(mesh, form, TriMesh::halfedge(f, k));
        EXPECT_NEAR(around, 0.0, 1e-12) << shape.name;
      }
      std::vector<double> divergence(static_cast<std::size_t>(context->surface.nodeCount), 0.0);
      for (EdgeId e : mesh.edges()) {
        const HalfedgeId h = mesh.halfedge(e);
        const double flow = context->surface.weight[e] * form[e];
        divergence[static_cast<std::size_t>(context->surface.node[mesh.tail(h)])] += flow;
        divergence[static_cast<std::size_t>(context->surface.node[mesh.head(h)])] -= flow;
      }
      for (double d : divergence) EXPECT_NEAR(d, 0.0, 1e-10) << shape.name;
    }
  }
}

TEST(HandleBasis, PeriodsAreTheIntegralsAlongTheLoopsAndPositiveDefinite) {
  for (const test::Shape& shape : test::all()) {
    if (shape.genus == 0) continue;
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    const HandleBasis& basis = context->handles;
    const auto count = static_cast<Eigen::Index>(basis.loops.size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const PerEdge<double> form =
          combineForms(mesh, context->surface, basis, Eigen::VectorXd::Unit(count, i));
      for (Eigen::Index j = 0; j < count; ++j) {
        double integral = 0.0;
        for (HalfedgeId h : basis.loops[static_cast<std::size_t>(j)].crossed)
          integral += context->surface.weight[mesh.edge(h)] * along(mesh, form, h);
        EXPECT_NEAR(basis.periods(j, i), integral, 1e-10) << shape.name;
      }
    }
    EXPECT_LT((basis.periods - basis.periods.transpose()).norm(), 1e-12);
    EXPECT_EQ(basis.periods.llt().info(), Eigen::Success) << shape.name;
  }
}

}  // namespace
}  // namespace hgp
