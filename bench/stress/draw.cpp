#include "draw.h"

#include <algorithm>

#include "integer_sums.h"

namespace hgp::stress {
namespace {

constexpr int kOrders[] = {1, 2, 2, 3, 3, 4, 4, 5, 6, 7, 8, 10, 12};
constexpr int kCounts[] = {3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64};
constexpr int kManyCounts[] = {100, 200, 400, 800, 1600, 2500};
constexpr int kMaxCones = 64;
constexpr int kAttempts = 50;

template <std::size_t N>
int oneOf(const int (&values)[N], Random& random) {
  return values[random.below(static_cast<int>(N))];
}

/// Draws vertices without replacement.
class VertexPool {
 public:
  explicit VertexPool(std::vector<VertexId> vertices) : left_(std::move(vertices)) {}
  VertexId take(Random& random) {
    if (left_.empty()) return {};
    std::swap(left_[static_cast<std::size_t>(random.below(static_cast<int>(left_.size())))],
              left_.back());
    const VertexId v = left_.back();
    left_.pop_back();
    return v;
  }

 private:
  std::vector<VertexId> left_;
};

bool isInner(const TriMesh& mesh, VertexId v) {
  return !mesh.isIsolated(v) && !mesh.isBoundary(v) && mesh.valence(v) >= 3;
}

std::vector<VertexId> innerVertices(const TriMesh& mesh) {
  std::vector<VertexId> found;
  for (VertexId v : mesh.vertices())
    if (isInner(mesh, v)) found.push_back(v);
  return found;
}

/// Vertices at most `reach` edges from the given ones, excluding these, in breadth-first order.
std::vector<VertexId> around(const TriMesh& mesh, std::vector<VertexId> from, int reach) {
  PerVertex<char> isSeen(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : from) isSeen[v] = 1;
  std::vector<VertexId> found;
  for (int step = 0; step < reach; ++step) {
    std::vector<VertexId> ring;
    for (VertexId v : from)
      for (HalfedgeId h : outgoingHalfedges(mesh, v))
        for (VertexId w : {mesh.head(h), mesh.tail(TriMesh::previous(h))})
          if (!isSeen[w]) isSeen[w] = 1, ring.push_back(w);
    found.insert(found.end(), ring.begin(), ring.end());
    from = std::move(ring);
  }
  std::erase_if(found, [&](VertexId v) { return !isInner(mesh, v); });
  return found;
}

std::vector<VertexId> onHandleLoops(const TriMesh& mesh) {
  PerVertex<char> isSeen(static_cast<std::size_t>(mesh.vertexCount()), 0);
  std::vector<VertexId> found;
  for (const DualLoop& loop : handleGenerators(mesh))
    for (HalfedgeId h : loop.crossed)
      if (const VertexId v = mesh.tail(h); isInner(mesh, v) && !isSeen[v]) {
        isSeen[v] = 1;
        found.push_back(v);
      }
  return found;
}

std::vector<VertexId> nearBoundary(const TriMesh& mesh) {
  std::vector<VertexId> rim;
  for (VertexId v : mesh.vertices())
    if (mesh.isBoundary(v)) rim.push_back(v);
  return around(mesh, std::move(rim), 2);
}

std::vector<VertexId> chooseVertices(const TriMesh& mesh, Family family, int count,
                                     Random& random) {
  VertexPool anywhere(innerVertices(mesh));
  VertexPool special(family == Family::kFew            ? onHandleLoops(mesh)
                     : family == Family::kNearBoundary ? nearBoundary(mesh)
                                                       : std::vector<VertexId>{});
  std::vector<VertexId> chosen;
  const auto add = [&](VertexId v) {
    if (v.isValid() && std::find(chosen.begin(), chosen.end(), v) == chosen.end())
      chosen.push_back(v);
  };
  for (int tries = 0; static_cast<int>(chosen.size()) < count && tries < 4 * count; ++tries) {
    const bool isSpecial =
        family == Family::kNearBoundary || (family == Family::kFew && tries % 2 == 0);
    add(isSpecial ? special.take(random) : anywhere.take(random));
    if (family != Family::kAdjacent || chosen.empty()) continue;
    add(VertexPool(around(mesh, {chosen.back()}, 1 + random.below(3))).take(random));
  }
  return chosen;
}

/// Cone indices at `vertices` and turning indices that satisfy Lemma 6.2; empty if there are none.
std::optional<HolonomySpec> drawIndices(const TriMesh& mesh, const Topology& topology, int q,
                                        Family family, const std::vector<VertexId>& vertices,
                                        Random& random) {
  std::vector<IntegerRange> ranges;
  for (VertexId v : vertices) {
    const int most =
        std::min(family == Family::kBig ? 3 * q : 2 * q - 1, (q * mesh.valence(v) - 1) / 2);
    const bool isMany = family == Family::kMany;
    ranges.push_back(
        {isMany ? std::max(q - most, -1) : q - most, isMany ? std::min(1, q - 1) : q - 1, 0});
  }
  for (const BoundaryLoop& loop : topology.loops) {
    const TurningRange range = turningRange(mesh, loop, q);
    ranges.push_back({static_cast<int>(std::max<long long>(range.lowest, -2 * q)),
                      static_cast<int>(std::min<long long>(range.highest, 2 * q)),
                      {}});
  }
  const int m = static_cast<int>(topology.loops.size());
  const auto x = drawWithSum(ranges, q * (2 - 2 * topology.genus - m), random);
  if (!x) return {};
  HolonomySpec spec;
  spec.q = q;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    spec.cones.push_back({vertices[i], q - (*x)[i]});
  if (random.below(2) == 0)
    spec.turning.assign(x->begin() + static_cast<std::ptrdiff_t>(vertices.size()), x->end());
  return spec;
}

bool belongs(const HolonomySpec& spec, Family family) {
  if (family != Family::kBig) return true;
  return std::any_of(spec.cones.begin(), spec.cones.end(),
                     [&](const ConePoint& c) { return c.k >= 2 * spec.q; });
}

}  // namespace

const char* familyName(Family family) {
  static const char* const kNames[] = {"random",        "few",     "big", "adjacent",
                                       "near-boundary", "handles", "many"};
  return kNames[static_cast<int>(family)];
}

std::optional<HolonomySpec> draw(const TriMesh& mesh, const Topology& topology, Family family,
                                 Random& random) {
  const bool hasHandles = topology.genus > 0, isClosed = topology.loops.empty();
  if ((family == Family::kNearBoundary && isClosed) || (family == Family::kHandles && !hasHandles))
    return {};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const int q = oneOf(kOrders, random);
    int count = family == Family::kFew    ? 3 + random.below(4)
                : family == Family::kMany ? oneOf(kManyCounts, random)
                                          : oneOf(kCounts, random);
    if (family == Family::kMany) count = std::min(count, mesh.vertexCount() / 4);
    std::optional<HolonomySpec> spec;
    for (; !spec && (count <= kMaxCones || family == Family::kMany); ++count) {
      spec = drawIndices(mesh, topology, q, family, chooseVertices(mesh, family, count, random),
                         random);
      if (family != Family::kFew) break;
    }
    if (!spec || !belongs(*spec, family)) continue;
    const bool areHandlesGiven = family == Family::kHandles || random.below(3) == 0;
    for (int i = 0; areHandlesGiven && i < 2 * topology.genus; ++i)
      spec->handles.emplace_back(random.below(q));
    if (checkPrescription(mesh, topology, *spec)) return spec;
  }
  return {};
}

}  // namespace hgp::stress
