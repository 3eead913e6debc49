// A session: loads a file, parametrizes it, verifies the map and writes it.  Role: the API boundary. Command line,
// WebAssembly bindings and benchmarks call only this; every exception of the core becomes a Failure here.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hgp/api/options.h"
#include "hgp/api/read_prescription.h"
#include "hgp/api/results.h"
#include "hgp/io/document.h"

namespace hgp::api {

/// Ids are those of the loaded surface before any repair: the file's own or, for glTF and STL, those after vertices at
/// equal positions were joined. JSON texts follow docs/schema.
/// One thread at a time may use a session, in const methods as well: they keep what they compute. Different
/// sessions are independent.
class Session {
 public:
  Session();
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// On failure the previous model and result are kept.
  Status load(io::FileSet files, const LoadOptions& options);
  /// Loads a mesh that is not in a file; write() then produces an OBJ.
  Status loadArrays(std::vector<Vec3> positions, std::vector<std::array<int, 3>> triangles,
                    const LoadOptions& options);

  /// Number of meshes with triangles in the file; LoadOptions::surface, and then choose() without reading, take one.
  int surfaceCount() const;
  Status choose(int surface);
  Result<Verdict> inspect() const;  ///< hgp-inspect; isGood: the mesh can be parametrized
  /// hgp-check: whether the prescription satisfies Lemma 6.2 on every component, in integers; solves nothing.
  Result<Verdict> check(const prescription::Prescription& prescription) const;
  Result<SuggestedCones> suggest(const SolveOptions& options) const;  ///< automatic cones
  /// Any prescription on this surface as complete hgp-cones with positions; a field becomes cones and rotations.
  Result<std::string> convert(const prescription::Prescription& prescription) const;
  Result<FeatureList> features(const prescription::Prescription& p, const std::string& name) const;
  /// Stored in the file, if any are.
  Result<std::optional<prescription::Prescription>> embeddedCones() const;
  /// hgp-cones with these cones and those that Gauss–Bonnet misses, where they cause the least distortion (balanceCones).
  Result<std::string> balance(const prescription::Prescription& prescription) const;
  /// The cones of `from`, another reading or version of this surface, on this one: by number where both have the same
  /// vertices and triangles, otherwise by exact position. What has no place is left out, with a note.
  Result<MovedCones> transfer(const prescription::Prescription& prescription,
                              const Session& from) const;

  /// Solves, then verifies the map as it will be stored. Without a prescription, cones are automatic. Also succeeds if
  /// the map is not certified; fails for contradictory options, impossible prescriptions, limits and cancellation.
  /// With the arguments of one of the last calls on this surface, its result is returned, with its report.
  Status parametrize(const std::optional<prescription::Prescription>& prescription,
                     const SolveOptions& options);
  /// Verifies the uv in the file: hgp-certificate. Without a prescription any cones are accepted.
  Result<Verdict> verify(const std::optional<prescription::Prescription>& prescription,
                         const VerifyOptions& options) const;

  /// The current result, for use() after others were computed; in memory as long as a StoredResult refers to it.
  StoredResult result() const;
  /// Makes a result the current one, which is written, measured and shown. False if it is of another surface; it may come
  /// from another session with an identical surface, so that the maps of several meshes can be written into one file.
  bool use(const StoredResult& result);
  bool hasResult() const;
  bool isCertified() const;
  const std::string& certificateJson() const;  ///< of the result: hgp-certificate
  const std::string& reportJson() const;       ///< hgp-report; contains the certificate
  const std::string& conesJson() const;        ///< the completed prescription: hgp-cones

  const std::vector<double>& positions() const;  ///< |V| × 3 of the surface, or the refined one
  const std::vector<std::uint32_t>& triangles() const;   ///< |F| × 3
  std::optional<Repaired> repaired() const;              ///< empty if the surface is used unchanged
  SolvedTriangles solvedTriangles() const;               ///< of the result; empty without one
  const std::vector<double>& uv() const;                 ///< |uv| × 2, as stored
  const std::vector<std::uint32_t>& cornerToUv() const;  ///< |F| × 3
  const std::vector<std::uint32_t>& uvToVertex() const;  ///< "xref": uv vertex → surface vertex
  const std::vector<SeamEdge>& seams() const;
  MapFacts mapFacts() const;  ///< the certificate of the result as numbers; empty without one
  MapArrays release();        ///< moves the arrays of the result out, which ends it

  Result<MapMeasures> measure() const;  ///< of the result, for overlays and statistics
  Result<SurfaceFacts> facts() const;   ///< on the loaded surface, whether usable or not
  Result<SurfaceLoops> loops() const;   ///< in the order in which a prescription numbers them
  /// The log conformal factor of a prescription by surface vertex; NaN on components of which nothing is prescribed.
  Result<std::vector<float>> logScale(const prescription::Prescription& prescription) const;
  /// By mesh of the file, how its nodes use it; {} in formats without nodes.
  std::vector<io::Placements> placements() const;

  bool isAligned() const;  ///< every component, to the grid that the options asked for
  /// The cells of a result that is aligned in quad mode, as quads in an OBJ or PLY or, if `name` ends in .glb, as triangles,
  /// with the attributes of the input: every corner has what the input's triangle has at its point. Fails with kNoMap if the result is not aligned, with kUsage for another extension.
  /// @param resolve  gives the images of a .gltf that a .glb takes in; may be empty: these stay outside
  Result<QuadFile> quads(const std::string& name, const io::Resolver& resolve = {}) const;

  /// Whether write() can produce a file of this name, judged by its extension.
  Status canWrite(const std::string& name) const;
  /// The original with the result as a uv set, or the result in another format. The map is snapped to the numbers
  /// that this format stores and verified again; fails with kNoMap if it is then no longer certified.
  Result<WrittenMap> write(const WriteOptions& options) const;

 private:
  friend class FileMaps;
  friend class StoredResult;
  friend class LiveDrag;
  struct State;
  std::unique_ptr<State> state_;
};

std::string errorJson(const Failure& failure);  ///< hgp-error

/// For the whole process: no instructions that only some processors have, so that maps are bit-identical on all.
void setReproducible(bool isAsked);
const char* version();  ///< "1.2.3"

}  // namespace hgp::api
