#include "integer_sums.h"

namespace hgp::stress {
namespace {

/// ways[i][s − least[i]]: how many x_i … x_n−1 sum to s. Doubles: only ratios matter.
struct Completions {
  std::vector<int> least;
  std::vector<std::vector<double>> ways;

  double of(std::size_t i, int sum) const {
    const int at = sum - least[i];
    return at < 0 || at >= static_cast<int>(ways[i].size()) ? 0.0
                                                            : ways[i][static_cast<std::size_t>(at)];
  }
};

bool allows(const IntegerRange& r, int x) { return r.hole != x; }

Completions countCompletions(const std::vector<IntegerRange>& ranges) {
  const std::size_t n = ranges.size();
  Completions c;
  c.least.assign(n + 1, 0);
  c.ways.assign(n + 1, {1.0});
  int most = 0;
  for (std::size_t i = n; i-- > 0;) {
    c.least[i] = c.least[i + 1] + ranges[i].low;
    most += ranges[i].high;
    c.ways[i].assign(static_cast<std::size_t>(most - c.least[i] + 1), 0.0);
    double total = 0.0;
    for (int s = c.least[i]; s <= most; ++s) {
      double& ways = c.ways[i][static_cast<std::size_t>(s - c.least[i])];
      for (int x = ranges[i].low; x <= ranges[i].high; ++x)
        if (allows(ranges[i], x)) ways += c.of(i + 1, s - x);
      total += ways;
    }
    if (total > 0.0)
      for (double& ways : c.ways[i]) ways /= total;
  }
  return c;
}

}  // namespace

std::optional<std::vector<int>> drawWithSum(const std::vector<IntegerRange>& ranges, int sum,
                                            Random& random) {
  for (const IntegerRange& r : ranges)
    if (r.low > r.high) return {};
  const Completions c = countCompletions(ranges);
  if (!(c.of(0, sum) > 0.0)) return {};
  std::vector<int> x;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    double all = 0.0;
    for (int v = ranges[i].low; v <= ranges[i].high; ++v)
      if (allows(ranges[i], v)) all += c.of(i + 1, sum - v);
    double left = random.unit() * all;
    int chosen = 0;
    for (int v = ranges[i].low; v <= ranges[i].high; ++v) {
      const double ways = allows(ranges[i], v) ? c.of(i + 1, sum - v) : 0.0;
      if (ways <= 0.0) continue;
      chosen = v;
      if ((left -= ways) < 0.0) break;
    }
    x.push_back(chosen);
    sum -= chosen;
  }
  return x;
}

}  // namespace hgp::stress
