#include "hgp/quads/cut_strips.h"

#include <algorithm>
#include <optional>

#include "hgp/base/check.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/refill.h"

namespace hgp {
namespace {

/// Number of times that lines are added; one is enough for pairs, two for loops.
constexpr int kMaxPasses = 6;

/// The quads of two halvings as a net of lines: those of the grid itself, and three more in each of its strips.
class Net {
 public:
  explicit Net(QuadMesh fine) : fine_(std::move(fine)) {
    link();
    joinLines();
  }

  /// The quads between the grid's own lines and those added.
  QuadMesh quads();
  /// The same before lines are added, with the numbers of edges.
  QuadNet plain();
  /// Adds the shortest line across an edge between the two vertices of quads(). False if no line is left there.
  bool separate(const std::array<int, 2>& ends);
  int cuts() const { return cuts_; }

 private:
  /// Corner k of quad n is halfedge 4 n + k, from that corner to the next.
  int tail(int h) const { return fine_.quads[at(h / 4)][at(h % 4)]; }
  static int next(int h) { return h % 4 == 3 ? h - 3 : h + 1; }
  static int previous(int h) { return h % 4 == 0 ? h + 3 : h - 1; }
  int head(int h) const { return tail(next(h)); }
  int halfedgeCount() const { return static_cast<int>(4 * fine_.quads.size()); }

  void link();
  void joinLines();
  /// The halfedge after h straight on, along the quads on its left; −1 at the boundary.
  int ahead(int h) const {
    const int side = twin_[at(next(h))];
    return side < 0 ? -1 : next(side);
  }
  bool isKept(int h) const { return isLineKept_[at(line_[at(h)])] != 0; }
  /// From the start of h along kept lines: the corners of the cell on the left and the lines across its sides.
  struct Cell {
    std::array<int, 4> corner{};  ///< the halfedges that leave them
    std::array<int, 4>
        middle{};  ///< the halfedge that leaves a side's middle inwards, −1 where there is none
  };
  std::optional<Cell> cellAt(int first) const;
  std::int8_t kindOf(int h) const;

