// hgp::parametrize(V, F) with Eigen matrices.  Role: does in one call, without files, what the command line does
// (repairs, components, cones, certificate).
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hgp/api/session.h"

namespace hgp {

/// Options of hgp::parametrize(V, F).
struct MatrixOptions {
  api::LoadOptions load;                         ///< repairs, welding, limits
  api::SolveOptions solve;                       ///< order q, number of cones, scale …
  std::optional<io::Prescription> prescription;  ///< cones, turnings, handles; none: automatic
};

/// A map of V, F. `isCertified`: every triangle of `UV`, `FUV` has exactly positive area, every cone
/// and turning is as prescribed, and every seam is a rotation by a multiple of 2π/q.
struct MatrixMap {
  Eigen::MatrixXd UV;   ///< #uv × 2, one row per vertex of the cut surface
  Eigen::MatrixXi FUV;  ///< #F × 3, rows of UV; row f belongs to row f of F
  bool isCertified = false;
  std::string
      report;  ///< JSON, docs/schema/hgp-report.schema.json: cones, certificate, rounds, notes
};

/// @param V  #V × 3 positions
/// @param F  #F × 3 rows of V, counter-clockwise from outside; any number of components
/// Fails (and never throws) for unusable meshes, impossible prescriptions and contradictory options; a map that is not
/// certified is a success with isCertified = false.
template <typename DerivedV, typename DerivedF>
Result<MatrixMap> parametrize(const Eigen::MatrixBase<DerivedV>& V,
                              const Eigen::MatrixBase<DerivedF>& F,
                              const MatrixOptions& options = {}) {
  if (V.cols() != 3 || F.cols() != 3)
    return Failure{ErrorCode::kUsage, "read", "V and F have three columns each", {}};
  std::vector<Vec3> positions;
  for (Eigen::Index v = 0; v < V.rows(); ++v)
    positions.push_back(
        {static_cast<double>(V(v, 0)), static_cast<double>(V(v, 1)), static_cast<double>(V(v, 2))});
  std::vector<std::array<int, 3>> triangles;
  for (Eigen::Index f = 0; f < F.rows(); ++f)
    triangles.push_back(
        {static_cast<int>(F(f, 0)), static_cast<int>(F(f, 1)), static_cast<int>(F(f, 2))});
  api::Session session;
  if (Status done = session.loadArrays(std::move(positions), std::move(triangles), options.load);
      !done)
    return std::move(done).error();
  if (Status done = session.parametrize(options.prescription, options.solve); !done)
    return std::move(done).error();
  MatrixMap map;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
  using Corners = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
  map.UV = Eigen::Map<const Rows>(session.uv().data(),
                                  static_cast<Eigen::Index>(session.uv().size() / 2), 2);
  map.FUV = Eigen::Map<const Corners>(session.cornerToUv().data(),
                                      static_cast<Eigen::Index>(session.cornerToUv().size() / 3), 3)
                .template cast<int>();
  map.isCertified = session.isCertified();
  map.report = session.reportJson();
  return map;
}

}  // namespace hgp
