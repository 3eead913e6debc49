#include "hgp/quads/grid_points.h"

#include <algorithm>
#include <cmath>

#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Floor division.
std::int64_t floorDiv(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

Vec3 unit(const Vec3& n) {
  const double length = norm(n);
  return length > 0 ? Vec3{n[0] / length, n[1] / length, n[2] / length} : Vec3{0, 0, 1};
}

bool isBefore(const LatticePoint& a, const LatticePoint& b) {
  return a.u != b.u ? a.u < b.u : a.v < b.v;
}

/// The points of a face, and thus those of an edge, were added in this order.
int nodeAt(const std::vector<GridPoints::Point>& sorted, const LatticePoint& p) {
  const auto found = std::lower_bound(
      sorted.begin(), sorted.end(), p,
      [](const GridPoints::Point& point, const LatticePoint& q) { return isBefore(point.at, q); });
  return found != sorted.end() && found->at == p ? found->node : -1;
}

}  // namespace

GridPoints::GridPoints(const LatticeMap& lattice, QuadMesh& out)
    : lattice_(lattice),
      mesh_(lattice.mesh()),
      out_(out),
      vertexNode_(at(mesh_.vertexCount()), -1),
      edgePoints_(at(mesh_.edgeCount())),
      facePoints_(at(mesh_.faceCount())) {
  findNormals();
  addVertices();
  for (FaceId f : mesh_.faces()) addInside(f);
}

int GridPoints::addNode(FaceId f, const LatticePoint& p, const Vec3& position, const Vec3& normal) {
  const auto line = [&](std::int64_t x) {
    const std::int64_t rest = x / lattice_.unit() & 3;
    return static_cast<std::int8_t>(std::min(rest, 4 - rest));
  };
  out_.lines.push_back({line(p.u), line(p.v)});
  out_.face.push_back(f);
  out_.positions.push_back(position);
  out_.normals.push_back(normal);
  out_.coneVertex.push_back(-1);
  out_.isOnFeature.push_back(0);
  return static_cast<int>(out_.positions.size()) - 1;
}

void GridPoints::findNormals() {
  normal_.assign(at(mesh_.vertexCount()), Vec3{0, 0, 0});
  for (FaceId f : mesh_.faces()) {
    const auto [a, b, c] = mesh_.corners(f);
    const Vec3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(c);
    const Vec3 u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, w{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    const Vec3 n{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    for (VertexId v : {a, b, c})
      for (std::size_t k = 0; k < 3; ++k) normal_[at(v.i)][k] += n[k];
  }
}

int GridPoints::addNode(FaceId f, const LatticePoint& p) {
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
      normal[j] += weight[k] / total * normal_[at(v.i)][j];
    }
  }
  return addNode(f, p, position, unit(normal));
}

void GridPoints::addVertices() {
  for (VertexId v : mesh_.vertices()) {
    if (mesh_.isIsolated(v) || !lattice_.isWhole(lattice_.corner(mesh_.outgoing(v)))) continue;
    vertexNode_[v] = addNode(TriMesh::face(mesh_.outgoing(v)), lattice_.corner(mesh_.outgoing(v)),
                             mesh_.position(v), unit(normal_[at(v.i)]));
  }
}

void GridPoints::addInside(FaceId f) {
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

std::pair<std::int64_t, std::int64_t> GridPoints::rowsOf(FaceId f, std::int64_t u) const {
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

void GridPoints::addPoint(FaceId f, const LatticePoint& p) {
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

int GridPoints::nodeIn(FaceId f, const LatticePoint& p, const GridPlace& place) const {
  if (place.kind == GridPlace::Kind::kVertex) return vertexNode_[mesh_.tail(place.on)];
  if (place.kind == GridPlace::Kind::kFace) return nodeAt(facePoints_[f], p);
  const EdgeId e = mesh_.edge(place.on);
  return nodeAt(edgePoints_[e], mesh_.halfedge(e) == place.on ? p : lattice_.across(place.on, p));
}

}  // namespace hgp
