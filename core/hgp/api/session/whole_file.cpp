#include "hgp/api/whole_file.h"

#include <algorithm>
#include <cmath>

#include "hgp/io/placements.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

double areaOf(const Session& session) {
  const std::vector<double>& x = session.positions();
  const std::vector<std::uint32_t>& t = session.triangles();
  const auto point = [&](std::uint32_t v) {
    const std::size_t i = 3 * std::size_t{v};
    return Vec3{x[i], x[i + 1], x[i + 2]};
  };
  double area = 0.0;
  for (std::size_t f = 0; f + 2 < t.size(); f += 3)
    area += triangleArea(point(t[f]), point(t[f + 1]), point(t[f + 2]));
  return area;
}

/// By mesh, the factor of lengths with which nodes show it.
std::vector<double> scalesOf(const Session& session) {
  std::vector<double> scales(static_cast<std::size_t>(session.surfaceCount()), 1.0);
  const std::vector<io::Placements> placements = session.placements();
  for (std::size_t mesh = 0; mesh < std::min(scales.size(), placements.size()); ++mesh)
    scales[mesh] = io::scaleOf(placements[mesh]);
  return scales;
}

/// By mesh, the options in which a number of cells is their edge length: that of so many cells on all meshes together, as
/// nodes show them.
std::vector<SolveOptions> withSharedCells(Session& session, const SolveOptions& options) {
  std::vector<SolveOptions> each(static_cast<std::size_t>(session.surfaceCount()), options);
  if (!(options.grid.cells > 0.0) || each.size() < 2) return each;
  const std::vector<double> scales = scalesOf(session);
  double area = 0.0;
  for (std::size_t mesh = 0; mesh < each.size(); ++mesh)
    if (session.choose(static_cast<int>(mesh)))
      area += scales[mesh] * scales[mesh] * areaOf(session);
  if (!(area > 0.0)) return each;
  const double length = std::sqrt(area / options.grid.cells);
  for (std::size_t mesh = 0; mesh < each.size(); ++mesh)
    each[mesh].grid = {0.0, length / scales[mesh], options.grid.mode};
  return each;
}

Status solveOne(Session& session, const WholeFileOptions& options, const SolveOptions& solve) {
  Result<std::optional<prescription::Prescription>> cones =
      std::optional<prescription::Prescription>();
  if (solve.boundary != BoundaryKind::kConvex)
    cones = storedCones(session, options.q, options.ignoresEmbedded);
  if (!cones) return cones.error();
  return session.parametrize(withFeatures(std::move(*cones), options.solve.q, options.features),
                             solve);
}

Result<WrittenFile> writeOnly(const Session& session, const WriteOptions& options) {
  Result<WrittenMap> written = session.write(options);
  if (!written) return written.error();
  WrittenFile out;
  static_cast<WrittenMap&>(out) = std::move(*written);
  out.mapNotes.push_back(std::move(out.notes));
  out.notes.clear();
  return out;
}

}  // namespace

bool FileOutcome::isWhole() const {
  return std::all_of(meshes.begin(), meshes.end(), [](const MeshOutcome& m) { return m.isGood(); });
}

std::optional<prescription::Prescription> withFeatures(
    std::optional<prescription::Prescription> cones, int q,
    const prescription::PrescribedFeatures& features) {
  if (features.isEmpty()) return cones;
  if (!cones) cones.emplace().q = q;
  cones->features = features;
  return cones;
}

Result<std::optional<prescription::Prescription>> storedCones(const Session& session,
                                                              std::optional<int> q,
                                                              bool ignoresEmbedded) {
  if (ignoresEmbedded) return std::optional<prescription::Prescription>();
  auto cones = session.embeddedCones();
  if (cones && *cones && q && *q != (*cones)->q) return std::optional<prescription::Prescription>();
  return cones;
}

Result<FileOutcome> parametrizeFile(Session& session, const WholeFileOptions& options) {
  FileOutcome out;
  const std::vector<SolveOptions> byMesh = withSharedCells(session, options.solve);
  const bool storesAll = options.solve.keepsGoing || options.write.allowUncertified;
  const bool isGridAsked = options.solve.grid.isAsked() || options.solve.choosesCells;
  WriteOptions write = options.write;
  write.allowUncertified = storesAll;
  FileMaps maps(write);
  const bool isOnly = session.surfaceCount() == 1;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    if (options.onMesh) options.onMesh(mesh);
    MeshOutcome one;
    one.mesh = mesh;
    Status done = isOnly ? Status(Done{}) : session.choose(mesh);
    if (done) done = solveOne(session, options, byMesh[static_cast<std::size_t>(mesh)]);
    if (!done && done.error().code == ErrorCode::kCancelled) return done.error();
    if (done) {
      one.isCertified = session.isCertified();
      one.isAligned = !isGridAsked || session.isAligned();
      one.report = session.reportJson();
    } else {
      one.failure = done.error();
    }
    if (done && (one.isGood() || storesAll)) {
      if (!isOnly)
        if (Status kept = maps.add(session); !kept) return kept.error();
      out.inFile.push_back(mesh);
    }
    out.meshes.push_back(std::move(one));
  }
  if (out.inFile.empty() || (!out.isWhole() && !storesAll)) return out;
  Result<WrittenFile> made = isOnly ? writeOnly(session, write) : maps.write();
  if (!made) return made.error();
  out.written = std::move(*made);
  return out;
}

}  // namespace hgp::api
