#include "hgp/grid/line_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// Triangles that one ray crosses, and that are looked at around one cone, at most.
constexpr int kLongestRay = 20'000;
constexpr std::size_t kMaxAround = 20'000;
/// Points are kept apart within this share of the reach of lines.
constexpr double kPointShare = 0.25;
/// A corner that lies beside the other one by more than this share is left as it is: half a cell where the reach is twelve.
constexpr double kSlightShare = 1.0 / 24.0;

double crossOf(const Complex& a, const Complex& b) { return std::imag(std::conj(a) * b); }

class GapFinder {
 public:
  GapFinder(const StraightPlane& plane, double reach)
      : p_(plane), mesh_(plane.mesh), reach_(reach) {}

  std::vector<LineGap> run() {
    for (VertexId cone : p_.cones) isPoint_[cone] = !p_.sectors.isOnFeature[cone];
    for (std::size_t s = 0; s < p_.sectors.list.size(); ++s)
      if (isReflex(s)) isPoint_[mesh_.tail(p_.sectors.list[s].first)] = 1;
    for (HalfedgeId h : mesh_.halfedges()) {
      if (!isFeature(h)) continue;
      const int heading = headingOf(p_, h);
      trace({TriMesh::face(h), 0.5 * (at(h) + at(TriMesh::next(h))), heading + 1}, copyAt(h),
            false);
      // The third corner may be on a line that no ray of this one meets.
      const HalfedgeId beside = TriMesh::previous(h);
      const double height = std::real(std::conj(rotation(heading + 1, 4)) * (at(beside) - at(h)));
      if (height <= reach_) keep(along(copyAt(h), heading + 1, {}, copyAt(beside)), height, false);
      if (p_.isNode[mesh_.tail(h)]) follow(h);
    }
    for (VertexId cone : p_.cones) {
      if (p_.sectors.isOnFeature[cone]) continue;
      for (HalfedgeId h : outgoingHalfedges(mesh_, cone)) sendRays(h, true);
      lookAround(mesh_.outgoing(cone));
    }
    for (std::size_t s = 0; s < p_.sectors.list.size(); ++s) {
      if (p_.isNode[mesh_.tail(p_.sectors.list[s].first)]) sendRaysOf(p_.sectors.list[s]);
      if (isReflex(s)) lookAround(p_.sectors.list[s].first);
    }
    for (const FaceId f : mesh_.faces()) keepHeight(f);
    std::vector<LineGap> out;
    for (auto& [sum, gap] : found_) out.push_back({sum, gap.length, gap.isOfCone, gap.mayVanish});
    return out;
  }

 private:
  struct Ray {
    FaceId face;
    Complex at;
    int direction;
  };
  bool isFeature(HalfedgeId h) const { return p_.sectors.isFeature[mesh_.edge(h)] != 0; }
  int copyAt(HalfedgeId h) const { return p_.cut.copy[h].i; }
  Complex at(HalfedgeId h) const { return p_.z[hgp::at(copyAt(h))]; }

  /// The rotation from the chart of h's face to that of its twin's.
  int turnAcross(HalfedgeId h) const {
    const HalfedgeId twin = mesh_.twin(h);
    if (copyAt(h) == copyAt(TriMesh::next(twin)) && copyAt(TriMesh::next(h)) == copyAt(twin))
      return 0;
    const Complex here = at(TriMesh::next(h)) - at(h), there = at(twin) - at(TriMesh::next(twin));
    const Complex ratio = there * std::conj(here);
    if (std::fabs(ratio.real()) >= std::fabs(ratio.imag())) return ratio.real() >= 0.0 ? 0 : 2;
    return ratio.imag() > 0.0 ? 1 : 3;
  }
  bool isSeam(HalfedgeId h) const { return p_.cut.isSeam[mesh_.edge(h)] != 0; }

  SeamStep stepOver(HalfedgeId h, int before, int after) const {
    return {copyAt(h), copyAt(TriMesh::next(mesh_.twin(h))), before, after};
  }
  /// The way from one copy to another along a direction, over these seams.
  RealSum along(int from, int direction, const std::vector<SeamStep>& seams, int to) const {
    return wayAlong(p_.unknowns, from, direction, seams, to);
  }
  void keep(RealSum sum, double length, bool isOfCone, bool mayVanish = false) {
    if (sum.empty()) return;
    const Found found{length, isOfCone, mayVanish};
    const auto [entry, isNew] = found_.try_emplace(std::move(sum), found);
    if (isNew) return;
    entry->second.isOfCone = entry->second.isOfCone && isOfCone;
    entry->second.mayVanish = entry->second.mayVanish && mayVanish;
  }

