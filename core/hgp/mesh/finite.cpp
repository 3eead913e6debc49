#include "hgp/mesh/finite.h"

namespace hgp {

std::vector<int> unusedNotFinite(const MeshData& data) {
  std::vector<char> isFound(data.positions.size(), 0);
  for (std::size_t v = 0; v < data.positions.size(); ++v) isFound[v] = !isFinite(data.positions[v]);
  for (const auto& t : data.triangles)
    for (int v : t)
      if (v >= 0 && static_cast<std::size_t>(v) < isFound.size())
        isFound[static_cast<std::size_t>(v)] = 0;
  std::vector<int> found;
  for (std::size_t v = 0; v < isFound.size(); ++v)
    if (isFound[v]) found.push_back(static_cast<int>(v));
  return found;
}

}  // namespace hgp
