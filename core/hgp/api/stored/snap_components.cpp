#include "hgp/api/stored/snap_components.h"

#include <algorithm>
#include <cmath>

namespace hgp::api {

namespace {

/// (c − u, v + d) of a rounded map, near to where the image was; nothing where that is not exact.
std::optional<std::vector<Vec2>> imageOf(const std::vector<Vec2>& rounded, const Vec2& before,
                                         const Vec2& imageBefore, int exponent,
                                         const SeamSnapper& snapper, const StoredNumbers& numbers) {
  const double step = std::ldexp(1.0, exponent);
  const double c = std::nearbyint((before[0] + imageBefore[0]) / step) * step;
  const double d = std::nearbyint((imageBefore[1] - before[1]) / step) * step;
  std::vector<Vec2> image;
  image.reserve(rounded.size());
  for (const Vec2& p : rounded) image.push_back({c - p[0], p[1] + d});
  if (snapper.firstExponent(image, numbers) > exponent) return {};
  return image;
}

}  // namespace

ComponentSnapper::ComponentSnapper(const Model& model, const std::vector<ComponentMap>& components)
    : components_(components) {
  for (std::size_t p = 0; p < components.size(); ++p) {
    const ComponentMap& component = components[p];
    const TriMesh& mesh = model.components[p].mesh;
    mirrors_.emplace_back();
    if (component.mirror && !isSecond(p))
      mirrors_.back() = std::make_unique<MirrorPlaces>(mesh, *component.mirror, component.map);
    if (isSecond(p) || !component.certificate.isCertified) {  // rounding must not hide its faults
      snappers_.emplace_back();
      continue;
    }
    if (component.mirror) {
      snappers_.push_back(mirrors_.back()->snapper(component.spec, component.map.uv));
      continue;
    }
    std::vector<VertexId> cones;
    for (const ConePoint& cone : component.spec.cones) cones.push_back(cone.vertex);
    snappers_.push_back(
        SeamSnapper::make(mesh, component.map, component.spec.q, cones, component.spec.features));
  }
}

void ComponentSnapper::snapOne(std::size_t p, const StoredNumbers& numbers, std::span<Vec2> part,
                               std::span<Vec2> image) const {
  std::vector<Vec2> uv(part.begin(), part.end());
  std::vector<Vec2> side = mirrors_[p] ? mirrors_[p]->sideOf(uv) : uv;
  std::vector<Vec2> all = uv;
  all.insert(all.end(), image.begin(), image.end());
  if (snappers_[p]) {
    // Rounded copies may exceed the largest exact number: a second attempt uses a coarser grid.
    for (int exponent = snappers_[p]->firstExponent(all, numbers), last = exponent + 1;
         exponent <= last; ++exponent) {
      std::optional<SnappedMap> snapped = snappers_[p]->snap(side, exponent, numbers);
      if (!snapped) continue;
      if (!image.empty()) {
        const auto second =
            imageOf(snapped->uv, part[0], image[0], exponent, *snappers_[p], numbers);
        if (!second) continue;
        std::copy(second->begin(), second->end(), image.begin());
      }
      if (mirrors_[p]) mirrors_[p]->keepPlane(side, exponent, snapped->uv);
      side = std::move(snapped->uv);
      break;
    }
  }
  if (mirrors_[p])
    mirrors_[p]->spread(side, uv);
  else
    uv = std::move(side);
  std::copy(uv.begin(), uv.end(), part.begin());
}

void ComponentSnapper::snap(const StoredNumbers& numbers, std::vector<Vec2>& uv) const {
  std::vector<std::span<Vec2>> parts, images(components_.size());
  for (std::size_t p = 0, first = 0; p < components_.size(); ++p) {
    parts.push_back(std::span(uv).subspan(first, components_[p].map.uv.size()));
    first += parts.back().size();
    if (isSecond(p)) images[at(components_[p].mirror->of)] = parts.back();
  }
  for (std::size_t p = 0; p < components_.size(); ++p)
    if (!isSecond(p)) snapOne(p, numbers, parts[p], images[p]);
}

}  // namespace hgp::api
