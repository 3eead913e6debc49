#include "hgp/cones/cone_placer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "hgp/base/stable_order.h"

namespace hgp {
namespace {

/// Initial maximum number of edges that a cone moves downhill in one step of relax().
constexpr int kFirstReach = 16;
/// relax() ends when the relative decrease of the energy is below this.
constexpr double kMinDecrease = 5e-3;
/// Fractions of the cones to move at once: first all, then fewer, because many simultaneous moves can overshoot.
constexpr double kParts[] = {1.0, 0.5, 0.25, 0.1};
/// Fraction of the remaining node solves for moving cones after some were added or removed.
constexpr double kShareOfOneStep = 0.2;
/// Maximum number of right-hand sides per solve, and of the numbers in them.
constexpr std::size_t kBlock = 32;
constexpr std::size_t kBlockNumbers = 4'000'000;
/// Nodes for which the energy is computed exactly before a unit is added.
constexpr int kCandidates = 6;

/// Gᵀ diag(weight) G, some rows at a time.
Eigen::MatrixXd weightedGram(const Eigen::MatrixXd& G, const Eigen::VectorXd& weight) {
  constexpr Eigen::Index kRows = 256;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(G.cols(), G.cols());
  Eigen::MatrixXd weighted;
  for (Eigen::Index first = 0; first < G.rows(); first += kRows) {
    const Eigen::Index rows = std::min(kRows, G.rows() - first);
    const auto part = G.middleRows(first, rows);
    weighted = weight.segment(first, rows).asDiagonal() * part;
    gram.noalias() += part.transpose() * weighted;
  }
  return gram;
}

}  // namespace

ConePlacer::ConePlacer(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start,
                       DefectBounds bounds)
    : mesh_(mesh),
      metric_(metric),
      surface_(metric.context().surface),
      bounds_(std::move(bounds)),
      defects_(std::move(start)) {
  vertexOf_.resize(static_cast<std::size_t>(metric.nodeCount()));
  for (VertexId v : mesh.vertices())
    if (surface_.isInterior(mesh, v)) vertexOf_[at(surface_.node[v])] = v;
  for (std::size_t n = 0; n < defects_.size(); ++n)
    defects_[n] = std::clamp(defects_[n], bounds_.low[n], bounds_.high[n]);
  measure();
}

void ConePlacer::restore(const ConePlacer& other) {
  defects_ = other.defects_;
  setCost(other.cost_);
}

int ConePlacer::missing() const {
  return metric_.total() - std::accumulate(defects_.begin(), defects_.end(), 0);
}

void ConePlacer::setCost(ConeCost cost) {
  cost_ = std::move(cost);
  slope_.reset();
}

void ConePlacer::settle(double part) {
  for (int reach = kFirstReach; reach >= 1;) reach = walkTogether(reach, part) ? reach : reach / 2;
}

void ConePlacer::relax(double share) {
  const double before = nodeSolves_;
  nodeSolves_ *= share;
  for (const double part : kParts) settle(part);
  for (int reach = kFirstReach; reach >= 1;) reach = walkOneByOne(reach) ? reach : reach / 4;
  nodeSolves_ += (1.0 - share) * before;
}

void ConePlacer::growTo(int count) {
  count = std::min(count, mesh_.vertexCount());
  for (int stalls = 0; cones() < count && stalls < 4;) {
    const int before = cones();
    for (int pairs = 1 + (count - before) / 8; pairs > 0; --pairs)
      if (!addUnits({1, -1}, true)) return;
    relax(kShareOfOneStep);
    stalls = cones() > before ? 0 : stalls + 1;
  }
}

void ConePlacer::shrinkTo(int count) {
  for (int now = cones(); now > count;) {
    thinTo(std::max(count, now - std::max(1, now / 4)));
    relax(kShareOfOneStep);
    if (cones() >= now) return;
    now = cones();
  }
}

bool ConePlacer::balance() {
  for (int left = missing(); left != 0; left = missing())
    if (!addUnits({left > 0 ? 1 : -1})) return false;
  return true;
}

std::pair<int, double> ConePlacer::walk(int node, double sign, int reach,
                                        const ConeSlope& slope) const {
  double total = 0.0;
  for (int step = 0; step < reach; ++step) {
    int best = node;
    double least = 0.0;
    eachNeighbour(node, [&](int w, HalfedgeId h) {
      const double change = slope.along(mesh_, h, node, w);
      if (sign * change >= sign * least) return;
      least = change;
      best = w;
    });
    if (best == node) break;
    total += least;
    node = best;
  }
  return {node, total};
}

/// For the current cones; solved once until they change.
const ConeSlope& ConePlacer::slope() {
  if (!slope_) {
    slope_ = metric_.slope(cost_);
    nodeSolves_ -= metric_.nodeCount();
  }
  return *slope_;
}

/// One move per cone, at most `reach` edges downhill; the largest first-order decrease comes first.
std::vector<UnitMove> ConePlacer::downhillMoves(int reach) {
  const ConeSlope& slope = this->slope();
  struct Found {
    UnitMove move;
    double change;
  };
  std::vector<Found> found;
  for (int n = 0; n < metric_.nodeCount(); ++n) {
    const int d = defects_[at(n)];
    if (d == 0 || !vertexOf_[at(n)].isValid()) continue;
    const auto [end, change] = walk(n, d, reach, slope);
    const UnitMove move{n, end, d};
    if (move.to != n && isAllowed(move)) found.push_back({move, d * change});
  }
  sortStably(found, [](const Found& a, const Found& b) { return a.change < b.change; });
  std::vector<UnitMove> moves;
  moves.reserve(found.size());
  for (const Found& f : found) moves.push_back(f.move);
  return moves;
}

/// A move onto a cone of the same sign is not allowed: it would merge cones, which separate() decides.
bool ConePlacer::isAllowed(const UnitMove& m) const {
  const bool isLoop = !vertexOf_[at(m.to)].isValid();
  const int meeting = isLoop ? 0 : defects_[at(m.to)] * m.units;
  if (meeting > 0 || (keepsCount_ && (isLoop || meeting < 0))) return false;
  return fits(m.from, defects_[at(m.from)] - m.units) && fits(m.to, defects_[at(m.to)] + m.units);
}

void ConePlacer::apply(const UnitMove& m) {
  defects_[at(m.from)] -= m.units;
  defects_[at(m.to)] += m.units;
}

/// Applies the fraction `share` of the moves with the largest first-order decrease. Undoes them and returns false if
/// the energy does not decrease by kMinDecrease.
bool ConePlacer::walkTogether(int reach, double share) {
  if (nodeSolves_ <= 0.0) return false;
  const NodeDefects before = defects_;
  const std::vector<UnitMove> moves = downhillMoves(reach);
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(moves.size())));
  for (std::size_t i = 0; i < count; ++i)
    if (isAllowed(moves[i])) apply(moves[i]);
  ConeCost cost = metric_.cost(defects_);
  nodeSolves_ -= metric_.nodeCount();
  if (cost.energy < (1.0 - kMinDecrease) * cost_.energy) {
    setCost(std::move(cost));
    return true;
  }
  defects_ = before;
  return false;
}

