#include "hgp/features/index_sums.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/features/index_flow.h"
#include "hgp/features/index_paths.h"

namespace hgp {
namespace {

/// Cones of which a message tells the k.
constexpr std::size_t kListed = 8;

class SumFlow {
 public:
  SumFlow(const TriMesh& mesh, const Geometry& geometry, AlignedField& field)
      : mesh_(mesh), field_(field), graph_(mesh, geometry, field), paths_(graph_) {}

  Status run() {
    if (Status held = checkBounds(); !held) return held;
    for (VertexId v : mesh_.vertices())
      while (surplus(v) != 0 && move(v, surplus(v) > 0 ? -1 : 1)) continue;
    const std::vector<VertexId> missed = differing();
    if (missed.empty()) return Done{};
    const bool isTooMuch =
        std::any_of(missed.begin(), missed.end(), [&](VertexId v) { return surplus(v) > 0; });
    return notAsAsked(isTooMuch ? -1 : 1, missed);
  }

 private:
  /// The least and the most that the sectors of a vertex can have.
  std::pair<int, int> boundsAt(VertexId v) const {
    int low = 0, high = 0;
    for (const int n : graph_.sectorsAt(v)) {
      low += graph_.lowest(n);
      high += graph_.largest(n);
    }
    return {low, high};
  }

  Status checkBounds() const {
    std::vector<VertexId> beyond;
    for (VertexId v : mesh_.vertices()) {
      const int wanted = givenAround(field_, v);
      const auto [low, high] = boundsAt(v);
      if (wanted != 0 && (wanted < low || wanted > high)) beyond.push_back(v);
    }
    if (beyond.empty()) return Done{};
    const VertexId v = beyond.front();
    const auto [low, high] = boundsAt(v);
    return Failure{
        ErrorCode::kPrescription, "features",
        formatText("%s not possible along these features: the feature edges at the first of these "
                   "vertices leave at least %d and at most %d quarter turns between them, not %d. "
                   "Prescribe k within these bounds, or leave out the cones or the features.",
                   counted(beyond.size(), "prescribed cone is", "prescribed cones are").c_str(),
                   low, high, givenAround(field_, v)),
        placesOf(beyond)};
  }

  /// By how much the sum around a vertex is larger than prescribed; 0 where it is free.
  int surplus(VertexId v) const {
    const int wanted = givenAround(field_, v);
    return wanted == 0 ? 0 : indexAround(mesh_, field_, v) - wanted;
  }

  /// Whether a node may be given `units` without another sum that is prescribed being missed.
  bool isEnd(int n, int units) const {
    const VertexId v = graph_.vertexOf(n);
    if (isImpossible(graph_.changeOf(n, units))) return false;
    return !graph_.isSector(n) || givenAround(field_, v) == 0 || surplus(v) * units < 0;
  }

  /// One unit to the vertex (1) or from it (−1).
  bool move(VertexId v, int units) {
    IndexPaths::Starts starts;
    for (const int n : graph_.sectorsAt(v))
      if (const double change = graph_.changeOf(n, units); !isImpossible(change))
        starts.push_back({n, change});
    double best = kImpossible;
    int end = -1;
    paths_.search(starts, units, [&](int n, double d) {
      if (d > best) return false;
      if (graph_.vertexOf(n) == v || !isEnd(n, -units)) return true;
      const double all = d + std::max(0.0, graph_.changeOf(n, -units));
      if (all < best) {
        best = all;
        end = n;
      }
      return true;
    });
    if (end < 0) return false;
    applyMove(mesh_, {paths_.stepsTo(end, units), best}, field_);
    ++field_.moved;
    return true;
  }

  /// The patches that a unit can reach have no place for it (−1), or none to spare (1): their indices' sum contradicts the
  /// prescribed ones.
  Failure notAsAsked(int units, const std::vector<VertexId>& missed) {
    IndexPaths::Starts starts;
    for (VertexId v : missed)
      if (surplus(v) * units < 0)
        for (const int n : graph_.sectorsAt(v))
          if (!isImpossible(graph_.changeOf(n, units))) starts.push_back({n, 0.0});
    paths_.search(starts, units, [](int, double) { return true; });
    int triangles = 0;
    for (FaceId f : mesh_.faces())
      triangles += paths_.isReached(field_.sectors.node(mesh_, TriMesh::halfedge(f, 0))) ? 1 : 0;
    int sectors = 0, sum = 0, bound = 0;
    for (VertexId v : mesh_.vertices()) {
      bound += reachedBoundAt(v, units);
      for (const int n : graph_.sectorsAt(v)) {
        if (!paths_.isReached(n)) continue;
        ++sectors;
        sum += graph_.index(n);
      }
    }
    HGP_CHECK((sum - bound) * units < 0, "patches with corners of %d contradict %d", sum, bound);
    return Failure{
        ErrorCode::kPrescription, "features",
        formatText(
            "The prescribed cones are not possible along these features: a region of %d "
            "triangles between them turns by %d° along its boundary, but with these cones on "
            "it by at %s %d°. Possible is k = %s at %s instead. Prescribe that, or leave out the "
            "cones or the features.",
            triangles, (2 * sectors - sum) * 90, units < 0 ? "least" : "most",
            (2 * sectors - bound) * 90, listOf(missed).c_str(),
            counted(missed.size(), "place").c_str()),
        placesOf(missed)};
  }

  /// The largest (−1) or smallest sum (1) that the sectors of a vertex in the reached patches can have as prescribed.
  int reachedBoundAt(VertexId v, int units) const {
    const auto extreme = [&](int n, bool isLargest) {
      return isLargest ? graph_.largest(n) : graph_.lowest(n);
    };
    int inside = 0, outside = 0;
    bool isIn = false;
    for (const int n : graph_.sectorsAt(v)) {
      isIn = isIn || paths_.isReached(n);
      (paths_.isReached(n) ? inside : outside) += extreme(n, paths_.isReached(n) == (units < 0));
    }
    const int wanted = givenAround(field_, v);
    if (!isIn || wanted == 0) return inside;
    return units < 0 ? std::min(inside, wanted - outside) : std::max(inside, wanted - outside);
  }

  /// The k that the field has.
  std::string listOf(const std::vector<VertexId>& vertices) const {
    std::string list;
    for (std::size_t i = 0; i < vertices.size() && i < kListed; ++i)
      list += (i == 0 ? "" : ", ") + std::to_string(indexAround(mesh_, field_, vertices[i]));
    if (vertices.size() > kListed) list += ", …";
    return list;
  }

  std::vector<VertexId> differing() const {
    std::vector<VertexId> out;
    for (VertexId v : mesh_.vertices())
      if (surplus(v) != 0) out.push_back(v);
    return out;
  }

  static std::vector<Where> placesOf(const std::vector<VertexId>& vertices) {
    std::vector<Where> where;
    where.reserve(vertices.size());
    for (VertexId v : vertices) where.push_back({Where::Kind::kVertex, v.i});
    return where;
  }

  const TriMesh& mesh_;
  AlignedField& field_;
  const IndexGraph graph_;
  IndexPaths paths_;
};

}  // namespace

Status makeSumsPossible(const TriMesh& mesh, const Geometry& geometry, AlignedField& field) {
  if (field.given.around.size() == 0) return Done{};
  return SumFlow(mesh, geometry, field).run();
}

}  // namespace hgp
