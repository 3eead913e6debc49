#include "hgp/features/real_unknowns.h"

#include <cmath>

#include "hgp/base/ids.h"
#include "hgp/features/sum_relations.h"

namespace hgp {
namespace {

using ComplexRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

bool isNearlyExact(double factor) {
  const double steps = kFactorSteps * factor;
  return std::fabs(steps - std::nearbyint(steps)) < 1e-9 && std::fabs(factor) < kLargestFactor;
}

/// sign · root + offset; the offset is a sum of parts of translations.
struct Expression {
  int root = -1;  ///< −1: the offset alone
  double sign = 1.0;
  RealSum offset;
};

class Equator {
 public:
  Equator(const ComplexRows& copies, const std::vector<char>& isShared)
      : copies_(copies), isShared_(isShared), link_(2 * isShared.size()), size_(link_.size(), 1) {
    for (std::size_t i = 0; i < link_.size(); ++i) link_[i].root = static_cast<int>(i);
  }

  bool equate(const EqualCoordinate& equation) {
    RealSum sum = part(equation.a, equation.isImaginary);
    addTo(sum, part(equation.b, equation.isImaginary), -1.0);
    RealSum roots, offset;
    for (const auto& [variable, factor] : sum) addVariable(variable, factor, roots, offset);
    if (roots.empty()) {
      if (!offset.empty()) relations_.push_back(std::move(offset));
      return true;
    }
    const auto first = *roots.begin();
    if (roots.size() == 1) {  // factor · root + offset = 0
      link_[at(first.first)] = {-1, 1.0, {}};
      addTo(link_[at(first.first)].offset, offset, -1.0 / first.second);
      return true;
    }
    const auto second = *roots.rbegin();
    if (roots.size() > 2 || first.second * first.second != second.second * second.second)
      return false;
    // The smaller class joins the larger one: root = −(other factor / factor) other − offset / factor.
    const bool isFirst = size_[at(first.first)] < size_[at(second.first)];
    const auto& [from, factor] = isFirst ? first : second;
    const auto& [to, otherFactor] = isFirst ? second : first;
    link_[at(from)] = {to, -otherFactor / factor, {}};
    addTo(link_[at(from)].offset, offset, -1.0 / factor);
    size_[at(to)] += size_[at(from)];
    return true;
  }

  std::optional<RealUnknowns> collect() {
    std::optional<std::map<int, RealSum>> solved = solveSums(std::move(relations_));
    if (!solved) return {};
    RealUnknowns out;
    std::vector<int> index(link_.size(), -1);
    for (int i = 0; i < static_cast<int>(link_.size()); ++i) {
      const bool isFree = isShared_[at(i / 2)] ? !solved->contains(i) : link_[at(i)].root == i;
      if (!isFree) continue;
      index[at(i)] = out.count++;
      out.variable.push_back(i);
    }
    out.rows = RealUnknowns::Rows(2 * copies_.rows(), out.count);
    out.rows.reserve(2 * copies_.nonZeros());
    for (int row = 0; row < 2 * copies_.rows(); ++row) {
      RealSum sum, roots, offset;
      for (const auto& [variable, factor] : part(row / 2, row % 2 == 1))
        addVariable(variable, factor, roots, offset);
      for (const auto& [variable, factor] : offset) {
        const auto found = solved->find(variable);
        if (found == solved->end())
          addTo(sum, {{variable, factor}}, 1.0);
        else
          addTo(sum, found->second, factor);
      }
      addTo(sum, roots, 1.0);
      out.rows.startVec(row);
      for (const auto& [variable, factor] : sum)
        out.rows.insertBack(row, index[at(variable)]) = factor;
    }
    out.rows.finalize();
    return out;
  }

 private:
  static double exact(double factor) {
    return std::nearbyint(kFactorSteps * factor) / kFactorSteps;
  }

  /// The real or imaginary part of a copy in parts of the unknowns.
  RealSum part(int copy, bool isImaginary) const {
    RealSum sum;
    for (ComplexRows::InnerIterator it(copies_, copy); it; ++it) {
      const int variable = 2 * static_cast<int>(it.col());
      const double re = exact(it.value().real()), im = exact(it.value().imag());
      addTo(sum, {{variable, isImaginary ? im : re}, {variable + 1, isImaginary ? re : -im}}, 1.0);
    }
    return sum;
  }

  /// The expression of a variable that is not a translation, with its path compressed.
  const Expression& find(int variable) {
    Expression& own = link_[at(variable)];
    if (own.root < 0 || own.root == variable) return own;
    std::vector<int> path{variable};
    while (true) {
      const int next = link_[at(path.back())].root;
      if (next < 0 || next == link_[at(next)].root) break;
      path.push_back(next);
    }
    for (std::size_t n = path.size(); n-- > 0;) {
      Expression& e = link_[at(path[n])];
      if (e.root < 0) continue;
      const Expression& parent = link_[at(e.root)];
      if (parent.root == e.root) continue;
      addTo(e.offset, parent.offset, e.sign);
      e.sign *= parent.sign;
      e.root = parent.root;
    }
    return own;
  }

  void addVariable(int variable, double factor, RealSum& roots, RealSum& offset) {
    if (isShared_[at(variable / 2)]) {
      addTo(offset, {{variable, factor}}, 1.0);
      return;
    }
    const Expression& e = find(variable);
    if (e.root >= 0) addTo(roots, {{e.root, factor * e.sign}}, 1.0);
    addTo(offset, e.offset, factor);
  }

  const ComplexRows& copies_;
  const std::vector<char>& isShared_;
  std::vector<Expression> link_;
  std::vector<int> size_;
  std::vector<RealSum> relations_;
};

}  // namespace

Eigen::VectorXd partsOf(const Eigen::VectorXcd& x, const std::vector<int>& parts) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i)
    values.data()[i] = reinterpret_cast<const double*>(x.data())[parts[i]];
  return values;
}

void setParts(const Eigen::VectorXd& values, const std::vector<int>& parts, Eigen::VectorXcd& x) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    reinterpret_cast<double*>(x.data())[parts[i]] = values.data()[i];
}

std::vector<Complex> placesOf(const RealUnknowns& unknowns, const Eigen::VectorXd& x) {
  const Eigen::VectorXd parts = unknowns.rows * x;
  std::vector<Complex> z;
  for (Eigen::Index n = 0; n < parts.size(); n += 2) z.emplace_back(parts[n], parts[n + 1]);
  return z;
}

std::optional<RealUnknowns> equateCoordinates(const ComplexRows& copies,
                                              const std::vector<char>& isShared,
                                              const std::vector<EqualCoordinate>& equations) {
  for (int row = 0; row < copies.rows(); ++row)
    for (ComplexRows::InnerIterator it(copies, row); it; ++it)
      if (!isNearlyExact(it.value().real()) || !isNearlyExact(it.value().imag())) return {};
  Equator equator(copies, isShared);
  for (const EqualCoordinate& equation : equations)
    if (!equator.equate(equation)) return {};
  return equator.collect();
}

}  // namespace hgp
