// What a session holds.  Role: shared by the sources of Session and by nothing else.
#pragma once

#include "hgp/api/json_text.h"
#include "hgp/api/session.h"
#include "hgp/field/prepared_surface.h"

namespace hgp::api {

struct Session::State {
  std::optional<Model> model;
  std::vector<std::unique_ptr<PreparedSurface>> prepared;  ///< per component, made when needed
  struct Solved {
    bool isAligned = false;  ///< to a grid, every component
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
  Status solve(const std::optional<io::Prescription>& prescription, const SolveOptions& options);
  Result<Parametrization> solveComponent(std::size_t p, const ComponentRequest& request,
                                         const SolveOptions& options);
  void flatten(Solved& result) const;
  /// Automatic cones of component p, completed; appends the stages' times where asked.
  Result<CompleteSpec> chooseCones(std::size_t p, const SolveOptions& options,
                                   std::vector<StageTime>* times = nullptr);
  PreparedSurface& surfaceOf(std::size_t p);
  void dropLarge(std::size_t p);
};

Failure notLoaded();
Status requireComponents(const std::optional<Model>& model);

}  // namespace hgp::api
