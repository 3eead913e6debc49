#include "hgp/grid/rounded_map.h"

#include <cmath>
#include <limits>

#include "hgp/base/check.h"

namespace hgp {
namespace {

/// A number of cells within this fraction of the one asked for needs no correction.
constexpr double kCorrected = 0.03;
/// Densities that are tried, each corrected by the error of the one before, and their range.
constexpr int kCorrections = 4;
constexpr double kLargestCorrection = 0.6;
/// Up to this many integers, single ones are changed.
constexpr int kFewIntegers = 6;

class CellCount {
 public:
  CellCount(const GridSystem& system, const ChangeContext& context, const IntegerChoice& choice,
            double scale, double cells, const std::function<bool()>& affords)
      : system_(system),
        context_(context),
        choice_(choice),
        scale_(scale),
        cells_(cells),
        affords_(affords) {}

  RoundedMap run() {
    const RoundedMap asked = roundedMap(system_, context_, choice_, scale_, 1.0);
    if (offBy(asked) <= kCorrected) return asked;
    RoundedMap best = asked;
    double factor = 1.0, cells = asked.cells;
    for (int n = 0; n < kCorrections && offBy(best) > kCorrected; ++n) {
      factor *= std::sqrt(cells_ / cells);
      if (!(std::fabs(factor - 1.0) <= kLargestCorrection) || !affords_()) break;
      RoundedMap next = roundedMap(system_, context_, choice_, scale_, factor);
      cells = next.cells;
      if (!(cells > 0.0)) break;
      if (offBy(next) < offBy(best)) best = std::move(next);
    }
    if (offBy(best) <= kCorrected || system_.integerCount() > kFewIntegers) return best;
    return withOneChanged(asked, best);
  }

 private:
  double offBy(const RoundedMap& map) const { return std::fabs(map.cells / cells_ - 1.0); }

  /// Of the maps with one integer changed that have the number of cells, the one with the least strain; else `best`.
  RoundedMap withOneChanged(const RoundedMap& from, const RoundedMap& best) {
    RoundedMap out = best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < from.y.size(); ++j)
      for (const Gaussian unit : {Gaussian{1, 0}, Gaussian{0, 1}}) {
        const auto changed = [&](std::int64_t steps) {
          std::vector<Gaussian> y = from.y;
          y[j] = {y[j].re + steps * unit.re, y[j].im + steps * unit.im};
          return roundedMap(system_, context_, choice_, scale_, 1.0, std::move(y));
        };
        if (!affords_() || !affords_()) return out;
        // The area is a quadratic function of the integers.
        const double up = changed(1).cells, down = changed(-1).cells;
        const double slope = 0.5 * (up - down), bend = 0.5 * (up + down) - from.cells;
        const std::int64_t steps = stepsTo(cells_ - from.cells, slope, bend);
        if (steps == 0) continue;
        RoundedMap map = changed(steps);
        const double energy = choice_.energy(system_.relaxed(map.scale), map.y);
        if (offBy(map) > kCorrected || !(energy < least)) continue;
        least = energy;
        out = std::move(map);
      }
    return out;
  }

  /// The nearest integer to the smaller solution of slope s + bend s² = difference; 0 without one.
  static std::int64_t stepsTo(double difference, double slope, double bend) {
    const double root = slope * slope + 4.0 * bend * difference;
    if (!(root >= 0.0)) return 0;
    const double s = 2.0 * difference / (slope + std::copysign(std::sqrt(root), slope));
    return std::fabs(s) < 1e6 ? std::llround(s) : 0;
  }

  const GridSystem& system_;
  const ChangeContext& context_;
  const IntegerChoice& choice_;
  const double scale_, cells_;
  const std::function<bool()>& affords_;
};

}  // namespace

RoundedMap roundedMap(const GridSystem& system, const ChangeContext& context,
                      const IntegerChoice& choice, double scale, double factor,
                      std::vector<Gaussian> integers) {
  RoundedMap out;
  out.factor = factor;
  out.scale = scale * factor;
  out.y = integers.empty() ? choice.near(system.relaxed(out.scale)) : std::move(integers);
  out.x = system.changeTo(out.y, out.scale);
  out.cells = changedArea(context, out.x) * out.scale * out.scale;
  return out;
}

RoundedMap roundedToCells(const GridSystem& system, const ChangeContext& context,
                          const IntegerChoice& choice, double scale, double cells,
                          const std::function<bool()>& affords) {
  return CellCount(system, context, choice, scale, cells, affords).run();
}

}  // namespace hgp
