#include "hgp/features/index_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "hgp/base/counted.h"

namespace hgp {
namespace {

constexpr double kQuarterTurn = kPi / 2.0;
/// Cost of a path per edge, relative to the costs of nodes.
constexpr double kEdgeCost = 0.05;
/// Largest gain by a single unit that a longer path may still have: searches end there.
constexpr double kLargestGain = 12.0;
/// Nodes that are looked at for the cheapest moves.
constexpr int kMaxVisited = 2000;
/// Quarter turns around a vertex without a cone.
constexpr int kRegular = 4;
/// A cone of a quarter turn is explained by this much curvature around it.
constexpr double kExplained = kPi / 8;
/// Cost of an index per unit beyond its bounds.
constexpr double kImpossible = 1e6;

Failure notAsAsked(std::vector<Where> stuck) {
  return {
      ErrorCode::kPrescription, "features",
      "The prescribed cones and corners are not possible along these features: " +
          counted(stuck.size(), "place has", "places have") +
          " too few triangles or a quarter turn too many or too few, which nothing else between "
          "the features may have. Add or leave out cones or corners, or refine the mesh there.",
      std::move(stuck)};
}

/// Nodes are vertices off Γ and sectors (Sectors::node); the edges of a node's corners lead to its neighbours.
class IndexFlow {
 public:
  IndexFlow(const TriMesh& mesh, const Geometry& geometry, AlignedField& field)
      : mesh_(mesh), field_(field), sectors_(field.sectors) {
    const std::size_t count = at(mesh.vertexCount()) + sectors_.list.size();
    angle_.assign(count, 0.0);
    distance_.assign(count, 0.0);
    via_.assign(count, HalfedgeId());
    isForward_.assign(count, 0);
    from_.assign(count, -1);
    for (HalfedgeId h : mesh.halfedges())
      angle_[at(sectors_.node(mesh, h))] += geometry.cornerAngle[h];
  }

  std::vector<IndexMove> cheapest(int start, int sign, std::size_t most) {
    std::vector<IndexMove> moves;
    const double own = changeOf(start, sign);
    if (own > 0.5 * kImpossible) return moves;
    int visited = 0;
    search(start, [&](int n, double d) {
      const double all = own + d + changeOf(n, -sign);
      if (n != start && all < 0.5 * kImpossible) moves.push_back({stepsTo(n, start, sign), all});
      return ++visited < kMaxVisited;
    });
    const auto isCheaper = [](const IndexMove& a, const IndexMove& b) { return a.cost < b.cost; };
    std::stable_sort(moves.begin(), moves.end(), isCheaper);
    if (moves.size() > most) moves.resize(most);
    return moves;
  }

  /// Opposite vertices that no curvature explains; nearest ones first from each vertex that has too little.
  int cancelPairs() {
    int pairs = 0;
    for (int n = 0; n < mesh_.vertexCount(); ++n) {
      while (isLoose(n) && index(n) < kRegular) {
        int end = -1, visited = 0;
        search(n, [&](int m, double) {
          if (m < mesh_.vertexCount() && isLoose(m) && index(m) > kRegular) end = m;
          return end < 0 && ++visited < kMaxVisited;
        });
        if (end < 0) break;
        const IndexMove move{stepsTo(end, n, 1), 0.0};
        const double apart = distance_[at(end)];
        if (curvatureNear(n, 0.5 * apart) > kExplained ||
            curvatureNear(end, 0.5 * apart) < -kExplained)
          break;
        applyMove(mesh_, move, field_);
        ++pairs;
      }
    }
    field_.moved += pairs;
    return pairs;
  }

  Status run() {
    std::vector<Where> stuck;
    for (int n = 0; n < static_cast<int>(angle_.size()); ++n) {
      if (!exists(n)) continue;
      while (index(n) < lowest(n) || index(n) > largest(n)) {
        if (!canHold(n) || !moveUnit(n, index(n) < lowest(n) ? 1 : -1)) {
          stuck.push_back({Where::Kind::kVertex, vertexOf(n).i});
          break;
        }
      }
    }
    if (stuck.empty()) return Done{};
    if (!field_.given.empty()) return notAsAsked(std::move(stuck));
    return Failure{ErrorCode::kPrescription, "features",
                   "No cones and corners are possible between these features: " +
                       counted(stuck.size(), "corner") +
                       " cannot have a positive multiple of 90° that its triangles hold. Refine "
                       "the mesh there or leave out a feature edge.",
                   std::move(stuck)};
  }

 private:
  bool exists(int n) const {
    if (n >= mesh_.vertexCount()) return true;
    const VertexId v(n);
    return !mesh_.isIsolated(v) && !sectors_.isOnFeature[v];
  }
  VertexId vertexOf(int n) const {
    return n < mesh_.vertexCount() ? VertexId(n)
                                   : mesh_.tail(sectors_.list[at(n - mesh_.vertexCount())].first);
  }
  int& index(int n) { return field_.index[at(n)]; }
  int given(int n) const { return field_.given.empty() ? 0 : field_.given[at(n)]; }
  int lowest(int n) const { return given(n) != 0 ? given(n) : 1; }
  int largest(int n) const { return given(n) != 0 ? given(n) : largestIndex(mesh_, sectors_, n); }
  /// Whether a prescribed index is one that the triangles can have.
  bool canHold(int n) const {
    return lowest(n) >= 1 && lowest(n) <= largestIndex(mesh_, sectors_, n);
  }

  /// Whether a vertex off Γ may have another index.
  bool isLoose(int n) const { return exists(n) && given(n) == 0; }

