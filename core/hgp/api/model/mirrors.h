// Planes across which a whole file is symmetric.  Role: mesh/reflection.h for all components of a model.
#pragma once

#include <memory>
#include <vector>

#include "hgp/api/model/model.h"
#include "hgp/mesh/reflection.h"

namespace hgp::api {

/// Where a model has no two sides that are mirror images of each other.
struct NoMirror {
  int component = -1;       ///< the first that is the image neither of itself nor of another
  bool isMirrored = false;  ///< it is its own image, but not hasTwoSides()
  double tolerance = 0.0;   ///< of its vertices
};

struct ModelMirror {
  MirrorPlane plane;
  double distance = 0.0;        ///< of a vertex's image from its mirrored place, at most
  int inPlane = 0, across = 0;  ///< edges
  /// Per component: the reflection onto itself, or that of a component before it; none for the first of a pair.
  std::vector<std::shared_ptr<const Mirror>> mirrors;
  NoMirror missing;  ///< component −1: none is
};

/// The components' reflections onto themselves, with two sides, and otherwise onto others, up to the first that has neither.
ModelMirror mirrorAcross(const Model& model, const MirrorPlane& plane);
/// All planes of likelyPlanes() across which no component is missing.
std::vector<ModelMirror> findMirrors(const Model& model);
/// "X = 0.25"; "(0.6, 0.8, 0) · p = 0.25"
std::string planeText(const MirrorPlane& plane);

}  // namespace hgp::api
