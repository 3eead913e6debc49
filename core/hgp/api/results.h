// Results of a session that are not JSON.  Role: return types of session.h, plain values that any thread
// may copy and read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hgp/api/map_facts.h"
#include "hgp/base/result.h"
#include "hgp/io/written.h"
#include "hgp/prescription/prescription.h"

namespace hgp::api {

/// The surface after welds and repairs, with its own vertex ids.
struct Repaired {
  std::vector<std::uint32_t> triangles;  ///< × 3
  std::vector<int> vertexOrigin;         ///< vertex → a vertex of the surface
  std::vector<int> vertexImage;          ///< vertex of the surface → vertex, −1 if removed
};

/// The triangles that a certificate is about, oriented as verified, with their uv. `origin` maps each to the triangle of
/// the surface it comes from; triangles that are left out (no area, copies of others) are not among them.
struct SolvedTriangles {
  std::vector<std::uint32_t> triangles;   ///< × 3, vertices of the surface
  std::vector<std::uint32_t> cornerToUv;  ///< × 3
  std::vector<std::uint32_t> origin;      ///< ascending
};

/// Facts on the surface as it is solved (welded, repaired), per vertex or triangle of the file.
struct SurfaceFacts {
  /// The vertex with which a vertex was joined, or itself; −1 if removed.
  std::vector<int> representative;
  std::vector<double> angle;             ///< Θ_v, the sum of the triangle angles, radians
  std::vector<std::uint32_t> valence;    ///< triangles at the vertex; if split, the maximum
  std::vector<std::uint8_t> isBoundary;  ///< if split: 1 only if all copies are on the boundary
  std::vector<int> component;            ///< connected component, −1 without triangles
  std::vector<int> triangleComponent;    ///< of every triangle, −1 if left out
  /// Neighbours of v: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1].
  std::vector<std::uint32_t> neighbourStart, neighbours;
  double area = 0;  ///< total area of the triangles, in the file's unit squared
};

/// Measurements of a result per stored triangle and per seam edge.
struct MapMeasures {
  std::vector<float> stretch;    ///< ratio of the singular values ≥ 1; 1 preserves angles
  std::vector<float> logArea;    ///< log₂ of uv area per area, as in the component's distortion
  std::vector<int> notPositive;  ///< triangles without positive uv area, oriented as verified
  double surfaceArea = 0, uvArea = 0;
  long long overlapPairs = 0;  ///< triangles that overlap in the plane and share no uv: allowed
  std::vector<int> overlapping;
  bool areMorePairs = false;             ///< counting stopped early: there are more pairs
  std::vector<std::uint32_t> seamChain;  ///< by seam edge, the seam it belongs to (chainsOfEdges)
};

/// The boundary loops and handle generators to which the numbers of --turning and --handle refer.
struct SurfaceLoops {
  std::vector<std::vector<int>> boundaries;  ///< vertices in order, the surface on their left
  /// Edges that each generator crosses, in order: a closed walk over triangles.
  std::vector<std::vector<std::array<int, 2>>> handles;
};

/// The features that a prescription means on a surface, rims included, as a file of a name: `.json` (hgp-cones with
/// positions and without cones), `.sharp`, `.obj` (l lines), otherwise rows of two vertices; and their numbers.
struct FeatureList {
  std::string text;
  int creaseEdges = 0, rimEdges = 0;
  int chains = 0;  ///< runs between ends and crossings (countRuns)
  Notes notes;
};

/// Cones that Session::transfer() has moved; `json` as hgp-cones.
struct MovedCones {
  prescription::Prescription cones;
  std::string json;
  Notes lost;  ///< what has no place
};

/// Cones that Session::suggest() has chosen, as hgp-cones.
struct SuggestedCones {
  std::string json;
  Notes notes;  ///< where their number is another than the one asked for
};

/// A result that stays usable while its session computes others: see Session::use(). Cheap to copy.
class StoredResult {
  friend class Session;
  struct Data;
  std::shared_ptr<const Data> data_;  ///< null: no result
};

/// Whether Session::quads() writes files of this name: .obj, .ply, .glb, or none.
Status canWriteQuads(const std::string& name);

/// A quad mesh as a file, and its counts.
struct QuadFile {
  io::Bytes bytes;
  int vertices = 0, quads = 0;
  int clipped = 0;        ///< cells that the boundary cuts; they are left out
  int multipleEdges = 0;  ///< pairs of vertices joined by several edges in the grid as it is
  int cuts = 0;           ///< lines added along strips of quads, which remove them
  int replaced = 0;       ///< edges replaced by a vertex of three edges, which removes them, too
  int halvings = 0;  ///< how often all cells were divided into four, where no strips remove them
  int foldedInSpace =
      0;                ///< quads of which a corner is turned over: too large for the surface there
  int foldedQuads = 0;  ///< at cones with k = 1, whose only quad is joined to itself
  int acrossSeams =
      0;        ///< quads across seams of the input's uv, or across borders of its materials
  Notes notes;  ///< on these, and on what of the input the format does not keep
};

/// The files of write(), and whether the map is certified as stored in them: glTF stores float32, OBJ float64.
struct WrittenMap : io::Written {
  bool isCertified = false;
};

}  // namespace hgp::api
