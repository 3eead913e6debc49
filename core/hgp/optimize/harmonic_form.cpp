#include <algorithm>
#include <numeric>

#include "hgp/optimize/harmonic_basis.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

class HarmonicForm : public ProgramForm {
 public:
  explicit HarmonicForm(const HarmonicBasis& basis) : basis_(basis) {
    all_.resize(static_cast<std::size_t>(basis_.count()));
    std::iota(all_.begin(), all_.end(), 0);
  }
  int number(int) const override { return -1; }
  Eigen::VectorXcd expand(const Eigen::VectorXcd& y) const override { return basis_.expand(y); }
  bool isDense() const override { return true; }

  void rewrite(FaceRows& rows) const override {
    FaceRows dense;
    dense.heldSimilar = rows.heldSimilar;
    dense.heldAnti = rows.heldAnti;
    for (const int j : all_) dense.terms.push_back({j, 0.0, 0.0});
    for (const FaceRows::Term& term : rows.terms) {
      const auto found = std::lower_bound(near_.begin(), near_.end(), term.unknown);
      const auto row = rowsNear_.row(found - near_.begin());
      for (FaceRows::Term& out : dense.terms) {
        out.similar += term.similar * row[out.unknown];
        out.anti += term.anti * row[out.unknown];
      }
    }
    rows = std::move(dense);
  }

  bool build(const ProgramInput& in) {
    FaceRows rows;
    const HeldUnknowns none{std::vector<char>(static_cast<std::size_t>(in.unknowns.count), 0), {}};
    for (FaceId f : in.frames.faces) {
      faceRows(in, none, f, rows);
      for (const FaceRows::Term& term : rows.terms) near_.push_back(term.unknown);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    if (!near_.empty()) rowsNear_ = basis_.rowsOf(near_);
    linalg::Cliques cliques;
    if (!in.frames.faces.empty()) cliques.push_back(all_);
    linalg::SeparatorTree root;
    root.order = all_;
    root.nodeStart = {0, basis_.count()};
    root.parent = {-1};
    linalg::PartialCholeskyOptions options;
    options.tree = &root;
    options.delayDepth = 0;
    c = basis_.distortion().c;
    return static_cast<bool>(cholesky.build(basis_.distortion().H.sparseView(), cliques, options));
  }

 private:
  const HarmonicBasis& basis_;
  std::vector<int> all_;   // 0 … count − 1
  std::vector<int> near_;  // unknowns of frames' faces, ascending
  Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rowsNear_;
};

}  // namespace

std::unique_ptr<ProgramForm> harmonicForm(const ProgramInput& in,
                                          const HarmonicObjective& objective) {
  if (!objective.basis) return nullptr;
  auto form = std::make_unique<HarmonicForm>(*objective.basis);
  if (!form->build(in)) return nullptr;
  return form;
}

}  // namespace hgp
