// budget: a short method for every call of the package
// hgp::api::Session for JavaScript. Every call returns a plain object: its results, or `error` with
// the JSON of the failure. No exception crosses this boundary, and no C++ object except sessions and stored results.
#include <emscripten/bind.h>

#include <array>
#include <optional>
#include <string>

#include "decoders.h"
#include "drag.h"
#include "hgp/api/notes.h"
#include "options.h"
#include "reply.h"
#include "results.h"
#include "written.h"

namespace hgp::js {
namespace {

class Session {
 public:
  val load(const std::string& name, const val& names, const val& contents, const val& decoders,
           const std::string& options) {
    return guarded([&] {
      const auto asked = api::optionsFromJson<api::LoadOptions>(options);
      if (!asked) return failed(asked.error());
      io::FileSet files = toFileSet(name, names, contents);
      files.decoders = toDecoders(decoders);
      return afterLoad(session_.load(std::move(files), *asked));
    });
  }

  val loadMesh(const val& positions, const val& triangles, const std::string& options) {
    return guarded([&] {
      const auto asked = api::optionsFromJson<api::LoadOptions>(options);
      if (!asked) return failed(asked.error());
      return afterLoad(session_.loadArrays(toRows<Vec3>(toVector<double>(positions)),
                                           toRows<std::array<int, 3>>(toVector<int>(triangles)),
                                           *asked));
    });
  }

  val inspect() const {
    return guarded([&] { return replyVerdict(session_.inspect()); });
  }

  val check(const std::string& cones) const {
    return guarded([&] {
      const auto asked = api::readPrescription("cones.json", cones, 0);
      return asked ? replyVerdict(session_.check(*asked)) : failed(asked.error());
    });
  }

  /// The loaded surface, usable or not, to which ids refer, and the surface after welds and repairs.
  val surface() const {
    return guarded([&] {
      val reply = withSurface(val::object());
      if (const auto mesh = session_.repaired()) reply.set("repaired", toRepaired(*mesh));
      return reply;
    });
  }

  /// Any cone file on this surface as hgp-cones; `q` is used if the file has none.
  val readCones(const std::string& name, const std::string& text, int q) const {
    return guarded([&] {
      const auto read = api::readPrescription(name, text, q);
      return replyText(read ? session_.convert(*read) : Result<std::string>(read.error()));
    });
  }

  /// The cones stored in the file as hgp-cones; an empty reply if it has none.
  val embeddedCones() const {
    return guarded([&] {
      const auto stored = session_.embeddedCones();
      if (!stored) return failed(stored.error());
      return *stored ? replyText(session_.convert(**stored)) : val::object();
    });
  }

  val logScale(const std::string& cones) const {
    return guarded([&] {
      const auto asked = api::readPrescription("cones.json", cones, 0);
      if (!asked) return failed(asked.error());
      const Result<std::vector<float>> scale = session_.logScale(*asked);
      if (!scale) return failed(scale.error());
      val reply = val::object();
      reply.set("logScale", toTypedArray("Float32Array", *scale));
      return reply;
    });
  }

  val features(const val& list, const std::string& name) const {
    return guarded([&] {
      val files = val::object();
      files.set("features", list);
      const MaybePrescription asked = toPrescription("", files);
      if (!asked) return failed(asked.error());
      const auto found = session_.features(asked->value_or(prescription::Prescription()), name);
      if (!found) return failed(found.error());
      val reply = val::object();
      reply.set("text", found->text);
      reply.set("creaseEdges", found->creaseEdges);
      reply.set("rimEdges", found->rimEdges);
      reply.set("chains", found->chains);
      reply.set("notes", api::notesDocument(found->notes));
      return reply;
    });
  }

  val suggestCones(const std::string& options, const val& onProgress) const {
    return guarded([&] {
      const auto how = toSolveOptions(options, onProgress);
      if (!how) return failed(how.error());
      auto made = session_.suggest(*how);
      return made ? replyText(std::move(made->json)) : failed(made.error());
    });
  }

  val balanceCones(const std::string& cones) const {
    return guarded([&] {
      const auto asked = api::readPrescription("cones.json", cones, 0);
      return replyText(asked ? session_.balance(*asked) : Result<std::string>(asked.error()));
    });
  }

