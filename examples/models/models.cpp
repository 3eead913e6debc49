#include "models.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "implicit.h"
#include "vectors.h"

namespace hgp::models {
namespace {

constexpr double kPi = std::numbers::pi;

/// A smooth minimum of two distances, which rounds off the crease between them.
double smoothMin(double a, double b, double radius) {
  const double h = std::max(radius - std::abs(a - b), 0.0) / radius;
  return std::min(a, b) - h * h * radius / 4;
}

/// Distance to a rod from a to b whose radius changes from ra to rb.
double rod(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb) {
  const Vec3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return norm(p - a - t * d) - (ra + t * (rb - ra));
}

double creatureField(const Vec3& p) {
  struct Limb {
    Vec3 a, b;
    double ra, rb;
  };
  static const std::vector<Limb> kLimbs = {
      {{-0.45, 0.05, 0}, {0.35, 0.1, 0}, 0.27, 0.24},       // body
      {{0.4, 0.15, 0}, {0.62, 0.5, 0}, 0.15, 0.12},         // neck
      {{0.6, 0.52, 0}, {0.86, 0.46, 0}, 0.15, 0.09},        // head
      {{0.58, 0.6, 0.07}, {0.44, 0.86, 0.22}, 0.05, 0.02},  // horns
      {{0.58, 0.6, -0.07}, {0.44, 0.86, -0.22}, 0.05, 0.02},
      {{-0.6, 0.1, 0}, {-0.82, 0.3, 0.06}, 0.1, 0.06},  // tail
      {{-0.82, 0.3, 0.06}, {-0.78, 0.62, 0.1}, 0.06, 0.04},
      {{-0.78, 0.62, 0.1}, {-0.58, 0.7, 0.0}, 0.04, 0.05}};
  double distance = 1e30;
  for (const Limb& l : kLimbs) {
    distance = smoothMin(distance, rod(p, l.a, l.b, l.ra, l.rb), 0.12);
  }
  for (double x : {-0.45, 0.3}) {
    for (double side : {-1.0, 1.0}) {
      const Vec3 hip{x, -0.05, 0.15 * side}, knee{x + 0.08, -0.4, 0.26 * side},
          foot{x - 0.02, -0.72, 0.24 * side}, toe{x + 0.12, -0.76, 0.27 * side};
      distance = smoothMin(distance, rod(p, hip, knee, 0.13, 0.09), 0.1);
      distance = smoothMin(distance, rod(p, knee, foot, 0.09, 0.06), 0.06);
      distance = smoothMin(distance, rod(p, foot, toe, 0.065, 0.055), 0.05);
    }
  }
  return distance;
}

double latticeField(const Vec3& p) {
  const double angle = 0.5 * p[1];
  const Vec3 q{std::cos(angle) * p[0] - std::sin(angle) * p[2], p[1],
               std::sin(angle) * p[0] + std::cos(angle) * p[2]};
  // Distance to the nearest rod along each axis, with the two other coordinates reduced to one cell.
  constexpr double kSpacing = 0.6, kRadius = 0.13;
  Vec3 folded, beyond;
  for (int i = 0; i < 3; ++i) {
    const double cell = std::clamp(std::round(q[i] / kSpacing), -1.0, 1.0);
    folded[i] = q[i] - kSpacing * cell;
    beyond[i] = std::max(std::abs(q[i]) - kSpacing, 0.0);
  }
  double distance = 1e30;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double rodDistance = std::hypot(folded[j], folded[k], beyond[i]) - kRadius;
    distance = smoothMin(distance, rodDistance, 0.1);
  }
  return distance;
}

double pretzelField(const Vec3& p) {
  const auto ring = [&](double x, double z) {
    const double across = std::hypot(p[0] - x, p[2] - z) - 0.36;
    return std::hypot(across, p[1]) - 0.15;
  };
  const double two = smoothMin(ring(-0.44, -0.25), ring(0.44, -0.25), 0.08);
  return smoothMin(two, ring(0, 0.5), 0.08);
}

double ringsField(const Vec3& p) {
  double distance = 1e30;
  for (double x : {-0.72, -0.36, 0.0, 0.36, 0.72}) {
    const double across = std::hypot(p[0] - x, p[2]) - 0.19;
    distance = smoothMin(distance, std::hypot(across, p[1]) - 0.075, 0.04);
  }
  return distance;
}

double cubeField(const Vec3& p) {
  double sum = 0;
  for (double x : p) sum += std::pow(x / 0.8, 6);
  return std::pow(sum, 1.0 / 6) - 1;
}

/// Rows × columns of vertices; columns are closed, rows if `isClosed`.
MeshData gridSurface(int columns, int rows, bool isClosed, Vec3 (*point)(double, double)) {
  MeshData mesh;
  const int bands = isClosed ? rows : rows - 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.positions.push_back(point(2 * kPi * i / columns, double(j) / bands));
    }
  }
  for (int j = 0; j < bands; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto id = [&](int di, int dj) {
        return (j + dj) % rows * columns + (i + di) % columns;
      };
      mesh.triangles.push_back({id(0, 0), id(1, 0), id(1, 1)});
      mesh.triangles.push_back({id(0, 0), id(1, 1), id(0, 1)});
    }
  }
  return mesh;
}

