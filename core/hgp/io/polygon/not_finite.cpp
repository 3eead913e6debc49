#include "hgp/io/polygon/not_finite.h"

#include "hgp/base/check.h"
#include "hgp/text/text.h"

namespace hgp::io {

std::optional<NotFiniteVertex> firstUsed(const std::vector<NotFiniteVertex>& vertices,
                                         const PolygonMesh& polygons) {
  if (vertices.empty()) return std::nullopt;
  if (polygons.polygonCount() == 0) return vertices.front();
  std::vector<char> isUsed(polygons.positions.size(), 0);
  for (const int v : polygons.cornerVertex) isUsed[static_cast<std::size_t>(v)] = 1;
  for (const NotFiniteVertex& one : vertices)
    if (isUsed[static_cast<std::size_t>(one.vertex)]) return one;
  return std::nullopt;
}

Failure notFiniteFailure(std::int64_t line, int vertex) {
  return text::malformedLine(
      line, formatText("vertex %d has no finite position, and a face uses it", vertex));
}

}  // namespace hgp::io
