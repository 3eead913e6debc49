#include "whole_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/api/file_maps.h"
#include "hgp/api/notes.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/phrase.h"
#include "mesh_notes.h"
#include "text_report.h"

namespace hgp::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The cones stored in the mesh, used as for a file with one mesh.
Result<std::optional<prescription::Prescription>> embedded(const api::Session& session,
                                                           const Arguments& asked) {
  if (asked.ignoresEmbedded) return std::optional<prescription::Prescription>();
  auto cones = session.embeddedCones();
  if (cones && *cones && asked.q && *asked.q != (*cones)->q)
    return std::optional<prescription::Prescription>();
  return cones;
}

Status solveOne(api::Session& session, const Arguments& asked, const Progress& progress) {
  Result<std::optional<prescription::Prescription>> cones =
      std::optional<prescription::Prescription>();
  if (asked.solve.boundary == api::BoundaryKind::kFree) cones = embedded(session, asked);
  if (!cones) return cones.error();
  api::SolveOptions options = asked.solve;
  options.progress = progress;
  return session.parametrize(*cones, options);
}

double areaOf(const api::Session& session) {
  const std::vector<double>& x = session.positions();
  const std::vector<std::uint32_t>& t = session.triangles();
  double area = 0.0;
  for (std::size_t f = 0; f + 2 < t.size(); f += 3) {
    const auto side = [&](std::size_t to, std::size_t k) {
      return x[3 * std::size_t{t[f + to]} + k] - x[3 * std::size_t{t[f]} + k];
    };
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const double n = side(1, k) * side(2, l) - side(1, l) * side(2, k);
      square += n * n;
    }
    area += 0.5 * std::sqrt(square);
  }
  return area;
}

/// Options in which a number of cells has become an edge length: that of so many cells on all meshes together.
Arguments withSharedGrid(api::Session& session, Arguments asked) {
  if (!(asked.solve.grid.cells > 0.0)) return asked;
  double area = 0.0;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh)
    if (session.choose(mesh)) area += areaOf(session);
  if (area > 0.0)
    asked.solve.grid = {0.0, std::sqrt(area / asked.solve.grid.cells), asked.solve.grid.mode};
  return asked;
}

/// A GLB that becomes a .gltf stays one until all meshes are written.
api::WriteOptions writeOptions(const api::Session& session, const Arguments& asked) {
  api::WriteOptions options = asked.write;
  const bool isGlb = session.canWrite("x.glb").hasValue();
  options.name = isGlb && asked.load.target == "gltf" ? "mesh.glb" : asked.output;
  options.isCompressedLater = asked.isCompressed;
  options.allowUncertified = asked.solve.keepsGoing || asked.write.allowUncertified;
  options.isSideFileNoted = false;
  return options;
}

/// Why a certified map is not on the grid, per component.
std::string gridReasons(const Json& report) {
  std::string out;
  for (std::size_t p = 0; p < report["components"].size(); ++p) {
    const Json& grid = report["components"][p]["grid"];
    if (!grid.is_null() && !grid["aligned"].get<bool>())
      out += formatText("  component %zu: ", p) +
             printable(api::phraseJson(grid["reason"].dump())) + "\n";
  }
  return out;
}

}  // namespace

Result<FileOutcome> parametrizeAll(api::Session& session, const Arguments& given,
                                   const Progress& progress) {
  FileOutcome out;
  const Arguments asked = withSharedGrid(session, given);
  const bool storesAll = asked.solve.keepsGoing || asked.write.allowUncertified;
  api::FileMaps maps(writeOptions(session, asked));
  std::vector<int> written;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    MeshOutcome one;
    one.mesh = mesh;
    Status done = session.choose(mesh);
    if (done) done = solveOne(session, asked, progress);
    if (!done && done.error().code == ErrorCode::kCancelled) return done.error();
    if (done) {
      one.isCertified = session.isCertified();
      one.isAligned = !asked.solve.grid.isAsked() || session.isAligned();
      one.json = session.reportJson();
    } else {
      one.failure = done.error();
    }
    if (done && ((one.isCertified && one.isAligned) || storesAll)) {
      if (Status kept = maps.add(session); !kept) return kept.error();
      written.push_back(mesh);
    }
    out.meshes.push_back(std::move(one));
  }
  const bool isWhole = out.goodCount() == static_cast<int>(out.meshes.size());
  if (written.empty() || (!isWhole && !storesAll)) return out;
  Result<api::WrittenFile> made = maps.write();
  if (!made) return made.error();
  MeshNotes notes;
  for (std::size_t i = 0; i < written.size(); ++i)
    for (const Note& note : made->mapNotes[i]) notes.add(written[i], note.code, phrase(note));
  out.notes = notes.lines();
  for (const Note& note : made->notes) out.notes.push_back(phrase(note));
  out.files = std::move(made->files);
  return out;
}

