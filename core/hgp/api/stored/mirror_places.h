// The places of a symmetric map.  Role: one side is rounded, and the other gets its mirrored numbers.
#pragma once

#include "hgp/grid/snap.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/reflection.h"

namespace hgp::api {

/// Of one component with a mirror: which of its uv are those of one side, and which are their images.
class MirrorPlaces {
 public:
  /// @pre `map` is symmetric; both sides share their uv along u = const in the plane
  MirrorPlaces(const TriMesh& mesh, const Mirror& mirror, const UvMap& map);

  /// Rounds one side, see SeamSnapper; nothing if it has no lattice.
  std::optional<SeamSnapper> snapper(const CompleteSpec& spec, const std::vector<Vec2>& uv) const;
  /// The uv of one side.
  std::vector<Vec2> sideOf(const std::vector<Vec2>& uv) const;
  /// Moves a side that was rounded to steps of 2^exponent by such steps, so that the plane is as near to where it was in
  /// `before` as they allow: at u = 0, it stays there.
  void keepPlane(const std::vector<Vec2>& before, int exponent, std::vector<Vec2>& side) const;
  /// All uv from those of one side, by u ↦ 2a − u where the plane is u = a.
  void spread(const std::vector<Vec2>& side, std::vector<Vec2>& uv) const;

 private:
  const TriMesh* mesh_;
  HalfSurface half_;
  std::vector<std::array<int, 3>> cornerUv_;  ///< of the half, indices into its own uv
  std::vector<int> index_;                    ///< uv of the half → uv
  std::vector<int> image_;                    ///< uv of the half → uv of the image
  int axis_ = -1;                             ///< uv of the half on u = a
};

}  // namespace hgp::api
