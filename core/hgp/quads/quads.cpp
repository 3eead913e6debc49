// budget: one traversal of shared tables
#include "hgp/quads/quads.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/mesh/map_area.h"
#include "hgp/mesh/vectors.h"
#include "hgp/quads/grid_walk.h"

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
  struct GridPoint {
    LatticePoint at;  ///< on an edge e: in the plane of mesh.halfedge(e)'s face
    int node;
  };

  int addNode(FaceId f, const LatticePoint& p, const Vec3& position, const Vec3& normal) {
    const auto line = [&](std::int64_t x) {
      const std::int64_t rest = x / lattice_.unit() & 3;
      return static_cast<std::int8_t>(std::min(rest, 4 - rest));
    };
    out_.lines.push_back({line(p.u), line(p.v)});
    out_.face.push_back(f);
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
    return addNode(f, p, position, unit(normal));
  }
  static Vec3 unit(const Vec3& n) {
    const double length = norm(n);
    return length > 0 ? Vec3{n[0] / length, n[1] / length, n[2] / length} : Vec3{0, 0, 1};
  }

  void findNodes() {
    findNormals();
    for (VertexId v : mesh_.vertices()) {
      if (mesh_.isIsolated(v) || !lattice_.isWhole(lattice_.corner(mesh_.outgoing(v)))) continue;
      vertexNode_[v] = addNode(TriMesh::face(mesh_.outgoing(v)), lattice_.corner(mesh_.outgoing(v)),
                               mesh_.position(v), unit(normal_[hgp::at(v.i)]));
    }
    for (FaceId f : mesh_.faces()) {
      const std::int64_t one = lattice_.unit();
      std::int64_t low = lattice_.corner(TriMesh::halfedge(f, 0)).u, high = low;
      for (int k = 1; k < 3; ++k) {
        low = std::min(low, lattice_.corner(TriMesh::halfedge(f, k)).u);
        high = std::max(high, lattice_.corner(TriMesh::halfedge(f, k)).u);
      }
      for (std::int64_t u = -floorDiv(-low, one); u <= floorDiv(high, one); ++u) {
        const auto [first, last] = rowsOf(f, u * one);
        for (std::int64_t v = first; v <= last; ++v) addPoint(f, {u * one, v * one});
      }
    }
  }

  /// The range of whole v in which the line u meets face f, and at most one more at either end: a long triangle has few
  /// of the grid points of its box. Rounding here is far below a cell, and addPoint() decides.
  std::pair<std::int64_t, std::int64_t> rowsOf(FaceId f, std::int64_t u) const {
    double low = 0.0, high = -1.0;
    for (int k = 0; k < 3; ++k) {
      const LatticePoint &a = lattice_.corner(TriMesh::halfedge(f, k)),
                         &b = lattice_.corner(TriMesh::halfedge(f, (k + 1) % 3));
      if (u < std::min(a.u, b.u) || u > std::max(a.u, b.u)) continue;
      const double share =
          a.u == b.u ? 0.0 : static_cast<double>(u - a.u) / static_cast<double>(b.u - a.u);
      const double v = static_cast<double>(a.v) + share * static_cast<double>(b.v - a.v);
      const double w = a.u == b.u ? static_cast<double>(b.v) : v;
      const bool isFirst = high < low;
      low = isFirst ? std::min(v, w) : std::min({low, v, w});
      high = isFirst ? std::max(v, w) : std::max({high, v, w});
    }
    const auto one = static_cast<double>(lattice_.unit());
    return {static_cast<std::int64_t>(std::ceil(low / one)) - 1,
            static_cast<std::int64_t>(std::floor(high / one)) + 1};
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

  /// The node at p, which lies at `place` in face f; −1 if there is none.
  int nodeIn(FaceId f, const LatticePoint& p, const GridPlace& place) const {
    if (place.kind == GridPlace::Kind::kVertex) return vertexNode_[mesh_.tail(place.on)];
    if (place.kind == GridPlace::Kind::kFace) return nodeAt(facePoints_[f], p);
    const EdgeId e = mesh_.edge(place.on);
    return nodeAt(edgePoints_[e], mesh_.halfedge(e) == place.on ? p : lattice_.across(place.on, p));
  }
  static bool isBefore(const LatticePoint& a, const LatticePoint& b) {
    return a.u != b.u ? a.u < b.u : a.v < b.v;
  }
  /// findNodes() adds the points of a face, and thus those of an edge, in this order.
  static int nodeAt(const std::vector<GridPoint>& sorted, const LatticePoint& p) {
    const auto found = std::lower_bound(
        sorted.begin(), sorted.end(), p,
        [](const GridPoint& point, const LatticePoint& q) { return isBefore(point.at, q); });
    return found != sorted.end() && found->at == p ? found->node : -1;
  }

  /// Adds the darts of a node in face f from `start` (included) to `end` (excluded), counterclockwise.
  void addDarts(int node, FaceId f, const LatticePoint& p, const LatticePoint& start,
                const LatticePoint& end) {
    for (int d : directionsBetween(lattice_, start, end)) {
      if (d < 0) continue;
      around_[hgp::at(node)].push_back(static_cast<int>(darts_.size()));
      darts_.push_back({node, f, p, d, -1});
    }
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
      for (const GridPoint& point : edgePoints_[e]) {
        const HalfedgeId h = mesh_.halfedge(e);
        addDarts(point.node, TriMesh::face(h), point.at, vectorOf(h), negative(vectorOf(h)));
        isClosed_[hgp::at(point.node)] = !mesh_.isBoundary(h);
        if (mesh_.isBoundary(h)) continue;
        const HalfedgeId twin = mesh_.twin(h);
        addDarts(point.node, TriMesh::face(twin), lattice_.across(h, point.at), vectorOf(twin),
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
        indexOf_.resize(std::max(indexOf_.size(), hgp::at(list[n]) + 1));
    for (const std::vector<int>& list : around_)
      for (std::size_t n = 0; n < list.size(); ++n)
        indexOf_[hgp::at(list[n])] = static_cast<int>(n);
  }

  int dartAt(int node, FaceId f, int direction) const {
    for (int d : around_[hgp::at(node)])
      if (darts_[hgp::at(d)].face == f && darts_[hgp::at(d)].direction == direction) return d;
    return -1;
  }

  /// Walks to the other end of a dart and finds the dart that leaves it in the opposite direction.
  void trace(int index) {
    Dart& dart = darts_[hgp::at(index)];
    const LatticePoint step = lattice_.step(dart.direction);
    const std::optional<GridRay> end =
        walkTo(lattice_, dart.face, {dart.at.u + step.u, dart.at.v + step.v}, dart.direction);
    if (!end) return;
    const GridPlace place = placeIn(lattice_, end->face, end->at);
    const int node = nodeIn(end->face, end->at, place);
    if (node < 0) return;
    const GridArrival back = arrivalOf(lattice_, *end, place);
    dart.opposite = dartAt(node, back.ray.face, back.ray.direction);
    if (back.alongBoundary) dart.end = node;
  }

  /// The edge after `dart` around the cell on its left, −1 at the boundary.
  int nextAround(int dart) const {
    const int back = darts_[hgp::at(dart)].opposite;
    if (const int end = darts_[hgp::at(dart)].end; end >= 0)  // along the boundary
      return around_[hgp::at(end)].empty() ? -1 : around_[hgp::at(end)].back();
    if (back < 0) return -1;
    const int node = darts_[hgp::at(back)].node;
    const std::vector<int>& list = around_[hgp::at(node)];
    const int index = indexOf_[hgp::at(back)];
    if (index > 0) return list[hgp::at(index - 1)];
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
      out_.face[hgp::at(count)] = out_.face[v];
      out_.lines[hgp::at(count)] = out_.lines[v];
      out_.coneVertex[hgp::at(count++)] = out_.coneVertex[v];
    }
    out_.positions.resize(hgp::at(count));
    out_.normals.resize(hgp::at(count));
    out_.face.resize(hgp::at(count));
    out_.lines.resize(hgp::at(count));
    out_.coneVertex.resize(hgp::at(count));
    for (auto& quad : out_.quads)
      for (int& v : quad) v = name[hgp::at(v)];
  }

  const LatticeMap& lattice_;
  const TriMesh& mesh_;
  std::vector<Vec3> normal_;
  PerVertex<int> vertexNode_;
  PerEdge<std::vector<GridPoint>> edgePoints_;
  PerFace<std::vector<GridPoint>> facePoints_;
  std::vector<Dart> darts_;
  std::vector<std::vector<int>> around_;  ///< per node: its darts, counterclockwise
  std::vector<int> indexOf_;              ///< per dart: its index in `around_`
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