bool ConePlacer::walkOneByOne(int reach) {
  if (nodeSolves_ <= 0.0) return false;
  const double before = cost_.energy;
  const std::vector<UnitMove> moves = downhillMoves(reach);
  const std::size_t size =
      std::clamp<std::size_t>(kBlockNumbers / at(metric_.nodeCount() + 1), 1, kBlock);
  for (std::size_t first = 0; first < moves.size() && nodeSolves_ > 0.0; first += size) {
    const auto begin = moves.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<UnitMove> block(
        begin, begin + static_cast<std::ptrdiff_t>(std::min(size, moves.size() - first)));
    const Eigen::MatrixXd response = metric_.moveResponse(block);
    nodeSolves_ -= static_cast<double>(metric_.nodeCount()) * static_cast<double>(block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      const UnitMove& move = block[i];
      if (!isAllowed(move)) continue;
      ConeCost cost = cost_;
      cost.u += response.col(static_cast<Eigen::Index>(i));
      cost.natural +=
          move.units * (metric_.naturalResponse(move.to) - metric_.naturalResponse(move.from));
      metric_.measure(cost);
      if (cost.energy >= cost_.energy) continue;
      apply(move);
      setCost(std::move(cost));
    }
  }
  return cost_.energy < (1.0 - kMinDecrease) * before;
}

/// Local minima of sign·g at which the bounds allow one more unit, lowest first. g is the slope of the scale alone: that of
/// the twist, which is not the gradient of a function, may have no minimum.
std::vector<int> ConePlacer::bestNodes(int sign, const Eigen::VectorXd& g, bool isNew) const {
  const auto canTake = [&](int n) {
    const bool isFree = defects_[at(n)] == 0 && vertexOf_[at(n)].isValid();
    return (isFree || !isNew) && fits(n, defects_[at(n)] + sign);
  };
  std::vector<int> found;
  for (int n = 0; n < metric_.nodeCount(); ++n) {
    if (!canTake(n)) continue;
    bool isLowest = true;
    eachNeighbour(n, [&](int w, HalfedgeId) {
      if (canTake(w) && sign * g[w] < sign * g[n]) isLowest = false;
    });
    if (isLowest) found.push_back(n);
  }
  std::sort(found.begin(), found.end(), [&](int a, int b) { return sign * g[a] < sign * g[b]; });
  if (found.size() > kCandidates) found.resize(kCandidates);
  return found;
}

