#include "hgp/grid/cone_pairs.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>

#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"

namespace hgp {
namespace {

/// Number of paths considered per pair of cones, shortest first.
constexpr int kWaysPerPair = 4;
constexpr double kSameWay = 1e-6;

/// One edge of a path, in the plane of one face.
struct Step {
  int from = -1, to = -1;  ///< copies
};

class NeighbourSearch {
 public:
  NeighbourSearch(const TriMesh& mesh, const SeamStructure& seams, const SeamlessChange& change,
                  const std::vector<Vec2>& uv, double reach)
      : mesh_(mesh),
        seams_(seams),
        change_(change),
        uv_(uv),
        reach_(reach),
        distance_(at(mesh.vertexCount()), std::numeric_limits<double>::infinity()),
        source_(at(mesh.vertexCount())),
        via_(at(mesh.vertexCount())) {}

  ConeNeighbours run(const std::vector<VertexId>& cones) {
    spread(cones);
    struct Bridge {
      double length;
      HalfedgeId edge;
    };
    std::vector<Bridge> bridges;
    for (EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      const VertexId a = mesh_.tail(h), b = mesh_.head(h);
      if (!source_[a].isValid() || !source_[b].isValid() || source_[a] == source_[b]) continue;
      const double length = distance_[a] + lengthOf(h) + distance_[b];
      if (length <= reach_) bridges.push_back({length, h});
    }
    sortStably(bridges, [](const Bridge& x, const Bridge& y) {
      return x.length != y.length ? x.length < y.length : x.edge < y.edge;
    });
    std::map<std::pair<int, int>, std::vector<Complex>> found;
    std::vector<ConePair> pairs;
    for (const Bridge& bridge : bridges) {
      const int a = source_[mesh_.tail(bridge.edge)].i, b = source_[mesh_.head(bridge.edge)].i;
      std::vector<Complex>& known = found[{std::min(a, b), std::max(a, b)}];
      if (static_cast<int>(known.size()) >= kWaysPerPair) continue;
      ConePair pair = wayOver(bridge.edge, mesh_.tail(bridge.edge));
      const bool isNew = std::none_of(known.begin(), known.end(), [&](const Complex& d) {
        return portable::abs(portable::abs(d) - portable::abs(pair.distance)) < kSameWay;
      });
      known.push_back(pair.distance);
      if (isNew) pairs.push_back(std::move(pair));
    }
    return {std::move(pairs), triangles()};
  }

 private:
  Complex valueOf(int copy) const { return {uv_[at(copy)][0], uv_[at(copy)][1]}; }
  double lengthOf(HalfedgeId h) const {
    return portable::abs(valueOf(seams_.copy[TriMesh::next(h)]) - valueOf(seams_.copy[h]));
  }

  void spread(const std::vector<VertexId>& cones) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (VertexId v : cones) {
      distance_[v] = 0.0;
      source_[v] = v;
      queue.push({0.0, v.i});
    }
    while (!queue.empty()) {
      const auto [d, i] = queue.top();
      queue.pop();
      const VertexId v(i);
      if (d > distance_[v]) continue;
      for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
        if (relax(v, mesh_.head(h), h)) queue.push({distance_[mesh_.head(h)], mesh_.head(h).i});
        const HalfedgeId in = TriMesh::previous(h);  // also the last edge of a boundary vertex
        if (relax(v, mesh_.tail(in), in)) queue.push({distance_[mesh_.tail(in)], mesh_.tail(in).i});
      }
    }
  }
  bool relax(VertexId from, VertexId to, HalfedgeId edge) {
    const double d = distance_[from] + lengthOf(edge);
    if (d > reach_ || d >= distance_[to]) return false;
    distance_[to] = d;
    source_[to] = source_[from];
    via_[to] = edge;
    return true;
  }

  Step stepFrom(VertexId v, HalfedgeId edge) const {
    const int tail = seams_.copy[edge], head = seams_.copy[TriMesh::next(edge)];
    return mesh_.tail(edge) == v ? Step{tail, head} : Step{head, tail};
  }

  std::vector<ConeTriangle> triangles() const {
    std::vector<ConeTriangle> found;
    for (FaceId f : mesh_.faces()) {
      const auto [i, j, k] = mesh_.corners(f);
      if (!source_[i].isValid() || !source_[j].isValid() || !source_[k].isValid()) continue;
      if (source_[i] == source_[j] || source_[j] == source_[k] || source_[k] == source_[i])
        continue;
      ConeTriangle t{wayOver(TriMesh::halfedge(f, 0), i), wayOver(TriMesh::halfedge(f, 2), i)};
      if (std::imag(std::conj(t.ab.distance) * t.ac.distance) > 0.0) found.push_back(std::move(t));
    }
    return found;
  }

  /// The path over `bridge`: from the cone nearest to `from`, one of its ends, to the cone nearest to the other end.
  ConePair wayOver(HalfedgeId bridge, VertexId from) const {
    std::vector<Step> steps;
    VertexId v = from;
    const VertexId to = mesh_.tail(bridge) == from ? mesh_.head(bridge) : mesh_.tail(bridge);
    ConePair pair{source_[v], source_[to], {}, 0.0};
    while (via_[v].isValid()) {
      const Step back = stepFrom(v, via_[v]);
      steps.push_back({back.to, back.from});
      v = seams_.vertexOf[at(back.to)];
    }
    std::reverse(steps.begin(), steps.end());
    steps.push_back(stepFrom(from, bridge));
    for (v = to; via_[v].isValid();) {
      steps.push_back(stepFrom(v, via_[v]));
      v = seams_.vertexOf[at(steps.back().to)];
    }
    // Between two steps the plane rotates as the copies of their common vertex do.
    int turn = 0;
    std::vector<SeamlessChange::Term> terms;
    for (std::size_t n = 0; n < steps.size(); ++n) {
      if (n > 0) turn += seams_.place(steps[n - 1].to).turn - seams_.place(steps[n].from).turn;
      const Complex unit = toComplex(quarterTurn(turn));
      pair.distance += unit * (valueOf(steps[n].to) - valueOf(steps[n].from));
      change_.append(steps[n].to, unit, terms);
      change_.append(steps[n].from, -unit, terms);
    }
    std::map<int, Complex> sum;
    for (const SeamlessChange::Term& t : terms) sum[t.unknown] += t.factor;
    for (const auto& [unknown, factor] : sum)
      if (portable::abs(factor) > 1e-9) pair.way.push_back({unknown, factor});
    return pair;
  }

  const TriMesh& mesh_;
  const SeamStructure& seams_;
  const SeamlessChange& change_;
  const std::vector<Vec2>& uv_;
  const double reach_;
  PerVertex<double> distance_;
  PerVertex<VertexId> source_;
  PerVertex<HalfedgeId> via_;  ///< edge to the previous vertex of the path; invalid at a cone
};

}  // namespace

ConeNeighbours neighbouringCones(const TriMesh& mesh, const SeamStructure& seams,
                                 const SeamlessChange& change, const std::vector<Vec2>& uv,
                                 const std::vector<VertexId>& cones, double reach) {
  return NeighbourSearch(mesh, seams, change, uv, reach).run(cones);
}

}  // namespace hgp
