#include "hgp/field/field_system.h"

#include <array>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// By how much a neighbour must couple more strongly than another to be preferred; otherwise the first in the row is, so
/// that rounding does not decide between equal ones.
constexpr double kPreferred = 1.0 + 1e-9;

/// The one or two fine unknowns of every patch (second: −1 for a single one); fills `patch`.
std::vector<std::array<int, 2>> matchStrongest(const FieldSystem& fine, std::vector<int>& patch) {
  const int n = fine.size();
  patch.assign(static_cast<std::size_t>(n), -1);
  std::vector<std::array<int, 2>> members;
  members.reserve(static_cast<std::size_t>(n) * 6 / 10);
  for (int i = 0; i < n; ++i) {
    if (patch[i] >= 0) continue;
    int mate = -1;
    double best = 0.0;
    for (int e = fine.start[i]; e < fine.start[i + 1]; ++e) {
      const int j = fine.other[e];
      const double score = fine.strength[e] / fine.faces[j];
      if (patch[j] >= 0 || score <= kPreferred * best) continue;
      best = score;
      mate = j;
    }
    patch[i] = static_cast<int>(members.size());
    if (mate >= 0) patch[mate] = patch[i];
    members.push_back({i, mate});
  }
  return members;
}

}  // namespace

FieldSystem pairUp(const FieldSystem& fine, Patches& patches) {
  const std::vector<std::array<int, 2>> members = matchStrongest(fine, patches.patch);
  const std::size_t n = members.size();
  patches.turn.assign(patches.patch.size(), 1.0);
  for (const auto& [first, second] : members) {
    if (second < 0) continue;
    for (int e = fine.start[second]; e < fine.start[second + 1]; ++e) {
      if (fine.other[e] != first) continue;
      const double size = portable::abs(fine.coupling[e]);
      if (size > 0.0) patches.turn[second] = -fine.coupling[e] / size;
    }
  }
  FieldSystem coarse;
  coarse.start.reserve(n + 1);
  coarse.diagonal.assign(n, 0.0);
  coarse.faces.assign(n, 0);
  coarse.mass.assign(n, 0.0);
  coarse.pull.assign(n, 0.0);
  std::vector<int> index(n, -1);  // index of a patch in the current row
  for (std::size_t c = 0; c < n; ++c) {
    const int begin = static_cast<int>(coarse.other.size());
    for (const int i : members[c]) {
      if (i < 0) continue;
      const Complex back = std::conj(patches.turn[i]);
      coarse.diagonal[c] += fine.diagonal[i];
      coarse.faces[c] += fine.faces[i];
      coarse.mass[c] += fine.mass[i];
      coarse.pull[c] += back * fine.pull[i];
      for (int e = fine.start[i]; e < fine.start[i + 1]; ++e) {
        const int j = fine.other[e], d = patches.patch[j];
        const Complex value = back * fine.coupling[e] * patches.turn[j];
        if (d == static_cast<int>(c)) {
          coarse.diagonal[c] += value.real();
        } else if (index[d] >= begin) {
          coarse.coupling[index[d]] += value;
          coarse.strength[index[d]] += fine.strength[e];
        } else {
          index[d] = static_cast<int>(coarse.other.size());
          coarse.other.push_back(d);
          coarse.coupling.push_back(value);
          coarse.strength.push_back(fine.strength[e]);
        }
      }
    }
    coarse.start.push_back(static_cast<int>(coarse.other.size()));
  }
  return coarse;
}

void smoothSweeps(const FieldSystem& system, int sweeps, std::vector<Complex>& x) {
  const int n = system.size();
  const auto relax = [&](int i) {
    Complex sum = system.pull[i];
    for (int e = system.start[i]; e < system.start[i + 1]; ++e)
      sum -= system.coupling[e] * x[system.other[e]];
    x[i] = sum / system.diagonal[i];
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (sweep % 2 == 0)
      for (int i = 0; i < n; ++i) relax(i);
    else
      for (int i = n; i-- > 0;) relax(i);
  }
}

}  // namespace hgp
