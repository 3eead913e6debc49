#include "surfaces.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "hgp/mesh/topology.h"
#include "implicit.h"
#include "random.h"
#include "vectors.h"

namespace hgp::stress {
namespace {

using namespace hgp::models;

/// Maximum number of random shapes tried for a genus; usually one of the first few has it.
constexpr int kTries = 80;

struct Rod {
  Vec3 a, b;
  double ra, rb;
};

double distanceTo(const Vec3& p, const Rod& r) {
  const Vec3 d = r.b - r.a;
  const double t = std::clamp(dot(p - r.a, d) / std::max(dot(d, d), 1e-12), 0.0, 1.0);
  return norm(p - r.a - t * d) - (r.ra + t * (r.rb - r.ra));
}

double blend(double a, double b, double radius) {
  const double h = std::max(radius - std::abs(a - b), 0.0) / radius;
  return std::min(a, b) - h * h * radius / 4;
}

Vec3 pointIn(double size, Random& random) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

/// A tree of rods, and one additional arc for every handle.
std::vector<Rod> randomRods(int genus, double thinnest, Random& random) {
  const int nodes = 3 + genus / 2 + random.below(3);
  std::vector<Vec3> at;
  std::vector<double> radius;
  for (int n = 0; n < nodes; ++n) {
    at.push_back(pointIn(0.7, random));
    radius.push_back(random.between(std::max(0.09, thinnest), 0.22 / (1 + 0.12 * genus)));
  }
  std::vector<Rod> rods;
  for (int n = 1; n < nodes; ++n) {
    const auto to = static_cast<std::size_t>(random.below(n)), from = static_cast<std::size_t>(n);
    rods.push_back({at[from], at[to], radius[from], radius[to]});
  }
  for (int g = 0; g < genus; ++g) {
    const auto i = static_cast<std::size_t>(random.below(nodes));
    const auto j = (i + 1 + static_cast<std::size_t>(random.below(nodes - 1))) %
                   static_cast<std::size_t>(nodes);
    const double thin = thinnest * random.between(1.0, 2.0);
    const Vec3 over = pointIn(0.85, random);
    rods.push_back({at[i], over, thin, thin});
    rods.push_back({over, at[j], thin, thin});
  }
  return rods;
}

/// The mesh without the triangles that touch a ball, renumbered.
MeshData withoutBall(const MeshData& whole, const Vec3& centre, double radius) {
  MeshData mesh;
  std::vector<int> image(whole.positions.size(), -1);
  for (const auto& t : whole.triangles) {
    if (std::any_of(t.begin(), t.end(), [&](int v) {
          return norm(whole.positions[static_cast<std::size_t>(v)] - centre) < radius;
        }))
      continue;
    std::array<int, 3> kept{};
    for (std::size_t i = 0; i < 3; ++i) {
      int& v = image[static_cast<std::size_t>(t[i])];
      if (v < 0) {
        v = static_cast<int>(mesh.positions.size());
        mesh.positions.push_back(whole.positions[static_cast<std::size_t>(t[i])]);
      }
      kept[i] = v;
    }
    mesh.triangles.push_back(kept);
  }
  return mesh;
}

/// The genus of a connected surface; empty if it is not one.
std::optional<int> genusOf(const MeshData& data) {
  const auto mesh = buildTriMesh(data);
  if (!mesh) return {};
  const Topology topology = computeTopology(*mesh);
  if (topology.componentCount != 1) return {};
  return topology.genus;
}

MeshData cutHoles(MeshData mesh, int holes, Random& random) {
  for (int tries = 0; holes > 0 && tries < 60; ++tries) {
    const auto centre =
        static_cast<std::size_t>(random.below(static_cast<int>(mesh.positions.size())));
    MeshData cut = withoutBall(mesh, mesh.positions[centre], random.between(0.04, 0.3));
    if (cut.triangles.size() < mesh.triangles.size() / 2 || !genusOf(cut)) continue;
    mesh = std::move(cut);
    --holes;
  }
  return mesh;
}

}  // namespace

MeshData randomSurface(const std::string& name, int genus, int holes) {
  Random random(name);
  MeshData nearest;
  int distance = 1 << 20;
  for (int tries = 0; tries < kTries && distance > 0; ++tries) {
    const int cells = 18 + random.below(30 + 2 * genus);
    const std::vector<Rod> rods = randomRods(genus, 1.3 * 2.1 / cells, random);
    const Field field = [&](const Vec3& p) {
      double nearestRod = 1e30;
      for (const Rod& r : rods) nearestRod = blend(nearestRod, distanceTo(p, r), 0.06);
      return nearestRod;
    };
    MeshData mesh = surfaceOf(field, 1.05, cells);
    const std::optional<int> found = genusOf(mesh);
    if (!found || mesh.triangles.size() < 400 || std::abs(*found - genus) >= distance) continue;
    distance = std::abs(*found - genus);
    nearest = std::move(mesh);
  }
  return cutHoles(std::move(nearest), holes, random);
}

}  // namespace hgp::stress
