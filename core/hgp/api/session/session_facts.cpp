// Facts about the loaded surface, in ids of the file.
#include <algorithm>
#include <limits>

#include "hgp/api/request/request.h"
#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/mesh/vertex_facts.h"

namespace hgp::api {
namespace {

/// Copies the facts of mesh vertices to the vertices of the surface; removed vertices keep the defaults.
void pullBackVertices(const Model& model, const VertexFacts& mesh, SurfaceFacts& out) {
  const int count = model.vertexImage.size();
  const auto size = static_cast<std::size_t>(count);
  out.representative.assign(size, -1);
  out.angle.assign(size, 0.0);
  out.valence.assign(size, 0);
  out.isBoundary.assign(size, 0);
  out.component.assign(size, -1);
  out.neighbourStart.assign(size + 1, 0);
  out.neighbours.reserve(mesh.neighbours.size());
  for (std::size_t v = 0; v < size; ++v) {
    const MeshVertexId m = model.vertexImage[SurfaceVertexId{static_cast<int>(v)}];
    if (m.isValid()) {
      out.representative[v] = model.vertexOrigin[m].i;
      out.angle[v] = mesh.angle[at(m.i)];
      out.valence[v] = static_cast<std::uint32_t>(mesh.valence[at(m.i)]);
      out.isBoundary[v] = static_cast<std::uint8_t>(mesh.isBoundary[at(m.i)]);
      out.component[v] = mesh.component[at(m.i)];
      for (auto n = mesh.neighbourStart[at(m.i)]; n < mesh.neighbourStart[at(m.i) + 1]; ++n) {
        const MeshVertexId w{static_cast<int>(mesh.neighbours[n])};
        out.neighbours.push_back(static_cast<std::uint32_t>(model.vertexOrigin[w].i));
      }
    }
    out.neighbourStart[v + 1] = static_cast<std::uint32_t>(out.neighbours.size());
  }
}

/// Where repairs split a vertex, any copy may be a cone, so the values that allow the most are reported.
void takeTheMost(const Model& model, const VertexFacts& mesh, SurfaceFacts& out) {
  for (int m = 0; m < model.vertexOrigin.size(); ++m) {
    const SurfaceVertexId v = model.vertexOrigin[MeshVertexId{m}];
    if (!v.isValid() || out.representative[at(v.i)] < 0) continue;
    auto& valence = out.valence[at(v.i)];
    valence = std::max(valence, static_cast<std::uint32_t>(mesh.valence[at(m)]));
    if (mesh.isBoundary[at(m)] == 0) out.isBoundary[at(v.i)] = 0;
  }
}

void pullBackFaces(const Model& model, const VertexFacts& mesh, SurfaceFacts& out) {
  out.triangleComponent.assign(model.source().mesh.triangles.size(), -1);
  for (int f = 0; f < model.faceOrigin.size(); ++f) {
    const SurfaceFaceId face = model.faceOrigin[MeshFaceId{f}];
    const int corner = model.mesh.triangles[at(f)][0];
    if (!face.isValid() || corner < 0 || at(corner) >= mesh.component.size()) continue;
    out.triangleComponent[at(face.i)] = mesh.component[at(corner)];
  }
}

/// The certificate of one component with ids of the surface.
ComponentFacts factsOf(const ModelComponent& component, const Certificate& certificate) {
  ComponentFacts out;
  out.isCertified = certificate.isCertified;
  for (const Reason& reason : certificate.reasons)
    out.reasons.push_back(toSurfaceIds(component, reason));
  out.triangles = certificate.faceCount;
  out.genus = certificate.genus;
  out.boundaries = certificate.loopCount;
  out.positive = certificate.orientation.positive;
  for (const MeasuredCone& c : certificate.angles.cones)
    out.cones.push_back({component.vertex[c.vertex].i, c.measured, c.distance});
  for (const MeasuredTurning& t : certificate.angles.turnings)
    out.turnings.push_back({component.loop[t.loop].i, t.measured});
  for (const MeasuredHandle& h : certificate.seams.handles)
    out.handles.push_back({component.generatorOffset + h.index, h.measured});
  return out;
}

}  // namespace

MapFacts Session::mapFacts() const {
  MapFacts out;
  if (!hasResult()) return out;
  const State& shown = state_->shown();
  out.isCertified = shown.solved->stored.isCertified;
  out.q = shown.solved->prescription.q;
  const std::vector<Certificate>& certificates = shown.solved->stored.certificates;
  for (std::size_t p = 0; p < certificates.size(); ++p)
    out.components.push_back(factsOf(shown.model->components[p], certificates[p]));
  return out;
}

MapArrays Session::release() {
  MapArrays out;
  if (!hasResult()) return out;
  state_->runs.clear();
  const State& shown = state_->shown();
  out.positions = shown.positions;
  out.triangles = shown.triangles;
  const std::shared_ptr<State::Solved> solved = shown.solved;
  state_->clearResult();
  if (solved.use_count() > 1) {  // a StoredResult has it, too
    out.uv = solved->uv;
    out.cornerToUv = solved->cornerToUv;
    out.uvToVertex = solved->stored.uvToVertex;
    out.seams = solved->seams;
    return out;
  }
  out.uv = std::move(solved->uv);
  out.cornerToUv = std::move(solved->cornerToUv);
  out.uvToVertex = std::move(solved->stored.uvToVertex);
  out.seams = std::move(solved->seams);
  return out;
}

std::vector<io::Placements> Session::placements() const {
  return state_->model ? state_->model->document->placements() : std::vector<io::Placements>();
}

Result<SurfaceFacts> Session::facts() const {
  return guarded([&]() -> Result<SurfaceFacts> {
    if (!state_->model) return notLoaded();
    const Model& model = *state_->model;
    const VertexFacts mesh = vertexFacts(model.mesh);
    SurfaceFacts out;
    out.area = mesh.area;
    pullBackVertices(model, mesh, out);
    takeTheMost(model, mesh, out);
    pullBackFaces(model, mesh, out);
    return out;
  });
}

Result<std::vector<float>> Session::logScale(const prescription::Prescription& prescription) const {
  return guarded([&]() -> Result<std::vector<float>> {
    State& state = *state_;
    if (Status ready = requireComponents(state.model); !ready) return ready.error();
    const Result<Request> request = resolveCones(*state.model, prescription);
    if (!request) return request.error();
    std::vector<float> out(state.model->source().mesh.positions.size(),
                           std::numeric_limits<float>::quiet_NaN());
    for (std::size_t p = 0; p < state.model->components.size(); ++p) {
      const ModelComponent& component = state.model->components[p];
      const HolonomySpec& spec = request->components[p].spec;
      if (request->components[p].isAutomatic) continue;
      PreparedSurface& surface = state.surfaceOf(p);
      const Result<BudgetReport> possible =
          checkPrescription(component.mesh, surface.topology(), spec, &surface.shortages());
      if (!possible) return toSurfaceIds(*state.model, component, possible.error());
      const Result<PrescribedField> field = surface.field(spec);
      if (!field) return toSurfaceIds(*state.model, component, field.error());
      for (VertexId v : component.mesh.vertices())
        if (const SurfaceVertexId s = component.vertex[v]; s.isValid())
          out[at(s.i)] = static_cast<float>(field->u[v]);
      state.dropLarge(p);
    }
    return out;
  });
}

}  // namespace hgp::api
