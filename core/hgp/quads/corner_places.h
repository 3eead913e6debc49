// Where the corners of quads lie on the triangles of the surface.  Role: what attributes of the surface are read by.
#pragma once

#include <array>
#include <vector>

#include "hgp/quads/quad_mesh.h"

namespace hgp {

/// The point Σ weight[k] · corner k of a face; weights are ≥ 0 and have the sum 1.
struct CornerPlace {
  FaceId face;
  std::array<double, 3> weight{};
};
using QuadPlaces = std::vector<std::array<CornerPlace, 4>>;

/// Per quad and corner a face that holds the corner's point. Where that lies on an edge or a vertex of the surface, of its
/// faces the one on the side of the quad, that is, into which the way to the quad's centre leads; on an edge its weights are
/// the same bits in both faces, at a vertex exactly 1.
QuadPlaces cornerPlaces(const TriMesh& mesh, const QuadMesh& quads);

/// Per quad: whether some side of it crosses the edges of `isSeam`, that is, every way from one end's face to the other's
/// over faces near the side does.
std::vector<char> crossesSeams(const TriMesh& mesh, const QuadMesh& quads, const QuadPlaces& places,
                               const PerEdge<char>& isSeam);

}  // namespace hgp
