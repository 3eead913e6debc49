#include <algorithm>
#include <cmath>

#include "hgp/field/mesh_trees.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

class PenaltyForm : public ProgramForm {
 public:
  PenaltyForm(int pinned, int count) : pinned_(pinned), count_(count) {}
  int place(int unknown) const override {
    return unknown - (pinned_ >= 0 && unknown > pinned_ ? 1 : 0);
  }
  Eigen::VectorXcd expand(const Eigen::VectorXcd& x) const override {
    Eigen::VectorXcd full(count_);
    for (int i = 0; i < count_; ++i) full[i] = i == pinned_ ? 0.0 : x[place(i)];
    return full;
  }

 private:
  int pinned_, count_;
};

/// All terms as rows: harmonic rows first, two rows per face of the distortion term behind; and the
/// linear term that belongs to them.
SparseC allRows(const ProgramInput& in, PenaltyForm& form, int pinned, int columns) {
  std::vector<Eigen::Triplet<Complex>> entries;
  const SparseRows& harmonic = in.harmonic.rows;
  entries.reserve(static_cast<std::size_t>(harmonic.nonZeros()) +
                  8 * static_cast<std::size_t>(in.mesh.faceCount()));
  for (Eigen::Index r = 0; r < harmonic.rows(); ++r) {
    const VertexId v = in.harmonic.rowVertex[static_cast<std::size_t>(r)];
    const double weight = std::exp(-in.options.u[v]);
    for (SparseRows::InnerIterator it(harmonic, r); it; ++it)
      if (it.col() != pinned)
        entries.emplace_back(static_cast<int>(r), form.place(static_cast<int>(it.col())),
                             weight * it.value());
  }
  int row = static_cast<int>(harmonic.rows());
  PerFace<double> delta(static_cast<std::size_t>(in.mesh.faceCount()),
                        std::max(in.options.quality, in.options.tieBreak));
  for (FaceId f : in.options.pulled) delta[f] = std::max(delta[f], in.options.pull);
  FaceRows rows;
  for (FaceId f : in.mesh.faces()) {
    if (delta[f] <= 0.0) continue;
    faceRows(in, pinned, f, rows);
    const DistortionRows d = distortionRows(in, f, delta[f]);
    for (std::size_t i = 0; i < rows.unknowns.size(); ++i) {
      const int column = form.place(rows.unknowns[i]);
      const Complex similar = d.first * rows.similar[i];
      entries.emplace_back(row, column, similar);
      entries.emplace_back(row + 1, column, d.second * rows.anti[i]);
      form.c[column] -= std::conj(similar) * d.target;
    }
    row += 2;
  }
  SparseC all(row, columns);
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

/// The mesh dissected with separators of width 2, as a tree of H: a third of the time that H's own
/// graph takes. Translations couple to whole seams and are placed where that fits.
linalg::SeparatorTree treeOf(const ProgramInput& in, const PenaltyForm& form, int pinned,
                             const SparseC& H) {
  std::vector<int> keep = in.unknowns.vertexUnknown.raw();
  for (int& unknown : keep)
    if (unknown >= 0) unknown = unknown == pinned ? -1 : form.place(unknown);
  const linalg::SeparatorTree vertices = linalg::restrictTree(vertexTree(in.mesh, 2), keep);
  // Only the appended ones' neighbours are looked at.
  linalg::Graph appended;
  appended.start.assign(vertices.order.size() + 1, 0);
  for (auto j = static_cast<Eigen::Index>(vertices.order.size()); j < H.cols(); ++j) {
    for (SparseC::InnerIterator it(H, j); it; ++it)
      if (it.row() != j) appended.neighbours.push_back(static_cast<int>(it.row()));
    appended.start.push_back(static_cast<int>(appended.neighbours.size()));
  }
  return linalg::appendVertices(vertices, appended);
}

}  // namespace

std::unique_ptr<ProgramForm> penaltyForm(const ProgramInput& in, int pinned) {
  auto form = std::make_unique<PenaltyForm>(pinned, in.unknowns.count);
  const int n = in.unknowns.count - (pinned >= 0 ? 1 : 0);
  form->c = Eigen::VectorXcd::Zero(n);
  SparseC H;
  {  // the rows go before the factor comes
    const SparseC all = allRows(in, *form, pinned, n);
    H = all.adjoint() * all;
  }
  linalg::Cliques cliques;
  FaceRows rows;
  for (FaceId f : in.frames.faces) {
    faceRows(in, pinned, f, rows);
    for (int& unknown : rows.unknowns) unknown = form->place(unknown);
    cliques.push_back(rows.unknowns);
  }
  const linalg::SeparatorTree tree = treeOf(in, *form, pinned, H);
  linalg::PartialCholeskyOptions options;
  options.tree = &tree;
  if (!form->cholesky.build(H, cliques, options)) return nullptr;
  return form;
}

}  // namespace hgp
