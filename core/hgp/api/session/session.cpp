#include "hgp/api/session.h"

#include "hgp/api/model/load_model.h"
#include "hgp/api/session/guard.h"
#include "hgp/api/session/map_notes.h"
#include "hgp/api/session/session_state.h"
#include "hgp/io/cone_files.h"
#include "hgp/io/convert.h"
#include "hgp/linalg/kernels/dense_kernels.h"
#include "hgp/prescription/feature_files.h"

#ifndef HGP_VERSION
#define HGP_VERSION "0.0.0"
#endif

namespace hgp::api {
namespace {

const std::string kEmpty;
const std::vector<double> kNoNumbers;
const std::vector<std::uint32_t> kNoIndices;
const std::vector<SeamEdge> kNoSeams;

}  // namespace

Failure notLoaded() { return {ErrorCode::kUsage, "session", "no model is loaded", {}}; }

Status requireComponents(const std::optional<Model>& model) {
  if (!model) return notLoaded();
  if (model->unusable) return *model->unusable;
  return Done{};
}

Session::Session() : state_(std::make_unique<State>()) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Status Session::State::take(Result<Model> loaded) {
  if (!loaded) return loaded.error();
  clearResult();
  runs.clear();
  hash.clear();
  prepared.clear();
  model.reset();
  positions.clear();
  triangles.clear();
  model = std::move(*loaded);
  const MeshData& mesh = model->source().mesh;
  positions.reserve(3 * mesh.positions.size());
  for (const Vec3& p : mesh.positions) positions.insert(positions.end(), p.begin(), p.end());
  triangles.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (int v : t) triangles.push_back(static_cast<std::uint32_t>(v));
  }
  return Done{};
}

Status Session::load(io::FileSet files, const LoadOptions& options) {
  return guarded([&]() -> Status {
    Result<OpenedFile> file = openFile(std::move(files), options);
    if (!file) return file.error();
    if (Status done = state_->take(modelOfFile(*file, options)); !done) return done;
    state_->file.reset();
    if (file->document->surfaces().size() > 1) state_->file = std::move(*file);
    return Done{};
  });
}

Status Session::choose(int surface) {
  return guarded([&]() -> Status {
    if (!state_->file)
      return Failure{ErrorCode::kUsage, "session", "no file with several meshes is loaded", {}};
    LoadOptions options = state_->model->load;
    options.surface = surface;
    return state_->take(modelOfFile(*state_->file, options));
  });
}

Status Session::loadArrays(std::vector<Vec3> positions, std::vector<std::array<int, 3>> triangles,
                           const LoadOptions& options) {
  return guarded([&]() -> Status {
    Result<Model> made = modelOfArrays({std::move(positions), std::move(triangles)}, options);
    if (made) state_->file.reset();
    return state_->take(std::move(made));
  });
}

int Session::surfaceCount() const {
  return state_->model ? static_cast<int>(state_->model->document->surfaces().size()) : 0;
}

Result<Verdict> Session::inspect() const {
  return guarded([&]() -> Result<Verdict> {
    if (!state_->model) return notLoaded();
    return Verdict{!state_->model->unusable, inspectText(*state_->model), state_->model->unusable};
  });
}

Result<SuggestedCones> Session::suggest(const SolveOptions& options) const {
  return guarded([&]() -> Result<SuggestedCones> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    std::vector<HolonomySpec> specs;
    SuggestedCones out;
    for (std::size_t p = 0; p < state_->model->components.size(); ++p) {
      Result<CompleteSpec> spec = state_->chooseCones(p, options);
      if (!spec) return toSurfaceIds(*state_->model, state_->model->components[p], spec.error());
      if (std::optional<Note> other = countNote(options.coneCount, *spec))
        out.notes.push_back(std::move(*other));
      state_->dropLarge(p);
      specs.push_back(toSpec(*spec));
    }
    out.json = prescription::writeConesJson(describe(*state_->model, specs));
    return out;
  });
}

Result<std::string> Session::convert(const prescription::Prescription& prescription) const {
  return guarded([&]() -> Result<std::string> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    Result<Request> request = resolve(*state_->model, prescription);
    if (!request) return request.error();
    std::vector<HolonomySpec> specs;
    for (const ComponentRequest& component : request->components) specs.push_back(component.spec);
    return prescription::writeConesJson(describe(*state_->model, specs));
  });
}

Result<std::optional<prescription::Prescription>> Session::embeddedCones() const {
  return guarded([&]() -> Result<std::optional<prescription::Prescription>> {
    if (!state_->model) return notLoaded();
    return state_->model->embeddedCones;
  });
}

Status Session::parametrize(const std::optional<prescription::Prescription>& prescription,
                            const SolveOptions& options) {
  return guarded([&]() -> Status {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    return state_->solveOrFind(prescription, options);
  });
}

