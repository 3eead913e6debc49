#include "hgp/cones/cancel_cones.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <queue>

#include "hgp/mesh/surface_order.h"

namespace hgp {
namespace {

/// The vertices in the order of the surface, and where going round each of them starts: which cone cancels which does not
/// hang on the numbers of a file.
struct VertexOrder {
  std::vector<VertexId> vertices;
  PerVertex<HalfedgeId> outgoing;
};

VertexOrder vertexOrder(const TriMesh& mesh) {
  const auto n = static_cast<std::size_t>(mesh.vertexCount());
  VertexOrder order{{}, PerVertex<HalfedgeId>(n)};
  order.vertices.reserve(n);
  for (HalfedgeId h : surfaceOrder(mesh)) {
    for (int k = 0; k < 3; ++k, h = TriMesh::next(h)) {
      HalfedgeId& first = order.outgoing[mesh.tail(h)];
      if (first.isValid()) continue;
      first = mesh.isBoundary(mesh.tail(h)) ? mesh.outgoing(mesh.tail(h)) : h;
      order.vertices.push_back(mesh.tail(h));
    }
  }
  return order;
}

/// Breadth-first search from v through interior vertices; returns the nearest vertex at most `reach`
/// edges away that `accepts`, or an invalid id.
class NearestSearch {
 public:
  explicit NearestSearch(const TriMesh& mesh)
      : mesh_(mesh),
        order_(vertexOrder(mesh)),
        stamp_(static_cast<std::size_t>(mesh.vertexCount()), -1) {}

  const VertexOrder& order() const { return order_; }

  template <class Accepts>
  VertexId find(VertexId v, int reach, const Accepts& accepts) {
    ++now_;
    queue_.assign(1, {v, 0});
    stamp_[v] = now_;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const auto [w, distance] = queue_[next];
      if (w != v && accepts(w)) return w;
      if (distance == reach) continue;
      const HalfedgeId first = order_.outgoing[w];
      HalfedgeId h = first;
      do {
        const VertexId x = mesh_.head(h);
        if (stamp_[x] != now_ && !mesh_.isBoundary(x)) {
          stamp_[x] = now_;
          queue_.push_back({x, distance + 1});
        }
        h = mesh_.nextOutgoing(h);
      } while (h.isValid() && h != first);
    }
    return {};
  }

 private:
  struct Entry {
    VertexId vertex;
    int distance;
  };
  const TriMesh& mesh_;
  VertexOrder order_;
  PerVertex<int> stamp_;
  int now_ = 0;
  std::vector<Entry> queue_;
};

/// Largest k with 2k < q·valence: above it a corner would need more than π.
int largestIndex(const TriMesh& mesh, VertexId v, int q) { return (q * mesh.valence(v) - 1) / 2; }

int coneCount(const PerVertex<int>& defect) {
  int count = 0;
  for (int d : defect) count += d != 0;
  return count;
}

/// Whether v may have defect d: frames need not turn by more than the limit per edge, or by less than before.
bool isBearable(const TriMesh& mesh, const FieldContext& context, int q, VertexId v, int before,
                int d) {
  const double K = curvature(mesh, context.geometry, v);
  const double gap = std::abs(turnAngle(d, q) - K);
  return gap <= kLargestTurnPerEdge * mesh.valence(v) || gap <= std::abs(turnAngle(before, q) - K);
}

void cancelWithin(const TriMesh& mesh, const FieldContext& context, int q, PerVertex<int>& defect,
                  int reach, NearestSearch& search) {
  for (VertexId v : search.order().vertices) {
    while (defect[v] > 0) {
      if (!isBearable(mesh, context, q, v, defect[v], defect[v] - 1)) break;
      const VertexId other = search.find(v, reach, [&](VertexId w) {
        return defect[w] < 0 && isBearable(mesh, context, q, w, defect[w], defect[w] + 1);
      });
      if (!other.isValid()) break;
      --defect[v];
      ++defect[other];
    }
  }
}

/// Moves single units away from vertices that cannot carry their index.
void spread(const TriMesh& mesh, int q, PerVertex<int>& defect, NearestSearch& search) {
  const auto fits = [&](VertexId v, int d) {
    return q - d >= 1 && q - d <= largestIndex(mesh, v, q);
  };
  for (VertexId v : search.order().vertices) {
    if (mesh.isBoundary(v)) continue;
    while (defect[v] != 0 && !fits(v, defect[v])) {
      const int unit = defect[v] > 0 ? 1 : -1;
      const VertexId other = search.find(v, mesh.vertexCount(), [&](VertexId w) {
        return fits(w, defect[w] + unit) &&
               std::abs(defect[w] + unit) <= std::max(1, std::abs(defect[w]));
      });
      if (!other.isValid()) return;
      defect[v] -= unit;
      defect[other] += unit;
    }
  }
}

}  // namespace

std::vector<ConePoint> cancelCones(const TriMesh& mesh, const FieldContext& context, int q,
                                   PerVertex<int> defect, const CancelOptions& options) {
  const Topology& topology = context.topology;
  NearestSearch search(mesh);
  const int few = std::max(mesh.vertexCount() / kNoiseShare, kNeverNoise);
  for (int reach = 1;
       reach <= options.reach || (reach <= options.noiseReach && coneCount(defect) > few); ++reach)
    cancelWithin(mesh, context, q, defect, reach, search);
  spread(mesh, q, defect, search);
  // A closed torus has no map with exactly one cone q − 1 and one q + 1.
  if (topology.genus == 1 && topology.loops.empty() && coneCount(defect) == 2)
    cancelWithin(mesh, context, q, defect, mesh.vertexCount(), search);

  std::vector<ConePoint> cones;
  for (VertexId v : mesh.vertices())
    if (defect[v] != 0) cones.push_back({v, q - defect[v]});
  return cones;
}

}  // namespace hgp
