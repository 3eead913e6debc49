#include "hgp/features/index_flow.h"

#include "hgp/base/counted.h"
#include "hgp/base/stable_order.h"
#include "hgp/features/index_paths.h"

namespace hgp {
namespace {

constexpr double kQuarterTurn = kPi / 2.0;
/// Largest gain by a single unit that a longer path may still have: searches end there.
constexpr double kLargestGain = 12.0;
/// Nodes that are looked at for the cheapest moves.
constexpr int kMaxVisited = 2000;
/// Quarter turns around a vertex without a cone.
constexpr int kRegular = 4;
/// A cone of a quarter turn is explained by this much curvature around it.
constexpr double kExplained = kPi / 8;

Failure notAsAsked(std::vector<Where> stuck) {
  return {
      ErrorCode::kPrescription, "features",
      "The prescribed cones and corners are not possible along these features: " +
          counted(stuck.size(), "place has", "places have") +
          " too few triangles or a quarter turn too many or too few, which nothing else between "
          "the features may have. Add or leave out cones or corners, or refine the mesh there.",
      std::move(stuck)};
}

class IndexFlow {
 public:
  IndexFlow(const TriMesh& mesh, const Geometry& geometry, AlignedField& field)
      : field_(field), graph_(mesh, geometry, field), paths_(graph_) {}

  std::vector<IndexMove> cheapest(int start, int sign, std::size_t most) {
    std::vector<IndexMove> moves;
    const double own = graph_.changeOf(start, sign);
    if (isImpossible(own)) return moves;
    int visited = 0;
    paths_.search(start, [&](int n, double d) {
      const double all = own + d + graph_.changeOf(n, -sign);
      if (n != start && !isImpossible(all) && keepsSums(start, n))
        moves.push_back({paths_.stepsTo(n, sign), all});
      return ++visited < kMaxVisited;
    });
    const auto isCheaper = [](const IndexMove& a, const IndexMove& b) { return a.cost < b.cost; };
    sortStably(moves, isCheaper);
    if (moves.size() > most) moves.resize(most);
    return moves;
  }

  /// Opposite vertices that no curvature explains; nearest ones first from each vertex that has too little.
  int cancelPairs() {
    int pairs = 0;
    for (int n = 0; n < graph_.mesh().vertexCount(); ++n) {
      while (isLoose(n) && graph_.index(n) < kRegular) {
        int end = -1, visited = 0;
        paths_.search(n, [&](int m, double) {
          if (isVertex(m) && isLoose(m) && graph_.index(m) > kRegular) end = m;
          return end < 0 && ++visited < kMaxVisited;
        });
        if (end < 0) break;
        const IndexMove move{paths_.stepsTo(end, 1), 0.0};
        const double apart = paths_.distance(end);
        if (curvatureNear(n, 0.5 * apart) > kExplained ||
            curvatureNear(end, 0.5 * apart) < -kExplained)
          break;
        applyMove(graph_.mesh(), move, field_);
        ++pairs;
      }
    }
    field_.moved += pairs;
    return pairs;
  }

  Status run() {
    std::vector<Where> stuck;
    for (int n = 0; n < graph_.count(); ++n) {
      if (!graph_.exists(n)) continue;
      while (graph_.index(n) < graph_.lowest(n) || graph_.index(n) > graph_.largest(n)) {
        if (!graph_.canHold(n) || !moveUnit(n, graph_.index(n) < graph_.lowest(n) ? 1 : -1)) {
          stuck.push_back({Where::Kind::kVertex, graph_.vertexOf(n).i});
          break;
        }
      }
    }
    if (stuck.empty()) return Done{};
    if (!field_.given.node.empty()) return notAsAsked(std::move(stuck));
    return Failure{ErrorCode::kPrescription, "features",
                   "No cones and corners are possible between these features: " +
                       counted(stuck.size(), "corner") +
                       " cannot have a positive multiple of 90° that its triangles hold. Refine "
                       "the mesh there or leave out a feature edge.",
                   std::move(stuck)};
  }

 private:
  bool isVertex(int n) const { return !graph_.isSector(n); }

  /// Whether a vertex off Γ may have another index.
  bool isLoose(int n) const { return graph_.exists(n) && graph_.given(n) == 0; }

  /// Whether a unit may move between two nodes without a change of a sum that is prescribed.
  bool keepsSums(int a, int b) const {
    const VertexId v = graph_.vertexOf(a), w = graph_.vertexOf(b);
    return v == w || (givenAround(field_, v) == 0 && givenAround(field_, w) == 0);
  }

  /// Sum of the curvatures of the vertices off Γ within a distance.
  double curvatureNear(int n, double reach) {
    double sum = 0.0;
    paths_.search(n, [&](int m, double d) {
      if (d > reach) return false;
      if (isVertex(m)) sum += 2 * kPi - graph_.angle(m);
      return true;
    });
    return sum;
  }

  /// To the node that gives a unit (sign 1) or takes one (−1) most cheaply.
  bool moveUnit(int start, int sign) {
    double best = 0.5 * kImpossible;
    int end = -1;
    paths_.search(start, [&](int n, double d) {
      if (d - kLargestGain > best) return false;
      const double change = graph_.changeOf(n, -sign);
      if (n != start && d + change < best) {
        best = d + change;
        end = n;
      }
      return true;
    });
    if (end < 0) return false;
    applyMove(graph_.mesh(), {paths_.stepsTo(end, sign), best}, field_);
    ++field_.moved;
    return true;
  }

  AlignedField& field_;
  const IndexGraph graph_;
  IndexPaths paths_;
};

}  // namespace

void moveUnit(const TriMesh& mesh, HalfedgeId h, int units, AlignedField& field) {
  const HalfedgeId twin = mesh.twin(h);
  field.isFitted = false;
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