  /// Cones of the surface of `from` on this one, and notes on what is left out.
  val transferCones(const std::string& cones, const Session& from) const {
    return guarded([&] {
      const auto asked = api::readPrescription("cones.json", cones, 0);
      if (!asked) return failed(asked.error());
      const Result<api::MovedCones> moved = session_.transfer(*asked, from.session_);
      if (!moved) return failed(moved.error());
      val reply = val::object();
      reply.set("json", moved->json);
      reply.set("lost", api::notesDocument(moved->lost));
      return reply;
    });
  }

  val parametrize(const std::string& cones, const val& files, const std::string& options,
                  const val& onProgress) {
    return guarded([&] {
      const MaybePrescription asked = toPrescription(cones, files);
      if (!asked) return failed(asked.error());
      const auto how = toSolveOptions(options, onProgress);
      if (!how) return failed(how.error());
      const Status done = session_.parametrize(*asked, *how);
      return done ? result() : failed(done.error());
    });
  }

  val verify(const std::string& cones, const val& files, const std::string& options) const {
    return guarded([&] {
      const MaybePrescription asked = toPrescription(cones, files);
      if (!asked) return failed(asked.error());
      const auto how = api::optionsFromJson<api::VerifyOptions>(options);
      return how ? replyVerdict(session_.verify(*asked, *how)) : failed(how.error());
    });
  }

  val write(const std::string& options) const {
    return guarded([&] {
      const auto how = api::optionsFromJson<api::WriteOptions>(options);
      if (!how) return failed(how.error());
      const Result<api::WrittenMap> written = session_.write(*how);
      return written ? toWritten(*written) : failed(written.error());
    });
  }

  /// All meshes of the file: {meshes, file}; `file` as from write(), with the notes of each mesh, if it may be written.
  val parametrizeFile(const std::string& options, const std::string& write, const val& files,
                      const val& onProgress, const val& onMesh) {
    return guarded([&] {
      const MaybePrescription all = toPrescription("", files);
      if (!all) return failed(all.error());
      auto solve = toSolveOptions(options, onProgress);
      if (!solve) return failed(solve.error());
      auto how = api::optionsFromJson<api::WriteOptions>(write);
      if (!how) return failed(how.error());
      api::WholeFileOptions asked;
      if (options.find("\"q\":") != std::string::npos) asked.q = solve->q;
      asked.solve = std::move(*solve);
      asked.write = std::move(*how);
      if (*all) asked.features = (*all)->features;
      asked.onMesh = [&](int mesh) { onMesh(mesh, session_.surfaceCount()); };
      const Result<api::FileOutcome> made = api::parametrizeFile(session_, asked);
      if (!made) return failed(made.error());
      val reply = val::object(), meshes = val::array();
      for (const api::MeshOutcome& one : made->meshes) meshes.call<void>("push", toOutcome(one));
      reply.set("meshes", meshes);
      if (made->written) reply.set("file", toFile(*made->written, made->inFile));
      return reply;
    });
  }

  const api::Session& session() const { return session_; }

  val measure() const {
    return guarded([&] {
      const Result<api::MapMeasures> made = session_.measure();
      return made ? toMeasures(*made) : failed(made.error());
    });
  }

  val facts() const {
    return guarded([&] {
      const Result<api::SurfaceFacts> made = session_.facts();
      return made ? toFacts(*made) : failed(made.error());
    });
  }

  /// By mesh of the file; undefined in formats without nodes.
  val placements() const {
    return guarded([&] { return toPlacements(session_.placements()); });
  }

  val loops() const {
    return guarded([&] {
      const Result<api::SurfaceLoops> made = session_.loops();
      return made ? toLoops(*made) : failed(made.error());
    });
  }

  /// The current result as an object that JavaScript must delete().
  api::StoredResult storedResult() const { return session_.result(); }
  bool use(const api::StoredResult& result) { return session_.use(result); }

  /// A new drag, which begins from the current result.
  val beginDrag(Drag& drag, int vertex) {
    return guarded([&] {
      const Status begun = drag.begin(session_, vertex);
      return begun ? val::object() : failed(begun.error());
    });
  }

