// Results of a session other than JSON.  Role: types of session.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hgp/io/written.h"

namespace hgp::api {

/// A seam edge of the result: its two sides as uv indices, corresponding ends first, and r ∈ Z_q.
struct SeamEdge {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
  int r = 0;
};

/// The surface after welds and repairs, with its own vertex ids.
struct Repaired {
  std::vector<std::uint32_t> triangles;  ///< × 3
  std::vector<int> vertexOrigin;         ///< vertex → a vertex of the surface
  std::vector<int> vertexImage;          ///< vertex of the surface → vertex, −1 when removed
};

/// Facts on the surface as it is solved (welded, repaired), per vertex or triangle of the file.
struct SurfaceFacts {
  /// The vertex that a vertex was joined with, or itself; −1 when removed.
  std::vector<int> representative;
  std::vector<double> angle;           ///< Θ_v, the sum of the triangle angles, radians
  std::vector<std::uint32_t> valence;  ///< triangles at the vertex; the maximum where it was split
  std::vector<std::uint8_t>
      isBoundary;              ///< where it was split: 1 only if all copies are on the boundary
  std::vector<int> component;  ///< connected component, −1 without triangles
  std::vector<int> triangleComponent;  ///< of every triangle, −1 when left out
  /// Neighbours of v: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1].
  std::vector<std::uint32_t> neighbourStart, neighbours;
  double area = 0;  ///< of all triangles, in the square of the file's unit
};

/// Measurements of a result per stored triangle and per seam edge.
struct MapMeasures {
  std::vector<float> stretch;  ///< ratio of the singular values ≥ 1; 1 preserves angles
  std::vector<float> logArea;  ///< log₂ of uv area per area, minus that of all triangles together
  std::vector<int> notPositive;  ///< triangles of the certificate, oriented as they were verified
  double surfaceArea = 0, uvArea = 0;
  long long overlapPairs = 0;  ///< triangles that share area of the plane and no uv: allowed
  std::vector<int> overlapping;
  bool areMorePairs = false;             ///< counting stopped: there are more pairs
  std::vector<std::uint32_t> seamChain;  ///< the seam that each seam edge belongs to (seamChains)
};

/// What the numbers of boundary loops (--turning) and handle generators (--handle) mean.
struct SurfaceLoops {
  std::vector<std::vector<int>> boundaries;  ///< vertices in order, the surface on their left
  /// Edges that each generator crosses, in order: a closed walk over triangles.
  std::vector<std::vector<std::array<int, 2>>> handles;
};

/// A quad mesh as a file, and what is in it.
struct QuadFile {
  io::Bytes bytes;
  int vertices = 0, quads = 0;
  int clipped = 0;   ///< cells that a boundary cuts: left out
  int halvings = 0;  ///< how often cells were cut into four so that no two edges have the same ends
  int multipleEdges = 0;  ///< pairs of vertices that more than one edge of uncut cells joins
  int foldedQuads = 0;    ///< at cones of k = 1: their only quad has two of its edges in common
};

/// The files of write(), and whether the certificate holds for the numbers in them: glTF stores float32, OBJ float64.
struct WrittenMap : io::Written {
  bool isCertified = false;
};

}  // namespace hgp::api
