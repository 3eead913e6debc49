#include <algorithm>
#include <array>
#include <map>

#include "hgp/base/check.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/base/ids.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/repair/repair_steps.h"

namespace hgp {
namespace {

using Triple = std::array<int, 3>;

bool namesAVertexTwice(const Triple& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

Triple sorted(Triple t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Groups of two and more faces with the same corners.
std::vector<std::vector<int>> findCopies(const std::vector<Triple>& triangles) {
  std::vector<int> order;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (!namesAVertexTwice(triangles[f])) order.push_back(static_cast<int>(f));
  std::stable_sort(order.begin(), order.end(), [&](int f, int g) {
    return sorted(triangles[at(f)]) < sorted(triangles[at(g)]);
  });
  std::vector<std::vector<int>> groups;
  for (std::size_t n = 0; n < order.size();) {
    std::size_t end = n + 1;
    while (end < order.size() &&
           sorted(triangles[at(order[end])]) == sorted(triangles[at(order[n])]))
      ++end;
    if (end - n > 1) groups.emplace_back(order.begin() + n, order.begin() + end);
    n = end;
  }
  return groups;
}

/// For each face of the groups, the number of sides whose direction is consistent with that of the neighbour, minus the
/// number of sides whose direction is not.
std::map<int, int> fitToNeighbours(const std::vector<Triple>& triangles,
                                   const std::vector<std::vector<int>>& groups) {
  std::map<std::array<int, 2>, std::vector<int>> sidesOn;
  const auto key = [&](int side) {
    const int a = sideTail(triangles, side), b = sideTail(triangles, nextSide(side));
    return std::array<int, 2>{std::min(a, b), std::max(a, b)};
  };
  for (const auto& group : groups)
    for (int s = 3 * group[0]; s < 3 * group[0] + 3; ++s) sidesOn[key(s)];
  for (int s = 0; s < static_cast<int>(3 * triangles.size()); ++s) {
    if (namesAVertexTwice(triangles[at(s / 3)])) continue;
    if (const auto found = sidesOn.find(key(s)); found != sidesOn.end()) found->second.push_back(s);
  }
  std::map<int, int> fit;
  for (const auto& group : groups)
    for (int f : group)
      for (int s = 3 * f; s < 3 * f + 3; ++s)
        for (int other : sidesOn[key(s)]) {
          if (sorted(triangles[at(other / 3)]) == sorted(triangles[at(f)])) continue;
          fit[f] += sideTail(triangles, s) != sideTail(triangles, other) ? 1 : -1;
        }
  return fit;
}

/// 1 for the faces of components in which no face has an area.
std::vector<char> findFlatComponents(const MeshData& mesh) {
  DisjointSets sets(static_cast<int>(mesh.positions.size()));
  for (const Triple& t : mesh.triangles)
    for (int k : {1, 2}) sets.join(t[0], t[at(k)]);
  std::vector<char> hasArea(mesh.positions.size(), 0);
  for (const Triple& t : mesh.triangles) {
    char& known = hasArea[at(sets.root(t[0]))];
    if (known || namesAVertexTwice(t)) continue;
    known =
        !hasNoArea(mesh.positions[at(t[0])], mesh.positions[at(t[1])], mesh.positions[at(t[2])]);
  }
  std::vector<char> isFlat;
  for (const Triple& t : mesh.triangles) isFlat.push_back(!hasArea[at(sets.root(t[0]))]);
  return isFlat;
}

void note(FixResult& result, std::size_t count, const char* code) {
  if (count > 0) result.notes.push_back(Note(code, {{"triangles", count}}));
}

}  // namespace

void leaveOut(FixResult& result) {
  MeshData& mesh = result.mesh;
  const auto& triangles = mesh.triangles;
  const std::vector<char> isFlat = findFlatComponents(mesh);
  std::vector<char> isLeftOut(triangles.size(), 0);
  const auto leave = [&](int f, LeftOut why, int twin) {
    isLeftOut[at(f)] = 1;
    result.leftOut.push_back({result.faceOrigin[at(f)], why, twin});
  };
  std::size_t zeroArea = 0, copies = 0;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!isFlat[f] && !namesAVertexTwice(triangles[f])) continue;
    leave(static_cast<int>(f), LeftOut::kZeroArea, -1);
    ++zeroArea;
  }
  const std::vector<std::vector<int>> groups = findCopies(triangles);
  std::map<int, int> fit = fitToNeighbours(triangles, groups);
  for (const auto& group : groups) {
    if (isLeftOut[at(group[0])]) continue;  // its component has no area
    const int best = *std::max_element(group.begin(), group.end(),
                                       [&](int f, int g) { return fit[f] < fit[g]; });
    for (int f : group) {
      if (f == best) continue;
      leave(f, LeftOut::kDuplicate, result.faceOrigin[at(best)]);
      ++copies;
    }
  }
  if (result.leftOut.empty()) return;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (isLeftOut[f]) continue;
    mesh.triangles[kept] = mesh.triangles[f];
    result.faceOrigin[kept++] = result.faceOrigin[f];
  }
  mesh.triangles.resize(kept);
  result.faceOrigin.resize(kept);
  note(result, zeroArea, "repair-no-surface");
  note(result, copies, "repair-copies");
}

}  // namespace hgp
