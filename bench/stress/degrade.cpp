#include "degrade.h"

#include <algorithm>

#include "collapse.h"
#include "hgp/mesh/tri_mesh.h"
#include "vectors.h"

namespace hgp::stress {
namespace {

using namespace hgp::models;

double meanEdge(const MeshData& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += norm(mesh.positions[static_cast<std::size_t>(t[i])] -
                  mesh.positions[static_cast<std::size_t>(t[(i + 1) % 3])]);
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

std::vector<Vec3> vertexNormals(const MeshData& mesh) {
  std::vector<Vec3> normal(mesh.positions.size(), Vec3{0, 0, 0});
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(t[i])]; };
    const Vec3 n = cross(at(1) - at(0), at(2) - at(0));
    for (int v : t) normal[static_cast<std::size_t>(v)] = normal[static_cast<std::size_t>(v)] + n;
  }
  for (Vec3& n : normal) n = norm(n) > 0 ? unit(n) : Vec3{0, 0, 1};
  return normal;
}

void addNoise(MeshData& mesh, double amount, Random& random) {
  for (Vec3& p : mesh.positions)
    p = p + amount * Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

void addSlivers(MeshData& mesh, double height, Random& random) {
  // Each triangle at most once, because a sliver of a sliver would have no area.
  const auto whole = mesh.triangles.size();
  std::vector<char> isCut(whole, 0);
  for (std::size_t n = 0; n < std::min<std::size_t>(100, whole); ++n) {
    const auto f = static_cast<std::size_t>(random.below(static_cast<int>(whole)));
    if (isCut[f]) continue;
    isCut[f] = 1;
    const auto t = mesh.triangles[f];
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(t[i])]; };
    const double along = random.between(0.3, 0.7);
    const int v = static_cast<int>(mesh.positions.size());
    mesh.positions.push_back((1 - height) * ((1 - along) * at(0) + along * at(1)) + height * at(2));
    mesh.triangles[f] = {t[0], t[1], v};
    mesh.triangles.push_back({t[1], t[2], v});
    mesh.triangles.push_back({t[2], t[0], v});
  }
}

void addSpikes(MeshData& mesh, double length, Random& random) {
  const std::vector<Vec3> normal = vertexNormals(mesh);
  for (int n = 0; n < 10; ++n) {
    const auto v = static_cast<std::size_t>(random.below(static_cast<int>(mesh.positions.size())));
    mesh.positions[v] = mesh.positions[v] + length * normal[v];
  }
}

/// Moves boundary vertices away from their neighbours, within the surface's plane there.
bool addNeedles(MeshData& mesh, double length, Random& random) {
  const auto surface = buildTriMesh(mesh);
  if (!surface) return false;
  std::vector<VertexId> rim;
  for (VertexId v : surface->vertices())
    if (surface->isBoundary(v)) rim.push_back(v);
  if (rim.empty()) return false;
  for (int n = 0; n < 10; ++n) {
    const VertexId v = rim[static_cast<std::size_t>(random.below(static_cast<int>(rim.size())))];
    Vec3 inward{0, 0, 0};
    for (HalfedgeId h : outgoingHalfedges(*surface, v))
      inward = inward + (surface->position(surface->head(h)) - surface->position(v));
    if (norm(inward) == 0) continue;
    Vec3& p = mesh.positions[static_cast<std::size_t>(v.i)];
    p = p - length * unit(inward);
  }
  return true;
}

}  // namespace

const std::vector<Harm>& harms() {
  static const std::vector<Harm> kHarms = {
      {"noise", 0.01},     {"noise", 0.05},      {"noise", 0.2},       {"noise", 0.5},
      {"anisotropy", 10},  {"anisotropy", 100},  {"anisotropy", 1000}, {"decimation", 0.5},
      {"decimation", 0.2}, {"decimation", 0.05}, {"slivers", 1e-3},    {"slivers", 1e-6},
      {"slivers", 1e-9},   {"slivers", 1e-12},   {"spikes", 5},        {"spikes", 50},
      {"spikes", 1000},    {"needles", 5},       {"needles", 100},     {"needles", 10000}};
  return kHarms;
}

std::optional<MeshData> degraded(const MeshData& whole, const Harm& harm, Random& random) {
  MeshData mesh = whole;
  const double edge = meanEdge(mesh);
  if (harm.kind == "noise") addNoise(mesh, harm.level * edge, random);
  if (harm.kind == "slivers") addSlivers(mesh, harm.level, random);
  if (harm.kind == "spikes") addSpikes(mesh, harm.level * edge, random);
  if (harm.kind == "needles" && !addNeedles(mesh, harm.level * edge, random)) return {};
  if (harm.kind == "anisotropy")
    for (Vec3& p : mesh.positions) p[0] *= harm.level;
  if (harm.kind == "decimation")
    mesh = decimated(
        mesh, static_cast<int>(harm.level * static_cast<double>(mesh.triangles.size())), random);
  return mesh;
}

}  // namespace hgp::stress
