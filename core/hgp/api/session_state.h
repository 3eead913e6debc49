// What a session holds.  Role: shared by the sources of Session and by nothing else.
#pragma once

#include "hgp/api/json_text.h"
#include "hgp/api/session.h"

namespace hgp::api {

struct Session::State {
  std::optional<Model> model;
  struct Solved {
    StoredMap stored;
    io::Prescription prescription;
    std::string certificate, report, cones;
    std::vector<double> uv;
    std::vector<std::uint32_t> cornerToUv;
    std::vector<SeamEdge> seams;
  };
  std::optional<Solved> solved;
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  Status take(Result<Model> loaded);
  Result<Request> requestFor(const std::optional<io::Prescription>& prescription, int q) const;
  Status solve(const std::optional<io::Prescription>& prescription, const SolveOptions& options);
  Result<Parametrization> solveComponent(std::size_t p, const ComponentRequest& request,
                                         const SolveOptions& options) const;
  void flatten(Solved& result) const;
  Result<CompleteSpec> completeAutomatically(const ModelComponent& component,
                                             const SolveOptions& options) const;
};

Failure notLoaded();
Status requireComponents(const std::optional<Model>& model);

}  // namespace hgp::api
