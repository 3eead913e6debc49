#include "hgp/api/stored/component_map.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"

namespace hgp::api {

double gridStep(const UvMap& map) {
  // A format that stores 1 − v rounds that value too.
  double largest = 0;
  for (const auto& corners : map.cornerUv)
    for (int i : corners) {
      if (i < 0 || i >= static_cast<int>(map.uv.size())) continue;
      const Vec2& p = map.uv[static_cast<std::size_t>(i)];
      largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(1 - p[1])});
    }
  return largest > 0 && std::isfinite(largest) ? std::scalbn(1.0, std::ilogb(largest) - 23) : 0;
}

int overlapCells(const UvMap& map) {
  int size = 32;
  while (size < 512 && static_cast<std::size_t>(size) * static_cast<std::size_t>(size) <
                           256 * map.cornerUv.size()) {
    size *= 2;
  }
  return size;
}

std::vector<int> componentOfTriangle(const Model& model) {
  std::vector<int> out(model.source().mesh.triangles.size(), -1);
  for (std::size_t p = 0; p < model.components.size(); ++p)
    for (const int f : model.components[p].face.raw()) out[at(f)] = static_cast<int>(p);
  return out;
}

namespace {

/// Up to this many uv of the surface per uv corner of a component, a table of all is faster than sorting.
constexpr std::size_t kTableShare = 8;

/// The indices below `count` that corners use, ascending.
std::vector<int> usedIndices(const UvMap& map, int count) {
  std::vector<int> used;
  const auto visit = [&](const auto& take) {
    for (const auto& corners : map.cornerUv)
      for (const int i : corners)
        if (i >= 0 && i < count) take(i);
  };
  if (at(count) > kTableShare * 3 * map.cornerUv.size()) {
    used.reserve(3 * map.cornerUv.size());
    visit([&](int i) { used.push_back(i); });
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
  }
  std::vector<char> isUsed(at(count), 0);
  visit([&](int i) { isUsed[at(i)] = 1; });
  for (int i = 0; i < count; ++i)
    if (isUsed[at(i)] != 0) used.push_back(i);
  return used;
}

/// Copies to `map` the uv that its corners use, with new indices, so that the cost of a component does not
/// depend on the others.
void takeUsed(const std::vector<Vec2>& uv, UvMap& map) {
  const int count = static_cast<int>(uv.size());
  const std::vector<int> used = usedIndices(map, count);
  const bool isAll = at(count) == used.size();
  for (auto& corners : map.cornerUv)
    for (int& i : corners) {
      if (i < 0 || i >= count) {
        i = -1;
      } else if (!isAll) {
        i = static_cast<int>(std::lower_bound(used.begin(), used.end(), i) - used.begin());
      }
    }
  map.uv.reserve(used.size());
  for (int i : used) map.uv.push_back(uv[at(i)]);
}

}  // namespace

UvMap mapOfComponent(const ModelComponent& component, const UvMap& surfaceMap) {
  UvMap out;
  out.cornerUv.resize(at(component.mesh.faceCount()));
  for (int c = 0; c < component.corner.size(); ++c) {
    const SurfaceCornerId from = component.corner[HalfedgeId{c}];
    out.cornerUv[at(c / 3)][at(c % 3)] = surfaceMap.cornerUv[at(from.i / 3)][at(from.i % 3)];
  }
  takeUsed(surfaceMap.uv, out);
  return out;
}

}  // namespace hgp::api
