#include "ratios.h"

#include <algorithm>

#include "hgp/base/check.h"

namespace hgp::bench {

Ratios::Ratios(const std::vector<SurfaceRow>& rows, const std::string& of, const std::string& to,
               const Number& number, const Pair& counts) {
  for (const SurfaceRow& row : rows) {
    const MeasuredMap *a = row.find(of), *b = row.find(to);
    if (a && b && counts(row, *a, *b) && number(*b) > 0.0)
      values_.push_back(number(*a) / number(*b));
  }
  std::sort(values_.begin(), values_.end());
}

double Ratios::at(double share) const {
  return values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))];
}

std::string Ratios::cells(const std::string& label) const {
  if (values_.empty()) return "| " + label + " | 0 | | | | | |\n";
  return formatText("| %s | %d | %.3f | %.3f | **%.3f** | %.3f | %.3f |\n", label.c_str(), count(),
                    values_.front(), at(0.25), at(0.5), at(0.75), values_.back());
}

std::string ratioHead() {
  return "| ratio | surfaces | least | 25 % | median | 75 % | most |\n"
         "|---|--:|--:|--:|--:|--:|--:|\n";
}

}  // namespace hgp::bench
