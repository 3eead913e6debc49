// Separates cones by a minimum distance in their own metric: a part of ConePlacer.
#include <algorithm>
#include <cmath>
#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"
#include "hgp/cones/cone_distances.h"
#include "hgp/cones/cone_placer.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Maximum number of rounds; each starts with the metric of the cones that the last one moved.
constexpr int kSeparatingRounds = 16;
/// A cone is moved by at most this multiple of the required distance.
constexpr double kAside = 2.0;
/// Separation may not widen max u − min u beyond this or its present value: with a wider range of scales, solving for
/// the map takes more rounds.
constexpr double kWidestRange = 7.5;

/// Limits on the solves, and on nodes × solves, of a separation.
constexpr double kMinSolves = 8.0, kMaxSolves = 250.0, kMaxNodeSolves = 2e7;
/// Number of candidate moves per pair whose energy is computed, and how many of them share one block of solves, in
/// which each costs a fraction of a single solve.
constexpr std::size_t kWaysMeasured = 2, kWaysAtOnce = 32;
constexpr double kShareOfBlock = 0.5;
/// R/√area of roughPrice().
constexpr double kReachOfDipole = 0.5;

double rangeOf(const Eigen::VectorXd& u) { return u.maxCoeff() - u.minCoeff(); }

}  // namespace

/// The node near v, at least `least` from all other cones, at which v's defect costs least to first order; −1: none.
int ConePlacer::nodeAside(ConeDistances& distances, VertexId v, double least,
                          const Eigen::VectorXd& g) const {
  const int d = defects_[at(surface_.node[v])];
  std::vector<VertexId> others, around = distances.around({v}, (1.0 + kAside) * least);
  for (VertexId w : around)
    if (w != v && defects_[at(surface_.node[w])] != 0) others.push_back(w);
  around = distances.around({v}, kAside * least);
  std::vector<VertexId> taken = distances.around(others, least);
  std::sort(taken.begin(), taken.end());
  int best = -1;
  for (VertexId w : around) {
    const int node = surface_.node[w];
    if (w == v || !fits(node, d) || std::binary_search(taken.begin(), taken.end(), w)) continue;
    if (best < 0 || d * g[node] < d * g[best]) best = node;
  }
  return best;
}

/// Estimates the increase of the energy by a short move: to first order from the gradient, to second order from the
/// variance of the dipole that it adds to u. With p = d·(2π/q)·r in a plane of area 1: ∫ u² = p²/(4π) ln(R/r).
double ConePlacer::roughPrice(const UnitMove& move, const Eigen::VectorXd& g) const {
  const Vec3 &a = mesh_.position(vertexOf_[at(move.from)]),
             &b = mesh_.position(vertexOf_[at(move.to)]);
  const double r = distance(a, b) / metric_.size();
  const double p = move.units * turnAngle(1, metric_.q()) * r;
  const double dipole = p * p / (4.0 * kPi) * std::max(1.0, portable::log(kReachOfDipole / r));
  return move.units * (g[move.to] - g[move.from]) + dipole;
}

/// Moves that separate a and b, by merging them or moving one away: the kWaysMeasured with the lowest estimate.
std::vector<ConePlacer::PricedMove> ConePlacer::waysApart(ConeDistances& distances, VertexId a,
                                                          VertexId b, double least,
                                                          const Eigen::VectorXd& g) const {
  std::vector<PricedMove> ways;
  const auto offer = [&](const UnitMove& move) {
    ways.push_back({move, roughPrice(move, g), {a, b}});
  };
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
    const int i = surface_.node[from], j = surface_.node[to];
    const int d = defects_[at(i)];
    if (!fits(i, 0)) continue;
    if (!keepsCount_ && fits(j, defects_[at(j)] + d)) offer({i, j, d});
    if (const int node = nodeAside(distances, from, least, g); node >= 0) offer({i, node, d});
  }
  sortStably(ways, isCheaper);
  ways.resize(std::min(ways.size(), kWaysMeasured));
  return ways;
}

/// Computes the energy of every move from the current cones and keeps the cheapest of each pair; cheapest first.
std::vector<ConePlacer::PricedMove> ConePlacer::cheapestOfEach(
    std::vector<std::vector<PricedMove>> groups) const {
  std::vector<PricedMove*> all;
  for (auto& group : groups)
    for (PricedMove& move : group) all.push_back(&move);
  for (std::size_t first = 0; first < all.size(); first += kWaysAtOnce) {
    std::vector<UnitMove> block;
    for (std::size_t i = first; i < std::min(all.size(), first + kWaysAtOnce); ++i)
      block.push_back(all[i]->move);
    const Eigen::MatrixXd response = metric_.moveResponse(block);
    for (std::size_t i = 0; i < block.size(); ++i) {
      ConeCost cost = cost_;
      cost.u += response.col(static_cast<Eigen::Index>(i));
      cost.natural += block[i].units * (metric_.naturalResponse(block[i].to) -
                                        metric_.naturalResponse(block[i].from));
      metric_.measure(cost);
      all[first + i]->price = cost.energy - cost_.energy;
    }
  }
  std::vector<PricedMove> chosen;
  chosen.reserve(groups.size());
  for (const auto& group : groups)
    chosen.push_back(*std::min_element(group.begin(), group.end(), isCheaper));
  sortStably(chosen, isCheaper);
  return chosen;
}

