#include "hgp/mesh/reflection.h"

#include <algorithm>
#include <cmath>

#include "hgp/mesh/face_flood.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

using Matrix = std::array<Vec3, 3>;

/// The eigenvectors of a symmetric matrix, by Jacobi's rotations.
Matrix eigenvectors(Matrix a) {
  Matrix axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  constexpr int kSweeps = 12;  // convergence is quadratic
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double t =
            std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
        }
        const Vec3 x = axes[p], y = axes[q];
        axes[p] = subtract(scaled(x, c), scaled(y, s));
        axes[q] = add(scaled(x, s), scaled(y, c));
      }
  return axes;
}

/// An offset that is smaller, relative to the diagonal, is a rounding error of single precision, and so is a smaller coordinate
/// of a normal one of double precision.
constexpr double kNoOffset = 1e-6, kNoTilt = 1e-9;

/// Box, mean and second moments of the corners of all triangles.
struct Moments {
  Box<3> box;
  Vec3 mean{0.0, 0.0, 0.0};
  Matrix second{};
};

Moments momentsOf(const MeshData& mesh) {
  Moments out;
  const double share = 1.0 / (3.0 * static_cast<double>(mesh.triangles.size()));
  for (const auto& corners : mesh.triangles)
    for (const int v : corners) {
      out.box.add(mesh.positions[at(v)]);
      out.mean = add(out.mean, scaled(mesh.positions[at(v)], share));
    }
  for (const auto& corners : mesh.triangles)
    for (const int v : corners) {
      const Vec3 d = subtract(mesh.positions[at(v)], out.mean);
      for (std::size_t i = 0; i < 3; ++i)
        out.second[i] = add(out.second[i], scaled(d, share * d[i]));
    }
  return out;
}

bool isAxis(const Vec3& normal) {
  return std::any_of(normal.begin(), normal.end(),
                     [](double x) { return std::fabs(x) > 1 - 1e-9; });
}

/// Maps the triangles of `from` to those of `to`, one after the other.
class Walk {
 public:
  Walk(const TriMesh& from, const TriMesh& to, const MirrorPlane& plane, double tolerance)
      : from_(from), to_(to), plane_(plane), tolerance_(tolerance) {}

  /// Whether all triangles have images if h has the image g.
  bool run(HalfedgeId h, HalfedgeId g) {
    image_ = {};
    image_.vertex = PerVertex<VertexId>(at(from_.vertexCount()));
    image_.halfedge = PerHalfedge<HalfedgeId>(at(from_.halfedgeCount()));
    std::vector<FaceId> open;
    matched_ = 0;
    if (!take(h, g, open)) return false;
    while (!open.empty()) {
      const FaceId f = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId side = TriMesh::halfedge(f, k);
        const HalfedgeId across = from_.twin(side), there = to_.twin(image_.halfedge[side]);
        if (across.isValid() != there.isValid()) return false;
        if (!across.isValid() || image_.halfedge[across] == there) continue;
        if (image_.halfedge[across].isValid() || !take(across, there, open)) return false;
      }
    }
    return matched_ == from_.faceCount() && matched_ == to_.faceCount();
  }
  Reflection& image() { return image_; }

 private:
  bool take(HalfedgeId h, HalfedgeId g, std::vector<FaceId>& open) {
    open.push_back(TriMesh::face(h));
    for (int k = 0; k < 3; ++k, h = TriMesh::next(h), g = TriMesh::previous(g)) {
      image_.halfedge[h] = g;
      VertexId& image = image_.vertex[from_.tail(h)];
      const VertexId v = to_.head(g);
      if (image.isValid() && image != v) return false;
      image = v;
      const double off = distance(mirrored(plane_, from_.position(from_.tail(h))), to_.position(v));
      if (!(off <= tolerance_)) return false;
      image_.distance = std::max(image_.distance, off);
    }
    ++matched_;
    return true;
  }

  const TriMesh& from_;
  const TriMesh& to_;
  const MirrorPlane& plane_;
  const double tolerance_;
  Reflection image_;
  int matched_ = 0;
};

HalfedgeId largestTriangle(const TriMesh& mesh) {
  FaceId best(0);
  double most = -1.0;
  for (FaceId f : mesh.faces()) {
    const auto [a, b, c] = mesh.corners(f);
    const double area = triangleArea(mesh.position(a), mesh.position(b), mesh.position(c));
    if (!(area > most)) continue;
    most = area;
    best = f;
  }
  return TriMesh::halfedge(best, 0);
}

bool isInPlane(const Reflection& own, const TriMesh& mesh, HalfedgeId h) {
  return own.vertex[mesh.tail(h)] == mesh.tail(h) && own.vertex[mesh.head(h)] == mesh.head(h);
}

/// Gives the corners at tail(h), as far as no edge in the plane separates them, the same number.
void numberFan(const TriMesh& mesh, const Reflection& own, HalfedgeId first, int number,
               PerHalfedge<int>& index) {
  const auto isOpen = [&](HalfedgeId side) {
    return !mesh.isBoundary(side) && !isInPlane(own, mesh, side);
  };
  for (HalfedgeId h = first; index[h] < 0;) {
    index[h] = number;
    if (isOpen(TriMesh::previous(h))) h = mesh.twin(TriMesh::previous(h));
  }
  for (HalfedgeId h = first; isOpen(h);) {
    h = TriMesh::next(mesh.twin(h));
    if (index[h] >= 0) break;
    index[h] = number;
  }
}

}  // namespace

Vec3 mirrored(const MirrorPlane& plane, const Vec3& p) {
  return subtract(p, scaled(plane.normal, 2.0 * (dot(plane.normal, p) - plane.offset)));
}

