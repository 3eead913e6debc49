// The maps of all components rounded together so that seams hold exactly in the stored numbers.
// Role: grid/snap for what a file holds.
#pragma once

#include <vector>

#include "hgp/api/stored_map.h"
#include "hgp/grid/snap.h"

namespace hgp::api {

class ComponentSnapper {
 public:
  /// Keeps references to both.
  ComponentSnapper(const Model& model, const std::vector<ComponentMap>& components);

  /// Rounds uv of all components, one after another, each on a grid of its own. A component whose q
  /// has no exact rotations (3, 5, 6, …), or that was left out, stays as it is.
  void snap(const StoredNumbers& numbers, std::vector<Vec2>& uv) const;

  /// This component does not survive being rounded: it stays as it is from now on.
  void leave(std::size_t component) { snappers_[component].reset(); }

 private:
  const std::vector<ComponentMap>& components_;
  std::vector<std::optional<SeamSnapper>> snappers_;
};

}  // namespace hgp::api