  /// Sum of the curvatures of the vertices off Γ within a distance.
  double curvatureNear(int n, double reach) {
    double sum = 0.0;
    search(n, [&](int m, double d) {
      if (d > reach) return false;
      if (m < mesh_.vertexCount()) sum += 2 * kPi - angle_[at(m)];
      return true;
    });
    return sum;
  }

  double cost(int n, int value) const {
    const int excess = std::max(lowest(n) - value, value - largest(n));
    if (excess > 0) return kImpossible * excess;
    if (n < mesh_.vertexCount()) return std::abs(value - 4);
    const double miss = value - angle_[at(n)] / kQuarterTurn;
    return kSectorCost * miss * miss;
  }

  /// Calls use(h, isForward, neighbour) for every step from node n: along halfedge h from its tail, or backwards.
  template <class Use>
  void forSteps(int n, const Use& use) const {
    const auto corner = [&](HalfedgeId h) {
      const HalfedgeId into = TriMesh::previous(h);
      use(h, true, sectors_.node(mesh_, TriMesh::next(h)));
      // A feature edge that ends the sector is a step on this side alone; others are seen from the next corner.
      if (sectors_.isFeature[mesh_.edge(into)]) use(into, false, sectors_.node(mesh_, into));
    };
    if (n < mesh_.vertexCount()) {
      for (HalfedgeId h : outgoingHalfedges(mesh_, VertexId(n))) corner(h);
      return;
    }
    HalfedgeId h = sectors_.list[at(n - mesh_.vertexCount())].first;
    for (;; h = mesh_.twin(TriMesh::previous(h))) {
      corner(h);
      if (sectors_.isFeature[mesh_.edge(TriMesh::previous(h))]) return;
    }
  }

  /// Dijkstra from `start`; calls use(node, distance) for every node, nearest first, until that returns false.
  template <class Use>
  void search(int start, const Use& use) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::fill(distance_.begin(), distance_.end(), std::numeric_limits<double>::infinity());
    distance_[at(start)] = 0.0;
    via_[at(start)] = HalfedgeId();
    queue.push({0.0, start});
    while (!queue.empty()) {
      const double d = queue.top().first;
      const int n = queue.top().second;
      queue.pop();
      if (d > distance_[at(n)]) continue;
      if (!use(n, d)) break;
      forSteps(n, [&](HalfedgeId h, bool isForward, int to) {
        if (d + kEdgeCost >= distance_[at(to)]) return;
        distance_[at(to)] = d + kEdgeCost;
        via_[at(to)] = h;
        isForward_[at(to)] = isForward;
        from_[at(to)] = n;
        queue.push({distance_[at(to)], to});
      });
    }
  }

  /// The steps of a unit between `start` and a node that was found.
  std::vector<std::pair<HalfedgeId, int>> stepsTo(int end, int start, int sign) const {
    std::vector<std::pair<HalfedgeId, int>> steps;
    for (int n = end; n != start; n = from_[at(n)]) {
      // The step leads from from_[n] to n; a unit moves back along it, towards `start`, if sign is 1.
      steps.emplace_back(via_[at(n)], isForward_[at(n)] == (sign < 0) ? 1 : -1);
    }
    return steps;
  }

  double changeOf(int n, int sign) const {
    const int now = field_.index[at(n)];
    return cost(n, now + sign) - cost(n, now);
  }

  /// To the node that gives a unit (sign 1) or takes one (−1) most cheaply.
  bool moveUnit(int start, int sign) {
    double best = 0.5 * kImpossible;
    int end = -1;
    search(start, [&](int n, double d) {
      if (d - kLargestGain > best) return false;
      const double change = changeOf(n, -sign);
      if (n != start && d + change < best) {
        best = d + change;
        end = n;
      }
      return true;
    });
    if (end < 0) return false;
    applyMove(mesh_, {stepsTo(end, start, sign), best}, field_);
    ++field_.moved;
    return true;
  }

  const TriMesh& mesh_;
  AlignedField& field_;
  const Sectors& sectors_;
  std::vector<double> angle_, distance_;
  std::vector<HalfedgeId> via_;
  std::vector<char> isForward_;
  std::vector<int> from_;
};

}  // namespace

void moveUnit(const TriMesh& mesh, HalfedgeId h, int units, AlignedField& field) {
  const HalfedgeId twin = mesh.twin(h);
  field.index[at(field.sectors.node(mesh, h))] -= units;
  field.index[at(field.sectors.node(mesh, TriMesh::next(h)))] += units;
  if (field.sectors.isFeature[mesh.edge(h)]) {
    field.axis[h] += units;
    field.tilt[h] += units * kQuarterTurn;
  }
  if (!twin.isValid()) return;
  field.field.matching[h] -= units;
  field.field.matching[twin] += units;
  field.turn[h] -= units * kQuarterTurn;
  field.turn[twin] += units * kQuarterTurn;
}

void applyMove(const TriMesh& mesh, const IndexMove& move, AlignedField& field) {
  for (const auto& [h, units] : move.steps) moveUnit(mesh, h, units, field);
}

std::vector<IndexMove> cheapestMoves(const TriMesh& mesh, const Geometry& geometry,
                                     AlignedField& field, int node, int sign, std::size_t most) {
  return IndexFlow(mesh, geometry, field).cheapest(node, sign, most);
}

int cancelFlatPairs(const TriMesh& mesh, const Geometry& geometry, AlignedField& field) {
  return IndexFlow(mesh, geometry, field).cancelPairs();
}

Status makeIndicesPossible(const TriMesh& mesh, const Geometry& geometry, AlignedField& field) {
  return IndexFlow(mesh, geometry, field).run();
}

}  // namespace hgp