/// Applies moves first … last − 1 together; undoes them and returns false if the result exceeds the limits.
bool ConePlacer::applyAll(const std::vector<PricedMove>& moves, std::size_t first, std::size_t last,
                          const EnergyLimits& limits) {
  nodeSolves_ -= metric_.nodeCount();
  const NodeDefects defectsBefore = defects_;
  const ConeCost costBefore = cost_;
  for (std::size_t i = first; i < last; ++i) {
    const UnitMove& move = moves[i].move;
    if (fits(move.to, defects_[at(move.to)] + move.units)) apply(move);
  }
  measure();
  if (cost_.energy <= limits.energy && rangeOf(cost_.u) <= limits.range) return true;
  defects_ = defectsBefore;
  setCost(costBefore);
  return false;
}

/// The same; if it fails, the two halves separately, so that one expensive move does not prevent the others.
bool ConePlacer::applyWithin(const std::vector<PricedMove>& moves, std::size_t first,
                             std::size_t last, const EnergyLimits& limits) {
  if (first == last || nodeSolves_ <= 0.0) return false;
  if (applyAll(moves, first, last, limits)) return true;
  if (last - first == 1) return false;
  const std::size_t middle = first + (last - first + 1) / 2;
  const bool isFirst = applyWithin(moves, first, middle, limits);
  return applyWithin(moves, middle, last, limits) || isFirst;
}

/// Applies the cheapest move of every pair, as far as limits and work allow; false if there is no move left to try.
bool ConePlacer::partPairs(ConeDistances& distances, const std::vector<ConeDistances::Pair>& pairs,
                           double least, const Eigen::VectorXd& g, const EnergyLimits& limits,
                           std::set<std::pair<VertexId, VertexId>>& held) {
  std::vector<std::vector<PricedMove>> groups;
  std::vector<VertexId> touched;
  for (const ConeDistances::Pair& pair : pairs) {
    // A cone takes part in one move per round; the next round measures the metric after it.
    const bool isFresh = std::none_of(touched.begin(), touched.end(),
                                      [&](VertexId v) { return v == pair.a || v == pair.b; });
    if (!isFresh || nodeSolves_ <= 0.0 || held.contains({pair.a, pair.b})) continue;
    std::vector<PricedMove> ways = waysApart(distances, pair.a, pair.b, least, g);
    if (ways.empty()) continue;
    nodeSolves_ -= kShareOfBlock * metric_.nodeCount() * static_cast<double>(ways.size());
    groups.push_back(std::move(ways));
    touched.insert(touched.end(), {pair.a, pair.b});
  }
  const std::vector<PricedMove> moves = cheapestOfEach(std::move(groups));
  const NodeDefects before = defects_;
  applyWithin(moves, 0, moves.size(), limits);
  for (const PricedMove& m : moves)
    if (defects_[at(m.move.from)] == before[at(m.move.from)]) held.insert(m.pair);
  return !moves.empty();
}

/// Applies the merges that lower the energy to first order, as many of the best as stay within the limits; usually
/// one or two solves suffice for all of them.
bool ConePlacer::mergeDownhill(const std::vector<ConeDistances::Pair>& pairs,
                               const Eigen::VectorXd& g, const EnergyLimits& limits) {
  std::vector<PricedMove> moves;
  for (const ConeDistances::Pair& pair : pairs) {
    const int i = surface_.node[pair.a], j = surface_.node[pair.b];
    const auto isTouched = [&](const PricedMove& m) {
      return m.pair.first == pair.a || m.pair.second == pair.a || m.pair.first == pair.b ||
             m.pair.second == pair.b;
    };
    const int sum = defects_[at(i)] + defects_[at(j)];
    std::optional<PricedMove> best;
    for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, i}}) {
      const int d = defects_[at(from)];
      const PricedMove move{{from, to, d}, d * (g[to] - g[from]), {pair.a, pair.b}};
      if (move.price <= 0.0 && fits(from, 0) && fits(to, sum) &&
          (!best || move.price < best->price))
        best = move;
    }
    if (best && std::none_of(moves.begin(), moves.end(), isTouched)) moves.push_back(*best);
  }
  sortStably(moves, isCheaper);
  for (std::size_t count = moves.size(); count > 0; count /= 2)
    if (applyAll(moves, 0, count, limits)) return true;
  return false;
}

void ConePlacer::separate(const ConeSpacing& spacing) {
  const double least = spacing.least;
  const EnergyLimits limits{(1.0 + spacing.dearest) * cost_.energy,
                            std::max(kWidestRange, 1.02 * rangeOf(cost_.u))};
  const double nodes = metric_.nodeCount();
  std::set<std::pair<VertexId, VertexId>> held;  // pairs that cannot be separated within the limits
  nodeSolves_ = std::max(kMinSolves * nodes, std::min(kMaxSolves * nodes, kMaxNodeSolves));
  NodeDefects last, lastButOne;
  bool isDownhill = !keepsCount_;
  for (int round = 0; round < kSeparatingRounds && nodeSolves_ > 0.0; ++round) {
    ConeDistances distances(mesh_, metric_, cost_.u);
    const std::vector<ConeDistances::Pair> pairs = distances.closer(defects_, least);
    const bool isBackAndForth = defects_ == lastButOne && defects_ != last;
    if (pairs.empty() || isBackAndForth) return;
    lastButOne = std::exchange(last, defects_);
    const Eigen::VectorXd g = metric_.scaleGradient(cost_);
    nodeSolves_ -= nodes;
    if (isDownhill && mergeDownhill(pairs, g, limits)) continue;
    isDownhill = false;
    if (!partPairs(distances, pairs, least, g, limits, held)) return;
  }
}

}  // namespace hgp
