#include "hgp/api/live_drag.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "hgp/api/request/request.h"
#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/io/cone_files.h"

namespace hgp::api {

struct LiveDrag::State {
  State(Session::State& in, std::size_t p, LiveEdit made)
      : session(in), component(p), solved(in.solved), edit(std::move(made)) {}

  Session::State& session;
  std::size_t component;
  std::shared_ptr<Session::State::Solved> solved;  ///< the result where the drag began
  LiveEdit edit;
  std::vector<VertexId> vertexOf;  ///< by surface vertex; invalid outside the component

  Status requireCurrent() const;
  Result<VertexId> place(int vertex) const;  ///< of a surface vertex, while the drag is current
  const ModelComponent& on() const { return session.model->components[component]; }
  void addMap(const LiveFrame& frame, LiveView& view) const;
  std::string conesOf(const LiveFrame& frame) const;
  std::vector<ComponentMap> mapsNow() const;
};

namespace {

Failure refuse(std::string message) { return {ErrorCode::kUsage, "live", std::move(message), {}}; }

std::vector<VertexId> verticesOf(const Model& model, const ModelComponent& component) {
  std::vector<VertexId> out(model.source().mesh.positions.size());
  for (VertexId v : component.mesh.vertices())
    if (const SurfaceVertexId s = component.vertex[v]; s.isValid()) out[hgp::at(s.i)] = v;
  return out;
}

}  // namespace

LiveDrag::LiveDrag(std::unique_ptr<State> state) : state_(std::move(state)) {}
LiveDrag::LiveDrag(LiveDrag&&) noexcept = default;
LiveDrag& LiveDrag::operator=(LiveDrag&&) noexcept = default;
LiveDrag::~LiveDrag() = default;

Result<LiveDrag> LiveDrag::begin(Session& session, int vertex) {
  return guarded([&]() -> Result<LiveDrag> {
    Session::State& in = *session.state_;
    if (Status ready = requireComponents(in.model); !ready) return ready.error();
    if (!in.solved || in.finer || !in.solved->stored.isCertified)
      return refuse("a drag starts from a certified map on the mesh as loaded; solve first");
    const auto count = static_cast<int>(in.model->source().mesh.positions.size());
    if (vertex < 0 || vertex >= count)
      return refuse(formatText("there is no vertex %d; the mesh has %d", vertex, count));
    for (std::size_t p = 0; p < in.model->components.size(); ++p) {
      const ModelComponent& component = in.model->components[p];
      std::vector<VertexId> vertexOf = verticesOf(*in.model, component);
      const VertexId v = vertexOf[hgp::at(vertex)];
      if (!v.isValid()) continue;
      Result<LiveEdit> edit = LiveEdit::begin(in.surfaceOf(p), in.solved->components[p].spec,
                                              mapOfComponent(component, in.solved->stored.map), v);
      if (!edit) return toSurfaceIds(*in.model, component, edit.error());
      auto state = std::make_unique<State>(in, p, std::move(*edit));
      state->vertexOf = std::move(vertexOf);
      return LiveDrag(std::move(state));
    }
    return refuse(formatText("vertex %d is in no triangle", vertex));
  });
}

Status LiveDrag::State::requireCurrent() const {
  if (session.solved == solved && !session.finer) return Done{};
  return refuse("another map was loaded or solved since the drag began");
}

void LiveDrag::State::addMap(const LiveFrame& frame, LiveView& view) const {
  const auto first = static_cast<std::uint32_t>(solved->uv.size() / 2);
  view.uv = solved->uv;
  for (const Vec2& p : frame.map.uv) view.uv.insert(view.uv.end(), p.begin(), p.end());
  view.cornerToUv = solved->cornerToUv;
  for (HalfedgeId h : on().mesh.halfedges()) {
    const SurfaceCornerId corner = on().corner[h];
    if (!corner.isValid()) continue;
    view.cornerToUv[hgp::at(corner.i)] =
        first + static_cast<std::uint32_t>(frame.map.cornerUv[hgp::at(h.i / 3)][hgp::at(h.i % 3)]);
  }
  for (FaceId f : frame.certificate.orientation.notPositive)
    if (const SurfaceFaceId s = on().face[f]; s.isValid()) view.notPositive.push_back(s.i);
  for (const Reason& reason : frame.certificate.reasons)
    view.reasons.push_back(toSurfaceIds(on(), reason).message);
}

std::string LiveDrag::State::conesOf(const LiveFrame& frame) const {
  std::vector<HolonomySpec> specs;
  for (std::size_t p = 0; p < solved->components.size(); ++p)
    specs.push_back(toSpec(p == component ? frame.spec : solved->components[p].spec));
  return prescription::writeConesJson(describe(*session.model, specs));
}

Result<VertexId> LiveDrag::State::place(int vertex) const {
  if (Status current = requireCurrent(); !current) return std::move(current).error();
  const bool isThere = vertex >= 0 && vertex < static_cast<int>(vertexOf.size());
  if (isThere && vertexOf[hgp::at(vertex)].isValid()) return vertexOf[hgp::at(vertex)];
  return refuse(formatText("vertex %d is not on the component of this cone", vertex));
}

Result<LiveView> LiveDrag::moveTo(int vertex) {
  return guarded([&]() -> Result<LiveView> {
    State& s = *state_;
    const Result<VertexId> to = s.place(vertex);
    if (!to) return to.error();
    Result<LiveFrame> frame = s.edit.moveTo(*to);
    if (!frame) return toSurfaceIds(*s.session.model, s.on(), frame.error());
    LiveView view;
    view.state = frame->state;
    view.wantsPreparation = frame->wantsAnchor;
    view.logScale.assign(s.vertexOf.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t v = 0; v < s.vertexOf.size(); ++v)
      if (s.vertexOf[v].isValid()) view.logScale[v] = static_cast<float>(frame->u[s.vertexOf[v]]);
    if (frame->state != LiveState::kHeat) s.addMap(*frame, view);
    view.cones = s.conesOf(*frame);
    return view;
  });
}

/// Every component as it is stored, the dragged one as it now is.
std::vector<ComponentMap> LiveDrag::State::mapsNow() const {
  std::vector<ComponentMap> maps;
  for (std::size_t p = 0; p < solved->components.size(); ++p) {
    const TriMesh& mesh = session.model->components[p].mesh;
    ComponentMap map;
    if (p == component) {
      LiveEdit::Reached reached = edit.reached();
      map.spec = std::move(reached.spec);
      map.map = std::move(reached.map);
      map.copyOf = std::move(reached.copyOf);
    } else {
      map.spec = solved->components[p].spec;
      map.isKept = solved->components[p].isKept;
      map.map = mapOfComponent(session.model->components[p], solved->stored.map);
      map.copyOf.resize(map.map.uv.size());
      for (HalfedgeId h : mesh.halfedges())
        map.copyOf[hgp::at(map.map.cornerUv[hgp::at(h.i / 3)][hgp::at(h.i % 3)])] = mesh.tail(h);
    }
    map.certificate = certify(mesh, map.spec, map.map);
    maps.push_back(std::move(map));
  }
  return maps;
}

Status LiveDrag::drop() {
  return guarded([&]() -> Status {
    State& s = *state_;
    if (Status current = s.requireCurrent(); !current) return current;
    const auto start = std::chrono::steady_clock::now();
    std::vector<ComponentMap> maps = s.mapsNow();
    RunRecord run;
    run.options = s.solved->options;
    for (const ComponentMap& map : maps) {
      Parametrization& component = run.components.emplace_back();
      component.spec = map.spec;
      component.certificate = map.certificate;
      component.isCertified = map.certificate.isCertified;
      component.isUsable = map.certificate.isUsable;
    }
    const Where dropped{Where::Kind::kVertex, s.on().vertex[s.edit.cone().vertex].i};
    run.notes.push_back(Note("map-dragged", {}, {dropped}));
    const int q = maps.front().spec.q;
    s.session.clearResult();
    s.session.storeMaps(std::move(maps), q, run.options, false, run);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    run.seconds = seconds.count();
    s.session.publish(run);
    return Done{};
  });
}

Status LiveDrag::prepareHere() {
  return guarded([&]() -> Status {
    if (Status current = state_->requireCurrent(); !current) return current;
    return state_->edit.beginHere();
  });
}

Result<int> LiveDrag::prepareToward(int vertex) {
  return guarded([&]() -> Result<int> {
    State& s = *state_;
    const Result<VertexId> to = s.place(vertex);
    if (!to) return to.error();
    const Result<bool> isNearer = s.edit.beginToward(*to);
    if (!isNearer) return toSurfaceIds(*s.session.model, s.on(), isNearer.error());
    return *isNearer ? s.on().vertex[s.edit.cone().vertex].i : -1;
  });
}

}  // namespace hgp::api
