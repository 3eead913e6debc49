// Straightens steps of features whose lengths contradict each other.  Role: lengths are a second contradiction, beside
// indices: a step at one end of a band whose other end is straight has length 0.
#pragma once

#include <optional>

#include "hgp/features/aligned_field.h"

namespace hgp {

/// A run of feature edges, seen from one side, between a corner of index 1 and one of index 3 or more.
struct FeatureStep {
  std::vector<HalfedgeId> run;  ///< consecutive, in the direction of the halfedges
  int units = 0;  ///< 1: the unit moves from the tail of the run to its head; −1: back
};

/// The whole run of feature edges through h, seen from its side, whose inner corners all have index 2; a long or closed one
/// ends anywhere.
std::vector<HalfedgeId> straightRun(const TriMesh& mesh, const AlignedField& field, HalfedgeId h);

/// Steps that contain one of the given edges, the shortest first. Both sides of each edge are looked at.
std::vector<FeatureStep> findSteps(const TriMesh& mesh, const Geometry& geometry,
                                   const AlignedField& field, const std::vector<HalfedgeId>& edges);

/// The field without this step: one unit of index moves along the run from one corner to the other, so that the line goes
/// straight on. The vertices at both ends become cones (3 and 5 quarter turns) where they were none.
AlignedField withoutStep(const TriMesh& mesh, AlignedField field, const FeatureStep& step);

}  // namespace hgp
