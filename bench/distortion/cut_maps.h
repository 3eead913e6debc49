// The unknowns of an existing map.  Role: other methods start from our map, on our cut, with our
// unknowns or with one unknown per copy of a vertex.
#pragma once

#include "hgp/improve/face_terms.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::bench {

/// One complex unknown per copy: the two sides of a seam are independent.
ReducedUnknowns freeUnknowns(const CutMesh& cut);

/// x with copies · x = uv, by least squares. @param gap  receives the largest deviation of a copy
Eigen::VectorXcd unknownsOf(const ReducedUnknowns& unknowns, const UvMap& map, double& gap);

/// The scale of a map at which its symmetric Dirichlet energy relative to the surface is minimal.
double dirichletScale(const FaceTerms& terms, const Eigen::VectorXcd& free);

/// Two copies far apart on the surface, for maps in which two points must be fixed.
std::pair<int, int> farApart(const TriMesh& mesh, const CutMesh& cut);

}  // namespace hgp::bench
