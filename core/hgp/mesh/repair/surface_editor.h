// A triangle list that can be edited locally.  Role: what the degenerate-face repairs work on.
#pragma once

#include <array>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Faces by index with the faces around each vertex; removed faces keep their index until compact().
/// Works on any soup: every operation checks what it needs and refuses instead of damaging.
class SurfaceEditor {
 public:
  SurfaceEditor(MeshData mesh, std::vector<int> origins);

  const MeshData& mesh() const { return mesh_; }
  int faceCount() const { return static_cast<int>(isAlive_.size()); }
  bool isAlive(int f) const { return isAlive_[static_cast<std::size_t>(f)]; }
  const std::array<int, 3>& triangle(int f) const {
    return mesh_.triangles[static_cast<std::size_t>(f)];
  }
  int origin(int f) const { return origins_[static_cast<std::size_t>(f)]; }
  const std::vector<int>& facesAt(int v) const { return facesAt_[static_cast<std::size_t>(v)]; }
  std::vector<int> facesOn(int a, int b) const;
  /// Does face f run from a to b?
  bool hasSide(int f, int a, int b) const;
  /// The corner of f that is neither a nor b.
  int apex(int f, int a, int b) const;
  bool isFlat(int f) const;
  /// Some edge at v has one face.
  bool isBoundary(int v) const;

  void remove(int f);
  void replace(int f, const std::array<int, 3>& corners, int origin);
  /// Moves all faces of `gone` to `kept` and drops those that had both, when the surface stays a
  /// manifold there (the neighbours they share are exactly the corners opposite their edge).
  bool merge(int kept, int gone);
  /// Moves v when afterwards all its faces have area and none that had area turned by 90° or more.
  bool tryMove(int v, const Vec3& position);

  /// Faces changed since the last call that are alive and flat.
  std::vector<int> takeTouched();

  /// The alive faces, in order; vertices as they are.
  MeshData compact() const;
  std::vector<int> compactOrigins() const;
  std::vector<int> aliveFaces() const;

 private:
  std::vector<int> neighbours(int v) const;
  void detach(int f);

  MeshData mesh_;
  std::vector<int> origins_;
  std::vector<char> isAlive_;
  std::vector<std::vector<int>> facesAt_;
  std::vector<int> touched_;
};

}  // namespace hgp
