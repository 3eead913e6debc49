#include "hgp/mesh/defects.h"

namespace hgp {

FixResult fixDefects(const MeshData& data, const FixOptions&) {
  FixResult result;
  result.mesh = data;
  for (std::size_t f = 0; f < data.triangles.size(); ++f)
    result.faceOrigin.push_back(static_cast<int>(f));
  for (std::size_t v = 0; v < data.positions.size(); ++v)
    result.vertexOrigin.push_back(static_cast<int>(v));
  return result;
}

}  // namespace hgp
