#include "hgp/mesh/angle_shortage.h"

#include <algorithm>
#include <array>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// Maximum number of vertices visited by all searches together, which take a fraction of a second.
constexpr int kMaxVisits = 2'000'000;

/// Of a flow that starts from rounded angles: what may be missing per corner, in units, and the smallest angle as a
/// part of π/q.
constexpr long long kMissing = 1 << 8;
constexpr long long kSmallestPart = 1 << 20;

/// Corner angles in units of π / (q N). With N above the number of corners, a minimum of one unit per corner is
/// equivalent to positive angles: a solution with one exists if and only if one with the other does.
///
/// A flow from rounded angles has finer units and asks for kMissing less per corner, and its minimum per corner is above
/// 3|F| times that. What is missing in total can then be moved through any corner: a solution is a proof again.
///
/// The nodes that receive angle are the vertices, and behind them the loops with a given turning, each in place of its
/// vertices. Vertices of other loops ask for what they like and give the rest.
class AngleFlow {
 public:
  AngleFlow(const TriMesh& mesh, const AngleQuestion& question)
      : AngleFlow(mesh, question, 1, 3LL * mesh.faceCount() + 1) {
    for (FaceId f : mesh_.faces()) share(f, question.q * unit_);
  }
  /// @param start  radians; need neither be positive nor have the sums asked for
  AngleFlow(const TriMesh& mesh, const AngleQuestion& question, const PerHalfedge<double>& start)
      : AngleFlow(mesh, question, kMissing * (3LL * mesh.faceCount() + 1),
                  kSmallestPart * kMissing * (3LL * mesh.faceCount() + 1)) {
    for (std::size_t n = 0; n < asked_.size(); ++n) asked_[n] -= kMissing * corners_[n];
    for (FaceId f : mesh_.faces()) round(f, question.q * unit_, start);
  }

  bool isOpen(int node) const { return isOpen_[at(node)] != 0; }
  int nodeOf(VertexId v) const { return nodeOf_[v]; }
  bool isMissing(int node) const { return sum_[at(node)] < asked_[at(node)]; }

  /// Moves angle to the node until it has what it needs. False if that is impossible: reached() is then W.
  bool satisfy(int node, std::size_t largestSearch) {
    while (isMissing(node)) {
      const Search found = search(node, largestSearch);
      if (found.isTooLarge) return true;
      if (found.donor < 0) return false;
      push(node, found.donor);
    }
    return true;
  }

  const std::vector<int>& reached() const { return queue_; }
  bool isReached(VertexId v) const { return isReached_[at(nodeOf_[v])] != 0; }

 private:
  struct Search {
    int donor = -1;
    bool isTooLarge = false;
  };

  AngleFlow(const TriMesh& mesh, const AngleQuestion& question, long long least, long long unit)
      : mesh_(mesh),
        least_(least),
        unit_(unit),
        nodeOf_(question.k.size()),
        loopMembers_(question.loops.size()),
        asked_(question.k.size() + question.loops.size(), 0),
        sum_(asked_.size(), 0),
        corners_(asked_.size(), 0),
        corner_(static_cast<std::size_t>(mesh.halfedgeCount()), 0),
        reachedBy_(asked_.size()),
        isOpen_(asked_.size(), 0),
        isReached_(asked_.size(), 0) {
    for (VertexId v : mesh.vertices()) {
      asked_[at(v.i)] = 2LL * question.k[v] * unit_;
      isOpen_[at(v.i)] = mesh.isBoundary(v);
      nodeOf_[v] = v.i;
    }
    for (std::size_t j = 0; j < question.loops.size(); ++j)
      addLoop(question.k.size() + j, question.q, question.loops[j]);
    for (VertexId v : mesh.vertices()) {
      if (nodeOf_[v] != v.i) loopMembers_[at(nodeOf_[v] - mesh.vertexCount())].push_back(v);
      if (!mesh.isIsolated(v)) corners_[at(nodeOf_[v])] += mesh.valence(v);
    }
  }

  /// Σ θ_v = π n − 2π l/q over the n vertices of the loop.
  void addLoop(std::size_t node, int q, const LoopAngle& loop) {
    const auto n = static_cast<long long>(loop.loop->halfedges.size());
    asked_[node] = (q * n - 2LL * loop.turning) * unit_;
    for (HalfedgeId h : loop.loop->halfedges) nodeOf_[mesh_.tail(h)] = static_cast<int>(node);
  }