Result<Verdict> Session::verify(const std::optional<prescription::Prescription>& prescription,
                                const VerifyOptions& options) const {
  return guarded([&]() -> Result<Verdict> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    const Model& model = *state_->model;
    const std::vector<int>& sets = model.source().uvSets;
    const int own = model.source().ownUvSet;
    const int last = own >= 0 ? own : sets.empty() ? 0 : sets.back();
    const int set = options.uvSet >= 0 ? options.uvSet : last;
    std::optional<UvMap> map = model.document->exactUv(model.surface, set);
    if (!map) {
      return Failure{ErrorCode::kUnsupported,
                     "verify",
                     sets.empty() ? "the file has no texture coordinates"
                                  : formatText("the file has no uv set %d", set),
                     {}};
    }
    Result<Request> request =
        prescription ? resolve(model, *prescription)
                     : Result<Request>(automaticRequest(model, options.q > 0 ? options.q : 4));
    if (!request) return request.error();
    const std::optional<UvMap> read = model.document->existingUv(model.surface, set);
    CertifyOptions rule;
    rule.tolerance = options.tolerance;
    const bool isFloat = model.document->uvPrecision() == io::UvPrecision::kFloat32;
    rule.precision = isFloat ? Precision::kFloat32 : Precision::kFloat64;
    std::vector<Certificate> certificates;
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      rule.isAnyConeAllowed = request->components[p].isAutomatic;
      const UvMap componentMap = mapOfComponent(model.components[p], *map);
      if (isFloat) rule.gridStep = gridStep(mapOfComponent(model.components[p], *read));
      certificates.push_back(
          certify(model.components[p].mesh, request->components[p].spec, componentMap, rule));
      certificates.back().overlap = measureOverlap(componentMap, overlapCells(componentMap));
    }
    denyFoldedPolygons(model, model.document->polygons(model.surface), *map, certificates);
    return Verdict{areCertified(certificates),
                   certificateText(model, certificates, measureOutside(model, *map), set,
                                   prescription ? mismatchNotes(model, *prescription) : Notes()),
                   std::nullopt};
  });
}

bool Session::hasResult() const { return state_->shown().solved != nullptr; }
bool Session::isCertified() const {
  return hasResult() && state_->shown().solved->stored.isCertified;
}
const std::string& Session::certificateJson() const {
  if (!hasResult()) return kEmpty;
  if (state_->certificate.empty())
    state_->certificate = certificateOf(state_->shown().solved->report);
  return state_->certificate;
}
const std::string& Session::reportJson() const {
  return hasResult() ? state_->shown().solved->report : kEmpty;
}
const std::string& Session::conesJson() const {
  return hasResult() ? state_->shown().solved->cones : kEmpty;
}
std::optional<Repaired> Session::repaired() const {
  const std::optional<Model>& shown = state_->shown().model;
  if (!shown || !shown->isChanged) return std::nullopt;
  const Model& model = *shown;
  Repaired out{{}, model.vertexOrigin.raw(), model.vertexImage.raw()};
  for (const auto& t : model.mesh.triangles) {
    for (int v : t) out.triangles.push_back(static_cast<std::uint32_t>(v));
  }
  return out;
}
const std::vector<double>& Session::positions() const { return state_->shown().positions; }
const std::vector<std::uint32_t>& Session::triangles() const { return state_->shown().triangles; }
const std::vector<double>& Session::uv() const {
  return hasResult() ? state_->shown().solved->uv : kNoNumbers;
}
const std::vector<std::uint32_t>& Session::cornerToUv() const {
  return hasResult() ? state_->shown().solved->cornerToUv : kNoIndices;
}
const std::vector<std::uint32_t>& Session::uvToVertex() const {
  return hasResult() ? state_->shown().solved->stored.uvToVertex : kNoIndices;
}
const std::vector<SeamEdge>& Session::seams() const {
  return hasResult() ? state_->shown().solved->seams : kNoSeams;
}

Status Session::canWrite(const std::string& name) const {
  return guarded([&]() -> Status {
    if (!state_->model) return notLoaded();
    const std::string wanted = extensionOf(name);
    const io::Document& document = *state_->shown().model->document;
    const std::string given = document.outputFormat();
    const bool isKnown = wanted == "obj" || wanted == "off" || wanted == "ply" || wanted == "stl" ||
                         wanted == "gltf" || wanted == "glb" || wanted == "gz";
    if (wanted.empty() || document.canWriteAs(wanted)) return Done{};
    if (state_->writesSplitMesh(wanted)) return Done{};
    if (!isKnown) {
      return Failure{
          ErrorCode::kUsage,
          "write",
          "no format has the extension ." + wanted + "; the result is written as ." + given,
          {}};
    }
    return Failure{
        ErrorCode::kUsage,
        "write",
        "the result is written as " + given + ", not as " + wanted +
            (io::canConvert(document, wanted) ? " (a file must be loaded for that: target)" : ""),
        {}};
  });
}

Result<prescription::Prescription> readPrescription(std::string_view name, std::string_view text,
                                                    int q) {
  return guarded([&] { return io::readPrescription(name, text, q); });
}

Result<prescription::PrescribedFeatures> readFeatures(std::string_view name,
                                                      std::string_view text) {
  return guarded([&] { return prescription::readFeatures(name, text); });
}

Result<prescription::Prescription> withField(prescription::Prescription cones,
                                             prescription::Prescription field) {
  if (field.q != cones.q) {
    return Failure{ErrorCode::kUsage,
                   "prescription",
                   formatText("the field has q = %d, the cones q = %d", field.q, cones.q),
                   {}};
  }
  cones.field = std::move(field.field);
  return cones;
}

void setReproducible(bool isAsked) { linalg::useBaselineKernels(isAsked); }

const char* version() { return HGP_VERSION; }

}  // namespace hgp::api
