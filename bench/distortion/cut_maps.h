// The unknowns of a map that is already there.  Role: comparators start from our map, on our cut, with our
// unknowns or with one per copy of a vertex.
#pragma once

#include "hgp/improve/face_terms.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::bench {

/// One complex unknown per copy: nothing holds the two sides of a seam together.
ReducedUnknowns freeUnknowns(const CutMesh& cut);

/// x with copies · x = uv, by least squares; the largest gap of a copy in `gap`.
Eigen::VectorXcd unknownsOf(const ReducedUnknowns& unknowns, const UvMap& map, double& gap);

/// Scale of a map at which its symmetric Dirichlet energy against the surface is least.
double dirichletScale(const FaceTerms& terms, const Eigen::VectorXcd& free);

/// Two copies far apart on the surface, for maps that need two points held.
std::pair<int, int> farApart(const TriMesh& mesh, const CutMesh& cut);

}  // namespace hgp::bench