  /// Initial angles of f, in proportion to what the corners' nodes need per triangle.
  void share(FaceId f, long long all) {
    std::array<double, 3> weight{};
    double total = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t node = nodeAt(TriMesh::halfedge(f, static_cast<int>(k)));
      weight[k] = static_cast<double>(asked_[node]) / corners_[node];
      total += weight[k];
    }
    long long rest = all;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, static_cast<int>(k));
      const auto part = static_cast<long long>(static_cast<double>(all) * weight[k] / total);
      corner_[h] = k == 2 ? rest : std::clamp(part, 1LL, rest - 2);
      rest -= corner_[h];
      sum_[nodeAt(h)] += corner_[h];
    }
  }

  /// Initial angles of f: those of `start`, none below the minimum.
  void round(FaceId f, long long all, const PerHalfedge<double>& start) {
    const double scale = static_cast<double>(all) / kPi;
    std::array<HalfedgeId, 3> h;
    for (std::size_t k = 0; k < 3; ++k) h[k] = TriMesh::halfedge(f, static_cast<int>(k));
    sortThree(h, [&](HalfedgeId a, HalfedgeId b) { return start[a] < start[b]; });
    long long rest = all;
    for (std::size_t k = 0; k < 3; ++k) {
      // The smallest first: what it is raised by is missing at the larger ones.
      const double part = std::clamp(scale * start[h[k]], 0.0, static_cast<double>(all));
      const auto left = static_cast<long long>(2 - k);
      corner_[h[k]] =
          k == 2 ? rest : std::clamp(static_cast<long long>(part), least_, rest - left * least_);
      rest -= corner_[h[k]];
      sum_[nodeAt(h[k])] += corner_[h[k]];
    }
  }

  std::size_t nodeAt(HalfedgeId h) const { return at(nodeOf_[mesh_.tail(h)]); }
  bool mayGive(std::size_t node) const { return isOpen_[node] || sum_[node] > asked_[node]; }

  /// Breadth-first search from a node over corners that can give up angle.
  Search search(int start, std::size_t largest) {
    for (const int node : queue_) isReached_[at(node)] = 0;
    queue_.assign(1, start);
    isReached_[at(start)] = 1;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      if (queue_.size() > largest) return {-1, true};
      const int node = queue_[next];
      const bool isVertex = node < mesh_.vertexCount();
      const std::size_t members = isVertex ? 1 : membersOf(node).size();
      for (std::size_t i = 0; i < members; ++i) {
        if (--visitsLeft_ < 0) return {-1, true};
        const int donor = reachAround(isVertex ? VertexId(node) : membersOf(node)[i]);
        if (donor >= 0) return {donor, false};
      }
    }
    return {};
  }

  const std::vector<VertexId>& membersOf(int loopNode) const {
    return loopMembers_[at(loopNode - mesh_.vertexCount())];
  }

  /// Reaches the nodes whose corners can give up angle to those at v. A node with angle to give, or −1.
  int reachAround(VertexId v) {
    for (HalfedgeId out : outgoingHalfedges(mesh_, v))
      for (const HalfedgeId h : {TriMesh::next(out), TriMesh::previous(out)}) {
        const std::size_t node = nodeAt(h);
        if (isReached_[node] != 0 || corner_[h] <= least_) continue;
        isReached_[node] = 1;
        reachedBy_[node] = {out, h};
        queue_.push_back(static_cast<int>(node));
        if (mayGive(node)) return static_cast<int>(node);
      }
    return -1;
  }

  void push(int to, int donor) {
    long long amount = asked_[at(to)] - sum_[at(to)];
    if (!isOpen(donor)) amount = std::min(amount, sum_[at(donor)] - asked_[at(donor)]);
    const auto before = [&](int node) { return nodeOf_[mesh_.tail(reachedBy_[at(node)].to)]; };
    for (int node = donor; node != to; node = before(node))
      amount = std::min(amount, corner_[reachedBy_[at(node)].from] - least_);
    for (int node = donor; node != to; node = before(node)) {
      corner_[reachedBy_[at(node)].from] -= amount;
      corner_[reachedBy_[at(node)].to] += amount;
    }
    sum_[at(donor)] -= amount;
    sum_[at(to)] += amount;
  }

  struct Step {
    HalfedgeId to, from;  ///< corners of one triangle: the receiving and the giving one
  };

  const TriMesh& mesh_;
  long long least_;  ///< of a corner
  long long unit_;   ///< N
  PerVertex<int> nodeOf_;
  std::vector<std::vector<VertexId>>
      loopMembers_;                     ///< per given loop; another node is its own vertex
  std::vector<long long> asked_, sum_;  ///< per node
  std::vector<int> corners_;            ///< per node: how many corners it has
  PerHalfedge<long long> corner_;
  std::vector<Step> reachedBy_;
  std::vector<char> isOpen_, isReached_;
  std::vector<int> queue_;
  int visitsLeft_ = kMaxVisits;
};

