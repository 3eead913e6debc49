#include "hgp/seams/cyclotomic.h"

#include <algorithm>

namespace hgp {

Cyclotomic Cyclotomic::turned(long long r, int order) {
  Cyclotomic a;
  a.q_ = order;
  a.add(reduceTurn(r, order), 1);
  return a;
}

void Cyclotomic::add(int power, std::int64_t count) {
  if (q_ % 2 == 0 && power >= q_ / 2) {
    power -= q_ / 2;
    count = -count;
  }
  const auto found =
      std::lower_bound(terms_.begin(), terms_.end(), power,
                       [](const auto& term, int wanted) { return term.first < wanted; });
  if (found == terms_.end() || found->first != power) {
    if (count != 0) terms_.insert(found, {power, count});
    return;
  }
  found->second += count;
  if (found->second == 0) terms_.erase(found);
}

Cyclotomic operator+(const Cyclotomic& a, const Cyclotomic& b) {
  Cyclotomic sum = a;
  sum.q_ = std::max(a.q_, b.q_);
  for (const auto& [power, count] : b.terms_) sum.add(power, count);
  return sum;
}

Cyclotomic operator-(const Cyclotomic& a) {
  Cyclotomic opposite = a;
  for (auto& [power, count] : opposite.terms_) count = -count;
  return opposite;
}

Cyclotomic operator*(const Cyclotomic& a, const Cyclotomic& b) {
  Cyclotomic product;
  product.q_ = std::max(a.q_, b.q_);
  for (const auto& [i, m] : a.terms_)
    for (const auto& [j, n] : b.terms_) product.add(reduceTurn(i + j, product.q_), m * n);
  return product;
}

Cyclotomic conjugate(const Cyclotomic& a) {
  Cyclotomic mirrored;
  mirrored.q_ = a.q_;
  for (const auto& [power, count] : a.terms_) mirrored.add(reduceTurn(-power, a.q_), count);
  return mirrored;
}

bool isZero(const Cyclotomic& a) {
  if (a.terms_.empty()) return true;
  // The usual case: n ζ^r is not 0.
  if (a.terms_.size() == 1) return false;
  std::vector<std::int64_t> f(static_cast<std::size_t>(a.q_), 0);
  for (const auto& [power, count] : a.terms_) f[static_cast<std::size_t>(power)] = count;
  int rest = a.q_;
  for (int p = 2; rest > 1; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    std::vector<std::int64_t> next(f.size(), 0);  // f · (x^{q/p} − 1)
    for (std::size_t r = 0; r < f.size(); ++r) {
      next[(r + static_cast<std::size_t>(a.q_ / p)) % f.size()] += f[r];
      next[r] -= f[r];
    }
    f = std::move(next);
  }
  return std::all_of(f.begin(), f.end(), [](std::int64_t n) { return n == 0; });
}

bool isUnit(const Cyclotomic& a) {
  return a.terms_.size() == 1 && (a.terms_[0].second == 1 || a.terms_[0].second == -1);
}

std::int64_t norm(const Cyclotomic& a) {
  std::int64_t sum = 0;
  for (const auto& [power, count] : a.terms_) sum += count * count;
  return sum;
}

Complex toComplex(const Cyclotomic& a) {
  Complex sum = 0.0;
  for (const auto& [power, count] : a.terms_)
    sum += static_cast<double>(count) * rotation(power, a.q_);
  return sum;
}

}  // namespace hgp
