#include "hgp/cones/cone_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"

namespace hgp {

ConeDistances::ConeDistances(const TriMesh& mesh, const ConeMetric& metric,
                             const Eigen::VectorXd& u)
    : mesh_(mesh),
      surface_(metric.context().surface),
      geometry_(metric.context().geometry),
      root_(static_cast<std::size_t>(mesh.vertexCount()), 1.0),
      distance_(static_cast<std::size_t>(mesh.vertexCount()),
                std::numeric_limits<double>::infinity()),
      source_(static_cast<std::size_t>(mesh.vertexCount())) {
  double area = 0.0;
  for (Eigen::Index i = 0; i < u.size(); ++i) area += portable::exp(2.0 * u[i]) * metric.area()[i];
  scale_ = geometry_.unit / std::sqrt(area);
  for (VertexId v : mesh.vertices())
    if (surface_.node[v] >= 0) root_[v] = portable::exp(0.5 * u[surface_.node[v]]);
}

double ConeDistances::lengthOf(HalfedgeId h) const {
  return scale_ * geometry_.length[h] * root_[mesh_.tail(h)] * root_[mesh_.head(h)];
}

void ConeDistances::spread(const std::vector<VertexId>& sources, double reach, std::size_t most) {
  for (VertexId v : touched_) {
    distance_[v] = std::numeric_limits<double>::infinity();
    source_[v] = {};
  }
  reached_.clear();
  touched_ = sources;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (VertexId v : sources) {
    distance_[v] = 0.0;
    source_[v] = v;
    queue.push({0.0, v.i});
  }
  while (!queue.empty() && reached_.size() < most) {
    const auto [d, i] = queue.top();
    queue.pop();
    const VertexId v(i);
    if (d > distance_[v]) continue;
    reached_.push_back(v);
    // Paths do not pass through boundary vertices.
    if (mesh_.isBoundary(v)) continue;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      const VertexId w = mesh_.head(h);
      const double next = d + lengthOf(h);
      if (next > reach || next >= distance_[w]) continue;
      if (!source_[w].isValid()) touched_.push_back(w);
      distance_[w] = next;
      source_[w] = source_[v];
      queue.push({next, w.i});
    }
  }
}

std::vector<ConeDistances::Pair> ConeDistances::closer(const NodeDefects& defects, double least) {
  std::vector<VertexId> cones;
  for (VertexId v : mesh_.vertices())
    if (surface_.isInterior(mesh_, v) && defects[static_cast<std::size_t>(surface_.node[v])] != 0)
      cones.push_back(v);
  spread(cones, least, std::numeric_limits<std::size_t>::max());
  std::map<std::pair<int, int>, double> shortest;
  for (EdgeId e : mesh_.edges()) {
    const HalfedgeId h = mesh_.halfedge(e);
    const VertexId a = source_[mesh_.tail(h)], b = source_[mesh_.head(h)];
    if (!a.isValid() || !b.isValid() || a == b) continue;
    const double length = distance_[mesh_.tail(h)] + lengthOf(h) + distance_[mesh_.head(h)];
    if (length >= least) continue;
    double& known =
        shortest.try_emplace({std::min(a.i, b.i), std::max(a.i, b.i)}, length).first->second;
    known = std::min(known, length);
  }
  std::vector<Pair> pairs;
  pairs.reserve(shortest.size());
  for (const auto& [ends, length] : shortest)
    pairs.push_back({VertexId(ends.first), VertexId(ends.second), length});
  sortStably(pairs, [](const Pair& x, const Pair& y) { return x.distance < y.distance; });
  return pairs;
}

std::vector<VertexId> ConeDistances::around(const std::vector<VertexId>& some, double reach) {
  std::vector<VertexId> found;
  spread(some, reach, kMaxAround);
  for (VertexId w : reached_)
    if (surface_.isInterior(mesh_, w)) found.push_back(w);
  return found;
}

}  // namespace hgp
