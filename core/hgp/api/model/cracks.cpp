#include "hgp/api/model/cracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

constexpr int kMaxCells = 512;  // maximum number of grid cells for one edge

/// Nonzero for triangles without three different vertices of the mesh.
std::vector<char> skipped(const std::vector<std::array<int, 3>>& triangles, int vertexCount) {
  std::vector<char> isSkipped;
  isSkipped.reserve(triangles.size());
  for (const auto& t : triangles)
    isSkipped.push_back(
        t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
        std::any_of(t.begin(), t.end(), [&](int v) { return v < 0 || v >= vertexCount; }));
  return isSkipped;
}

struct BoundaryEdge {
  int a, b;
  double length;
};

std::vector<BoundaryEdge> boundaryOf(const MeshData& mesh) {
  const auto count = static_cast<int>(mesh.positions.size());
  const EdgeTable table(mesh.triangles, skipped(mesh.triangles, count), count);
  std::vector<BoundaryEdge> edges;
  for (int e = 0; e < table.edgeCount(); ++e) {
    if (table.faceCount(e) != 1) continue;
    const auto [a, b] = table.vertices(e);
    const Vec3 d = subtract(mesh.positions[static_cast<std::size_t>(b)],
                            mesh.positions[static_cast<std::size_t>(a)]);
    const double length = norm(d);
    if (std::isfinite(length) && length > 0) edges.push_back({a, b, length});
  }
  return edges;
}

/// Boundary vertices and edges in a spatial grid.
class CrackFinder {
 public:
  CrackFinder(const MeshData& mesh, std::vector<BoundaryEdge> edges, long long maxTests)
      : mesh_(mesh), edges_(std::move(edges)), left_(maxTests) {
    std::vector<double> lengths;
    for (const BoundaryEdge& e : edges_) lengths.push_back(e.length);
    std::nth_element(lengths.begin(),
                     lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2),
                     lengths.end());
    near_ = kCrackRatio * lengths[lengths.size() / 2];
    for (const BoundaryEdge& e : edges_) {
      neighbours_[e.a].push_back(e.b);
      neighbours_[e.b].push_back(e.a);
    }
  }

  CrackFacts find() {
    CrackFacts facts;
    enterVertices();
    for (const auto& [v, beside] : neighbours_) {
      if (left_ < 0) break;
      const double d = spread(v, beside);
      if (d == 0) continue;
      ++facts.vertices;
      facts.gap = std::max(facts.gap, d);
      isPaired_[v] = true;
    }
    cells_.clear();
    enterEdges();
    for (const auto& [v, beside] : neighbours_) {
      if (left_ < 0) break;
      if (isPaired_.count(v) != 0) continue;
      const double d = nearestEdge(v);
      if (d > near_) continue;
      ++facts.onEdges;
      facts.edgeGap = std::max(facts.edgeGap, d);
    }
    facts.isPartial = left_ < 0;
    return facts;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t x : c) h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(h ^ (h >> 32));
    }
  };
  const Vec3& at(int v) const { return mesh_.positions[static_cast<std::size_t>(v)]; }
  Cell cellOf(const Vec3& p, double size) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = std::floor(p[k] / size);
      cell[k] = std::abs(c) < 4e18 ? static_cast<std::int64_t>(c) : 0;
    }
    return cell;
  }
  template <class Visit>
  void aroundCell(const Cell& cell, Visit visit) {
    for (int n = 0; n < 27; ++n) {
      const auto it =
          cells_.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (it == cells_.end()) continue;
      left_ -= static_cast<long long>(it->second.size());
      if (left_ < 0) return;
      for (int i : it->second) visit(i);
    }
  }

  void enterVertices() {
    for (const auto& entry : neighbours_)
      cells_[cellOf(at(entry.first), near_)].push_back(entry.first);
  }
  /// Distance of the farthest vertex that is still close, so that a weld by it joins all of them. 0: none is close.
  double spread(int v, const std::vector<int>& beside) {
    double farthest = 0;
    aroundCell(cellOf(at(v), near_), [&](int u) {
      if (u == v || std::find(beside.begin(), beside.end(), u) != beside.end()) return;
      const Vec3 d = subtract(at(u), at(v));
      const double distance = norm(d);
      if (distance <= near_) farthest = std::max(farthest, distance);
    });
    return farthest;
  }

  /// Wider than near_, and so small that the cells around a vertex meet few edges that are not near it.
  double edgeCell() const { return near_ / kCrackRatio / 8; }
  void enterEdges() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Vec3 &a = at(edges_[i].a), d = subtract(at(edges_[i].b), a);
      const int steps =
          static_cast<int>(std::min(2 * edges_[i].length / edgeCell() + 1, 1.0 * kMaxCells));
      Cell last{};
      for (int s = 0; s <= steps; ++s) {
        const double t = static_cast<double>(s) / steps;
        const Cell cell = cellOf({a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]}, edgeCell());
        if (s > 0 && cell == last) continue;
        cells_[cell].push_back(static_cast<int>(i));
        last = cell;
      }
    }
  }
  double nearestEdge(int v) {
    double best = HUGE_VAL;
    aroundCell(cellOf(at(v), edgeCell()), [&](int i) {
      const BoundaryEdge& e = edges_[static_cast<std::size_t>(i)];
      if (e.a == v || e.b == v) return;
      const Vec3 d = subtract(at(e.b), at(e.a)), p = subtract(at(v), at(e.a));
      const double t = dot(p, d) / dot(d, d);
      if (t < kCrackRatio || t > 1 - kCrackRatio) return;
      const Vec3 off{p[0] - t * d[0], p[1] - t * d[1], p[2] - t * d[2]};
      best = std::min(best, norm(off));
    });
    return best;
  }

  const MeshData& mesh_;
  std::vector<BoundaryEdge> edges_;
  double near_ = 0;
  std::map<int, std::vector<int>> neighbours_;
  std::map<int, bool> isPaired_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
  long long left_;  ///< distances that may still be measured; negative: the search has ended
};