AngleShortage describe(const TriMesh& mesh, const AngleQuestion& question, const AngleFlow& flow) {
  AngleShortage out;
  for (const int node : flow.reached()) {
    if (node >= mesh.vertexCount()) {
      const LoopAngle& loop = question.loops[at(node - mesh.vertexCount())];
      out.loops.push_back(loop.index);
      out.asked += kPi * static_cast<double>(loop.loop->halfedges.size()) -
                   turnAngle(loop.turning, question.q);
      continue;
    }
    const VertexId v(node);
    ++out.vertices;
    out.asked += turnAngle(question.k[v], question.q);
    (question.k[v] != question.q ? out.cones : out.regular).push_back(v);
  }
  sortStably(out.cones, [&](VertexId a, VertexId b) {
    return question.k[a] != question.k[b] ? question.k[a] > question.k[b] : a < b;
  });
  std::sort(out.regular.begin(), out.regular.end());
  std::sort(out.loops.begin(), out.loops.end());
  for (FaceId f : mesh.faces()) {
    const auto corners = mesh.corners(f);
    out.triangles +=
        std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return flow.isReached(v); });
  }
  return out;
}

/// Steep cones and the vertices beside them.
std::vector<VertexId> steepPlaces(const TriMesh& mesh, int q, const PerVertex<int>& k) {
  std::vector<VertexId> out;
  for (VertexId v : mesh.vertices()) {
    if (k[v] == q || mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    if (turnAngle(k[v], q) <= kSteepCornerAngle * mesh.valence(v)) continue;
    out.push_back(v);
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) out.push_back(mesh.head(h));
  }
  return out;
}

/// Whether positive angles with the sums asked for are found near those of `nearAngles`: a proof that nothing is short.
bool hasPositiveAngles(const TriMesh& mesh, const AngleQuestion& question,
                       const NearAngles& nearAngles) {
  const auto start = nearAngles ? nearAngles(question) : std::nullopt;
  if (!start) return false;
  AngleFlow flow(mesh, question, *start);
  const auto isMet = [&](int node) {
    return flow.satisfy(node, kLargestSearch) && !flow.isMissing(node);
  };
  for (std::size_t j = 0; j < question.loops.size(); ++j)
    if (!isMet(mesh.vertexCount() + static_cast<int>(j))) return false;
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && !mesh.isBoundary(v) && !isMet(v.i)) return false;
  return true;
}

std::optional<AngleShortage> search(const TriMesh& mesh, const AngleQuestion& question,
                                    const std::vector<VertexId>& first, std::size_t largest) {
  AngleFlow flow(mesh, question);
  std::vector<int> nodes;
  for (std::size_t j = 0; j < question.loops.size(); ++j)
    nodes.push_back(mesh.vertexCount() + static_cast<int>(j));
  for (const VertexId v : first) nodes.push_back(v.i);
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v)) nodes.push_back(v.i);
  for (const int node : nodes) {
    if (node < mesh.vertexCount() && mesh.isBoundary(VertexId(node))) continue;
    if (!flow.satisfy(node, largest)) return describe(mesh, question, flow);
  }
  return {};
}

}  // namespace

std::optional<AngleShortage> findAngleShortage(const TriMesh& mesh, int q, const PerVertex<int>& k,
                                               const NearAngles& nearAngles) {
  const std::vector<VertexId> steep = steepPlaces(mesh, q, k);
  if (steep.empty()) return {};
  if (hasPositiveAngles(mesh, {q, k, {}}, nearAngles)) return {};
  return search(mesh, {q, k, {}}, steep, kLargestSearch);
}

std::optional<AngleShortage> findAnyAngleShortage(const TriMesh& mesh,
                                                  const AngleQuestion& question,
                                                  const NearAngles& nearAngles) {
  if (hasPositiveAngles(mesh, question, nearAngles)) return {};
  return search(mesh, question, steepPlaces(mesh, question.q, question.k),
                at(mesh.vertexCount()) + question.loops.size());
}

}  // namespace hgp
