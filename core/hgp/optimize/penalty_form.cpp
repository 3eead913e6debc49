#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/field/mesh_trees.h"
#include "hgp/optimize/harmonic_rows.h"
#include "hgp/optimize/program_form.h"
#include "hgp/system/square_rows.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

/// To reserve memory: terms of the two rows of a face, of which some contain a translation, and the share of a surface
/// that a patch is.
constexpr std::size_t kTermsPerFace = 8, kPatchesPerSurface = 10;

class PenaltyForm : public ProgramForm {
 public:
  explicit PenaltyForm(const HeldUnknowns& held) : held_(held), free_(held.isHeld) {}
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

void addHarmonicRows(const ProgramInput& in, const HeldUnknowns& held, const PenaltyForm& form,
                     SquareRows<Complex>& sum) {
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
        sum.add(form.number(unknown), weight * it.value());
    }
    sum.endRow(constant);
  }
}

/// Adds the distortion term, two rows per face.
void addDistortion(const ProgramInput& in, const PenaltyObjective& objective,
                   const HeldUnknowns& held, const PenaltyForm& form, SquareRows<Complex>& sum) {
  const double tieBreak = objective.isHarmonic ? 0.0 : in.options.tieBreak;
  PerFace<double> delta(static_cast<std::size_t>(in.mesh.faceCount()),
                        std::max(objective.quality, tieBreak));
  const SoftFrames& soft = in.options.soft;
  for (FaceId f : soft.faces) delta[f] = std::max(delta[f], soft.weight);
  FaceRows rows;
  for (FaceId f : in.mesh.faces()) {
    if (delta[f] <= 0.0) continue;
    faceRows(in, held, f, rows);
    if (rows.terms.empty()) continue;
    scaleToDistortion(in, f, delta[f], rows);
    form.rewrite(rows);
    for (const FaceRows::Term& term : rows.terms) sum.add(term.unknown, term.similar);
    sum.endRow(rows.heldSimilar);
    for (const FaceRows::Term& term : rows.terms) sum.add(term.unknown, term.anti);
    sum.endRow(rows.heldAnti);
  }
}

/// All terms: the harmonic ones, then the distortion term.
SparseC objectiveOf(const ProgramInput& in, const PenaltyObjective& objective,
                    const HeldUnknowns& held, PenaltyForm& form) {
  const std::size_t all = static_cast<std::size_t>(in.harmonic.rows.nonZeros()) +
                          kTermsPerFace * static_cast<std::size_t>(in.mesh.faceCount());
  SquareRows<Complex> sum(form.count(), in.options.patch() ? all / kPatchesPerSurface : all);
  addHarmonicRows(in, held, form, sum);
  addDistortion(in, objective, held, form, sum);
  form.c = sum.linear;
  return sum.takeForm();
}

}  // namespace

std::unique_ptr<ProgramForm> penaltyForm(const ProgramInput& in, const PenaltyObjective& objective,
                                         const HeldUnknowns& held) {
  auto form = std::make_unique<PenaltyForm>(held);
  const SparseC H = objectiveOf(in, objective, held, *form);
  linalg::Cliques cliques;
  FaceRows rows;
  for (FaceId f : in.frames.faces) {
    faceRows(in, held, f, rows);
    form->rewrite(rows);
    cliques.push_back(rows.unknowns());
  }
  linalg::PartialCholeskyOptions options;
  linalg::SeparatorTree tree;
  if (!in.options.patch()) {  // a patch is small, so its own graph is dissected
    std::vector<int> numbers = in.unknowns.vertexUnknown.raw();
    for (int& unknown : numbers)
      if (unknown >= 0) unknown = form->number(unknown);
    tree = objective.wideTree ? formTree(*objective.wideTree, numbers, H)
                              : formTree(vertexTree(in.mesh, 2), numbers, H);
    options.tree = &tree;
  }
  if (!form->cholesky.build(H, cliques, options)) return nullptr;
  return form;
}

}  // namespace hgp
