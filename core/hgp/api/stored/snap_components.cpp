#include "hgp/api/stored/snap_components.h"

#include <algorithm>

namespace hgp::api {

ComponentSnapper::ComponentSnapper(const Model& model, const std::vector<ComponentMap>& components)
    : components_(components) {
  for (std::size_t p = 0; p < components.size(); ++p) {
    mirrors_.emplace_back();
    if (components[p].mirror)
      mirrors_.back() = std::make_unique<MirrorPlaces>(model.components[p].mesh,
                                                       *components[p].mirror, components[p].map);
    if (!components[p].certificate.isCertified) {  // rounding must not hide its faults
      snappers_.emplace_back();
      continue;
    }
    if (components[p].mirror) {
      snappers_.push_back(mirrors_.back()->snapper(components[p].spec, components[p].map.uv));
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
    std::vector<Vec2> part(begin, begin + count);
    std::vector<Vec2> side = mirrors_[p] ? mirrors_[p]->sideOf(part) : part;
    if (snappers_[p]) {
      // Rounded copies may exceed the largest exact number: a second attempt uses a coarser grid.
      for (int exponent = snappers_[p]->firstExponent(part, numbers), last = exponent + 1;
           exponent <= last; ++exponent) {
        std::optional<SnappedMap> snapped = snappers_[p]->snap(side, exponent, numbers);
        if (!snapped) continue;
        if (mirrors_[p]) mirrors_[p]->keepPlane(side, exponent, snapped->uv);
        side = std::move(snapped->uv);
        break;
      }
    }
    if (mirrors_[p])
      mirrors_[p]->spread(side, part);
    else
      part = std::move(side);
    std::copy(part.begin(), part.end(), begin);
  }
}

}  // namespace hgp::api
