// budget: one traversal of shared tables
#include "hgp/quads/quads.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/mesh/map_area.h"
#include "hgp/mesh/vectors.h"
#include "hgp/quads/grid_lines.h"

namespace hgp {
namespace {

Failure noQuads(std::string message) {
  return {ErrorCode::kUnsupported, "quads", std::move(message), {}};
}

/// A unit edge that leaves a grid point in one of the four directions of a face's plane.
struct Dart {
  int node = -1;
  FaceId face;
  LatticePoint at;
  int direction = 0;
  int opposite = -1;  ///< same edge from its other end; −1: leaves the surface, or on the boundary
  int end = -1;       ///< node at its other end if it runs along the boundary, −1 otherwise
};

/// Floor division.
std::int64_t floorDiv(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

class Extraction {
 public:
  explicit Extraction(const LatticeMap& lattice)
      : lattice_(lattice),
        mesh_(lattice.mesh()),
        vertexNode_(hgp::at(mesh_.vertexCount()), -1),
        edgePoints_(hgp::at(mesh_.edgeCount())),
        facePoints_(hgp::at(mesh_.faceCount())) {}

  Result<QuadMesh> run() {
    findNodes();
    makeDarts();
    for (std::size_t d = 0; d < darts_.size(); ++d) trace(static_cast<int>(d));
    for (std::size_t d = 0; d < darts_.size(); ++d) {
      const int o = darts_[d].opposite;
      // An edge along the boundary has only one dart.
      if (o >= 0 && darts_[hgp::at(o)].opposite != static_cast<int>(d)) {
        if (darts_[hgp::at(o)].opposite >= 0) return noQuads("a grid line does not lead back");
        darts_[d].opposite = -1;
      }
    }
    if (Status done = makeQuads(); !done) return done.error();
    dropUnused();
    return std::move(out_);
  }

 private:
  using PointId = std::pair<LatticePoint, int>;
  struct PointOnEdge {
    LatticePoint here;  ///< in the plane of mesh.halfedge(e)'s face
    int node;
  };

  int addNode(const Vec3& position, const Vec3& normal) {
    out_.positions.push_back(position);
    out_.normals.push_back(normal);
    out_.coneVertex.push_back(-1);
    return static_cast<int>(out_.positions.size()) - 1;
  }

  /// Area-weighted normals of the surface's vertices.
  void findNormals() {
    normal_.assign(hgp::at(mesh_.vertexCount()), Vec3{0, 0, 0});
    for (FaceId f : mesh_.faces()) {
      const auto [a, b, c] = mesh_.corners(f);
      const Vec3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(c);
      const Vec3 u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, w{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
      const Vec3 n{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
      for (VertexId v : {a, b, c})
        for (std::size_t k = 0; k < 3; ++k) normal_[hgp::at(v.i)][k] += n[k];
    }
  }

  /// The point p of face f in space.
  int addNode(FaceId f, const LatticePoint& p) {
    double weight[3], total = 0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::next(TriMesh::halfedge(f, k));  // opposite to corner k
      const LatticePoint &a = lattice_.corner(h), &b = lattice_.corner(TriMesh::next(h));
      weight[k] = static_cast<double>(b.u - a.u) * static_cast<double>(p.v - a.v) -
                  static_cast<double>(b.v - a.v) * static_cast<double>(p.u - a.u);
      weight[k] = std::max(weight[k], 0.0);
      total += weight[k];
    }
    Vec3 position{0, 0, 0}, normal{0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      const VertexId v = mesh_.tail(TriMesh::halfedge(f, k));
      for (std::size_t j = 0; j < 3; ++j) {
        position[j] += weight[k] / total * mesh_.position(v)[j];
        normal[j] += weight[k] / total * normal_[hgp::at(v.i)][j];
      }
    }
    return addNode(position, unit(normal));
  }
  static Vec3 unit(const Vec3& n) {
    const double length = norm(n);
    return length > 0 ? Vec3{n[0] / length, n[1] / length, n[2] / length} : Vec3{0, 0, 1};
  }

  void findNodes() {
    findNormals();
    for (VertexId v : mesh_.vertices()) {
      if (mesh_.isIsolated(v) || !lattice_.isWhole(lattice_.corner(mesh_.outgoing(v)))) continue;
      vertexNode_[v] = addNode(mesh_.position(v), unit(normal_[hgp::at(v.i)]));
    }
    for (FaceId f : mesh_.faces()) {
      const std::int64_t one = lattice_.unit();
      std::int64_t low[2], high[2];
      for (int k = 0; k < 3; ++k) {
        const LatticePoint& p = lattice_.corner(TriMesh::halfedge(f, k));
        const std::int64_t x[2] = {p.u, p.v};
        for (int j = 0; j < 2; ++j) {
          low[j] = k == 0 ? x[j] : std::min(low[j], x[j]);
          high[j] = k == 0 ? x[j] : std::max(high[j], x[j]);
        }
      }
      for (std::int64_t u = -floorDiv(-low[0], one); u <= floorDiv(high[0], one); ++u)
        for (std::int64_t v = -floorDiv(-low[1], one); v <= floorDiv(high[1], one); ++v)
          addPoint(f, {u * one, v * one});
    }
  }

  void addPoint(FaceId f, const LatticePoint& p) {
    HalfedgeId on;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (lattice_.corner(h) == p) return;  // a vertex
      const int side = lattice_.side(h, p);
      if (side < 0) return;
      if (side == 0) on = h;
    }
    if (!on.isValid()) {
      facePoints_[f].push_back({p, addNode(f, p)});
    } else if (mesh_.halfedge(mesh_.edge(on)) == on) {
      edgePoints_[mesh_.edge(on)].push_back({p, addNode(f, p)});
    }
  }

  /// The node at p in the closed face f, −1 if there is none. `on` is the halfedge on which p lies or, if p is a
  /// vertex, the halfedge that leaves it; invalid inside f.
  struct Place {
    int node = -1;
    HalfedgeId on;
    bool isVertex = false;
  };
  Place placeOf(FaceId f, const LatticePoint& p) const {
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (lattice_.corner(h) == p) return {vertexNode_[mesh_.tail(h)], h, true};
    }
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (lattice_.side(h, p) != 0) continue;
      const EdgeId e = mesh_.edge(h);
      const LatticePoint here = mesh_.halfedge(e) == h ? p : lattice_.across(h, p);
      for (const PointOnEdge& point : edgePoints_[e])
        if (point.here == here) return {point.node, h, false};
      return {};
    }
    for (const auto& [point, node] : facePoints_[f])
      if (point == p) return {node, {}, false};
    return {};
  }

