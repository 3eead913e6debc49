// Ids of vertices and faces at three levels, and the maps between them: the surface as in the file; the mesh of a model
// (welded, repaired, without faces that are left out); its connected components.  Role: ids of different levels are
// different types and cannot be confused.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "hgp/base/ids.h"

namespace hgp::api {

/// Ids of the surface as in the file, `Model::source()`. Corner 3f + k is corner k of triangle f.
using SurfaceVertexId = Id<struct SurfaceVertexTag>;
using SurfaceFaceId = Id<struct SurfaceFaceTag>;
using SurfaceCornerId = Id<struct SurfaceCornerTag>;
/// A boundary loop, numbered over all components in the order of `Model::topology`.
using SurfaceLoopId = Id<struct SurfaceLoopTag>;

/// Ids of `Model::mesh`. The ids of a component are VertexId, FaceId, HalfedgeId and LoopId.
using MeshVertexId = Id<struct MeshVertexTag>;
using MeshFaceId = Id<struct MeshFaceTag>;
using MeshCornerId = Id<struct MeshCornerTag>;

/// Maps every id of one level to an id of another level or to none, and none to none.
template <class From, class To>
class IdMap {
 public:
  IdMap() = default;
  explicit IdMap(std::vector<int> to) : to_(std::move(to)) {}
  static IdMap identity(std::size_t count) {
    std::vector<int> ids(count);
    std::iota(ids.begin(), ids.end(), 0);
    return IdMap(std::move(ids));
  }

  To operator[](From id) const { return id.isValid() ? To{to_[at(id.i)]} : To{}; }
  int size() const { return static_cast<int>(to_.size()); }
  bool has(From id) const { return id.isValid() && id.i < size(); }
  const std::vector<int>& raw() const { return to_; }

  /// Composition: this map, then `next`.
  template <class Last>
  IdMap<From, Last> then(const IdMap<To, Last>& next) const {
    std::vector<int> ids;
    ids.reserve(to_.size());
    for (int i : to_) ids.push_back(next[To{i}].i);
    return IdMap<From, Last>(std::move(ids));
  }

 private:
  std::vector<int> to_;
};

}  // namespace hgp::api
