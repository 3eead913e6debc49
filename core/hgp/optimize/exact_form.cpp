#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/harmonic_rows.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

class ExactForm : public ProgramForm {
 public:
  ExactForm(const ProgramInput& in, const ExactObjective& objective, const HeldUnknowns& held)
      : in_(in), vertexTree_(*objective.vertexTree), held_(held) {}
  int number(int unknown) const override { return free_.number(unknown); }

  Eigen::VectorXcd expand(const Eigen::VectorXcd& x) const override {
    Eigen::VectorXcd all(static_cast<Eigen::Index>(kept_.size()));
    for (std::size_t i = 0; i < kept_.size(); ++i)
      all[static_cast<Eigen::Index>(i)] = isHeld(kept_[i]) ? 0.0 : x[number(kept_[i])];
    return lu_.extend(all);
  }

  bool build() {
    chooseKept();
    if (static_cast<int>(kept_.size()) > kLargestExactRoot) return false;
    if (!lu_.build(squareRows(in_), kept_, unknownTree(in_, vertexTree_))) return false;
    return buildRoot();
  }

 private:
  /// Keeps unknowns that occur in a frame condition or have no harmonic row: translations, boundary, cones.
  void chooseKept() {
    std::vector<char> isKept = unknownsWithRows(in_);
    for (char& kept : isKept) kept = !kept;
    for (std::size_t i = 0; i < isKept.size(); ++i)
      if (held_.isHeld[i]) isKept[i] = 1;
    FaceRows rows;
    const auto keep = [&](FaceId f) {
      faceRows(in_, held_, f, rows);
      for (const FaceRows::Term& term : rows.terms) isKept[at(term.unknown)] = 1;
    };
    for (FaceId f : in_.frames.faces) keep(f);
    for (FaceId f : in_.options.soft.faces) keep(f);
    std::vector<int> free;
    for (std::size_t i = 0; i < isKept.size(); ++i) {
      if (!isKept[i]) continue;
      kept_.push_back(static_cast<int>(i));
      if (!held_.isHeld[i]) free.push_back(kept_.back());
    }
    free_ = FreeUnknowns(free, in_.unknowns.count);
  }

  /// H = SᴴD²S + the distortion of the constrained faces, which makes the minimiser unique.
  bool buildRoot() {
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(kept_.size()));
    for (VertexId v : in_.mesh.vertices()) {
      const int unknown = in_.unknowns.vertexUnknown[v];
      if (unknown < 0) continue;
      const auto found = std::lower_bound(kept_.begin(), kept_.end(), unknown);
      if (found != kept_.end() && *found == unknown)
        weight[found - kept_.begin()] = portable::exp(-in_.options.u[v]);
    }
    const Eigen::MatrixXcd gram = lu_.gram(weight);
    const int count = free_.count();
    Eigen::MatrixXcd H(count, count);
    for (std::size_t j = 0; j < kept_.size(); ++j)
      for (std::size_t i = j; i < kept_.size(); ++i) {
        if (isHeld(kept_[i]) || isHeld(kept_[j])) continue;
        const Complex value = gram(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        H(number(kept_[i]), number(kept_[j])) = value;
        H(number(kept_[j]), number(kept_[i])) = std::conj(value);
      }
    c = Eigen::VectorXcd::Zero(count);
    linalg::Cliques cliques;
    FaceRows rows;
    const auto addDistortion = [&](FaceId f, double delta) {
      faceRows(in_, held_, f, rows);
      rewrite(rows);
      scaleToDistortion(in_, f, delta, rows);
      addSquares(
          rows, 1.0, 1.0, [&](int i, const Complex& value) { c[i] += value; },
          [&](int i, int j, const Complex& value) { H(i, j) += value; });
    };
    for (FaceId f : in_.frames.faces) {
      addDistortion(f, in_.options.tieBreak);
      cliques.push_back(rows.unknowns());
    }
    for (FaceId f : in_.options.soft.faces) addDistortion(f, in_.options.soft.weight);
    linalg::SeparatorTree root;
    root.order.resize(static_cast<std::size_t>(count));
    std::iota(root.order.begin(), root.order.end(), 0);
    root.nodeStart = {0, count};
    root.parent = {-1};
    linalg::PartialCholeskyOptions options;
    options.tree = &root;
    options.delayDepth = 0;
    return static_cast<bool>(cholesky.build(H.sparseView(), cliques, options));
  }

  bool isHeld(int unknown) const { return held_.isHeld[static_cast<std::size_t>(unknown)] != 0; }

  const ProgramInput& in_;
  const linalg::SeparatorTree& vertexTree_;
  const HeldUnknowns& held_;  // the pinned unknown, held at 0
  std::vector<int> kept_;
  FreeUnknowns free_;  // those of kept_ that are not held
  linalg::SchurLu lu_;
};

}  // namespace

std::unique_ptr<ProgramForm> exactForm(const ProgramInput& in, const ExactObjective& objective,
                                       const HeldUnknowns& held) {
  auto form = std::make_unique<ExactForm>(in, objective, held);
  if (!form->build()) return nullptr;
  return form;
}

}  // namespace hgp
