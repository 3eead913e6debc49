#include "hgp/parametrize/solution.h"

namespace hgp {

bool finish(const TriMesh&, const ParametrizeOptions&, Solution&) {
  return false;  // nothing yet: improve/, grid/ and snapping are called here
}

UvMap layOut(const TriMesh& mesh, const Solution& solution) {
  const SeamlessSetup& setup = *solution.setup;
  if (solution.x.size() == 0) return layOut(mesh, setup, {});
  const Eigen::VectorXcd z = setup.unknowns.copies * solution.x;
  return layOut(mesh, setup, std::vector<Complex>(z.data(), z.data() + z.size()));
}

}  // namespace hgp
