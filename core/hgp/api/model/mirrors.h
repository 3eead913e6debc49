// Planes across which a whole file is symmetric.  Role: mesh/reflection.h for all components of a model.
#pragma once

#include <memory>
#include <vector>

#include "hgp/api/model/model.h"
#include "hgp/mesh/reflection.h"

namespace hgp::api {

/// Where a model is no mirror image of itself.
struct NoMirror {
  int component = -1;  ///< the first without an image
  int matched = 0;     ///< its triangles that have one
  FaceId without;      ///< one that has none
};

struct ModelMirror {
  MirrorPlane plane;
  double distance = 0.0;        ///< of a vertex's image from its mirrored place, at most
  int inPlane = 0, across = 0;  ///< edges
  std::vector<int> image;       ///< component → component
  std::vector<std::shared_ptr<const Mirror>> own;  ///< of components that are their own images
  NoMirror missing;                                ///< component −1: every one has an image
};

/// The components' images across the plane, up to the first that has none.
ModelMirror mirrorAcross(const Model& model, const MirrorPlane& plane);
/// All planes of likelyPlanes() across which every component has an image.
std::vector<ModelMirror> findMirrors(const Model& model);
/// "X = 0.25"; "(0.6, 0.8, 0) · p = 0.25"
std::string planeText(const MirrorPlane& plane);

}  // namespace hgp::api