  QuadMesh fine_;
  std::vector<int> twin_, line_;  ///< per halfedge; lines by number
  std::vector<int> length_;       ///< per line: halfedges
  std::vector<char> isLineKept_;
  std::vector<std::array<int, 2>> sides_;  ///< of quads(): ends of each side …
  std::vector<int> middles_;  ///< … and the halfedge of the line across its middle, −1 if none
  int cuts_ = 0;
};

void Net::link() {
  twin_.assign(at(halfedgeCount()), -1);
  std::vector<std::array<int, 3>> edges;
  edges.reserve(at(halfedgeCount()));
  for (int h = 0; h < halfedgeCount(); ++h)
    edges.push_back({std::min(tail(h), head(h)), std::max(tail(h), head(h)), h});
  std::sort(edges.begin(), edges.end());
  for (std::size_t n = 0; n + 1 < edges.size(); ++n) {
    if (edges[n][0] != edges[n + 1][0] || edges[n][1] != edges[n + 1][1]) continue;
    twin_[at(edges[n][2])] = edges[n + 1][2];
    twin_[at(edges[n + 1][2])] = edges[n][2];
  }
}

/// The coordinate that the ends of h share: 0 on a line of the grid itself.
std::int8_t Net::kindOf(int h) const {
  const auto &a = fine_.lines[at(tail(h))], &b = fine_.lines[at(head(h))];
  return a[0] == b[0] || a[0] == b[1] ? a[0] : a[1];
}

void Net::joinLines() {
  DisjointSets sets(halfedgeCount());
  for (int h = 0; h < halfedgeCount(); ++h) {
    if (twin_[at(h)] >= 0) sets.join(h, twin_[at(h)]);
    // Lines of the grid itself are all kept, and end at cones.
    if (const int straight = ahead(h); straight >= 0 && kindOf(h) != 0) sets.join(h, straight);
  }
  line_.resize(at(halfedgeCount()));
  length_.assign(at(halfedgeCount()), 0);
  isLineKept_.assign(at(halfedgeCount()), 0);
  for (int h = 0; h < halfedgeCount(); ++h) {
    line_[at(h)] = sets.root(h);
    ++length_[at(line_[at(h)])];
    if (kindOf(h) == 0) isLineKept_[at(line_[at(h)])] = 1;
  }
}

std::optional<Net::Cell> Net::cellAt(int first) const {
  Cell cell;
  int h = first;
  for (std::size_t k = 0; k < 4; ++k) {
    cell.corner[k] = h;
    std::vector<int> side{h};
    while (!isKept(next(h))) {
      h = ahead(h);
      if (h < 0) return {};
      side.push_back(h);
    }
    cell.middle[k] = side.size() % 2 == 0 ? next(side[side.size() / 2 - 1]) : -1;
    h = next(h);
  }
  if (h != first) return {};
  return cell;
}

QuadMesh Net::quads() {
  QuadMesh out;
  std::vector<int> name(fine_.positions.size(), -1);
  const auto nameOf = [&](int v) {
    if (name[at(v)] >= 0) return name[at(v)];
    name[at(v)] = static_cast<int>(out.positions.size());
    out.positions.push_back(fine_.positions[at(v)]);
    out.normals.push_back(fine_.normals[at(v)]);
    out.face.push_back(fine_.face[at(v)]);
    out.coneVertex.push_back(fine_.coneVertex[at(v)]);
    out.lines.push_back(fine_.lines[at(v)]);
    out.isOnFeature.push_back(fine_.isOnFeature[at(v)]);
    return name[at(v)];
  };
  std::vector<char> isDone(at(halfedgeCount()), 0);
  sides_.clear();
  middles_.clear();
  for (int first = 0; first < halfedgeCount(); ++first) {
    if (isDone[at(first)] != 0 || !isKept(first) || !isKept(previous(first))) continue;
    const std::optional<Cell> cell = cellAt(first);
    if (!cell) {
      ++out.clipped;
      continue;
    }
    std::array<int, 4> quad{};
    for (std::size_t k = 0; k < 4; ++k) {
      isDone[at(cell->corner[k])] = 1;
      quad[k] = nameOf(tail(cell->corner[k]));
    }
    for (std::size_t k = 0; k < 4; ++k) {
      sides_.push_back({quad[k], quad[(k + 1) % 4]});
      middles_.push_back(cell->middle[k]);
    }
    out.quads.push_back(quad);
  }
  return out;
}

QuadNet Net::plain() {
  QuadNet out;
  out.mesh = quads();
  // Both sides of an edge have the same middle.
  std::vector<int> name(fine_.positions.size(), -1);
  for (std::size_t n = 0; n < out.mesh.quads.size(); ++n) {
    out.edge.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const int v = tail(middles_[4 * n + k]);
      if (name[at(v)] < 0) {
        name[at(v)] = static_cast<int>(out.middle.size());
        out.middle.push_back(fine_.positions[at(v)]);
        out.middleNormal.push_back(fine_.normals[at(v)]);
        out.middleFace.push_back(fine_.face[at(v)]);
        out.isFeature.push_back(fine_.isOnFeature[at(v)]);
      }
      out.edge[n][k] = name[at(v)];
    }
  }
  return out;
}

bool Net::separate(const std::array<int, 2>& ends) {
  int best = -1;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    const bool joins = (sides_[s][0] == ends[0] && sides_[s][1] == ends[1]) ||
                       (sides_[s][0] == ends[1] && sides_[s][1] == ends[0]);
    if (!joins || middles_[s] < 0) continue;
    const int line = line_[at(middles_[s])];
    if (isLineKept_[at(line)]) return true;  // added for another pair
    if (best < 0 || length_[at(line)] < length_[at(best)]) best = line;
  }
  if (best < 0) return false;
  isLineKept_[at(best)] = 1;
  ++cuts_;
  return true;
}

}  // namespace

/// The quads with so many lines added that no two edges have the same ends; nothing where no line separates them.
static std::optional<CutQuads> withLines(Net& net, const QuadMesh& plain) {
  CutQuads out{plain};
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const MultipleEdgePairs found = findMultipleEdges(out.quads);
    if (found.pairs.empty()) {
      out.cuts = net.cuts();
      out.added = static_cast<int>(out.quads.quads.size() - plain.quads.size());
      return out;
    }
    bool isCut = false;
    for (const std::array<int, 2>& pair : found.pairs) isCut = net.separate(pair) || isCut;
    if (!isCut) break;
    out.quads = net.quads();
  }
  return {};
}

Result<CutQuads> cutStrips(const TriMesh& mesh, const UvMap& map, int q,
                           const std::vector<EdgeId>& features) {
  Result<QuadMesh> fine = extractQuads(mesh, map, q, kMaxHalvings, features);
  if (!fine) return fine.error();
  Net net(std::move(*fine));
  QuadNet plain = net.plain();
  std::optional<CutQuads> cut = withLines(net, plain.mesh);
  const auto size = static_cast<int>(plain.mesh.quads.size());
  if (cut && cut->added <= kMaxAdded * size) return std::move(*cut);
  if (std::optional<Refilled> refilled = refill(std::move(plain))) {
    const int added = static_cast<int>(refilled->quads.quads.size()) - size;
    if (cut && cut->added <= kWorthwhile * added) return std::move(*cut);
    return CutQuads{std::move(refilled->quads), 0, refilled->count, added};
  }
  if (cut) return std::move(*cut);
  return Failure{ErrorCode::kUnsupported, "quads", "edges with the same ends remain", {}};
}

}  // namespace hgp
