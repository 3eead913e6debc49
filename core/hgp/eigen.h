// hgp::parametrize(V, F) with Eigen matrices.  Role: does in one call, without files, what the command line does
// (repairs, components, cones, certificate). Calls are independent of each other: any number of threads may make them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hgp/api/session.h"

namespace hgp {

/// Options of hgp::parametrize(V, F).
struct MatrixOptions {
  api::LoadOptions load;    ///< repairs, welding, limits
  api::SolveOptions solve;  ///< order q, number of cones, scale …
  /// Cones, turnings, handles; none: automatic.
  std::optional<prescription::Prescription> prescription;
};

/// A map of the rows of `F`, the triangles as they were solved: those of the given F without the ones that are no
/// surface (copies of others, a vertex named twice), turned over where neighbours disagreed. `isCertified`: every row of
/// `FUV` has exactly positive area in `UV`, every cone and turning is as prescribed, and every seam is a rotation by a
/// multiple of 2π/q. To refuse meshes that need repairs instead, set MatrixOptions::load.isStrict.
struct MatrixMap {
  Eigen::MatrixXd V;       ///< #V × 3: the given ones; more follow if the mesh was refined
  Eigen::MatrixXi F;       ///< #S × 3, rows of V: the triangles as solved
  Eigen::VectorXi origin;  ///< #S: the row of the given F (or of the refined one) for each row of F
  Eigen::MatrixXd UV;      ///< #uv × 2, one row per vertex of the cut surface
  Eigen::MatrixXi FUV;     ///< #S × 3, rows of UV; row s belongs to row s of F
  Eigen::VectorXi uvToVertex;  ///< #uv: the row of V of each row of UV
  Eigen::MatrixXi seams;  ///< #seam edges × 5: rows of UV of both sides in the same order, r ∈ Z_q
  bool isCertified = false;
  api::MapFacts facts;  ///< the certificate as numbers, by component
  std::string
      report;  ///< JSON, docs/schema/hgp-report.schema.json: cones, certificate, rounds, notes
};

namespace detail {

/// Whether an index of any integer type names one of `count` rows.
template <typename Index>
bool isRow(Index i, Eigen::Index count) {
  if constexpr (std::is_signed_v<Index>) {
    if (i < 0) return false;
  }
  return static_cast<unsigned long long>(i) < static_cast<unsigned long long>(count);
}

template <int Columns, typename Scalar>
auto rowsOf(const std::vector<Scalar>& numbers) {
  using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, Columns,
                             Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  return Eigen::Map<const Rows>(numbers.data(), static_cast<Eigen::Index>(numbers.size() / Columns),
                                Columns);
}

inline MatrixMap mapOf(const api::Session& session) {
  const api::SolvedTriangles solved = session.solvedTriangles();
  MatrixMap map;
  map.V = rowsOf<3>(session.positions());
  map.F = rowsOf<3>(solved.triangles).template cast<int>();
  map.origin = rowsOf<1>(solved.origin).template cast<int>();
  map.UV = rowsOf<2>(session.uv());
  map.FUV = rowsOf<3>(solved.cornerToUv).template cast<int>();
  map.uvToVertex = rowsOf<1>(session.uvToVertex()).template cast<int>();
  map.isCertified = session.isCertified();
  map.facts = session.mapFacts();
  std::vector<int> seams;
  for (const api::SeamEdge& s : session.seams())
    seams.insert(seams.end(), {s.a[0], s.a[1], s.b[0], s.b[1], s.r});
  map.seams = rowsOf<5>(seams);
  map.report = session.reportJson();
  return map;
}

}  // namespace detail

/// @param V  #V × 3 positions
/// @param F  #F × 3 rows of V, of any integer type, counter-clockwise from outside; any number of components
/// Fails (and never throws) for unusable meshes, impossible prescriptions and contradictory options; a map that is not
/// certified is a success with isCertified = false.
template <typename DerivedV, typename DerivedF>
Result<MatrixMap> parametrize(const Eigen::MatrixBase<DerivedV>& V,
                              const Eigen::MatrixBase<DerivedF>& F,
                              const MatrixOptions& options = {}) {
  static_assert(std::is_integral_v<typename DerivedF::Scalar>, "F holds rows of V");
  if (V.cols() != 3 || F.cols() != 3)
    return Failure{ErrorCode::kUsage, "read", "V and F have three columns each", {}};
  std::vector<Vec3> positions;
  for (Eigen::Index v = 0; v < V.rows(); ++v)
    positions.push_back(
        {static_cast<double>(V(v, 0)), static_cast<double>(V(v, 1)), static_cast<double>(V(v, 2))});
  std::vector<std::array<int, 3>> triangles;
  for (Eigen::Index f = 0; f < F.rows(); ++f) {
    for (Eigen::Index k = 0; k < 3; ++k)
      if (!detail::isRow(F(f, k), V.rows()))
        return Failure{ErrorCode::kMalformed,
                       "read",
                       "row " + std::to_string(f) + " of F names the vertex " +
                           std::to_string(F(f, k)) + "; V has " + std::to_string(V.rows()) +
                           " rows, from 0",
                       {{Where::Kind::kFace, f}}};
    triangles.push_back(
        {static_cast<int>(F(f, 0)), static_cast<int>(F(f, 1)), static_cast<int>(F(f, 2))});
  }
  api::Session session;
  if (Status done = session.loadArrays(std::move(positions), std::move(triangles), options.load);
      !done)
    return std::move(done).error();
  if (Status done = session.parametrize(options.prescription, options.solve); !done)
    return std::move(done).error();
  return detail::mapOf(session);
}

}  // namespace hgp