  /// Adds the darts in the grid directions of face f from `start` (included) to `end` (excluded), counterclockwise.
  /// @pre `start` and `end` are at most half a turn apart
  void addDarts(int node, FaceId f, const LatticePoint& p, const LatticePoint& start,
                const LatticePoint& end) {
    // At most two grid directions lie in a half-open range of at most half a turn.
    int first = -1, second = -1;
    for (int d = 0; d < 4; ++d) {
      if (!isBetween(start, lattice_.step(d), end)) continue;
      (first < 0 ? first : second) = d;
    }
    if (second >= 0 && crossSign(lattice_.step(first), lattice_.step(second)) < 0)
      std::swap(first, second);
    for (int d : {first, second}) {
      if (d < 0) continue;
      around_[hgp::at(node)].push_back(static_cast<int>(darts_.size()));
      darts_.push_back({node, f, p, d, -1});
    }
  }
  static bool isBetween(const LatticePoint& start, const LatticePoint& d, const LatticePoint& end) {
    const int fromStart = crossSign(start, d), toEnd = crossSign(d, end);
    const bool isAlongStart = fromStart == 0 && dotSign(start, d) > 0;
    if (crossSign(start, end) == 0) return isAlongStart || fromStart > 0;  // half a turn
    return (isAlongStart || fromStart > 0) && toEnd > 0;
  }
  LatticePoint vectorOf(HalfedgeId h) const {
    const LatticePoint &a = lattice_.corner(h), &b = lattice_.corner(TriMesh::next(h));
    return {b.u - a.u, b.v - a.v};
  }
  static LatticePoint negative(const LatticePoint& p) { return {-p.u, -p.v}; }

