// A map on an integer lattice, walked along grid lines.  Role: exact predicates for quads.cpp.
#pragma once

#include <optional>

#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// A point or vector of the plane in steps of one power of two.
struct LatticePoint {
  std::int64_t u = 0, v = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// z ↦ i^turn z + shift, from the plane of one face to that of its neighbour.
struct Crossing {
  int turn = 0;
  LatticePoint shift;
};

/// i^turn p.
LatticePoint turned(const LatticePoint& p, int turn);

/// The corners of all faces as lattice points and the crossings between faces.
class LatticeMap {
 public:
  /// Fails with kUnsupported where coordinates are no multiples of one power of two within 2⁵⁵ steps,
  /// a triangle is not positive, or sides of an edge are not related by i^r z + t with integer t.
  static Result<LatticeMap> make(const TriMesh& mesh, const UvMap& map);

  const TriMesh& mesh() const { return *mesh_; }
  std::int64_t unit() const { return unit_; }  ///< steps in one cell
  const LatticePoint& corner(HalfedgeId h) const { return corner_[h]; }
  const Crossing& crossing(HalfedgeId h) const { return crossing_[h]; }

  bool isWhole(const LatticePoint& p) const { return p.u % unit_ == 0 && p.v % unit_ == 0; }
  /// Sign of the halfedge's side that p lies on: 1 left (inside), 0 on its line, −1 right.
  int side(HalfedgeId h, const LatticePoint& p) const;
  /// d (0 to 3, quarter turns from the u axis) as a vector of one cell.
  LatticePoint step(int d) const;
  /// The direction across h of direction d in face(h).
  int directionAcross(HalfedgeId h, int d) const { return (d + crossing_[h].turn) & 3; }
  LatticePoint across(HalfedgeId h, const LatticePoint& p) const;

 private:
  const TriMesh* mesh_ = nullptr;
  std::int64_t unit_ = 1;
  PerHalfedge<LatticePoint> corner_;
  PerHalfedge<Crossing> crossing_;
};

/// Sign of a × b.
int crossSign(const LatticePoint& a, const LatticePoint& b);
int dotSign(const LatticePoint& a, const LatticePoint& b);

}  // namespace hgp
