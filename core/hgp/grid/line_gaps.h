// Distances between lines of a map that must not vanish.  Role: lines and cones that are rounded to integers keep their
// order.
#pragma once

#include <vector>

#include "hgp/cut/cut_mesh.h"
#include "hgp/features/sectors.h"
#include "hgp/features/ways.h"

namespace hgp {

/// A map with straight features by its real unknowns.
struct StraightPlane {
  const TriMesh& mesh;
  const CutMesh& cut;
  const Sectors& sectors;
  const RealUnknowns& unknowns;
  const std::vector<Complex>& z;  ///< per copy
  const PerVertex<char>& isNode;  ///< ends and corners of features
  const std::vector<VertexId>& cones;
  const std::vector<int>& index;  ///< as AlignedField::index
};

/// Σ factor · unknown, a distance along an axis; positive in the map, but perhaps where it may vanish.
struct LineGap {
  RealSum sum;
  double length = 0.0;  ///< in the map
  bool isOfCone = false;
  bool mayVanish = false;  ///< but not become negative
};

/// The direction of a feature halfedge in its face: quarter turns from the u axis.
int headingOf(const StraightPlane& plane, HalfedgeId h);

/// Between features that face each other across triangles, between consecutive nodes of one line, from cones off
/// features to the features that face them, and between cones and corners with an index above 2 (the larger of both
/// coordinates); from ends and corners of features to those that face them; and in thin triangles of three cones or
/// corners. Every sum once.
/// @param reach  longer distances are left out, but for those between nodes
std::vector<LineGap> lineGaps(const StraightPlane& plane, double reach);

}  // namespace hgp