/// x rounded up to two digits: 1.1e-05.
double roundedUp(double x) {
  const double unit = portable::pow(10.0, std::floor(portable::log(x) / std::numbers::ln10) - 1);
  return (std::floor(x / unit) + 1) * unit;
}

struct Joints {
  int boundaryEdges = 0;
  int spoiled = 0;  ///< triangles that are as CrackFacts::spoiled says
};

Joints jointsOf(std::vector<std::array<int, 3>> triangles, int vertexCount) {
  std::vector<char> isSpoiled = skipped(triangles, vertexCount);
  Joints joints;
  const EdgeTable table(triangles, isSpoiled, vertexCount);
  for (int e = 0; e < table.edgeCount(); ++e) {
    joints.boundaryEdges += table.faceCount(e) == 1 ? 1 : 0;
    if (table.faceCount(e) <= 2) continue;
    for (const int* side = table.begin(e); side != table.end(e); ++side)
      isSpoiled[static_cast<std::size_t>(*side / 3)] = 1;
  }
  std::vector<std::pair<std::array<int, 3>, std::size_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    std::sort(triangles[f].begin(), triangles[f].end());
    sorted.emplace_back(triangles[f], f);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first) isSpoiled[sorted[i].second] = 1;
  joints.spoiled = static_cast<int>(std::count(isSpoiled.begin(), isSpoiled.end(), 1));
  return joints;
}

/// Tries the weld that joins the vertices of a crack.
void tryWeld(const MeshData& mesh, CrackFacts& facts) {
  const double length = roundedUp(facts.gap);
  const io::Weld weld = io::weldNear(mesh.positions, length);
  std::vector<std::array<int, 3>> triangles = mesh.triangles;
  const auto count = static_cast<int>(mesh.positions.size());
  for (auto& t : triangles)
    for (int& v : t)
      if (v >= 0 && v < count) v = weld.welded[static_cast<std::size_t>(v)];
  const Joints before = jointsOf(mesh.triangles, count);
  const Joints after = jointsOf(std::move(triangles), count);
  facts.spoiled = std::max(0, after.spoiled - before.spoiled);
  if (facts.spoiled == 0 && after.boundaryEdges < before.boundaryEdges) facts.weld = length;
}

}  // namespace

CrackFacts crackFacts(const MeshData& mesh, long long maxTests) {
  std::vector<BoundaryEdge> edges = boundaryOf(mesh);
  if (edges.empty()) return {};
  CrackFacts facts = CrackFinder(mesh, std::move(edges), maxTests).find();
  if (facts.vertices > 1) tryWeld(mesh, facts);
  return facts;
}

Notes crackNotes(const CrackFacts& cracks) {
  Notes notes;
  const int isPartial = cracks.isPartial ? 1 : 0;
  if (cracks.vertices > 1)
    notes.push_back(Note("crack", {{"vertices", cracks.vertices},
                                   {"gap", cracks.gap},
                                   {"weld", cracks.weld},
                                   {"spoiled", cracks.spoiled},
                                   {"partial", isPartial}}));
  if (cracks.onEdges > 0)
    notes.push_back(
        Note("t-junctions",
             {{"vertices", cracks.onEdges}, {"gap", cracks.edgeGap}, {"partial", isPartial}}));
  return notes;
}

}  // namespace hgp::api
