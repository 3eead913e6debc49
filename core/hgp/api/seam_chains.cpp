#include "hgp/api/seam_chains.h"

#include <algorithm>
#include <unordered_map>

#include "hgp/base/disjoint_sets.h"

namespace hgp::api {

std::vector<std::uint32_t> seamChains(const std::vector<SeamEdge>& seams,
                                      const std::vector<std::uint32_t>& uvToVertex, int q) {
  const auto turn = [q](const SeamEdge& s) { return std::min(s.r, (q - s.r) % q); };
  std::unordered_map<std::uint32_t, std::vector<int>> around;
  for (std::size_t i = 0; i < seams.size(); ++i)
    for (const int end : seams[i].a)
      around[uvToVertex[static_cast<std::size_t>(end)]].push_back(static_cast<int>(i));
  DisjointSets chains(static_cast<int>(seams.size()));
  for (const auto& [vertex, edges] : around) {
    if (edges.size() != 2) continue;  // a branch or an end of the seam graph
    const auto &a = seams[static_cast<std::size_t>(edges[0])],
               &b = seams[static_cast<std::size_t>(edges[1])];
    if (turn(a) == turn(b)) chains.join(edges[0], edges[1]);
  }
  std::vector<std::uint32_t> out(seams.size());
  std::vector<int> number(seams.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < seams.size(); ++i) {
    int& own = number[static_cast<std::size_t>(chains.root(static_cast<int>(i)))];
    if (own < 0) own = count++;
    out[i] = static_cast<std::uint32_t>(own);
  }
  return out;
}

}  // namespace hgp::api
