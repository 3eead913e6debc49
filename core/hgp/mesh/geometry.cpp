#include "hgp/mesh/geometry.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/mesh/defects.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Triangles that a thread takes at a time.
constexpr int kFacesAtOnce = 1024;

/// The triangle in the plane, in units of the mean edge length. The height of a sliver is
/// raised to the bound, so that angles and weights stay finite.
std::array<Complex, 3> layFlat(const TriMesh& mesh, FaceId f, double unit, double relativeHeight) {
  const auto [a, b, c] = mesh.corners(f);
  const Vec3 ab = subtract(mesh.position(b), mesh.position(a));
  const Vec3 ac = subtract(mesh.position(c), mesh.position(a));
  const Vec3 bc = subtract(mesh.position(c), mesh.position(b));
  const double longest = std::max({norm(ab), norm(ac), norm(bc)}) / unit;
  const double bound = relativeHeight * longest;
  const double length = norm(ab) / unit;
  if (length <= bound) return {Complex(0, 0), Complex(bound, 0), Complex(bound / 2, longest)};
  const double x = dot(ab, ac) / (length * unit * unit);
  const double y = norm(cross(ab, ac)) / (length * unit * unit);
  // The bound is on the height over the longest edge, y · length / longest.
  const double height = std::max(y, bound * longest / length);
  return {Complex(0, 0), Complex(length, 0), Complex(x, height)};
}

using Lengths = std::array<double, 3>;  // of sides 0–1, 1–2, 2–0

/// In units of the mean edge length.
Lengths lengthsOf(const TriMesh& mesh, FaceId f, double unit) {
  const auto [a, b, c] = mesh.corners(f);
  return {norm(subtract(mesh.position(b), mesh.position(a))) / unit,
          norm(subtract(mesh.position(c), mesh.position(b))) / unit,
          norm(subtract(mesh.position(a), mesh.position(c))) / unit};
}

/// The ε of [SC20 §4.5], or 0 where every face has an area.
double findMollification(const TriMesh& mesh, double unit) {
  bool isNeeded = false;
  for (FaceId f : mesh.faces()) {
    const auto [a, b, c] = mesh.corners(f);
    isNeeded = isNeeded || hasNoArea(mesh.position(a), mesh.position(b), mesh.position(c));
  }
  if (!isNeeded) return 0.0;
  double epsilon = 0.0;
  for (FaceId f : mesh.faces()) {
    const Lengths l = lengthsOf(mesh, f, unit);
    for (std::size_t k = 0; k < 3; ++k)
      epsilon = std::max(epsilon, kMollify - (l[k] + l[(k + 1) % 3] - l[(k + 2) % 3]));
  }
  return epsilon;
}

/// The triangle with these sides; Kahan's form of Heron's formula is accurate for thin ones.
std::array<Complex, 3> layFlat(const Lengths& l) {
  Lengths sorted = l;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const auto [a, b, c] = sorted;
  const double sixteenAreas = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  const double height = 0.5 * std::sqrt(std::max(sixteenAreas, 0.0)) / l[0];
  const double x = (l[0] * l[0] + (l[2] - l[1]) * (l[2] + l[1])) / (2.0 * l[0]);
  return {Complex(0, 0), Complex(l[0], 0), Complex(x, height)};
}

double meanEdgeLength(const TriMesh& mesh) {
  double sum = 0.0;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    sum += norm(subtract(mesh.position(mesh.head(h)), mesh.position(mesh.tail(h))));
  }
  return mesh.edgeCount() > 0 && sum > 0 ? sum / mesh.edgeCount() : 1.0;
}

/// @param lay  returns the planar triangle of a face
template <class Lay>
void measure(const TriMesh& mesh, const Lay& lay, Geometry& g) {
  const auto halfedges = static_cast<std::size_t>(mesh.halfedgeCount());
  const auto faces = static_cast<std::size_t>(mesh.faceCount());
  g.length = PerHalfedge<double>(halfedges);
  g.cornerAngle = PerHalfedge<double>(halfedges);
  g.direction = PerHalfedge<double>(halfedges);
  g.corner = PerFace<std::array<Complex, 3>>(faces);
  g.area = PerFace<double>(faces);
  g.angleSum = PerVertex<double>(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  parallelFor(mesh.faceCount(), kFacesAtOnce, [&](int face) {
    const FaceId f(face);
    const std::array<Complex, 3> p = lay(f);
    g.corner[f] = p;
    g.area[f] = 0.5 * std::imag(std::conj(p[1] - p[0]) * (p[2] - p[0]));
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int n) { return p[static_cast<std::size_t>(n % 3)]; };
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const Complex edge = at(k + 1) - at(k);
      g.length[h] = std::sqrt(std::norm(edge));  // not std::abs, which is std::hypot: see norm()
      g.direction[h] = portable::arg(edge);
      g.cornerAngle[h] = portable::arg(std::conj(edge) * (at(k + 2) - at(k)));
    }
  });
  for (HalfedgeId h : mesh.halfedges()) g.angleSum[mesh.tail(h)] += g.cornerAngle[h];
}

}  // namespace

Geometry computeGeometry(const TriMesh& mesh, double relativeHeight) {
  Geometry g;
  g.unit = meanEdgeLength(mesh);
  g.mollified = findMollification(mesh, g.unit);
  const auto lay = [&](FaceId f) {
    if (g.mollified == 0.0) return layFlat(mesh, f, g.unit, relativeHeight);
    Lengths l = lengthsOf(mesh, f, g.unit);
    for (double& x : l) x += g.mollified;
    return layFlat(l);
  };
  measure(mesh, lay, g);
  return g;
}

Geometry evenedGeometry(const TriMesh& mesh) {
  Geometry g;
  g.unit = meanEdgeLength(mesh);
  const auto lay = [&](FaceId f) {
    Lengths l = lengthsOf(mesh, f, g.unit);
    for (double& x : l) x = std::sqrt(x * x + kEvening * kEvening);
    return layFlat(l);
  };
  measure(mesh, lay, g);
  return g;
}

Geometry geometryOfShapes(const TriMesh& mesh, const PerHalfedge<double>& length) {
  Geometry g;
  const auto lay = [&](FaceId f) {
    Lengths l;
    for (int k = 0; k < 3; ++k) l[static_cast<std::size_t>(k)] = length[TriMesh::halfedge(f, k)];
    const double longest = *std::max_element(l.begin(), l.end());
    for (double& x : l) x /= longest;
    return layFlat(l);
  };
  measure(mesh, lay, g);
  return g;
}

double oppositeCotangent(const Geometry& geometry, HalfedgeId h) {
  const double angle = geometry.cornerAngle[TriMesh::previous(h)];
  return portable::cos(angle) / std::max(portable::sin(angle), 1e-12);
}

double curvature(const TriMesh& mesh, const Geometry& geometry, VertexId v) {
  return (mesh.isBoundary(v) ? kPi : 2.0 * kPi) - geometry.angleSum[v];
}

double transport(const TriMesh& mesh, const Geometry& geometry, HalfedgeId h) {
  return principalAngle(geometry.direction[mesh.twin(h)] + kPi - geometry.direction[h]);
}

}  // namespace hgp
