#include "hgp/api/stored/convex_polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"
#include "hgp/verify/orientation.h"

namespace hgp::api {
namespace {

constexpr int kPasses = 12, kSteps = 24;

using Corner = std::array<int, 3>;  // of uv: must be counterclockwise

struct Copy {
  int uv;
  int turn;  ///< multiples of 2π/q from the first copy
};

double doubleArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// One component, with the corners of its polygons that have more than three.
class Opener {
 public:
  Opener(const ModelComponent& component, io::PolygonsView polygons, ComponentMap& map)
      : component_(component), polygons_(polygons), map_(map), uv_(map.map.uv) {}

  /// Whether a uv was moved.
  bool open() {
    collectPolygons();
    std::vector<int> wrong = notConvex();
    if (wrong.empty()) return false;
    findTied();
    collectCorners();
    bool isAny = false;
    for (int pass = 0; pass < kPasses && !wrong.empty(); ++pass) {
      bool isMoved = false;
      for (const int p : wrong)
        for (const int i : rings_[at(p)]) isMoved = move(i) || isMoved;
      isAny = isAny || isMoved;
      if (!isMoved) break;
      wrong = notConvex();
    }
    return isAny;
  }

  const std::vector<Vec2>& uv() const { return uv_; }

 private:
  Vec2 uvAt(int i) const { return uv_[at(i)]; }

  /// The rings of polygons all of whose triangles are in this component with one winding and one uv per corner.
  void collectPolygons() {
    const auto& mesh = *polygons_.mesh;
    std::vector<int> faceOf(at(mesh.triangleCount()), -1);
    for (int f = 0; f < component_.face.size(); ++f) faceOf[at(component_.face[FaceId{f}].i)] = f;
    for (int p = 0; p < mesh.polygonCount(); ++p) {
      const int begin = static_cast<int>(mesh.start[at(p)]);
      std::vector<int> ring(mesh.start[at(p + 1)] - mesh.start[at(p)], -1);
      bool isWhole = ring.size() > 3;
      int turned = -1;
      for (int t = mesh.firstTriangle(p); isWhole && t < mesh.firstTriangle(p + 1); ++t) {
        const int f = faceOf[at(t)];
        isWhole = f >= 0 && takeTriangle(f, t, begin, ring, turned);
      }
      if (!isWhole) continue;
      if (turned == 1) std::reverse(ring.begin(), ring.end());
      rings_.push_back(std::move(ring));
    }
  }

  bool takeTriangle(int f, int t, int begin, std::vector<int>& ring, int& turned) const {
    const auto from = [&](int k) { return component_.corner[HalfedgeId{3 * f + k}].i % 3; };
    const int isTurned = (from(1) - from(0) + 3) % 3 == 2;
    if (turned >= 0 && turned != isTurned) return false;
    turned = isTurned;
    for (int k = 0; k < 3; ++k) {
      int& slot = ring[at((*polygons_.corners)[at(t)][at(from(k))] - begin)];
      const int i = map_.map.cornerUv[at(f)][at(k)];
      if (slot >= 0 && slot != i) return false;
      slot = i;
    }
    return true;
  }

  static Corner cornerOf(const std::vector<int>& ring, std::size_t i) {
    return {ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]};
  }

  std::vector<int> notConvex() const {
    std::vector<int> out;
    for (std::size_t p = 0; p < rings_.size(); ++p)
      for (std::size_t i = 0; i < rings_[p].size(); ++i) {
        const Corner c = cornerOf(rings_[p], i);
        if (orientationSign(uvAt(c[0]), uvAt(c[1]), uvAt(c[2])) > 0) continue;
        out.push_back(static_cast<int>(p));
        break;
      }
    return out;
  }

  /// The other copies of each uv on seams, with the turn by which a displacement carries over; a uv at the boundary or
  /// at a cone is tied.
  void findTied() {
    isTied_.assign(uv_.size(), 0);
    links_.resize(uv_.size());
    const TriMesh& mesh = component_.mesh;
    for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
      const auto uvOf = [&](HalfedgeId side) {
        return map_.map.cornerUv[at(side.i / 3)][at(side.i % 3)];
      };
      const HalfedgeId side{h}, twin = mesh.twin(side);
      const int a = uvOf(side), b = uvOf(mesh.next(side));
      if (!twin.isValid()) {
        isTied_[at(a)] = isTied_[at(b)] = 1;
        continue;
      }
      const int otherB = uvOf(twin), otherA = uvOf(mesh.next(twin));
      if (otherA == a && otherB == b) continue;
      const int turn = turnBetween(a, b, otherA, otherB);
      links_[at(a)].push_back({otherA, turn});
      links_[at(b)].push_back({otherB, turn});
    }
    for (const ConePoint& cone : map_.spec.cones)
      for (std::size_t i = 0; i < uv_.size(); ++i)
        if (map_.copyOf[i] == cone.vertex) isTied_[i] = 1;
  }

