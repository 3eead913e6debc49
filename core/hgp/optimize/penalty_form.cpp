#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/field/mesh_trees.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

class PenaltyForm : public ProgramForm {
 public:
  explicit PenaltyForm(const HeldUnknowns& held) : held_(held), free_(held.isHeld) {
    c = Eigen::VectorXcd::Zero(free_.count());
  }
  int count() const { return free_.count(); }
  int number(int unknown) const override { return free_.number(unknown); }
  Eigen::VectorXcd expand(const Eigen::VectorXcd& x) const override {
    Eigen::VectorXcd full = held_.value;
    free_.scatter(x, full);
    return full;
  }

 private:
  const HeldUnknowns& held_;
  FreeUnknowns free_;
};

/// A sum of terms |row x + constant|², collected as the matrix of all rows and the linear term.
class RowList {
 public:
  RowList(PenaltyForm& form, std::size_t expected) : form_(form) { entries_.reserve(expected); }
  void add(int unknown, const Complex& value) {
    entries_.emplace_back(count_, form_.number(unknown), value);
  }
  void endRow(const Complex& constant) {
    for (; done_ < entries_.size(); ++done_)
      form_.c[entries_[done_].col()] += std::conj(entries_[done_].value()) * constant;
    ++count_;
  }
  SparseC take() {
    SparseC all(count_, form_.count());
    all.setFromTriplets(entries_.begin(), entries_.end());
    entries_ = {};
    return all;
  }

 private:
  PenaltyForm& form_;
  std::vector<Eigen::Triplet<Complex>> entries_;
  std::size_t done_ = 0;
  int count_ = 0;
};

void addHarmonicRows(const ProgramInput& in, const HeldUnknowns& held, const PenaltyForm& form,
                     RowList& list) {
  const SparseRows& harmonic = in.harmonic.rows;
  for (Eigen::Index r = 0; r < harmonic.rows(); ++r) {
    bool isEmpty = true;
    for (SparseRows::InnerIterator it(harmonic, r); it && isEmpty; ++it)
      isEmpty = form.number(static_cast<int>(it.col())) < 0;
    if (isEmpty) continue;
    const VertexId v = in.harmonic.rowVertex[static_cast<std::size_t>(r)];
    const double weight = portable::exp(-in.options.u[v]);
    Complex constant = 0.0;
    for (SparseRows::InnerIterator it(harmonic, r); it; ++it) {
      const auto unknown = static_cast<int>(it.col());
      if (form.number(unknown) < 0)
        constant += weight * it.value() * held.value[unknown];
      else
        list.add(unknown, weight * it.value());
    }
    list.endRow(constant);
  }
}

/// Adds the distortion term, two rows per face.
void addDistortion(const ProgramInput& in, double quality, const HeldUnknowns& held,
                   RowList& list) {
  PerFace<double> delta(static_cast<std::size_t>(in.mesh.faceCount()),
                        std::max(quality, in.options.tieBreak));
  const SoftFrames& soft = in.options.soft;
  for (FaceId f : soft.faces) delta[f] = std::max(delta[f], soft.weight);
  FaceRows rows;
  for (FaceId f : in.mesh.faces()) {
    if (delta[f] <= 0.0) continue;
    faceRows(in, held, f, rows);
    if (rows.terms.empty()) continue;
    scaleToDistortion(in, f, delta[f], rows);
    for (const FaceRows::Term& term : rows.terms) list.add(term.unknown, term.similar);
    list.endRow(rows.heldSimilar);
    for (const FaceRows::Term& term : rows.terms) list.add(term.unknown, term.anti);
    list.endRow(rows.heldAnti);
  }
}

/// All terms as rows: the harmonic ones, then the distortion term; and their linear term.
SparseC allRows(const ProgramInput& in, double quality, const HeldUnknowns& held,
                PenaltyForm& form) {
  const std::size_t share = in.options.patch() ? 10 : 1;  // an estimate, to reserve memory
  RowList list(form, (static_cast<std::size_t>(in.harmonic.rows.nonZeros()) +
                      8 * static_cast<std::size_t>(in.mesh.faceCount())) /
                         share);
  addHarmonicRows(in, held, form, list);
  addDistortion(in, quality, held, list);
  return list.take();
}

/// The dissection of the mesh with separators of width 2, as a tree of H; dissecting H's own graph takes three times
/// as long. Translations, which couple to whole seams, are inserted where their neighbours allow.
linalg::SeparatorTree treeOf(const ProgramInput& in, const linalg::SeparatorTree& wideTree,
                             const PenaltyForm& form, const SparseC& H) {
  std::vector<int> keep = in.unknowns.vertexUnknown.raw();
  for (int& unknown : keep)
    if (unknown >= 0) unknown = form.number(unknown);
  const linalg::SeparatorTree vertices = linalg::restrictTree(wideTree, keep);
  // Only the neighbours of appended unknowns are needed.
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

std::unique_ptr<ProgramForm> penaltyForm(const ProgramInput& in, const PenaltyObjective& objective,
                                         const HeldUnknowns& held) {
  auto form = std::make_unique<PenaltyForm>(held);
  SparseC H;
  {  // frees the rows before the factor is computed
    const SparseC all = allRows(in, objective.quality, held, *form);
    H = all.adjoint() * all;
  }
  linalg::Cliques cliques;
  FaceRows rows;
  for (FaceId f : in.frames.faces) {
    faceRows(in, held, f, rows);
    cliques.emplace_back();
    for (const FaceRows::Term& term : rows.terms)
      cliques.back().push_back(form->number(term.unknown));
  }
  linalg::PartialCholeskyOptions options;
  linalg::SeparatorTree tree;
  if (!in.options.patch()) {  // a patch is small, so its own graph is dissected
    if (objective.wideTree != nullptr)
      tree = treeOf(in, *objective.wideTree, *form, H);
    else
      tree = treeOf(in, vertexTree(in.mesh, 2), *form, H);
    options.tree = &tree;
  }
  if (!form->cholesky.build(H, cliques, options)) return nullptr;
  return form;
}

}  // namespace hgp