bool ConePlacer::addUnits(const std::vector<int>& signs, bool isNew) {
  const Eigen::VectorXd g = metric_.scaleGradient(cost_);
  std::vector<Eigen::MatrixXd> response;
  std::vector<std::vector<int>> nodes;
  for (int sign : signs) {
    nodes.push_back(bestNodes(sign, g, isNew));
    if (nodes.back().empty()) return false;
    response.push_back(sign * metric_.response(nodes.back()));
  }
  std::optional<ConeCost> best;
  Eigen::Index chosen[2] = {0, 0};
  const Eigen::Index others = signs.size() > 1 ? response[1].cols() : 1;
  for (Eigen::Index i = 0; i < response[0].cols(); ++i) {
    for (Eigen::Index j = 0; j < others; ++j) {
      const Eigen::Index column[2] = {i, j};
      ConeCost cost = cost_;
      for (std::size_t s = 0; s < signs.size(); ++s) {
        cost.u += response[s].col(column[s]);
        cost.natural +=
            signs[s] * metric_.naturalResponse(nodes[s][at(static_cast<int>(column[s]))]);
      }
      metric_.measure(cost);
      if (best && cost.energy >= best->energy) continue;
      best = std::move(cost);
      std::copy(column, column + 2, chosen);
    }
  }
  for (std::size_t s = 0; s < signs.size(); ++s)
    defects_[at(nodes[s][at(static_cast<int>(chosen[s]))])] += signs[s];
  setCost(std::move(*best));
  return true;
}

/// By how much the number of cones decreases if a unit of the sign of `from` moves to `to`.
int ConePlacer::conesSaved(int from, int to) const {
  const int unit = defects_[at(from)] > 0 ? 1 : -1;
  const bool isLoop = !vertexOf_[at(to)].isValid();
  return (std::abs(defects_[at(from)]) == 1) + (!isLoop && defects_[at(to)] + unit == 0);
}

std::optional<ConePlacer::Exchange> ConePlacer::cheapestExchange(const std::vector<int>& nodes,
                                                                 const Eigen::MatrixXd& gram,
                                                                 const Eigen::VectorXd& slope,
                                                                 int most) const {
  std::optional<Exchange> best;
  for (int i = 0; i < gram.rows(); ++i) {
    const int from = nodes[at(i)];
    if (defects_[at(from)] == 0 || !vertexOf_[at(from)].isValid()) continue;
    const int unit = defects_[at(from)] > 0 ? 1 : -1;
    if (!fits(from, defects_[at(from)] - unit)) continue;
    for (int j = 0; j < gram.rows(); ++j) {
      const int to = nodes[at(j)];
      const bool isTaken = defects_[at(to)] == 0 && vertexOf_[at(to)].isValid();
      if (i == j || isTaken || !fits(to, defects_[at(to)] + unit)) continue;
      const int saved = conesSaved(from, to);
      if (saved < 1 || saved > most) continue;
      // E(u + unit (G_to − G_from)) − E(u)
      const double cost =
          2.0 * unit * (slope[j] - slope[i]) + gram(i, i) + gram(j, j) - 2.0 * gram(i, j);
      if (!best || cost < best->cost) best = Exchange{i, j, unit, cost};
    }
  }
  return best;
}

void ConePlacer::thinTo(int count) {
  std::vector<int> nodes;
  for (int n = 0; n < metric_.nodeCount(); ++n)
    if (defects_[at(n)] != 0 || !vertexOf_[at(n)].isValid()) nodes.push_back(n);
  const Eigen::MatrixXd G = metric_.response(nodes);
  const Eigen::MatrixXd gram = weightedGram(G, metric_.area());
  Eigen::VectorXd slope = G.transpose() * metric_.area().cwiseProduct(cost_.u);
  for (int now = cones(); now > count; now = cones()) {
    const std::optional<Exchange> e = cheapestExchange(nodes, gram, slope, now - count);
    if (!e) break;
    apply({nodes[at(e->from)], nodes[at(e->to)], e->unit});
    slope += e->unit * (gram.col(e->to) - gram.col(e->from));
  }
  measure();
}

}  // namespace hgp
