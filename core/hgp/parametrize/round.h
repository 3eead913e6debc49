// What one round of a run did, from its program and its verdict.  Role: the report of both loops, strategy/ and along/.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "hgp/parametrize/parametrization.h"
#include "hgp/socp/problem.h"

namespace hgp {

/// @param program  a ProgramResult or StraightResult
/// @param hard     number of triangles with hard frame constraints
template <class Program>
Round roundOf(std::string method, std::size_t hard, const Program& program,
              const Certificate& certificate, double seconds) {
  Round round;
  round.method = std::move(method);
  round.constrainedTriangles = static_cast<int>(hard);
  round.iterations = program.iterations;
  round.solverStatus = socp::statusName(program.status);
  round.flipped = certificate.orientation.zero + certificate.orientation.negative;
  round.wrongAngles = static_cast<int>(certificate.angles.wrong.size());
  for (const MeasuredTurning& t : certificate.angles.turnings) round.wrongAngles += t.isWrong;
  round.laplacianEnergy = program.laplacianEnergy;
  round.multiplyAdds = program.multiplyAdds;
  round.seconds = seconds;
  return round;
}

}  // namespace hgp
