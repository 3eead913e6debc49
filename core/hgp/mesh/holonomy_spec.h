// The prescription of a map: q, cones, turning of boundaries, rotations along handles.
// Role: q, C, k_i and l_j of [BCW17 §5.2], checked against Lemma 6.2 before anything is solved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/base/stable_order.h"
#include "hgp/mesh/angle_shortage.h"

namespace hgp {

class AngleShortageMemo;

/// A cone of angle 2πk/q at an interior vertex.
struct ConePoint {
  VertexId vertex;
  int k = 0;
};
/// By vertex, ascending.
inline void sortCones(std::vector<ConePoint>& cones) {
  sortStably(cones, [](const ConePoint& a, const ConePoint& b) { return a.vertex < b.vertex; });
}

/// The prescription for one connected surface. Turnings and handles that are empty are completed from the smoothest
/// field with these cones (prescribedField).
struct HolonomySpec {
  int q = 4;
  std::vector<ConePoint> cones;
  std::vector<std::optional<int>>
      turning;  ///< l_j per loop of Topology::loops; turning angle 2πl/q
  /// Per dual loop of handleGenerators, r in Z_q: the sum over the crossed halfedges of the seam
  /// rotation r_h, where the edge's uv vector seen from the face entered is e^{i2πr_h/q} times the
  /// one seen from the face left.
  std::vector<std::optional<int>> handles;
  /// Edges that the map must send to lines u = const or v = const, exactly (module features); ascending.
  std::vector<EdgeId> features = {};
  /// Along features: boundary vertices where the map has an interior angle of 2πk/q. The other vertices of a loop that
  /// has one are straight.
  std::vector<ConePoint> corners = {};
};

/// A prescription in which every number is given.
struct CompleteSpec {
  int q = 4;
  std::vector<ConePoint> cones;  ///< ascending by vertex, no k = q entries
  std::vector<int> turning;
  std::vector<int> handles;  ///< r ∈ {0, …, q − 1}
  std::vector<EdgeId> features = {};
  std::vector<ConePoint> corners = {};  ///< those that were asked for
};

HolonomySpec toSpec(const CompleteSpec& spec);

/// 1 ≤ q ≤ kLargestOrder.
inline constexpr int kLargestOrder = 64;
/// Cones whose triangles need more than this angle each on average, in radians, get a warning.
inline constexpr double kPoorCornerAngle = 2.0;

/// Turning indices that are possible with positive triangles: lowest ≤ l ≤ highest. With n boundary vertices
/// and t_v triangles at v:  q/2·Σ(1 − t_v) < l < q·n/2.
struct TurningRange {
  long long lowest = 0, highest = 0;
};
TurningRange turningRange(const TriMesh& mesh, const BoundaryLoop& loop, int q);

/// Both sides of Lemma 6.2 in integers.
struct BudgetReport {
  long long have = 0;  ///< q|C| − Σk + Σl over the loops with given l
  long long need = 0;  ///< q(2 − 2g − m)
  int openLoops = 0;   ///< loops whose turning is not given
  Notes warnings;      ///< prescriptions that are known to fail; kPoorCornerAngle
  /// No map on this mesh has these angles (findAngleShortage); `warnings` has the note.
  bool isTooCoarse = false;
};

/// Whether cones, corners, turnings and handles are there, and within the bounds that positive triangles imply.
Status checkBounds(const TriMesh& mesh, const Topology& topology, const HolonomySpec& spec);

/// Gauss–Bonnet and admissibility in exact integers [BCW17 Lemma 6.2]:
///     q|C| − Σ k_i + Σ l_j = q(2 − 2g − m).
/// Fails with kPrescription and the measured numbers when no map can have this prescription.
/// @pre one component
Result<BudgetReport> checkSums(const TriMesh& mesh, const Topology& topology,
                               const HolonomySpec& spec);

/// checkSums(), with what too few triangles make impossible or unlikely as warnings.
/// @param shortages  of this mesh: finds the answer of an earlier call with the same angles
Result<BudgetReport> checkPrescription(const TriMesh& mesh, const Topology& topology,
                                       const HolonomySpec& spec,
                                       AngleShortageMemo* shortages = nullptr);

/// The sentence that proves the angles and turnings that `spec` gives impossible on this mesh (findAnyAngleShortage).
/// @pre checkPrescription(mesh, topology, spec) succeeds
std::optional<Note> proveImpossible(const TriMesh& mesh, const Topology& topology,
                                    const HolonomySpec& spec, const NearAngles& nearAngles = {});

}  // namespace hgp
