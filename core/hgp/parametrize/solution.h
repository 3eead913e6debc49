// What the strategy ends with, before it is laid out and verified.  Role: the one value that everything
// after the solve takes and returns: improve → align to the grid → improve with the integers held.
#pragma once

#include "hgp/optimize/frames.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

/// A seamless map as its reduced unknowns. Whatever x is, seams are exact; positions of the copies are
/// z = setup->unknowns.copies · x.
struct Solution {
  std::shared_ptr<const SeamlessSetup> setup;
  Eigen::VectorXcd x;   ///< setup->unknowns.count
  PerVertex<double> u;  ///< log scale that the last program was weighted with
  Frames frames;        ///< its hard constraints
};

/// A solution with its map and certificate.
struct MappedSolution {
  Solution solution;
  UvMap map;
  Certificate certificate;
};

/// Does what options.improve asks for. The improved map replaces the one before when it is certified,
/// not less usable, and better in what was asked; otherwise everything stays as it was. Fills
/// result.improvement and a stage time. Fails with kCancelled only.
/// @pre mapped.certificate.isCertified, options.improve
Status improveSolution(const TriMesh& mesh, const ParametrizeOptions& options,
                       MappedSolution& mapped, Parametrization& result);

/// A map whose only fault is that its areas span more than its number type holds: descends isometrically, which
/// raises the smallest ones, and keeps what is then certified. Fails with kCancelled only.
Status evenOut(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
               Parametrization& result);

/// Does what options.grid asks for: the map aligned where that keeps it certified, else as it was, with the
/// reason in result.grid. Where an improvement is asked for as well, what alignment gave back of it is gained
/// once more with the integers held (result.improvement->onGrid): translations and, in quad mode, cones stay
/// exactly where they are. Fails with kCancelled only.
/// @pre mapped.certificate.isCertified, options.grid.isAsked()
Status alignSolution(const TriMesh& mesh, const ParametrizeOptions& options, MappedSolution& mapped,
                     Parametrization& result);

/// Its positions, scaled to the surface's area and centred at the origin.
UvMap layOut(const TriMesh& mesh, const Solution& solution);

}  // namespace hgp
