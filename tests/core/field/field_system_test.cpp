#include "hgp/field/field_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hgp {
namespace {

/// A ring of n unknowns with quarter chords; turned neighbours, so that no field is parallel.
FieldSystem ring(int n, double turn) {
  FieldSystem s;
  for (int i = 0; i < n; ++i) {
    s.diagonal.push_back(1e-3);
    for (const int step : {1, n - 1, n / 4, n - n / 4}) {
      const bool isForwards = step == 1 || step == n / 4;
      s.other.push_back((i + step) % n);
      s.strength.push_back(step == 1 || step == n - 1 ? 2.0 : 0.5);
      s.coupling.push_back(-std::polar(s.strength.back(), isForwards ? -turn : turn));
      s.diagonal.back() += s.strength.back();
    }
    s.start.push_back(static_cast<int>(s.other.size()));
    s.faces.push_back(1);
    s.mass.push_back(1.0 + 0.1 * (i % 3));
    s.pull.push_back(std::polar(0.1, 0.7 * i));
  }
  return s;
}

/// ½ xᴴ A x − Re(bᴴ x)
double energy(const FieldSystem& s, const std::vector<Complex>& x) {
  double sum = 0.0;
  for (int i = 0; i < s.size(); ++i) {
    Complex row = s.diagonal[i] * x[i];
    for (int e = s.start[i]; e < s.start[i + 1]; ++e) row += s.coupling[e] * x[s.other[e]];
    sum += std::real(std::conj(x[i]) * (0.5 * row - s.pull[i]));
  }
  return sum;
}

std::vector<Complex> someField(int n) {
  std::vector<Complex> x;
  for (int i = 0; i < n; ++i) x.push_back(std::polar(1.0 + 0.3 * std::sin(i), 1.7 * i * i));
  return x;
}

TEST(FieldSystem, EnergyOnPatchesIsThatOfTheFieldTheyStandFor) {
  for (const int n : {8, 21, 64}) {
    const FieldSystem fine = ring(n, 0.4);
    Patches patches;
    const FieldSystem coarse = pairUp(fine, patches);
    EXPECT_LT(coarse.size(), 3 * n / 4);
    const std::vector<Complex> onPatches = someField(coarse.size());
    std::vector<Complex> x;
    for (int i = 0; i < n; ++i) x.push_back(patches.turn[i] * onPatches[patches.patch[i]]);
    EXPECT_NEAR(energy(coarse, onPatches), energy(fine, x), 1e-12 * n);
    double fineMass = 0.0, coarseMass = 0.0;
    for (const double m : fine.mass) fineMass += m;
    for (const double m : coarse.mass) coarseMass += m;
    EXPECT_NEAR(fineMass, coarseMass, 1e-12 * n);
  }
}

TEST(FieldSystem, PairsAreNeighboursAndParallel) {
  const FieldSystem fine = ring(40, 0.4);
  Patches patches;
  const FieldSystem coarse = pairUp(fine, patches);
  std::vector<std::vector<int>> members(static_cast<std::size_t>(coarse.size()));
  for (int i = 0; i < fine.size(); ++i) members[patches.patch[i]].push_back(i);
  int pairs = 0;
  for (const std::vector<int>& m : members) {
    ASSERT_GE(m.size(), 1u);
    ASSERT_LE(m.size(), 2u);
    if (m.size() == 1) continue;
    ++pairs;
    bool isJoined = false;
    for (int e = fine.start[m[1]]; e < fine.start[m[1] + 1]; ++e) {
      if (fine.other[e] != m[0]) continue;
      isJoined = true;
      // −A_ij x_j is what i would be if j alone decided.
      const Complex wanted = -fine.coupling[e] / std::abs(fine.coupling[e]) * patches.turn[m[0]];
      EXPECT_NEAR(std::abs(wanted - patches.turn[m[1]]), 0.0, 1e-14);
    }
    EXPECT_TRUE(isJoined);
  }
  EXPECT_GT(pairs, 10);
}

TEST(FieldSystem, PairingGoesOnDownToAFewPatches) {
  // An uneven grid whose lines close: by strength alone one patch swallows its surroundings.
  const int side = 160;
  FieldSystem system;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side, column = i % side;
    for (const int j :
         {row * side + (column + 1) % side, row * side + (column + side - 1) % side,
          (row + 1) % side * side + column, (row + side - 1) % side * side + column}) {
      system.other.push_back(j);
      const int a = std::min(i, j), b = std::max(i, j);
      system.strength.push_back(std::exp(static_cast<int>((a * 7919LL + b * 104729LL) % 31) / 4.0));
      system.coupling.push_back(-system.strength.back());
    }
    system.start.push_back(static_cast<int>(system.other.size()));
    system.diagonal.push_back(1e4);
    system.mass.push_back(1.0);
    system.pull.push_back(0.0);
    system.faces.push_back(1);
  }
  int levels = 0;
  while (system.size() > 64 && ++levels < 40) {
    Patches patches;
    const FieldSystem coarse = pairUp(system, patches);
    EXPECT_LT(coarse.size(), 0.7 * system.size());
    system = coarse;
  }
  EXPECT_LE(system.size(), 64);
  int faces = 0, largest = 0;
  for (const int n : system.faces) {
    faces += n;
    largest = std::max(largest, n);
  }
  EXPECT_EQ(faces, side * side);
  EXPECT_LT(largest, 8 * side * side / system.size());
}

TEST(FieldSystem, SweepsLowerTheEnergyAndStopAtTheMinimiser) {
  const FieldSystem system = ring(30, 0.4);
  std::vector<Complex> x = someField(system.size());
  double last = energy(system, x);
  for (int i = 0; i < 20; ++i) {
    smoothSweeps(system, 2, x);
    const double now = energy(system, x);
    EXPECT_LE(now, last + 1e-12);
    last = now;
  }
  smoothSweeps(system, 2000, x);
  const std::vector<Complex> still = x;
  smoothSweeps(system, 1, x);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(std::abs(x[i] - still[i]), 0.0, 1e-9);
}

}  // namespace
}  // namespace hgp
