#include "whole_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hgp/api/notes.h"
#include "hgp/api/whole_file.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/phrase.h"
#include "mesh_notes.h"
#include "text_report.h"

namespace hgp::cli {
namespace {

using Json = nlohmann::ordered_json;

/// As for one mesh: what is asked for replaces what is stored.
bool ignoresEmbedded(const Arguments& asked) {
  return asked.ignoresEmbedded || asked.hasFeatures();
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

Result<FileOutcome> parametrizeAll(api::Session& session, const Arguments& asked,
                                   const Progress& progress) {
  api::WholeFileOptions options;
  options.solve = asked.solve;
  options.solve.progress = progress;
  options.write = writeOptions(session, asked);
  options.q = asked.q;
  options.ignoresEmbedded = ignoresEmbedded(asked);
  options.features = asked.everyMesh;
  Result<api::FileOutcome> made = api::parametrizeFile(session, options);
  if (!made) return made.error();
  FileOutcome out;
  for (api::MeshOutcome& one : made->meshes)
    out.meshes.push_back(
        {one.mesh, one.isCertified, one.isAligned, std::move(one.report), std::move(one.failure)});
  if (!made->written) return out;
  MeshNotes notes;
  for (std::size_t i = 0; i < made->inFile.size(); ++i)
    for (const Note& note : made->written->mapNotes[i])
      notes.add(made->inFile[i], note.code, phrase(note));
  out.notes = notes.lines();
  for (const Note& note : made->written->notes) out.notes.push_back(phrase(note));
  out.files = std::move(made->written->files);
  return out;
}

Result<FileOutcome> verifyAll(api::Session& session, const Arguments& asked) {
  FileOutcome out;
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    MeshOutcome one;
    one.mesh = mesh;
    Status done = session.choose(mesh);
    if (done) {
      auto cones = api::storedCones(session, asked.q, ignoresEmbedded(asked));
      Result<api::Verdict> verdict =
          cones ? session.verify(
                      api::withFeatures(std::move(*cones), asked.q.value_or(4), asked.everyMesh),
                      asked.verify)
                : Result<api::Verdict>(cones.error());
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
