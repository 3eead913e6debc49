#include "hgp/api/stored/snap_components.h"

#include <algorithm>

namespace hgp::api {

ComponentSnapper::ComponentSnapper(const Model& model, const std::vector<ComponentMap>& components)
    : components_(components) {
  for (std::size_t p = 0; p < components.size(); ++p) {
    if (!components[p].certificate.isCertified) {  // rounding must not hide its faults
      snappers_.emplace_back();
      continue;
    }
    std::vector<VertexId> cones;
    for (const ConePoint& cone : components[p].spec.cones) cones.push_back(cone.vertex);
    snappers_.push_back(SeamSnapper::make(model.components[p].mesh, components[p].map,
                                          components[p].spec.q, cones,
                                          components[p].spec.features));
  }
}

void ComponentSnapper::snap(const StoredNumbers& numbers, std::vector<Vec2>& uv) const {
  std::ptrdiff_t first = 0;
  for (std::size_t p = 0; p < components_.size(); ++p) {
    const auto begin = uv.begin() + first;
    const auto count = static_cast<std::ptrdiff_t>(components_[p].map.uv.size());
    first += count;
    if (!snappers_[p]) continue;
    const std::vector<Vec2> part(begin, begin + count);
    // Rounded copies may exceed the largest exact number: a second attempt uses a coarser grid.
    for (int exponent = snappers_[p]->firstExponent(part, numbers), last = exponent + 1;
         exponent <= last; ++exponent) {
      const std::optional<SnappedMap> snapped = snappers_[p]->snap(part, exponent, numbers);
      if (!snapped) continue;
      std::copy(snapped->uv.begin(), snapped->uv.end(), begin);
      break;
    }
  }
}

}  // namespace hgp::api
