// The state of a session.  Role: shared by the sources of Session and by nothing else.
#pragma once

#include "hgp/api/json/json_text.h"
#include "hgp/api/session.h"
#include "hgp/api/session/kept_runs.h"
#include "hgp/field/prepared_surface.h"

namespace hgp::api {

struct SplitModel;

struct Session::State {
  std::optional<OpenedFile> file;  ///< of the model, if it was read from one
  std::optional<Model> model;
  std::vector<std::unique_ptr<PreparedSurface>> prepared;  ///< per component, made on first use
  struct Solved {
    bool isAligned = false;                ///< every component is aligned to a grid
    SolveOptions options;                  ///< of the run, without its progress
    std::vector<ComponentMap> components;  ///< prescriptions and results, without the maps
    StoredMap stored;
    prescription::Prescription prescription;
    std::string report, cones;
    std::vector<double> uv;
    std::vector<std::uint32_t> cornerToUv;
    std::vector<SeamEdge> seams;
  };
  std::shared_ptr<Solved> solved;  ///< complete when published, and then shared with StoredResults
  std::string certificate;         ///< of `solved`, taken from its report when it is asked for
  std::string hash;                ///< see surfaceHash()
  KeptRuns<std::shared_ptr<Solved>> runs;  ///< of this surface, not on refined ones
  double stepShare = 1.0;                  ///< fraction of a run's limit of steps
  std::shared_ptr<State> finer;  ///< the refined surface, if the map is on that; shared likewise
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  /// The state that has the result and is written: the refined surface if there is one.
  const State& shown() const { return finer ? *finer : *this; }

  Status take(Result<Model> loaded);
  /// SHA-256 of the loaded surface as it is solved and stored; computed on first use.
  const std::string& surfaceHash();
  void clearResult();
  /// solve(), or the kept result of an earlier call with the same arguments.
  Status solveOrFind(const std::optional<prescription::Prescription>& prescription,
                     const SolveOptions& options);
  Status solve(const std::optional<prescription::Prescription>& prescription,
               const SolveOptions& options);
  /// The same options, with automaticCells where choosesCells asks for them.
  SolveOptions withCells(const Request& request, SolveOptions options);
  int conesAlong(const Request& request);
  /// With choosesCells: if the map is not aligned and a number of cells is known to work, solves with that and the same
  /// cones; replaces `solved` and `run` if the map is then aligned.
  Status solveWithWorkingCells(const SolveOptions& options, RunRecord& run);
  /// Solves every component and verifies it as stored: sets all of `solved` except its report.
  Status solveRequest(const Request& request, const SolveOptions& options, RunRecord& run);
  /// Stores one map per component and verifies what is stored: sets all of `solved` except its report.
  void storeMaps(std::vector<ComponentMap> maps, int q, const SolveOptions& options,
                 bool areAligned, RunRecord& run);
  /// Solves again with an improvement where maps were certified, but not in the numbers of the format; replaces
  /// `solved` and `run` if that helps.
  Status solveImproved(const Request& request, const SolveOptions& options, RunRecord& run);
  /// Where a component has no map: solves on refined meshes, each finer than the last, until one has a map; sets
  /// `finer`, or adds a note to `run` about the attempts.
  Status solveRefined(const Request& request, const SolveOptions& options, RunRecord& run);
  /// solveRequest() along features. Where these leave a component no room, or the map is not certified, solves on surfaces
  /// with split edges, each finer than the last; sets `finer`, or adds a note to `run` about the attempts.
  Status solveSplit(const Request& request, const SolveOptions& options, RunRecord& run);
  Result<std::shared_ptr<State>> solveOn(SplitModel& made, const SolveOptions& options,
                                         RunRecord& run);
  std::vector<std::optional<FrameField>> fieldsOfGivenHandles(const Request& request,
                                                              const RunRecord& run);
  void publish(const RunRecord& run);
  /// For files that cannot be refined: solves on the surface converted to polygons, set as `finer`.
  Status solveAsPolygons(const std::optional<prescription::Prescription>& prescription,
                         const SolveOptions& options);
  Result<Parametrization> solveComponent(std::size_t p, const ComponentRequest& request,
                                         const SolveOptions& options);
  Result<Parametrization> solveAutomatic(std::size_t p, SolveOptions choice,
                                         ParametrizeOptions core);
  Result<Parametrization> solveAlong(std::size_t p, const ComponentRequest& request,
                                     const ParametrizeOptions& options);
  /// The map of a component that is the image of another, from the other's.
  Result<Parametrization> solveImage(std::size_t p, const ComponentRequest& request,
                                     const ComponentMap& first, const Parametrization& run);
  Result<Parametrization> solveOnGrid(std::size_t p, const ComponentRequest& request,
                                      const SolveOptions& shared, RunRecord& run);
  void flatten(Solved& result) const;
  double tilesOfGrid(const WriteOptions& options) const;
  /// The original with the map as a uv set.
  Result<WrittenMap> writeOriginal(const WriteOptions& options) const;
  /// Whether the result is on a mesh with split edges and `format`, that of the file, is one in which these are stored as a
  /// mesh alone.
  bool writesSplitMesh(std::string_view format) const;
  /// The mesh alone in another format, with the map snapped to the numbers of that format and verified again.
  Result<WrittenMap> writeMesh(const WriteOptions& options) const;
  /// Automatic cones of component p as a complete spec. @param times  if given, the stages' times are appended
  Result<CompleteSpec> chooseCones(std::size_t p, const SolveOptions& options,
                                   std::vector<StageTime>* times = nullptr);
  PreparedSurface& surfaceOf(std::size_t p);
  void dropLarge(std::size_t p);
};

struct StoredResult::Data {
  std::string surface;  ///< surfaceHash() of the surface it belongs to
  std::shared_ptr<Session::State::Solved> solved;
  std::shared_ptr<Session::State> finer;
};

/// The extension of a file name, in lower case and without the dot.
std::string extensionOf(const std::string& name);

/// The options of a format's writer; `format` and `cones` are the caller's.
io::WriteOptions ioOptions(const WriteOptions& options);

Failure notLoaded();
Status requireComponents(const std::optional<Model>& model);
Status checkSums(const Model& model, const Request& request);

}  // namespace hgp::api
