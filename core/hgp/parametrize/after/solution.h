// The result of the loop, and the steps after it: improve → align to the grid → improve with the integers held.
// Role: all these steps take and return the same type.
#pragma once

#include "hgp/features/real_unknowns.h"
#include "hgp/optimize/frames.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

/// A seamless map given by its reduced unknowns x: z = setup->unknowns.copies · x satisfies all seam conditions for
/// every x.
struct Solution {
  std::shared_ptr<const SeamlessSetup> setup;
  Eigen::VectorXcd x;   ///< setup->unknowns.count
  PerVertex<double> u;  ///< log scale that the last program was weighted with
  Frames frames;        ///< its hard constraints
  /// Along features: the parts of x that are unknowns of their own. The others follow from them, and x need not have them.
  const RealUnknowns* real = nullptr;
};

/// z of every copy. Along features, the bits of their common coordinates are equal.
std::vector<Complex> placesOf(const Solution& solution);

/// A solution with its map and certificate.
struct MappedSolution {
  Solution solution;
  UvMap map;
  Certificate certificate;
};

/// Lowers the distortion as options.improve asks. The improved map replaces `mapped` if it is certified,
/// not less usable, and better by the requested measure. Fills
/// result.improvement and a stage time. Fails with kCancelled only.
/// @pre mapped.certificate.isCertified, options.improve
Status improveSolution(const TriMesh& mesh, const ParametrizeOptions& options,
                       MappedSolution& mapped, Parametrization& result);

/// For a map whose only fault is that its number type cannot resolve the range of its areas: minimises isometric
/// distortion, which enlarges the smallest areas, and keeps the result if it is certified. Fails with kCancelled only.
Status evenOut(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
               Parametrization& result);

/// What alignSolution may spend on this result, multiply-adds: 1.5 times the cost of the map so far.
double alignmentMultiplyAdds(const TriMesh& mesh, const Parametrization& result);

/// Aligns the map as options.grid asks. If no aligned map is certified, `mapped` does not change and result.grid has
/// the reason. If an improvement is asked for as well, the distortion that alignment added is lowered
/// with the integers held (result.improvement->onGrid): translations and, in quad mode, cones stay
/// exactly where they are. Fails with kCancelled only.
/// @pre mapped.certificate.isCertified, options.grid.isAsked()
Status alignSolution(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
                     Parametrization& result);

/// Lowers the distortion of an aligned map, with what is held staying exactly where it is. Fills result.improvement->onGrid.
/// Fails with kCancelled only.
/// @param isHeld        by unknown of the setup or, along features, by real unknown
/// @param multiplyAdds  that may be spent
/// @pre result.improvement, result.grid
Status improveOnGrid(const TriMesh& mesh, const ParametrizeOptions& options,
                     const std::vector<char>& isHeld, double multiplyAdds, MappedSolution& mapped,
                     Parametrization& result);

/// Its positions, scaled to the surface's area and centred at the origin.
UvMap layOut(const TriMesh& mesh, const Solution& solution);

}  // namespace hgp