Vec3 torusPoint(double a, double t) {
  const double b = 2 * kPi * t, r = 1 + 0.4 * std::cos(a);
  return {r * std::cos(b), r * std::sin(b), -0.4 * std::sin(a)};
}

/// The trefoil lies on a torus, whose normal gives a closed frame along the curve.
Vec3 knotPoint(double a, double t) {
  const auto curve = [](double s, double r) {
    const double out = 1 + r * std::cos(3 * s);
    return Vec3{out * std::cos(2 * s), out * std::sin(2 * s), r * std::sin(3 * s)};
  };
  const double s = 2 * kPi * t;
  const Vec3 center = curve(s, 0.42), normal = unit(curve(s, 0.52) - center);
  const Vec3 tangent = unit(curve(s + 1e-5, 0.42) - curve(s - 1e-5, 0.42));
  const Vec3 side = cross(tangent, normal);
  return center + 0.2 * (std::cos(a) * unit(cross(side, tangent)) + std::sin(a) * side);
}

Vec3 vasePoint(double a, double t) {
  const double flutes = 1 + 0.06 * std::sin(kPi * t) * std::cos(7 * a + 5 * t);
  const double r = flutes * (0.38 + 0.3 * std::sin(3.6 * t) * std::sin(3.6 * t) + 0.12 * t * t);
  return {-r * std::cos(a), 2 * t - 1, r * std::sin(a)};
}

}  // namespace

MeshData sphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  MeshData mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      Vec3 p{0, 0, 0};
      p[(axis + 1) % 3] = i & 1 ? 1 : -1;
      p[(axis + 2) % 3] = i & 2 ? g : -g;
      mesh.positions.push_back(p);
    }
  }
  // Faces: the triples at mutual distance 2, oriented outwards.
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        const auto &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        if (norm(p - q) > 2.1 || norm(q - r) > 2.1 || norm(r - p) > 2.1) continue;
        const bool isOutward = dot(cross(q - p, r - p), p) > 0;
        mesh.triangles.push_back(isOutward ? std::array{a, b, c} : std::array{a, c, b});
      }
    }
  }
  for (int level = 0; level < levels; ++level) mesh = subdivide(mesh);
  for (Vec3& p : mesh.positions) p = unit(p);
  return mesh;
}

MeshData colander(int levels) {
  const MeshData whole = sphere(levels);
  const std::vector<Vec3> holes = sphere(0).positions;
  MeshData mesh;
  std::vector<int> image(whole.positions.size(), -1);
  const auto isHole = [&](int v) {
    return std::any_of(holes.begin(), holes.end(),
                       [&](const Vec3& h) { return norm(whole.positions[v] - h) < 0.22; });
  };
  for (const auto& t : whole.triangles) {
    if (isHole(t[0]) || isHole(t[1]) || isHole(t[2])) continue;
    std::array<int, 3> kept;
    for (int i = 0; i < 3; ++i) {
      int& v = image[t[i]];
      if (v < 0) {
        v = static_cast<int>(mesh.positions.size());
        mesh.positions.push_back(whole.positions[t[i]]);
      }
      kept[i] = v;
    }
    mesh.triangles.push_back(kept);
  }
  return mesh;
}

MeshData torus(int around, int along) { return gridSurface(around, along, true, torusPoint); }
MeshData knot(int around, int along) { return gridSurface(around, along, true, knotPoint); }
MeshData vase(int around, int along) { return gridSurface(around, along, false, vasePoint); }
MeshData cube(int cells) { return surfaceOf(cubeField, 1, cells); }
MeshData pretzel(int cells) { return surfaceOf(pretzelField, 1.1, cells); }
MeshData rings(int cells) { return surfaceOf(ringsField, 1.05, cells); }
MeshData creature(int cells) { return surfaceOf(creatureField, 1.05, cells); }
MeshData lattice(int cells) { return surfaceOf(latticeField, 1.05, cells); }

MeshData creatureOfAMillion() {
  MeshData mesh = subdivide(creature(290));
  project(mesh, creatureField, 0.01);
  return mesh;
}
MeshData ringsOfAMillion() {
  MeshData mesh = subdivide(rings(420));
  project(mesh, ringsField, 0.01);
  return mesh;
}

const std::vector<std::string>& names() {
  static const std::vector<std::string> kNames = {"sphere",  "cube",    "torus",    "knot",
                                                  "vase",    "pretzel", "colander", "creature",
                                                  "lattice", "gear",    "rings",    "million"};
  return kNames;
}

MeshData byName(const std::string& name) {
  if (name == "sphere") return sphere(4);
  if (name == "cube") return cube(40);
  if (name == "torus") return torus(32, 80);
  if (name == "knot") return knot(24, 300);
  if (name == "vase") return vase(72, 96);
  if (name == "pretzel") return pretzel(70);
  if (name == "colander") return colander(5);
  if (name == "creature") return creature(80);
  if (name == "small-pretzel") return pretzel(24);
  if (name == "lattice") return lattice(72);
  if (name == "gear") return gear(9, 4);
  if (name == "rings") return rings(120);
  if (name == "million-rings") return ringsOfAMillion();
  if (name == "million") return creatureOfAMillion();
  return {};
}

}  // namespace hgp::models
