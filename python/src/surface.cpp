#include "surface.h"

#include <pybind11/stl.h>

#include <utility>

#include "../../examples/cli/files.h"
#include "failures.h"
#include "hgp/base/phrase.h"
#include "hgp/features/creases.h"
#include "hgp/text/text.h"
#include "options.h"
#include "watch.h"

namespace hgp::python {
namespace {

/// An OBJ with these texture coordinates; its numbers are read back exactly.
io::Bytes objOf(const std::vector<Vec3>& positions,
                const std::vector<std::array<int, 3>>& triangles, const Reals& uv,
                const std::vector<std::array<int, 3>>& corners) {
  std::string text;
  const auto line = [&](const char* word, const double* from, std::size_t count) {
    text += word;
    for (std::size_t i = 0; i < count; ++i) {
      text += ' ';
      text::appendDouble(text, from[i]);
    }
    text += '\n';
  };
  for (const Vec3& p : positions) line("v", p.data(), 3);
  for (py::ssize_t i = 0; i < uv.shape(0); ++i) line("vt", uv.data(i, 0), 2);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      text += ' ';
      text::appendInt(text, triangles[f][k] + 1);
      text += '/';
      text::appendInt(text, corners[f][k] + 1);
    }
    text += '\n';
  }
  return {text.begin(), text.end()};
}

}  // namespace

Status Source::load(api::Session& session) const {
  return files.name.empty() ? session.loadArrays(positions, triangles, options)
                            : session.load(files, options);
}

std::shared_ptr<Surface> Surface::loaded(Source source) {
  std::shared_ptr<Surface> surface(new Surface(std::move(source)));
  must(surface->alone_.run([&] { return surface->ready(); }));
  return surface;
}

std::shared_ptr<Surface> Surface::ofFile(const std::string& path, const std::string& root,
                                         const py::dict& options) {
  Source source;
  source.path = path;
  source.options = toLoadOptions(options);
  source.files = must([&] {
    const py::gil_scoped_release release;
    return cli::openFiles(path, "", root, source.options.limits.maxBytes);
  }());
  return loaded(std::move(source));
}

std::shared_ptr<Surface> Surface::ofArrays(const Reals& V, const py::array& F,
                                           const py::dict& options) {
  Source source;
  source.options = toLoadOptions(options);
  source.positions = toPositions(V);
  source.triangles = toTriangles(F, "F", V.shape(0));
  return loaded(std::move(source));
}

std::shared_ptr<Surface> Surface::ofMap(const Reals& V, const py::array& F, const Reals& uv,
                                        const py::array& fuv, const py::dict& options) {
  Source source;
  source.options = toLoadOptions(options);
  source.files.name = "arrays.obj";
  source.files.main = objOf(toPositions(V), toTriangles(F, "F", V.shape(0)), uv,
                            toTriangles(fuv, "fuv", uv.shape(0)));
  return loaded(std::move(source));
}

Status Surface::ready() {
  if (isLoaded_) return Done{};
  Status done = source_->load(session_);
  isLoaded_ = static_cast<bool>(done);
  return done;
}

template <class Work>
auto Surface::with(Work work) {
  return must(alone_.run([&]() -> decltype(work()) {
    if (Status done = ready(); !done) return done.error();
    return work();
  }));
}

std::optional<prescription::Prescription> Surface::prescription(const py::dict& asked,
                                                                bool usesEmbedded) {
  std::optional<prescription::Prescription> embedded;
  if (usesEmbedded) {
    Result<std::optional<prescription::Prescription>> stored =
        alone_.run([&]() -> Result<std::optional<prescription::Prescription>> {
          if (Status done = ready(); !done) return done.error();
          return session_.embeddedCones();
        });
    embedded = must(std::move(stored));
  }
  return toPrescription(asked, std::move(embedded));
}

std::pair<bool, std::string> Surface::inspect() {
  api::Verdict verdict = with([&] { return session_.inspect(); });
  return {verdict.isGood, std::move(verdict.json)};
}

std::pair<bool, std::string> Surface::check(const py::dict& asked) {
  std::optional<prescription::Prescription> wanted = prescription(asked);
  if (!wanted) {
    wanted.emplace();
    wanted->q = orderOf(asked).value_or(4);
  }
  api::Verdict verdict = with([&] { return session_.check(*wanted); });
  return {verdict.isGood, std::move(verdict.json)};
}

std::pair<bool, std::string> Surface::verify(const py::dict& asked, const py::dict& options) {
  const std::optional<prescription::Prescription> wanted = prescription(asked);
  const api::VerifyOptions how = toVerifyOptions(options);
  api::Verdict verdict = with([&] { return session_.verify(wanted, how); });
  return {verdict.isGood, std::move(verdict.json)};
}

