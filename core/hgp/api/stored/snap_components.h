// Rounds the maps of all components so that seams hold exactly in the stored numbers.
// Role: applies grid/snap.h to the components of a file.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "hgp/api/stored/mirror_places.h"
#include "hgp/api/stored/stored_map.h"

namespace hgp::api {

class ComponentSnapper {
 public:
  /// Keeps references to both.
  ComponentSnapper(const Model& model, const std::vector<ComponentMap>& components);

  /// Rounds the uv of all components in order, each on its own grid; of a symmetric one, one side, of which the other is the
  /// image; of a pair, the first. A component stays unchanged if its q has no lattice (5, 7, 8, …) or if it was left out.
  void snap(const StoredNumbers& numbers, std::vector<Vec2>& uv) const;

  /// Excludes a component that rounding breaks: snap() does not round it any more.
  void leave(std::size_t component) { snappers_[component].reset(); }

 private:
  bool isSecond(std::size_t p) const {
    return components_[p].mirror && components_[p].mirror->of >= 0;
  }
  /// Rounds one component, and its image with it (may be empty).
  void snapOne(std::size_t p, const StoredNumbers& numbers, std::span<Vec2> part,
               std::span<Vec2> image) const;

  const std::vector<ComponentMap>& components_;
  std::vector<std::optional<SeamSnapper>> snappers_;
  std::vector<std::unique_ptr<MirrorPlaces>>
      mirrors_;  ///< of symmetric ones; snappers refer to them
};

}  // namespace hgp::api