  void makeDarts() {
    around_.resize(out_.positions.size());
    isClosed_.assign(out_.positions.size(), 1);
    for (VertexId v : mesh_.vertices()) {
      const int node = vertexNode_[v];
      if (node < 0) continue;
      isClosed_[hgp::at(node)] = !mesh_.isBoundary(v);
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        addDarts(node, TriMesh::face(h), lattice_.corner(h), vectorOf(h),
                 negative(vectorOf(TriMesh::previous(h))));
      if (isClosed_[hgp::at(node)] && around_[hgp::at(node)].size() != 4)
        out_.coneVertex[hgp::at(node)] = v.i;
    }
    for (EdgeId e : mesh_.edges())
      for (const PointOnEdge& point : edgePoints_[e]) {
        const HalfedgeId h = mesh_.halfedge(e);
        addDarts(point.node, TriMesh::face(h), point.here, vectorOf(h), negative(vectorOf(h)));
        isClosed_[hgp::at(point.node)] = !mesh_.isBoundary(h);
        if (mesh_.isBoundary(h)) continue;
        const HalfedgeId twin = mesh_.twin(h);
        addDarts(point.node, TriMesh::face(twin), lattice_.across(h, point.here), vectorOf(twin),
                 negative(vectorOf(twin)));
      }
    for (FaceId f : mesh_.faces())
      for (const auto& [p, node] : facePoints_[f])
        for (int d = 0; d < 4; ++d) {
          around_[hgp::at(node)].push_back(static_cast<int>(darts_.size()));
          darts_.push_back({node, f, p, d, -1});
        }
    for (const std::vector<int>& list : around_)
      for (std::size_t n = 0; n < list.size(); ++n)
        place_.resize(std::max(place_.size(), hgp::at(list[n]) + 1));
    for (const std::vector<int>& list : around_)
      for (std::size_t n = 0; n < list.size(); ++n) place_[hgp::at(list[n])] = static_cast<int>(n);
  }

  int dartAt(int node, FaceId f, int direction) const {
    for (int d : around_[hgp::at(node)])
      if (darts_[hgp::at(d)].face == f && darts_[hgp::at(d)].direction == direction) return d;
    return -1;
  }

  /// Walks one unit through the faces just left of the line: points on the line count as right of it, so
  /// that lines through vertices and along edges are not special cases.
  void trace(int dart) {
    FaceId f = darts_[hgp::at(dart)].face;
    LatticePoint p = darts_[hgp::at(dart)].at;
    int direction = darts_[hgp::at(dart)].direction;
    for (;;) {
      const LatticePoint step = lattice_.step(direction);
      const LatticePoint q{p.u + step.u, p.v + step.v};
      bool isHere = true;
      for (int k = 0; k < 3 && isHere; ++k) isHere = lattice_.side(TriMesh::halfedge(f, k), q) >= 0;
      if (isHere) {
        arrive(darts_[hgp::at(dart)], f, q, (direction + 2) & 3);
        return;
      }
      HalfedgeId exit;
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        if (!isLeft(p, step, lattice_.corner(h)) &&
            isLeft(p, step, lattice_.corner(TriMesh::next(h))))
          exit = h;
      }
      if (!exit.isValid() || mesh_.isBoundary(exit)) return;
      p = lattice_.across(exit, p);
      direction = lattice_.directionAcross(exit, direction);
      f = TriMesh::face(mesh_.twin(exit));
    }
  }
  static bool isLeft(const LatticePoint& p, const LatticePoint& step, const LatticePoint& c) {
    return crossSign(step, {c.u - p.u, c.v - p.v}) > 0;
  }

  /// Finds the dart that leaves q in the opposite direction. It lies strictly inside the face just left of the line,
  /// or on the last ray of that face's corner: then it belongs to the next face.
  void arrive(Dart& dart, FaceId f, const LatticePoint& q, int back) const {
    const Place place = placeOf(f, q);
    if (place.node < 0) return;
    dart.opposite = dartAt(place.node, f, back);
    if (!place.on.isValid()) return;
    const LatticePoint end =
        negative(vectorOf(place.isVertex ? TriMesh::previous(place.on) : place.on));
    const LatticePoint step = lattice_.step(back);
    if (crossSign(step, end) != 0 || dotSign(step, end) < 0) return;
    const HalfedgeId over = place.isVertex ? TriMesh::previous(place.on) : place.on;
    if (mesh_.isBoundary(over)) {
      dart.end = place.node;
      return;
    }
    dart.opposite =
        dartAt(place.node, TriMesh::face(mesh_.twin(over)), lattice_.directionAcross(over, back));
  }