std::vector<MirrorPlane> likelyPlanes(const MeshData& mesh) {
  std::vector<MirrorPlane> planes;
  if (mesh.triangles.empty()) return planes;
  const Moments moments = momentsOf(mesh);
  const Box<3>& box = moments.box;
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 normal{0.0, 0.0, 0.0};
    normal[k] = 1.0;
    planes.push_back({std::string(1, static_cast<char>('X' + k)), normal, centreOf(box)[k]});
  }
  for (const Vec3& axis : eigenvectors(moments.second))
    if (!isAxis(axis)) planes.push_back({"", axis, dot(axis, moments.mean)});
  for (MirrorPlane& plane : planes) {
    if (std::fabs(plane.offset) < kNoOffset * diagonal(box)) plane.offset = 0.0;
    for (double& x : plane.normal)
      if (std::fabs(x) < kNoTilt) x = 0.0;
  }
  return planes;
}

Box<3> boxOfCorners(const TriMesh& mesh) {
  Box<3> box;
  for (HalfedgeId h : mesh.halfedges()) box.add(mesh.position(mesh.tail(h)));
  return box;
}

std::optional<Reflection> findReflection(const TriMesh& from, const TriMesh& to,
                                         const MirrorPlane& plane, double tolerance) {
  const HalfedgeId first = largestTriangle(from);
  std::array<Vec3, 3> place;  // of the image of tail, head and the third corner of `first`
  HalfedgeId h = first;
  for (Vec3& p : place) {
    p = mirrored(plane, from.position(from.tail(h)));
    h = TriMesh::next(h);
  }
  if (from.faceCount() != to.faceCount()) return std::nullopt;
  Walk walk(from, to, plane, tolerance);
  HalfedgeId g;  // the last start, and how far it is from the place
  double reached = -1.0;
  for (std::size_t n = 0; n < kMaxStarts; ++n) {
    HalfedgeId next;
    double nearest = tolerance;
    for (HalfedgeId k : to.halfedges()) {
      const double off = std::max({distance(to.position(to.head(k)), place[0]),
                                   distance(to.position(to.tail(k)), place[1]),
                                   distance(to.position(to.head(TriMesh::next(k))), place[2])});
      if (off < reached || (off == reached && !(g < k))) continue;
      if (!(off <= nearest) || (next.isValid() && off == nearest)) continue;
      next = k;
      nearest = off;
    }
    if (!next.isValid()) break;
    g = next;
    reached = nearest;
    if (walk.run(first, g)) return std::move(walk.image());
  }
  return std::nullopt;
}

bool hasTwoSides(const TriMesh& mesh, const Reflection& own) {
  PerVertex<char> isIn(at(mesh.vertexCount()), 0);
  std::vector<VertexId> side;  // all that is joined to its first vertex
  const auto take = [&](VertexId v) {
    isIn[v] = 1;
    side.push_back(v);
  };
  for (HalfedgeId h : mesh.halfedges()) {
    if (own.halfedge[own.halfedge[h]] != h) return false;
    if (side.empty() && own.vertex[mesh.tail(h)] != mesh.tail(h)) take(mesh.tail(h));
  }
  for (std::size_t i = 0; i < side.size(); ++i) {
    const VertexId v = side[i];
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      for (const VertexId w : {mesh.head(h), mesh.tail(TriMesh::previous(h))})
        if (!isIn[w] && own.vertex[w] != w && own.vertex[w] != v) take(w);
  }
  return !side.empty() && !isIn[own.vertex[side.front()]];
}

std::vector<EdgeId> edgesInPlane(const TriMesh& mesh, const Reflection& own) {
  std::vector<EdgeId> edges;
  for (EdgeId e : mesh.edges())
    if (isInPlane(own, mesh, mesh.halfedge(e))) edges.push_back(e);
  return edges;
}

std::vector<EdgeId> edgesAcross(const TriMesh& mesh, const Reflection& own) {
  std::vector<EdgeId> edges;
  for (EdgeId e : mesh.edges())
    if (own.halfedge[mesh.halfedge(e)] == mesh.halfedge(e)) edges.push_back(e);
  return edges;
}

HalfSurface halfOf(const TriMesh& mesh, const Reflection& own, const MirrorPlane& plane) {
  FaceId seed(0);
  double farthest = 0.0;
  for (HalfedgeId h : mesh.halfedges()) {
    const double height = dot(plane.normal, mesh.position(mesh.tail(h))) - plane.offset;
    if (!(height > farthest)) continue;
    farthest = height;
    seed = TriMesh::face(h);
  }
  PerFace<char> isIn(at(mesh.faceCount()), 0);
  isIn[seed] = 1;
  floodFaces(mesh, seed, [&](HalfedgeId h, FaceId g) {
    if (isIn[g] || isInPlane(own, mesh, h)) return false;
    isIn[g] = 1;
    return true;
  });
  HalfSurface out;
  MeshData data;
  PerHalfedge<int> index(at(mesh.halfedgeCount()), -1);
  for (FaceId f : mesh.faces()) {
    if (!isIn[f]) continue;
    out.faceOrigin.push_back(f);
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (index[h] < 0) {
        numberFan(mesh, own, h, static_cast<int>(out.vertexOrigin.size()), index);
        out.vertexOrigin.push_back(mesh.tail(h));
        data.positions.push_back(mesh.position(mesh.tail(h)));
      }
      corners[at(k)] = index[h];
    }
    data.triangles.push_back(corners);
  }
  out.mesh = buildUsableMesh(data);
  return out;
}

}  // namespace hgp
