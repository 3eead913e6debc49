#include "hgp/api/whole_file.h"

#include <algorithm>
#include <cmath>

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

/// A number of cells becomes an edge length: that of so many cells on all meshes together.
SolveOptions withSharedCells(Session& session, SolveOptions options) {
  if (!(options.grid.cells > 0.0) || session.surfaceCount() < 2) return options;
  double area = 0.0;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh)
    if (session.choose(mesh)) area += areaOf(session);
  if (area > 0.0) options.grid = {0.0, std::sqrt(area / options.grid.cells), options.grid.mode};
  return options;
}

Status solveOne(Session& session, const WholeFileOptions& options, const SolveOptions& solve) {
  Result<std::optional<prescription::Prescription>> cones =
      std::optional<prescription::Prescription>();
  if (solve.boundary != BoundaryKind::kConvex)
    cones = storedCones(session, options.q, options.ignoresEmbedded);
  if (cones && !options.features.isEmpty()) {
    if (!*cones) cones->emplace().q = options.solve.q;
    (*cones)->features = options.features;
  }
  return cones ? session.parametrize(*cones, solve) : Status(cones.error());
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
  const SolveOptions solve = withSharedCells(session, options.solve);
  const bool storesAll = solve.keepsGoing || options.write.allowUncertified;
  const bool isGridAsked = solve.grid.isAsked() || solve.choosesCells;
  WriteOptions write = options.write;
  write.allowUncertified = storesAll;
  FileMaps maps(write);
  const bool isOnly = session.surfaceCount() == 1;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    if (options.onMesh) options.onMesh(mesh);
    MeshOutcome one;
    one.mesh = mesh;
    Status done = isOnly ? Status(Done{}) : session.choose(mesh);
    if (done) done = solveOne(session, options, solve);
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