Result<FileOutcome> verifyAll(api::Session& session, const Arguments& asked) {
  FileOutcome out;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    MeshOutcome one;
    one.mesh = mesh;
    Status done = session.choose(mesh);
    if (done) {
      const auto cones = embedded(session, asked);
      Result<api::Verdict> verdict =
          cones ? session.verify(*cones, asked.verify) : Result<api::Verdict>(cones.error());
      if (verdict) {
        one.isCertified = verdict->isGood;
        one.json = verdict->json;
      } else {
        done = verdict.error();
      }
    }
    if (!done) one.failure = done.error();
    out.meshes.push_back(std::move(one));
  }
  return out;
}

int FileOutcome::certifiedCount() const {
  return static_cast<int>(std::count_if(meshes.begin(), meshes.end(),
                                        [](const MeshOutcome& m) { return m.isCertified; }));
}

int FileOutcome::goodCount() const {
  return static_cast<int>(std::count_if(meshes.begin(), meshes.end(), [](const MeshOutcome& m) {
    return m.isCertified && m.isAligned;
  }));
}

std::string FileOutcome::json() const {
  std::string out = formatText(
      "{\n\"format\": \"hgp-file\",\n\"version\": 1,\n\"certified\": %s,\n"
      "\"meshes\": [",
      certifiedCount() == static_cast<int>(meshes.size()) ? "true" : "false");
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshOutcome& m = meshes[i];
    const std::string body = m.failure ? api::errorJson(*m.failure) : m.json;
    out += formatText("%s\n{\"mesh\": %d, \"certified\": %s, \"document\": ", i > 0 ? "," : "",
                      m.mesh, m.isCertified ? "true" : "false");
    out += body.substr(0, body.find_last_not_of('\n') + 1) + "}";
  }
  return out + "\n]\n}\n";
}

std::string FileOutcome::text() const {
  std::string out;
  MeshNotes joined;
  for (const MeshOutcome& m : meshes) {
    out += formatText("mesh %d: ", m.mesh);
    if (m.failure) {
      out += "no map: " + printable(told(*m.failure)) + "\n";
      continue;
    }
    const Json json = Json::parse(m.json);
    const Json& certificate = json.contains("certificate") ? json["certificate"] : json;
    out += m.isCertified ? "certified" : "not certified";
    if (m.isCertified && !m.isAligned) out += ", but not aligned to a grid";
    out += formatText(", %s in %s\n",
                      counted(certificate["triangles"].get<long long>(), "triangle").c_str(),
                      counted(certificate["components"].size(), "component").c_str());
    if (m.isCertified && !m.isAligned) out += gridReasons(json);
    if (json.contains("notes")) {
      for (const Json& note : json["notes"])
        joined.add(m.mesh, note["code"].get<std::string>(), api::phraseJson(note.dump()));
    }
    for (std::size_t p = 0; p < certificate["components"].size() && !m.isCertified; ++p) {
      for (const Json& reason : certificate["components"][p]["reasons"]) {
        out += formatText("  component %zu: ", p) +
               printable(reason["message"].get<std::string>()) + "\n";
      }
    }
  }
  for (const std::string& line : joined.lines()) out += "  note: " + printable(line) + "\n";
  out += formatText("%d of %s certified", certifiedCount(),
                    counted(meshes.size(), "mesh", "meshes").c_str());
  if (goodCount() < certifiedCount()) out += formatText(", %d aligned to a grid", goodCount());
  return out + "\n";
}

}  // namespace hgp::cli
