#include "hgp/mesh/angle_shortage.h"

#include <algorithm>
#include <array>

#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// Maximum number of vertices visited by all searches together, which take a fraction of a second.
constexpr int kMaxVisits = 2'000'000;

/// Corner angles in units of π / (q N). With N above the number of corners, a minimum of one unit per corner is
/// equivalent to positive angles: a solution with one exists if and only if one with the other does.
class AngleFlow {
 public:
  AngleFlow(const TriMesh& mesh, int q, const PerVertex<int>& k)
      : mesh_(mesh),
        unit_(3LL * mesh.faceCount() + 1),
        asked_(k.size(), 0),
        sum_(asked_.size(), 0),
        corner_(static_cast<std::size_t>(mesh.halfedgeCount()), 0),
        reachedBy_(asked_.size()),
        isReached_(asked_.size(), 0) {
    for (VertexId v : mesh.vertices()) asked_[v] = 2LL * k[v] * unit_;
    for (FaceId f : mesh.faces()) share(f, q * unit_);
  }

  /// Moves angle to the vertex until it has what it needs. False if that is impossible: reached() is then W.
  bool satisfy(VertexId v) {
    while (sum_[v] < asked_[v]) {
      const Search found = search(v);
      if (found.isTooLarge) return true;
      if (!found.donor.isValid()) return false;
      push(v, found.donor);
    }
    return true;
  }

  const std::vector<VertexId>& reached() const { return queue_; }
  bool isReached(VertexId v) const { return isReached_[v] != 0; }

 private:
  struct Search {
    VertexId donor;
    bool isTooLarge = false;
  };

  /// Initial angles of f, in proportion to what the corners' vertices need per triangle.
  void share(FaceId f, long long all) {
    std::array<double, 3> weight{};
    double total = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = mesh_.tail(TriMesh::halfedge(f, static_cast<int>(k)));
      weight[k] = static_cast<double>(asked_[v]) / mesh_.valence(v);
      total += weight[k];
    }
    long long rest = all;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, static_cast<int>(k));
      const auto part = static_cast<long long>(static_cast<double>(all) * weight[k] / total);
      corner_[h] = k == 2 ? rest : std::clamp(part, 1LL, rest - 2);
      rest -= corner_[h];
      sum_[mesh_.tail(h)] += corner_[h];
    }
  }

  bool mayGive(VertexId v) const { return mesh_.isBoundary(v) || sum_[v] > asked_[v]; }

  /// Breadth-first search from v over corners that can give up angle.
  Search search(VertexId v) {
    for (VertexId u : queue_) isReached_[u] = 0;
    queue_.assign(1, v);
    isReached_[v] = 1;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      if (queue_.size() > kLargestSearch || --visitsLeft_ < 0) return {{}, true};
      for (HalfedgeId out : outgoingHalfedges(mesh_, queue_[next])) {
        for (const HalfedgeId h : {TriMesh::next(out), TriMesh::previous(out)}) {
          const VertexId u = mesh_.tail(h);
          if (isReached_[u] != 0 || corner_[h] <= 1) continue;
          isReached_[u] = 1;
          reachedBy_[u] = {out, h};
          queue_.push_back(u);
          if (mayGive(u)) return {u, false};
        }
      }
    }
    return {};
  }

  void push(VertexId v, VertexId donor) {
    long long amount = asked_[v] - sum_[v];
    if (!mesh_.isBoundary(donor)) amount = std::min(amount, sum_[donor] - asked_[donor]);
    for (VertexId u = donor; u != v; u = mesh_.tail(reachedBy_[u].to))
      amount = std::min(amount, corner_[reachedBy_[u].from] - 1);
    for (VertexId u = donor; u != v; u = mesh_.tail(reachedBy_[u].to)) {
      corner_[reachedBy_[u].from] -= amount;
      corner_[reachedBy_[u].to] += amount;
    }
    sum_[donor] -= amount;
    sum_[v] += amount;
  }

  struct Step {
    HalfedgeId to, from;  ///< corners of one triangle: the receiving and the giving one
  };

  const TriMesh& mesh_;
  long long unit_;  ///< N
  PerVertex<long long> asked_, sum_;
  PerHalfedge<long long> corner_;
  PerVertex<Step> reachedBy_;
  PerVertex<char> isReached_;
  std::vector<VertexId> queue_;
  int visitsLeft_ = kMaxVisits;
};

AngleShortage describe(const TriMesh& mesh, int q, const PerVertex<int>& k, const AngleFlow& flow) {
  AngleShortage out;
  out.vertices = static_cast<int>(flow.reached().size());
  for (VertexId v : flow.reached()) {
    out.asked += turnAngle(k[v], q);
    if (k[v] != q) out.cones.push_back(v);
  }
  std::sort(out.cones.begin(), out.cones.end(),
            [&](VertexId a, VertexId b) { return k[a] != k[b] ? k[a] > k[b] : a < b; });
  for (FaceId f : mesh.faces()) {
    const auto corners = mesh.corners(f);
    out.triangles +=
        std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return flow.isReached(v); });
  }
  return out;
}

}  // namespace

std::optional<AngleShortage> findAngleShortage(const TriMesh& mesh, int q,
                                               const PerVertex<int>& k) {
  std::vector<VertexId> suspects;
  for (VertexId v : mesh.vertices()) {
    if (k[v] == q || mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    if (turnAngle(k[v], q) <= kSteepCornerAngle * mesh.valence(v)) continue;
    suspects.push_back(v);
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) suspects.push_back(mesh.head(h));
  }
  if (suspects.empty()) return {};
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v)) suspects.push_back(v);
  AngleFlow flow(mesh, q, k);
  for (const VertexId v : suspects)
    if (!mesh.isBoundary(v) && !flow.satisfy(v)) return describe(mesh, q, k, flow);
  return {};
}

}  // namespace hgp
