// A cross field along features, with its indices.  Role: chooses cones and the corners of features; frames and seam
// rotations of a map whose feature edges are straight.
#pragma once

#include "hgp/base/result.h"
#include "hgp/features/sectors.h"
#include "hgp/field/field_context.h"
#include "hgp/field/frame_field.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp {

/// Indices that are prescribed; 0 where they are free. Both are empty, or neither.
struct GivenIndices {
  std::vector<int> node;  ///< per Sectors::node
  PerVertex<int> around;  ///< Σ a over the sectors of a vertex on Γ where several are free
};

/// A field of order 4 in which every feature halfedge follows direction `axis` of its face. All integers agree:
///
///   a_s π/2 = Σ α − Σ ω + δ_last − δ_first,   k_v π/2 = Σ α − Σ ω,
///
/// α the corner angles of the sector s or around the vertex v, ω the turn of the field across the edges between them
/// (counterclockwise), δ_h = axis·π/2 − (angle of h in its face − angle of the face).
struct AlignedField {
  Sectors sectors;
  FrameField field;
  PerHalfedge<int> axis;  ///< of feature halfedges, any integer
  PerHalfedge<double>
      turn;  ///< ω across h from its face, with its multiple of 2π; 0 on the boundary
  PerHalfedge<double> tilt;  ///< δ, with its multiple of 2π; 0 off features
  std::vector<int> index;    ///< per Sectors::node: k of a vertex off Γ, a of a sector
  GivenIndices given;
  std::vector<ConePoint> corners;  ///< that are prescribed
  int moved = 0;                   ///< units of index that were moved to make all of them possible
  bool isFitted = true;            ///< false after moveUnit(), until fitField()
};

/// The largest index that the triangles of a node can hold: two quarter turns for each, one where the triangle has a right
/// angle between two feature edges elsewhere, all less than that.
int largestIndex(const TriMesh& mesh, const Sectors& sectors, int node);

/// Indices that `asked` prescribes; none where it has neither cones nor corners. With either, every inner vertex is a cone of
/// `asked` or has k = 4, and a loop with corners has no others; loops without are free.
GivenIndices givenIndices(const TriMesh& mesh, const Topology& topology, const Sectors& sectors,
                          const HolonomySpec& asked);
/// GivenIndices::around
inline int givenAround(const AlignedField& aligned, VertexId v) {
  return aligned.given.around.size() == 0 ? 0 : aligned.given.around[v];
}

/// Whether the field has the indices that are prescribed.
bool hasGivenIndices(const TriMesh& mesh, const AlignedField& aligned);

/// Σ a over the sectors of a vertex on Γ.
int indexAround(const TriMesh& mesh, const AlignedField& aligned, VertexId v);

/// What the field prescribes: cones at inner vertices (Σ a on Γ), turning Σ(2 − a) of the loops, handles, features;
/// the prescribed corners.
/// @param handles  context.handles.loops
CompleteSpec specOf(const TriMesh& mesh, const Topology& topology,
                    const std::vector<DualLoop>& handles, const AlignedField& aligned,
                    const std::vector<EdgeId>& features);

}  // namespace hgp