  int turnBetween(int a, int b, int otherA, int otherB) const {
    const Complex here{uvAt(b)[0] - uvAt(a)[0], uvAt(b)[1] - uvAt(a)[1]};
    const Complex there{uvAt(otherB)[0] - uvAt(otherA)[0], uvAt(otherB)[1] - uvAt(otherA)[1]};
    const double angle = portable::arg(there * std::conj(here));
    const int q = map_.spec.q;
    const int turn = static_cast<int>(std::lround(angle * q / (2 * kPi)));
    return (turn % q + q) % q;
  }

  /// All copies of a uv, itself first; empty if they cannot move together.
  std::vector<Copy> copiesOf(int i) const {
    std::vector<Copy> out{{i, 0}};
    for (std::size_t n = 0; n < out.size(); ++n) {
      if (isTied_[at(out[n].uv)]) return {};
      for (const Copy& link : links_[at(out[n].uv)]) {
        const int turn = (out[n].turn + link.turn) % map_.spec.q;
        const auto known =
            std::find_if(out.begin(), out.end(), [&](const Copy& c) { return c.uv == link.uv; });
        if (known == out.end()) {
          out.push_back({link.uv, turn});
        } else if (known->turn != turn) {
          return {};
        }
      }
    }
    return out;
  }

  /// All corners around every uv, of triangles and polygons.
  void collectCorners() {
    around_.resize(uv_.size());
    const auto add = [&](const Corner& c) {
      for (const int i : c) around_[at(i)].push_back(c);
    };
    for (const auto& c : map_.map.cornerUv) add(c);
    for (const auto& ring : rings_)
      for (std::size_t i = 0; i < ring.size(); ++i) add(cornerOf(ring, i));
  }

  double smallest(const std::vector<Copy>& copies) const {
    double out = std::numeric_limits<double>::infinity();
    for (const Copy& copy : copies)
      for (const Corner& c : around_[at(copy.uv)])
        out = std::min(out, doubleArea(uvAt(c[0]), uvAt(c[1]), uvAt(c[2])));
    return out;
  }

  void place(const std::vector<Copy>& copies, const std::vector<Vec2>& start, const Vec2& by) {
    for (std::size_t n = 0; n < copies.size(); ++n) {
      const Complex d = rotation(copies[n].turn, map_.spec.q) * Complex{by[0], by[1]};
      uv_[at(copies[n].uv)] = {start[n][0] + d.real(), start[n][1] + d.imag()};
    }
  }

  /// A pattern search for the largest smallest area.
  bool move(int i) {
    const std::vector<Copy> copies = copiesOf(i);
    if (copies.empty()) return false;
    double best = smallest(copies), step = 0;
    for (const Corner& c : around_[at(i)])
      for (const int j : c)
        step =
            std::max({step, std::abs(uvAt(j)[0] - uvAt(i)[0]), std::abs(uvAt(j)[1] - uvAt(i)[1])});
    step /= 4;
    std::vector<Vec2> start;
    start.reserve(copies.size());
    for (const Copy& copy : copies) start.push_back(uvAt(copy.uv));
    Vec2 moved{0, 0};
    for (int n = 0; n < kSteps; ++n) {
      const Vec2 here = moved;
      for (int du = -1; du <= 1; ++du)
        for (int dv = -1; dv <= 1; ++dv) {
          const Vec2 next{here[0] + du * step, here[1] + dv * step};
          place(copies, start, next);
          const double value = smallest(copies);
          if (!(value > best)) continue;
          best = value;
          moved = next;
        }
      if (moved == here) step /= 2;
    }
    place(copies, start, moved);
    return moved != Vec2{0, 0};
  }

  const ModelComponent& component_;
  io::PolygonsView polygons_;
  const ComponentMap& map_;
  std::vector<Vec2> uv_;
  std::vector<std::vector<int>> rings_;
  std::vector<char> isTied_;
  std::vector<std::vector<Copy>> links_;
  std::vector<std::vector<Corner>> around_;
};

}  // namespace

void makePolygonsConvex(const Model& model, io::PolygonsView polygons,
                        std::vector<ComponentMap>& components) {
  if (!polygons.mesh) return;
  for (std::size_t p = 0; p < components.size(); ++p) {
    ComponentMap& component = components[p];
    if (component.isKept || !component.certificate.isCertified) continue;
    Opener opener(model.components[p], polygons, component);
    if (!opener.open()) continue;
    UvMap moved = component.map;
    moved.uv = opener.uv();
    Certificate certificate = certify(model.components[p].mesh, component.spec, moved);
    if (!certificate.isCertified) continue;
    component.map = std::move(moved);
    component.certificate = std::move(certificate);
  }
}

}  // namespace hgp::api
