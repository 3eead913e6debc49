#include "hgp/quads/quads.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/mesh/map_area.h"
#include "hgp/quads/grid_points.h"
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

class Extraction {
 public:
  explicit Extraction(const LatticeMap& lattice)
      : lattice_(lattice), mesh_(lattice.mesh()), points_(lattice, out_) {}

  Result<QuadMesh> run(const std::vector<EdgeId>& features) {
    mark(features);
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
  void mark(const std::vector<EdgeId>& features) {
    const auto set = [&](int node) {
      if (node >= 0) out_.isOnFeature[hgp::at(node)] = 1;
    };
    for (EdgeId e : features) {
      set(points_.atVertex(mesh_.tail(mesh_.halfedge(e))));
      set(points_.atVertex(mesh_.head(mesh_.halfedge(e))));
      for (const GridPoints::Point& point : points_.inside(e)) set(point.node);
    }
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
      const int node = points_.atVertex(v);
      if (node < 0) continue;
      isClosed_[hgp::at(node)] = !mesh_.isBoundary(v);
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        addDarts(node, TriMesh::face(h), lattice_.corner(h), vectorOf(h),
                 negative(vectorOf(TriMesh::previous(h))));
      if (isClosed_[hgp::at(node)] && around_[hgp::at(node)].size() != 4)
        out_.coneVertex[hgp::at(node)] = v.i;
    }
    for (EdgeId e : mesh_.edges())
      for (const GridPoints::Point& point : points_.inside(e)) {
        const HalfedgeId h = mesh_.halfedge(e);
        addDarts(point.node, TriMesh::face(h), point.at, vectorOf(h), negative(vectorOf(h)));
        isClosed_[hgp::at(point.node)] = !mesh_.isBoundary(h);
        if (mesh_.isBoundary(h)) continue;
        const HalfedgeId twin = mesh_.twin(h);
        addDarts(point.node, TriMesh::face(twin), lattice_.across(h, point.at), vectorOf(twin),
                 negative(vectorOf(twin)));
      }
    for (FaceId f : mesh_.faces())
      for (const auto& [p, node] : points_.inside(f))
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
    const int node = points_.nodeIn(end->face, end->at, place);
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
    bool isWithoutCones = false;  // inside cells, as far as is known
    for (std::size_t d = 0; d < darts_.size(); ++d)
      if (const int next = nextAround(static_cast<int>(d)); next >= 0) hasBefore[hgp::at(next)] = 1;
    for (std::size_t first = 0; first < darts_.size(); ++first) {
      if (!hasBefore[first]) ++out_.clipped;
      if (isDone[first]) continue;
      int cell[4], count = 0;
      int d = static_cast<int>(first);
      for (; d >= 0 && count < 4; d = nextAround(d)) cell[count++] = d;
      if (d < 0) continue;
      if (d != static_cast<int>(first) || cell[2] == cell[0]) {
        if (!isWithoutCones && hasConeInside())
          return noQuads("a cell does not close after four edges: a cone is inside it");
        isWithoutCones = true;
        leaveOut(static_cast<int>(first), isDone);
        continue;
      }
      for (int n : cell) isDone[hgp::at(n)] = 1;
      const auto nodeOf = [&](int n) { return darts_[hgp::at(n)].node; };
      out_.quads.push_back({nodeOf(cell[0]), nodeOf(cell[1]), nodeOf(cell[2]), nodeOf(cell[3])});
    }
    return Done{};
  }

  /// Whether a cone lies inside a cell.
  bool hasConeInside() const {
    for (VertexId v : mesh_.vertices()) {
      if (points_.atVertex(v) >= 0 || mesh_.isBoundary(v)) continue;
      int directions = 0;
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        for (int d :
             directionsBetween(lattice_, vectorOf(h), negative(vectorOf(TriMesh::previous(h)))))
          directions += d >= 0;
      if (directions != 4) return true;
    }
    return false;
  }

  /// A cell around a whole loop of the boundary, which turns by as much as the cell has more or fewer edges than four.
  void leaveOut(int first, std::vector<char>& isDone) {
    int d = first;
    do {
      isDone[hgp::at(d)] = 1;
      d = nextAround(d);
    } while (d >= 0 && d != first && !isDone[hgp::at(d)]);
    if (d == first) ++out_.clipped;
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
      out_.isOnFeature[hgp::at(count)] = out_.isOnFeature[v];
      out_.coneVertex[hgp::at(count++)] = out_.coneVertex[v];
    }
    out_.positions.resize(hgp::at(count));
    out_.normals.resize(hgp::at(count));
    out_.face.resize(hgp::at(count));
    out_.lines.resize(hgp::at(count));
    out_.isOnFeature.resize(hgp::at(count));
    out_.coneVertex.resize(hgp::at(count));
    for (auto& quad : out_.quads)
      for (int& v : quad) v = name[hgp::at(v)];
  }

  const LatticeMap& lattice_;
  const TriMesh& mesh_;
  QuadMesh out_;
  const GridPoints points_;
  std::vector<Dart> darts_;
  std::vector<std::vector<int>> around_;  ///< per node: its darts, counterclockwise
  std::vector<int> indexOf_;              ///< per dart: its index in `around_`
  std::vector<char> isClosed_;  ///< per node: whether it is an interior point of the surface
};

}  // namespace

Result<QuadMesh> extractQuads(const TriMesh& mesh, const UvMap& map, int q, int halvings,
                              const std::vector<EdgeId>& features) {
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
  return Extraction(*lattice).run(features);
}

}  // namespace hgp
