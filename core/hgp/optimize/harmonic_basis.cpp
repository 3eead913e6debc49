#include "hgp/optimize/harmonic_basis.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hgp/optimize/harmonic_rows.h"
#include "hgp/optimize/program_terms.h"

namespace hgp {
namespace {

/// The unknown that is held at 0: of the cone or boundary vertex where the map is smallest, or, where all cones are
/// determined by their chains, of a chain with a rotation. On a flat torus, where every vertex has a row, the first is
/// held. −1: there is none.
int heldUnknown(const SeamlessSystem& system, const std::vector<char>& hasRow,
                const PerVertex<double>& u) {
  VertexId held;
  for (VertexId v : system.mesh.vertices()) {
    const int unknown = system.unknowns.vertexUnknown[v];
    if (unknown < 0 || hasRow[static_cast<std::size_t>(unknown)]) continue;
    if (!held.isValid() || u[v] < u[held]) held = v;
  }
  if (held.isValid()) return system.unknowns.vertexUnknown[held];
  for (std::size_t c = 0; c < system.cut.chains.size(); ++c)
    if (system.unknowns.chainUnknown[c] >= 0 &&
        system.seams.rotation[system.cut.chains[c].left[0]] != 0)
      return system.unknowns.chainUnknown[c];
  const bool isTorus =
      system.harmonic.rowVertex.size() == static_cast<std::size_t>(system.mesh.vertexCount());
  return isTorus ? system.unknowns.vertexUnknown[VertexId(0)] : -1;
}

/// The rows of the harmonic equations, with zeros for pairs of unknowns that meet in a triangle only: beside a seam,
/// a triangle's corners may depend on a translation that no row of theirs contains.
SparseRows rowsWithTriangles(const SeamlessSystem& system, const std::vector<char>& hasRow) {
  const Frames noFrames;
  const ProgramOptions options;
  const ProgramInput in{system, noFrames, options};
  const HeldUnknowns none{std::vector<char>(static_cast<std::size_t>(system.unknowns.count), 0),
                          {}};
  std::vector<std::array<int, 2>> zeros;
  FaceRows rows;
  for (FaceId f : system.mesh.faces()) {
    faceRows(in, none, f, rows);
    const std::vector<int> unknowns = rows.unknowns();
    const std::array<VertexId, 3> corners = system.mesh.corners(f);
    const auto isOfCorner = [&](int unknown) {
      return std::any_of(corners.begin(), corners.end(),
                         [&](VertexId v) { return system.unknowns.vertexUnknown[v] == unknown; });
    };
    if (std::all_of(unknowns.begin(), unknowns.end(), isOfCorner)) continue;
    for (int a : unknowns)
      for (int b : unknowns)
        if (hasRow[static_cast<std::size_t>(a)] || hasRow[static_cast<std::size_t>(b)])
          zeros.push_back({a, b});
  }
  return squareRows(system, std::move(zeros));
}

/// Rounding leaves less of a row that follows from others; weights of a row sum to 1.
constexpr double kVanishedRow = 1e-10;
/// Multiply-adds of restricting a form, relative to the elimination before it.
constexpr double kFormShare = 3.0;

}  // namespace

int HarmonicBasis::countOf(const SeamlessSystem& system) {
  const auto rows = static_cast<int>(system.harmonic.rowVertex.size());
  const bool isTorus = rows == system.mesh.vertexCount();
  return system.unknowns.count - rows - (isTorus ? 0 : 1);
}

std::shared_ptr<const HarmonicBasis> HarmonicBasis::make(const SeamlessSystem& system,
                                                         const PerVertex<double>& u,
                                                         const linalg::SeparatorTree& tree) {
  auto basis = std::make_shared<HarmonicBasis>();
  std::vector<char> hasRow = unknownsWithRows(system);
  const int held = heldUnknown(system, hasRow, u);
  if (held < 0) return nullptr;
  const bool isHeldByRow = hasRow[static_cast<std::size_t>(held)] != 0;
  hasRow[static_cast<std::size_t>(held)] = 0;
  for (int unknown = 0; unknown < system.unknowns.count; ++unknown) {
    if (hasRow[static_cast<std::size_t>(unknown)]) continue;
    if (unknown != held) basis->free_.push_back(static_cast<int>(basis->kept_.size()));
    basis->kept_.push_back(unknown);
  }
  if (basis->free_.empty() ||
      !basis->lu_.build(rowsWithTriangles(system, hasRow), basis->kept_, unknownTree(system, tree)))
    return nullptr;
  if (isHeldByRow && !basis->fulfilsRowOf(held)) return nullptr;
  basis->restrictDistortion(system, u);
  const int size = basis->count();
  basis->rows_ = std::make_unique<linalg::SchurExtension>(
      basis->lu_, basis->keptOf(Eigen::MatrixXcd::Identity(size, size)));
  basis->multiplyAdds_ = 4.0 * (1.0 + kFormShare) * basis->lu_.cost().multiplyAdds;
  return basis;
}

/// Whether the row of a kept unknown follows from those that are eliminated.
bool HarmonicBasis::fulfilsRowOf(int unknown) const {
  const auto found = std::lower_bound(kept_.begin(), kept_.end(), unknown);
  return lu_.schur().row(found - kept_.begin()).cwiseAbs().maxCoeff() < kVanishedRow;
}

void HarmonicBasis::restrictDistortion(const SeamlessSystem& system, const PerVertex<double>& u) {
  const Frames noFrames;
  ProgramOptions options;
  options.u = u;
  const ProgramInput in{system, noFrames, options};
  const HeldUnknowns none{std::vector<char>(static_cast<std::size_t>(system.unknowns.count), 0),
                          {}};
  linalg::FormElements elements;
  elements.count = system.mesh.faceCount();
  elements.unknownsOf = [&](int f, std::vector<int>& unknowns) {
    thread_local FaceRows rows;  // reuses its memory
    faceRows(in, none, FaceId(f), rows);
    unknowns = rows.unknowns();
  };
  elements.get = [&](int f, linalg::FormElements::Element& out) {
    thread_local FaceRows rows;
    faceRows(in, none, FaceId(f), rows);
    scaleToDistortion(in, FaceId(f), 1.0, rows);
    out.unknowns = rows.unknowns();
    const auto count = static_cast<Eigen::Index>(rows.terms.size());
    for (Eigen::Index i = 0; i < count; ++i)
      rows.terms[static_cast<std::size_t>(i)].unknown = static_cast<int>(i);
    out.H.resize(count, count);
    out.c.resize(count);
    addSquares(
        rows, 1.0, 1.0, [&](int i, const Complex& value) { out.c[i] = value; },
        [&](int i, int j, const Complex& value) { out.H(i, j) = value; });
  };
  const linalg::QuadraticForm all = lu_.restrict(elements);
  const auto size = static_cast<Eigen::Index>(free_.size());
  distortion_.H.resize(size, size);
  distortion_.c.resize(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const int column = free_[static_cast<std::size_t>(j)];
    distortion_.c[j] = all.c[column];
    for (Eigen::Index i = 0; i < size; ++i)
      distortion_.H(i, j) = all.H(free_[static_cast<std::size_t>(i)], column);
  }
}

/// The kept unknowns from columns of y.
Eigen::MatrixXcd HarmonicBasis::keptOf(const Eigen::MatrixXcd& y) const {
  Eigen::MatrixXcd kept = Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(kept_.size()), y.cols());
  for (std::size_t i = 0; i < free_.size(); ++i)
    kept.row(free_[i]) = y.row(static_cast<Eigen::Index>(i));
  return kept;
}

Eigen::VectorXcd HarmonicBasis::expand(const Eigen::VectorXcd& y) const {
  return lu_.extend(keptOf(y)).col(0);
}

Eigen::MatrixXcd HarmonicBasis::rowsOf(const std::vector<int>& unknowns) const {
  return rows_->rows(unknowns);
}

}  // namespace hgp
