#include "hgp/parametrize/after/own_cones.h"

#include <map>

#include "hgp/verify/certificate.h"

namespace hgp {

CompleteSpec ownPrescription(const CompleteSpec& asked, const Certificate& certificate) {
  std::map<VertexId, int> k;
  for (const ConePoint& cone : asked.cones) k[cone.vertex] = cone.k;
  for (const MeasuredCone& cone : certificate.angles.wrong) k[cone.vertex] = cone.measured;
  CompleteSpec own = asked;
  own.cones.clear();
  for (const auto& [vertex, of] : k)
    if (of != asked.q) own.cones.push_back({vertex, of});
  for (const MeasuredTurning& turning : certificate.angles.turnings)
    own.turning[static_cast<std::size_t>(turning.loop.i)] = turning.measured;
  return own;
}

void keepOwnCones(const TriMesh& mesh, MappedSolution& mapped, Parametrization& result) {
  const Certificate& before = mapped.certificate;
  if (before.isCertified || !before.isMeasured || !before.orientation.notPositive.empty()) return;
  const std::size_t wrong = before.angles.wrong.size();
  auto setup = std::make_shared<SeamlessSetup>(*mapped.solution.setup);
  setup->field.spec = ownPrescription(setup->field.spec, before);
  Certificate own = Verifier(mesh).certify(toSpec(setup->field.spec), mapped.map);
  if (!own.isCertified) return;
  setup->cones.clear();
  for (const ConePoint& cone : setup->field.spec.cones) setup->cones.push_back(cone.vertex);
  result.spec = setup->field.spec;
  result.notes.push_back(Note("map-own-cones", {{"vertices", wrong}}));
  mapped.certificate = std::move(own);
  mapped.solution.setup = std::move(setup);
}

}  // namespace hgp