std::string Surface::suggest(const py::dict& options, bool isReproducible,
                             const py::object& progress) {
  Watch watch(progress, std::nullopt);
  api::SolveOptions how = toSolveOptions(options);
  how.progress = watch.progress();
  Arithmetic::check(isReproducible);
  Result<api::SuggestedCones> made = alone_.run([&]() -> Result<api::SuggestedCones> {
    if (Status done = ready(); !done) return done.error();
    const Arithmetic arithmetic(isReproducible);
    return session_.suggest(how);
  });
  if (!made) watch.raise(made.error());
  return std::move(made->json);
}

std::string Surface::convert(const py::dict& asked) {
  std::optional<prescription::Prescription> wanted = prescription(asked);
  if (!wanted) raiseUsage("nothing is prescribed");
  return with([&] { return session_.convert(*wanted); });
}

std::string Surface::balance(const py::dict& asked) {
  std::optional<prescription::Prescription> wanted = prescription(asked);
  if (!wanted) raiseUsage("nothing is prescribed");
  return with([&] { return session_.balance(*wanted); });
}

/// `from` is read once more, so that no two surfaces wait for each other.
std::pair<std::string, std::vector<std::string>> Surface::transfer(const py::dict& asked,
                                                                   const Surface& from) {
  std::optional<prescription::Prescription> wanted = prescription(asked);
  if (!wanted) raiseUsage("nothing is prescribed");
  api::MovedCones moved = with([&]() -> Result<api::MovedCones> {
    api::Session before;
    if (Status loaded = from.source_->load(before); !loaded) return loaded.error();
    return session_.transfer(*wanted, before);
  });
  std::vector<std::string> lost;
  for (const Note& note : moved.lost) lost.push_back(phrase(note));
  return {std::move(moved.json), std::move(lost)};
}

py::dict Surface::features(const py::dict& asked, const std::string& name) {
  prescription::Prescription wanted;
  wanted.features = toFeatures(asked);
  if (wanted.features.isEmpty() && !asked.contains("features_text"))
    wanted.features.creaseDegrees = kCreaseDegrees;
  api::FeatureList list = with([&] { return session_.features(wanted, name); });
  std::vector<std::string> notes;
  for (const Note& note : list.notes) notes.push_back(phrase(note));
  py::dict out;
  out["text"] = std::move(list.text);
  out["crease_edges"] = list.creaseEdges;
  out["rim_edges"] = list.rimEdges;
  out["chains"] = list.chains;
  out["notes"] = std::move(notes);
  return out;
}

std::optional<std::string> Surface::embeddedCones() {
  std::optional<prescription::Prescription> stored = with([&] { return session_.embeddedCones(); });
  if (!stored) return std::nullopt;
  return with([&] { return session_.convert(*stored); });
}

std::shared_ptr<Map> Surface::parametrize(const py::dict& asked, const py::dict& options,
                                          bool isReproducible, std::optional<double> limit,
                                          const py::object& progress) {
  Watch watch(progress, limit);
  api::SolveOptions how = toSolveOptions(options);
  how.progress = watch.progress();
  std::optional<prescription::Prescription> wanted;
  if (how.boundary != api::BoundaryKind::kConvex) wanted = prescription(asked);
  Arithmetic::check(isReproducible);
  Result<std::shared_ptr<Map>> made = alone_.run([&]() -> Result<std::shared_ptr<Map>> {
    if (Status done = ready(); !done) return done.error();
    const Arithmetic arithmetic(isReproducible);
    if (Status done = session_.parametrize(wanted, how); !done) return done.error();
    auto map = std::make_shared<Map>(std::move(session_), source_);
    session_ = api::Session();
    isLoaded_ = false;
    return map;
  });
  if (!made) watch.raise(made.error());
  return std::move(*made);
}

py::array Surface::positions() {
  return taken<double>(with([&] { return Result<std::vector<double>>(session_.positions()); }), 3);
}

py::array Surface::triangles() {
  return taken<std::int32_t>(
      with([&] { return Result<std::vector<std::uint32_t>>(session_.triangles()); }), 3);
}

py::dict Surface::loops() {
  api::SurfaceLoops loops = with([&] { return session_.loops(); });
  py::list boundaries, handles;
  for (std::vector<int>& loop : loops.boundaries)
    boundaries.append(taken<std::int32_t>(std::move(loop)));
  for (const auto& edges : loops.handles) {
    std::vector<int> flat;
    for (const auto& edge : edges) flat.insert(flat.end(), edge.begin(), edge.end());
    handles.append(taken<std::int32_t>(std::move(flat), 2));
  }
  py::dict out;
  out["boundaries"] = boundaries;
  out["handles"] = handles;
  return out;
}

int Surface::meshCount() {
  return with([&] { return Result<int>(session_.surfaceCount()); });
}

}  // namespace hgp::python
