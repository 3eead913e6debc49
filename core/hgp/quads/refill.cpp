#include "hgp/quads/refill.h"

#include <algorithm>
#include <set>

#include "hgp/base/check.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/quad_shapes.h"

namespace hgp {
namespace {

/// A quad with the edges of its sides.
struct Quad {
  std::array<int, 4> corner{}, edge{};
};

struct Filling {
  std::array<Quad, 3> quads;
  std::array<int, 2> replaced{};  ///< the quads whose place two of them take
  int cost = 0;
};

class Refill {
 public:
  explicit Refill(QuadNet net) : net_(std::move(net)), valence_(net_.mesh.positions.size(), 0) {
    for (const auto& quad : net_.mesh.quads)
      for (const int v : quad) ++valence_[at(v)];
  }

  std::optional<Refilled> run() {
    Refilled out;
    for (;;) {
      const MultipleEdgePairs found = findMultipleEdges(net_.mesh);
      if (found.pairs.empty()) break;
      // One that has no filling may have one after others.
      if (std::none_of(found.pairs.begin(), found.pairs.end(),
                       [&](const std::array<int, 2>& ends) { return separate(ends); }))
        return {};
      ++out.count;
    }
    out.quads = std::move(net_.mesh);
    return out;
  }

 private:
  struct Side {
    int quad, k;
  };

  bool separate(const std::array<int, 2>& ends) {
    std::optional<Filling> best;
    const auto consider = [&](const Side& a, const Side& b) {
      const std::optional<Filling> filling = fillingOf(a, b);
      if (filling && (!best || filling->cost < best->cost)) best = filling;
    };
    for (const auto& [a, b] : edgesBetween(ends)) {
      if (net_.isFeature[at(edgeOf(a))] != 0) continue;
      consider(a, b);
      consider(b, a);
    }
    if (!best) return false;
    apply(*best);
    return true;
  }

  /// Both sides of every edge with these ends.
  std::vector<std::array<Side, 2>> edgesBetween(const std::array<int, 2>& ends) const {
    std::vector<Side> sides;
    for (std::size_t n = 0; n < net_.mesh.quads.size(); ++n)
      for (int k = 0; k < 4; ++k) {
        const int a = net_.mesh.quads[n][at(k)], b = net_.mesh.quads[n][at((k + 1) % 4)];
        if (std::min(a, b) == ends[0] && std::max(a, b) == ends[1])
          sides.push_back({static_cast<int>(n), k});
      }
    std::vector<std::array<Side, 2>> out;
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < sides.size(); ++j)
        if (edgeOf(sides[i]) == edgeOf(sides[j])) out.push_back({sides[i], sides[j]});
    return out;
  }
  int edgeOf(const Side& side) const { return net_.edge[at(side.quad)][at(side.k)]; }

  /// a, b: the edge from A to B in its quad A B C D, and from B to A in the quad B A E F. The hexagon A E F B C D is
  /// filled by three quads around a new vertex m with edges to A, F and C.
  std::optional<Filling> fillingOf(const Side& a, const Side& b) const {
    if (a.quad == b.quad) return {};
    const auto& one = net_.mesh.quads[at(a.quad)];
    const auto& two = net_.mesh.quads[at(b.quad)];
    const auto corner = [](const std::array<int, 4>& quad, int k) { return quad[at(k % 4)]; };
    const auto side = [&](const Side& s, int k) {
      return net_.edge[at(s.quad)][at((s.k + k) % 4)];
    };
    const int A = corner(one, a.k), B = corner(one, a.k + 1), C = corner(one, a.k + 2),
              D = corner(one, a.k + 3), E = corner(two, b.k + 2), F = corner(two, b.k + 3);
    const int m = static_cast<int>(net_.mesh.positions.size());
    const int mA = static_cast<int>(net_.middle.size()), mF = mA + 1, mC = mA + 2;
    Filling out;
    out.replaced = {a.quad, b.quad};
    out.quads[0] = {{m, A, E, F}, {mA, side(b, 1), side(b, 2), mF}};
    out.quads[1] = {{m, F, B, C}, {mF, side(b, 3), side(a, 1), mC}};
    out.quads[2] = {{m, C, D, A}, {mC, side(a, 2), side(a, 3), mA}};
    if (std::set<int>{A, F, C}.size() < 3) return {};
    for (const Quad& quad : out.quads)
      if (std::set<int>(quad.corner.begin(), quad.corner.end()).size() < 4) return {};
    if (valence_[at(B)] < 4) return {};
    for (const int v : {B, F, C}) out.cost += net_.mesh.coneVertex[at(v)] >= 0 ? kConeCost : 0;
    out.cost += kFoldedCost * foldedOf(out, edgeOf(a));
    out.cost += std::abs(valence_[at(B)] - 5) + std::abs(valence_[at(F)] - 3) +
                std::abs(valence_[at(C)] - 3);
    return out;
  }
  static constexpr int kFoldedCost = 100, kConeCost = 1000;