  /// Walks to the next feature.
  void trace(Ray ray, int from, bool isOfCone) {
    const int first = ray.direction;
    double length = 0.0;
    std::vector<SeamStep> seams;
    for (int n = 0; n < kLongestRay && length <= reach_; ++n) {
      const Complex d = rotation(ray.direction, 4);
      HalfedgeId over;
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(ray.face, k);
        if (crossOf(d, at(h) - ray.at) <= 0.0 && crossOf(d, at(TriMesh::next(h)) - ray.at) > 0.0)
          over = h;
      }
      if (!over.isValid()) return;
      const Complex edge = at(TriMesh::next(over)) - at(over);
      const double share = crossOf(d, ray.at - at(over)) / crossOf(d, edge);
      const Complex hit = at(over) + share * edge;
      length += std::real(std::conj(d) * (hit - ray.at));
      if (isFeature(over)) {
        if (headingOf(p_, over) % 2 == reduceTurn(ray.direction, 2)) return;  // only grazed
        if (length <= reach_) keep(along(from, first, seams, copyAt(over)), length, isOfCone);
        return;
      }
      const HalfedgeId twin = mesh_.twin(over);
      const int turn = turnAcross(over);
      if (isSeam(over)) seams.push_back(stepOver(over, ray.direction, ray.direction + turn));
      ray = {TriMesh::face(twin), at(TriMesh::next(twin)) + rotation(turn, 4) * (hit - at(over)),
             ray.direction + turn};
    }
  }

  /// From a node along h to the next node of the same line.
  void follow(HalfedgeId h) {
    RealSum sum;
    double length = 0.0;
    for (int n = 0; n < mesh_.edgeCount(); ++n) {
      const int heading = headingOf(p_, h);
      const HalfedgeId next = TriMesh::next(h);
      addAlong(sum, p_.unknowns, copyAt(next), heading, 1.0);
      addAlong(sum, p_.unknowns, copyAt(h), heading, -1.0);
      length += portable::abs(at(next) - at(h));
      if (p_.isNode[mesh_.head(h)]) break;
      h = p_.sectors.list[hgp::at(p_.sectors.of[next])].first;
    }
    keep(std::move(sum), length, false);
  }

  /// The rays along the axes that leave a vertex through the corner at tail(h), but those along features.
  void sendRays(HalfedgeId h, bool isOfCone) {
    const Complex start = at(TriMesh::next(h)) - at(h), end = at(TriMesh::previous(h)) - at(h);
    for (int d = 0; d < 4; ++d) {
      const double first = crossOf(start, rotation(d, 4));
      if ((isFeature(h) ? first > 0.0 : first >= 0.0) && crossOf(rotation(d, 4), end) > 0.0)
        trace({TriMesh::face(h), at(h), d}, copyAt(h), isOfCone);
    }
  }
  /// Those of an end or corner of features, which no line beside it need meet.
  void sendRaysOf(const Sector& sector) {
    HalfedgeId h = sector.first;
    for (int n = 0; n < sector.triangles; ++n) {
      sendRays(h, false);
      h = mesh_.twin(TriMesh::previous(h));
    }
  }

  /// Of a thin triangle with three cones or corners: the one between the others along its longer extent goes to one side of
  /// both, by the other coordinate. Where it lies between them in that one, too, it would have far to go.
  void keepHeight(FaceId f) {
    const HalfedgeId first = TriMesh::halfedge(f, 0);
    std::array<HalfedgeId, 3> h{first, TriMesh::next(first), TriMesh::previous(first)};
    for (const HalfedgeId corner : h)
      if (!isPoint_[mesh_.tail(corner)] && !p_.isNode[mesh_.tail(corner)]) return;
    const auto part = [&](HalfedgeId corner, int axis) {
      return axis == 0 ? at(corner).real() : at(corner).imag();
    };
    const auto swapIf = [&](std::size_t a, std::size_t b, int axis) {
      if (part(h[b], axis) < part(h[a], axis)) std::swap(h[a], h[b]);
    };
    const auto sortAlong = [&](int axis) {
      swapIf(0, 1, axis);
      swapIf(1, 2, axis);
      swapIf(0, 1, axis);
      return part(h[2], axis) - part(h[0], axis);
    };
    const int axis = sortAlong(1) > sortAlong(0) ? 1 : 0;
    sortAlong(axis);
    const double below = part(h[1], 1 - axis) - part(h[0], 1 - axis);
    const double above = part(h[1], 1 - axis) - part(h[2], 1 - axis);
    const double side = std::fabs(below) >= std::fabs(above) ? below : above;
    const int direction = 1 - axis + (side < 0.0 ? 2 : 0);
    const auto keepFrom = [&](HalfedgeId other, double length, bool mayVanish) {
      const double ahead = side < 0.0 ? -length : length;
      keep(along(copyAt(other), direction, {}, copyAt(h[1])), ahead, true, mayVanish);
    };
    const bool isFirst = side == below;
    const double other = (isFirst ? above : below) * (side < 0.0 ? -1.0 : 1.0);
    if (std::fabs(side) > reach_ || other < -kSlightShare * reach_) return;
    keepFrom(h[0], below, !isFirst);
    keepFrom(h[2], above, isFirst);
  }

  /// Other cones and reflex corners within reach, in the plane unfolded from tail(first).
  void lookAround(HalfedgeId first) {
    struct Seen {
      FaceId face;
      Complex shift;  ///< z in the first chart = i^−turn z here + shift
      int turn;
      std::vector<SeamStep> seams;
    };
    const VertexId start = mesh_.tail(first);
    const Complex origin = at(first);
    std::vector<Seen> queue{{TriMesh::face(first), 0.0, 0, {}}};
    std::set<FaceId> isSeen{TriMesh::face(first)};
    for (std::size_t n = 0; n < queue.size() && n < kMaxAround; ++n)
      for (int k = 0; k < 3; ++k) {
        const Seen own = queue[n];
        const HalfedgeId h = TriMesh::halfedge(own.face, k);
        const auto place = [&](HalfedgeId corner) {
          return rotation(-own.turn, 4) * at(corner) + own.shift;
        };
        const VertexId v = mesh_.tail(h);
        if (v != start && isPoint_[v]) addPair(first, own.seams, h, place(h) - origin);
        if (isFeature(h)) continue;
        const FaceId next = TriMesh::face(mesh_.twin(h));
        const Complex middle = 0.5 * (place(h) + place(TriMesh::next(h)));
        if (isSeen.contains(next) || portable::abs(middle - origin) > kPointShare * reach_)
          continue;
        isSeen.insert(next);
        Seen there{next, 0.0, own.turn + turnAcross(h), own.seams};
        if (isSeam(h)) there.seams.push_back(stepOver(h, own.turn, there.turn));
        there.shift = place(h) - rotation(-there.turn, 4) * at(TriMesh::next(mesh_.twin(h)));
        queue.push_back(std::move(there));
      }
  }
  /// Whether a sector turns by more than half a turn.
  bool isReflex(std::size_t s) const { return p_.index[hgp::at(mesh_.vertexCount()) + s] >= 3; }
  void addPair(HalfedgeId from, const std::vector<SeamStep>& seams, HalfedgeId to,
               const Complex& way) {
    if (portable::abs(way) > kPointShare * reach_) return;
    const bool isReal = std::fabs(way.real()) >= std::fabs(way.imag());
    const double length = isReal ? way.real() : way.imag();
    const int direction = (isReal ? 0 : 1) + (length < 0.0 ? 2 : 0);
    std::vector<SeamStep> steps = seams;
    for (SeamStep& s : steps) {
      s.before += direction;
      s.after += direction;
    }
    const bool isOfCone =
        !p_.sectors.isOnFeature[mesh_.tail(from)] || !p_.sectors.isOnFeature[mesh_.tail(to)];
    keep(along(copyAt(from), direction, steps, copyAt(to)), std::fabs(length), isOfCone);
  }

  struct Found {
    double length;
    bool isOfCone, mayVanish;
  };
  const StraightPlane& p_;
  const TriMesh& mesh_;
  const double reach_;
  PerVertex<char> isPoint_{hgp::at(mesh_.vertexCount()),
                           0};  ///< cones off features, reflex corners
  std::map<RealSum, Found> found_;
};

}  // namespace

int headingOf(const StraightPlane& plane, HalfedgeId h) {
  const Complex d =
      plane.z[at(plane.cut.copy[TriMesh::next(h)].i)] - plane.z[at(plane.cut.copy[h].i)];
  if (std::fabs(d.real()) >= std::fabs(d.imag())) return d.real() >= 0.0 ? 0 : 2;
  return d.imag() > 0.0 ? 1 : 3;
}

std::vector<LineGap> lineGaps(const StraightPlane& plane, double reach) {
  return GapFinder(plane, reach).run();
}

}  // namespace hgp
