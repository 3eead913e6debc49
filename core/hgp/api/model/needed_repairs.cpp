#include "hgp/api/model/needed_repairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/base/portable_math.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

constexpr int kMaxCells = 512;  // maximum number of grid cells for one edge

int componentCount(const MeshData& mesh, const std::vector<int>* image, bool& isSoup) {
  const auto vertices = static_cast<int>(mesh.positions.size());
  DisjointSets sets(vertices);
  std::vector<char> isUsed(mesh.positions.size(), 0);
  int faces = 0, components = 0;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> v = t;
    if (std::any_of(v.begin(), v.end(), [&](int i) { return i < 0 || i >= vertices; })) continue;
    if (image) {
      for (int& i : v) i = (*image)[static_cast<std::size_t>(i)];
    }
    ++faces;
    for (int i : v) {
      components += isUsed[static_cast<std::size_t>(i)] == 0;
      isUsed[static_cast<std::size_t>(i)] = 1;
    }
    components -= sets.join(v[0], v[1]);
    components -= sets.join(v[0], v[2]);
  }
  isSoup = faces > 1 && components == faces;
  return components;
}

struct BoundaryEdge {
  int a, b;
  double length;
};

std::vector<BoundaryEdge> boundaryOf(const MeshData& mesh) {
  const auto count = static_cast<int>(mesh.positions.size());
  std::vector<char> isSkipped(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    const auto& t = mesh.triangles[f];
    isSkipped[f] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
                   std::any_of(t.begin(), t.end(), [&](int v) { return v < 0 || v >= count; });
  }
  const EdgeTable table(mesh.triangles, isSkipped, count);
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

}  // namespace

FixOptions neededRepairs(const std::vector<Defect>& defects) {
  FixOptions fix;
  for (const Defect& defect : defects) {
    switch (defect.kind) {
      case DefectKind::kInconsistentEdge:
        fix.orient = true;
        break;
      case DefectKind::kNonManifoldEdge:
      case DefectKind::kNonManifoldVertex:
        fix.split = true;
        break;
      case DefectKind::kRepeatedVertex:
      case DefectKind::kZeroArea:
      case DefectKind::kDuplicateFace:
        fix.degenerate = true;
        break;
      default:
        break;
    }
  }
  return fix;
}

Notes adviceAfter(const Notes& advice, const FixOptions& done, bool isAutomatic) {
  const Note* before = findNote(advice, "repair-with");
  if (!before) return advice;
  const NoteValue* named = before->find("fixes");
  const std::string fixes = named ? std::get<std::string>(named->value) : "";
  std::string more;
  const auto add = [&](const char* name, bool isDone) {
    if (isDone || fixes.find(name) == std::string::npos) return;
    if (!more.empty()) more += ',';
    more += name;
  };
  add("orient", done.orient);
  add("split", done.split);
  add("degenerate", done.degenerate);
  if (isAutomatic || more.empty()) return {Note("repair-by-hand")};
  return {Note("repair-with", {{"fixes", more}, {"more", 1}})};
}

WeldFacts weldFacts(const MeshData& mesh) {
  WeldFacts facts;
  const io::Weld weld = io::weldExact(mesh.positions);
  facts.sharing = static_cast<int>(mesh.positions.size() - weld.positions.size());
  facts.componentsBefore = componentCount(mesh, nullptr, facts.isSoup);
  facts.componentsAfter = facts.componentsBefore;
  bool ignored = false;
  if (facts.sharing > 0) facts.componentsAfter = componentCount(mesh, &weld.welded, ignored);
  facts.isSoup = facts.isSoup && facts.componentsAfter < facts.componentsBefore;
  return facts;
}

CrackFacts crackFacts(const MeshData& mesh, long long maxTests) {
  std::vector<BoundaryEdge> edges = boundaryOf(mesh);
  if (edges.empty()) return {};
  return CrackFinder(mesh, std::move(edges), maxTests).find();
}

Notes weldNotes(const WeldFacts& weld, bool isWelded) {
  if (weld.componentsAfter >= weld.componentsBefore) return {};
  return {Note(isWelded ? "weld-soup" : "weld-would-join", {{"vertices", weld.sharing},
                                                            {"before", weld.componentsBefore},
                                                            {"after", weld.componentsAfter}})};
}

Notes crackNotes(const CrackFacts& cracks) {
  Notes notes;
  const int isPartial = cracks.isPartial ? 1 : 0;
  if (cracks.vertices > 1)
    notes.push_back(Note("crack", {{"vertices", cracks.vertices},
                                   {"gap", cracks.gap},
                                   {"weld", roundedUp(cracks.gap)},
                                   {"partial", isPartial}}));
  if (cracks.onEdges > 0)
    notes.push_back(
        Note("t-junctions",
             {{"vertices", cracks.onEdges}, {"gap", cracks.edgeGap}, {"partial", isPartial}}));
  return notes;
}

}  // namespace hgp::api
