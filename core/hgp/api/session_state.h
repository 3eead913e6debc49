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
    Scale scale = Scale::kSolved;
    std::vector<ComponentMap> components;  ///< what was asked and became of it, without the maps
    StoredMap stored;
    io::Prescription prescription;
    std::string certificate, report, cones;
    std::vector<double> uv;
    std::vector<std::uint32_t> cornerToUv;
    std::vector<SeamEdge> seams;
  };
  std::optional<Solved> solved;
  std::string keptAs;  ///< empty: `solved` goes when the next is made
  struct Kept {
    std::string name, surface;  ///< surfaceHash() of what it is a result of
    std::size_t size = 0;       ///< triangles
    Solved result;
  };
  std::vector<Kept> aside;       ///< of this surface and of others; the newest last
  std::string hash;              ///< see surfaceHash()
  double workShare = 1.0;        ///< of what a run may spend
  std::unique_ptr<State> finer;  ///< the refined surface, where only that has the map
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  /// What a result is of, and what is written.
  const State& shown() const { return finer ? *finer : *this; }

  Status take(Result<Model> loaded);
  /// Of the loaded surface as it is solved and stored; computed when first asked for.
  const std::string& surfaceHash();
  /// There is no result any more, but perhaps in `aside`.
  void putAside();
  Status solve(const std::optional<io::Prescription>& prescription, const SolveOptions& options);
  /// Every component, verified as stored: all of `solved` but its report.
  Status solveRequest(const Request& request, const SolveOptions& options, RunRecord& run);
  /// Refined meshes, each finer than the one before, until one has a map; sets `finer`, or says in the
  /// notes of `run` what was tried.
  Status solveRefined(const Request& request, const SolveOptions& options, RunRecord& run);
  std::vector<std::optional<FrameField>> fieldsOfGivenHandles(const Request& request,
                                                              const RunRecord& run);
  void publish(const RunRecord& run);
  /// For formats that cannot be refined: everything on the surface as polygons, set as `finer`.
  Status solveAsPolygons(const std::optional<io::Prescription>& prescription,
                         const SolveOptions& options);
  Result<Parametrization> solveComponent(std::size_t p, const ComponentRequest& request,
                                         const SolveOptions& options);
  void flatten(Solved& result) const;
  double tilesOfGrid(const WriteOptions& options) const;
  /// The original with the map as a uv set.
  Result<WrittenMap> writeOriginal(const WriteOptions& options) const;
  /// The mesh on its own in another format, with the map snapped to its numbers and verified again.
  Result<WrittenMap> writeMesh(const WriteOptions& options) const;
  /// Automatic cones of component p, completed; appends the stages' times where asked.
  Result<CompleteSpec> chooseCones(std::size_t p, const SolveOptions& options,
                                   std::vector<StageTime>* times = nullptr);
  PreparedSurface& surfaceOf(std::size_t p);
  void dropLarge(std::size_t p);
};

/// Lower case, without the dot.
std::string extensionOf(const std::string& name);

Failure notLoaded();
Status requireComponents(const std::optional<Model>& model);

}  // namespace hgp::api