  /// The edge after `dart` around the cell on its left, −1 at the boundary.
  int nextAround(int dart) const {
    const int back = darts_[hgp::at(dart)].opposite;
    if (const int end = darts_[hgp::at(dart)].end; end >= 0)  // along the boundary
      return around_[hgp::at(end)].empty() ? -1 : around_[hgp::at(end)].back();
    if (back < 0) return -1;
    const int node = darts_[hgp::at(back)].node;
    const std::vector<int>& list = around_[hgp::at(node)];
    const int place = place_[hgp::at(back)];
    if (place > 0) return list[hgp::at(place - 1)];
    return isClosed_[hgp::at(node)] ? list.back() : -1;
  }

  Status makeQuads() {
    std::vector<char> isDone(darts_.size(), 0);
    std::vector<char> hasBefore(darts_.size(), 0);
    for (std::size_t d = 0; d < darts_.size(); ++d)
      if (const int next = nextAround(static_cast<int>(d)); next >= 0) hasBefore[hgp::at(next)] = 1;
    for (std::size_t first = 0; first < darts_.size(); ++first) {
      if (!hasBefore[first]) ++out_.clipped;
      if (isDone[first]) continue;
      int cell[4], count = 0;
      int d = static_cast<int>(first);
      for (; d >= 0 && count < 4; d = nextAround(d)) cell[count++] = d;
      if (count < 4 || d != static_cast<int>(first)) {
        if (d >= 0) return noQuads("a cell does not close after four edges: a cone is inside it");
        continue;
      }
      for (int n : cell) isDone[hgp::at(n)] = 1;
      const auto nodeOf = [&](int n) { return darts_[hgp::at(n)].node; };
      out_.quads.push_back({nodeOf(cell[0]), nodeOf(cell[1]), nodeOf(cell[2]), nodeOf(cell[3])});
    }
    return Done{};
  }

  /// Removes grid points that belong only to cells cut by the boundary.
  void dropUnused() {
    std::vector<int> name(out_.positions.size(), -1);
    int count = 0;
    for (auto& quad : out_.quads)
      for (int v : quad) name[hgp::at(v)] = 0;
    for (std::size_t v = 0; v < name.size(); ++v) {
      if (name[v] < 0) continue;
      name[v] = count;
      out_.positions[hgp::at(count)] = out_.positions[v];
      out_.normals[hgp::at(count)] = out_.normals[v];
      out_.coneVertex[hgp::at(count++)] = out_.coneVertex[v];
    }
    out_.positions.resize(hgp::at(count));
    out_.normals.resize(hgp::at(count));
    out_.coneVertex.resize(hgp::at(count));
    for (auto& quad : out_.quads)
      for (int& v : quad) v = name[hgp::at(v)];
  }

  const LatticeMap& lattice_;
  const TriMesh& mesh_;
  std::vector<Vec3> normal_;
  PerVertex<int> vertexNode_;
  PerEdge<std::vector<PointOnEdge>> edgePoints_;
  PerFace<std::vector<PointId>> facePoints_;
  std::vector<Dart> darts_;
  std::vector<std::vector<int>> around_;  ///< per node: its darts, counterclockwise
  std::vector<int> place_;                ///< per dart: its index in `around_`
  std::vector<char> isClosed_;  ///< per node: whether it is an interior point of the surface
  QuadMesh out_;
};

}  // namespace

Result<QuadMesh> extractQuads(const TriMesh& mesh, const UvMap& map, int q, int halvings) {
  if (q != 2 && q != 4)
    return noQuads(formatText("quads need rotations by quarter or half turns, not q = %d", q));
  const double cells = std::ldexp(mapArea(map), 2 * halvings);
  if (!(cells <= kMaxQuads))
    return Failure{
        ErrorCode::kLimit,
        "quads",
        formatText("%.0f quads exceed the limit of %d; ask for fewer cells", cells, kMaxQuads),
        {}};
  UvMap halved = map;
  for (Vec2& p : halved.uv) p = {std::ldexp(p[0], halvings), std::ldexp(p[1], halvings)};
  Result<LatticeMap> lattice = LatticeMap::make(mesh, halved);
  if (!lattice) return lattice.error();
  return Extraction(*lattice).run();
}

}  // namespace hgp
