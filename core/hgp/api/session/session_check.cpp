// Whether a prescription adds up, before anything is solved.
#include <algorithm>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/api/session/split_model.h"
#include "hgp/parametrize/along/along_features.h"

namespace hgp::api {
namespace {

/// The budget with what a search from all vertices proves.
BudgetReport provedOrNot(const ModelComponent& component, const HolonomySpec& spec,
                         BudgetReport budget) {
  if (budget.isTooCoarse) return budget;
  const std::optional<Note> proof = proveImpossible(component.mesh, component.topology, spec);
  budget.isTooCoarse = proof.has_value();
  if (proof) budget.warnings.insert(budget.warnings.begin(), *proof);
  return budget;
}

/// Why components have no field along their features, with edges split as a run splits them.
Result<std::vector<std::optional<Failure>>> refusedAlong(const Model& model,
                                                         const Request& request) {
  std::vector<std::optional<Failure>> refused(model.components.size());
  std::vector<char> isOpen(model.components.size(), 0);
  for (std::size_t p = 0; p < isOpen.size(); ++p)
    isOpen[p] = request.components[p].spec.features.empty() ? 0 : 1;
  for (const Splits splits : kAllSplits) {
    if (std::find(isOpen.begin(), isOpen.end(), 1) == isOpen.end()) break;
    SplitModel split(model, request);
    const Status done = split.split(splits, isOpen);
    if (!done && splits == Splits::kCrowded) return done.error();
    if (!done || (splits != Splits::kCrowded && isTooLargeToSplit(*split.model))) break;
    for (std::size_t p = 0; p < isOpen.size(); ++p) {
      if (!isOpen[p]) continue;
      const ModelComponent& component = split.model->components[p];
      PreparedSurface surface(component.mesh);
      const Status possible = checkAlongFeatures(surface, split.request->components[p].spec);
      if (possible) {
        isOpen[p] = 0;
        refused[p].reset();
      } else if (splits == Splits::kCrowded) {
        refused[p] = toSurfaceIds(*split.model, component, possible.error());
      }
    }
  }
  return refused;
}

}  // namespace

Status checkSums(const Model& model, const Request& request) {
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const ComponentRequest& asked = request.components[p];
    const HolonomySpec& spec = asked.spec;
    // Corners are compared with their patches, and mirrored cones with their images, before they are added up.
    if (spec.cones.empty() || !spec.corners.empty() || asked.mirror) continue;
    const ModelComponent& component = model.components[p];
    const Result<BudgetReport> budget = hgp::checkSums(component.mesh, component.topology, spec);
    if (!budget) return toSurfaceIds(model, component, budget.error());
  }
  return Done{};
}

Result<Verdict> Session::check(const prescription::Prescription& prescription) const {
  return guarded([&]() -> Result<Verdict> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    const Model& model = *state_->model;
    Result<Request> request = resolve(model, prescription);
    if (!request) return Verdict{false, checkText(request.error()), request.error()};
    Result<std::vector<std::optional<Failure>>> refused = refusedAlong(model, *request);
    if (!refused) return Verdict{false, checkText(refused.error()), refused.error()};
    std::vector<ComponentCheck> checks;
    std::optional<Failure> reason;
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      const ComponentRequest& component = request->components[p];
      ComponentCheck check;
      check.isAutomatic =
          component.isAutomatic && component.spec.cones.empty() && component.spec.corners.empty();
      if (!component.spec.features.empty()) {
        check.refusal = std::move((*refused)[p]);
      } else if (!component.isAutomatic) {
        Result<BudgetReport> budget = checkPrescription(
            model.components[p].mesh, model.components[p].topology, component.spec);
        if (budget)
          check.budget = provedOrNot(model.components[p], component.spec, std::move(*budget));
        else
          check.refusal = toSurfaceIds(model, model.components[p], budget.error());
      }
      if (check.refusal && !reason) reason = check.refusal;
      checks.push_back(std::move(check));
    }
    return Verdict{!reason, checkText(model, *request, checks), reason};
  });
}

}  // namespace hgp::api
