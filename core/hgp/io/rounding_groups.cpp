#include "hgp/io/rounding_groups.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "hgp/base/disjoint_sets.h"

namespace hgp::io {
namespace {

std::vector<int> numbered(DisjointSets& sets, std::size_t size, int& count) {
  std::vector<int> group(size, -1), number(size, -1);
  count = 0;
  for (std::size_t t = 0; t < size; ++t) {
    int& n = number[static_cast<std::size_t>(sets.root(static_cast<int>(t)))];
    if (n < 0) n = count++;
    group[t] = n;
  }
  return group;
}

/// Joins triangles that share a uv.
void joinByUv(const UvMap& map, const std::vector<int>* partOf, DisjointSets& sets) {
  std::vector<int> firstOf(map.uv.size(), -1);
  for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
    if (partOf && (*partOf)[t] < 0) continue;
    for (const int c : map.cornerUv[t]) {
      if (c < 0) continue;
      int& first = firstOf[static_cast<std::size_t>(c)];
      if (first < 0) first = static_cast<int>(t);
      sets.join(first, static_cast<int>(t));
    }
  }
}

void joinByEdges(const MeshData& mesh, DisjointSets& sets) {
  std::vector<std::pair<std::uint64_t, int>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      edges.emplace_back(static_cast<std::uint64_t>(static_cast<std::uint32_t>(low)) << 32 |
                             static_cast<std::uint32_t>(high),
                         static_cast<int>(t));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].first == edges[i - 1].first) sets.join(edges[i].second, edges[i - 1].second);
  }
}

void joinByPart(const std::vector<int>& partOf, DisjointSets& sets) {
  std::vector<int> firstOf;
  for (std::size_t t = 0; t < partOf.size(); ++t) {
    if (partOf[t] < 0) continue;
    const auto part = static_cast<std::size_t>(partOf[t]);
    if (firstOf.size() <= part) firstOf.resize(part + 1, -1);
    if (firstOf[part] < 0) firstOf[part] = static_cast<int>(t);
    sets.join(firstOf[part], static_cast<int>(t));
  }
}

/// The triangles without a part, with the uv that no part has.
RoundingGroup leftOvers(const MeshData& mesh, const UvMap& map, const std::vector<int>& partOf,
                        std::vector<int>& local) {
  RoundingGroup out;
  out.isFollowing = true;
  for (std::size_t t = 0; t < partOf.size(); ++t) {
    if (partOf[t] >= 0) continue;
    std::array<int, 3> corners = map.cornerUv[t];
    for (int& c : corners) c = c >= 0 && local[static_cast<std::size_t>(c)] < 0 ? c : -1;
    out.mesh.triangles.push_back(mesh.triangles[t]);
    out.map.cornerUv.push_back(corners);
  }
  for (auto& corners : out.map.cornerUv)
    for (int& c : corners) {
      if (c < 0) continue;
      int& n = local[static_cast<std::size_t>(c)];
      if (n < 0) {
        n = static_cast<int>(out.map.uv.size());
        out.map.uv.push_back(map.uv[static_cast<std::size_t>(c)]);
        out.uvOrigin.push_back(c);
      }
      c = n;
    }
  return out;
}

}  // namespace

std::vector<RoundingGroup> roundingGroups(const MeshData& mesh, const UvMap& map,
                                          const std::vector<int>& partOf) {
  DisjointSets sets(static_cast<int>(mesh.triangles.size()));
  joinByUv(map, partOf.empty() ? nullptr : &partOf, sets);
  if (partOf.empty()) {
    joinByEdges(mesh, sets);
  } else {
    joinByPart(partOf, sets);
  }
  int count = 0;
  const std::vector<int> group = numbered(sets, mesh.triangles.size(), count);
  std::vector<RoundingGroup> groups(static_cast<std::size_t>(count));
  std::vector<int> local(map.uv.size(), -1);  // one array suffices: a uv belongs to one group
  for (std::size_t t = 0; t < group.size(); ++t) {
    if (!partOf.empty() && partOf[t] < 0) continue;
    RoundingGroup& g = groups[static_cast<std::size_t>(group[t])];
    g.mesh.triangles.push_back(mesh.triangles[t]);
    std::array<int, 3> corners = map.cornerUv[t];
    for (int& c : corners) {
      if (c < 0) continue;
      int& n = local[static_cast<std::size_t>(c)];
      if (n < 0) {
        n = static_cast<int>(g.map.uv.size());
        g.map.uv.push_back(map.uv[static_cast<std::size_t>(c)]);
        g.uvOrigin.push_back(c);
      }
      c = n;
    }
    g.map.cornerUv.push_back(corners);
  }
  if (!partOf.empty()) groups.push_back(leftOvers(mesh, map, partOf, local));
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const RoundingGroup& g) { return g.uvOrigin.empty(); }),
               groups.end());
  return groups;
}

}  // namespace hgp::io