  /// @param names, contents  side files of the input, of which a GLB gets the pictures
  val quads(const std::string& name, const val& names, const val& contents) const {
    return guarded([&] {
      const io::Resolver sides = toFileSet("", names, contents).resolve;
      const Result<api::QuadFile> quads = session_.quads(name, sides);
      return quads ? toQuads(*quads) : failed(quads.error());
    });
  }

  /// The current result; after a drag, the map that was dropped.
  val result() const {
    val reply = withSurface(val::object());
    reply.set("report", session_.reportJson());
    reply.set("uv", toTypedArray("Float64Array", session_.uv()));
    reply.set("cornerToUv", toTypedArray("Uint32Array", session_.cornerToUv()));
    reply.set("uvToVertex", toTypedArray("Uint32Array", session_.uvToVertex()));
    reply.set("seams", toSeams(session_.seams()));
    const api::SolvedTriangles solved = session_.solvedTriangles();
    if (solved.triangles != session_.triangles() || solved.cornerToUv != session_.cornerToUv())
      reply.set("solved", toSolved(solved));
    return reply;
  }

 private:
  val afterLoad(const Status& loaded) const {
    return loaded ? replyVerdict(session_.inspect()) : failed(loaded.error());
  }

  val withSurface(val reply) const {
    reply.set("positions", toTypedArray("Float64Array", session_.positions()));
    reply.set("triangles", toTypedArray("Uint32Array", session_.triangles()));
    return reply;
  }

  api::Session session_;
};

/// Maps of several meshes of a file, from sessions that have read it.
class FileMaps {
 public:
  /// @param options  of this map; of the file are those of the first
  val add(const Session& session, const std::string& options) {
    return guarded([&] {
      const auto how = api::optionsFromJson<api::WriteOptions>(options);
      if (!how) return failed(how.error());
      if (!maps_) maps_.emplace(*how);
      const Status kept = maps_->add(session.session(), *how);
      return kept ? val::object() : failed(kept.error());
    });
  }
  /// @param meshes  of the maps, in their order
  val write(const val& meshes) const {
    return guarded([&] {
      const Result<api::WrittenFile> made = maps_->write();
      return made ? toFile(*made, toVector<int>(meshes)) : failed(made.error());
    });
  }

 private:
  std::optional<api::FileMaps> maps_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(hgp) {
  emscripten::class_<FileMaps>("FileMaps")
      .constructor<>()
      .function("add", &FileMaps::add)
      .function("write", &FileMaps::write);
  emscripten::class_<api::StoredResult>("StoredResult");
  emscripten::class_<Drag>("Drag")
      .constructor<>()
      .function("moveTo", &Drag::moveTo)
      .function("prepareHere", &Drag::prepareHere)
      .function("prepareToward", &Drag::prepareToward)
      .function("drop", &Drag::drop);
  emscripten::class_<Session>("Session")
      .constructor<>()
      .function("load", &Session::load)
      .function("loadMesh", &Session::loadMesh)
      .function("inspect", &Session::inspect)
      .function("check", &Session::check)
      .function("surface", &Session::surface)
      .function("readCones", &Session::readCones)
      .function("embeddedCones", &Session::embeddedCones)
      .function("logScale", &Session::logScale)
      .function("features", &Session::features)
      .function("suggestCones", &Session::suggestCones)
      .function("balanceCones", &Session::balanceCones)
      .function("transferCones", &Session::transferCones)
      .function("parametrize", &Session::parametrize)
      .function("verify", &Session::verify)
      .function("parametrizeFile", &Session::parametrizeFile)
      .function("write", &Session::write)
      .function("measure", &Session::measure)
      .function("facts", &Session::facts)
      .function("storedResult", &Session::storedResult)
      .function("use", &Session::use)
      .function("beginDrag", &Session::beginDrag)
      .function("result", &Session::result)
      .function("loops", &Session::loops)
      .function("placements", &Session::placements)
      .function("quads", &Session::quads);
  emscripten::function("neededDecoders", &neededDecoders);
  emscripten::function("version",
                       emscripten::optional_override([] { return std::string(api::version()); }));
}

}  // namespace hgp::js