  int foldedOf(const Filling& filling, int edge) const {
    QuadMesh part;
    for (const Quad& quad : filling.quads) {
      std::array<int, 4> corners{};
      for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = static_cast<int>(part.positions.size());
        const int v = quad.corner[k];
        part.positions.push_back(at(v) < net_.mesh.positions.size() ? net_.mesh.positions[at(v)]
                                                                    : net_.middle[at(edge)]);
      }
      part.quads.push_back(corners);
    }
    return countFoldedInSpace(part);
  }

  void apply(const Filling& filling) {
    QuadMesh& mesh = net_.mesh;
    int shared = -1;  // the edge that both quads had
    for (const int e : net_.edge[at(filling.replaced[0])])
      for (const int f : net_.edge[at(filling.replaced[1])])
        if (e == f && !isUsed(filling, e)) shared = e;
    HGP_CHECK(shared >= 0, "an edge of two quads is replaced");
    for (const int n : filling.replaced)
      for (const int v : mesh.quads[at(n)]) --valence_[at(v)];
    mesh.positions.push_back(net_.middle[at(shared)]);
    mesh.normals.push_back(net_.middleNormal[at(shared)]);
    mesh.face.push_back(net_.middleFace[at(shared)]);
    mesh.coneVertex.push_back(-1);
    mesh.lines.push_back({0, 0});
    mesh.isOnFeature.push_back(0);
    valence_.push_back(0);
    const int center = static_cast<int>(mesh.positions.size()) - 1;
    for (const int end :
         {filling.quads[0].corner[1], filling.quads[1].corner[1], filling.quads[2].corner[1]})
      addMiddle(center, end);
    for (std::size_t n = 0; n < 3; ++n) {
      const Quad& quad = filling.quads[n];
      if (n < 2) {
        mesh.quads[at(filling.replaced[n])] = quad.corner;
        net_.edge[at(filling.replaced[n])] = quad.edge;
      } else {
        mesh.quads.push_back(quad.corner);
        net_.edge.push_back(quad.edge);
      }
      for (const int v : quad.corner) ++valence_[at(v)];
    }
  }
  static bool isUsed(const Filling& filling, int edge) {
    return std::any_of(filling.quads.begin(), filling.quads.end(), [&](const Quad& quad) {
      return std::find(quad.edge.begin(), quad.edge.end(), edge) != quad.edge.end();
    });
  }
  void addMiddle(int a, int b) {
    Vec3 p{}, n{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = 0.5 * (net_.mesh.positions[at(a)][k] + net_.mesh.positions[at(b)][k]);
      n[k] = 0.5 * (net_.mesh.normals[at(a)][k] + net_.mesh.normals[at(b)][k]);
    }
    net_.middle.push_back(p);
    net_.middleNormal.push_back(n);
    net_.middleFace.push_back(net_.mesh.face[at(a)]);
    net_.isFeature.push_back(0);
  }

  QuadNet net_;
  std::vector<int> valence_;
};

}  // namespace

std::optional<Refilled> refill(QuadNet net) { return Refill(std::move(net)).run(); }

}  // namespace hgp
