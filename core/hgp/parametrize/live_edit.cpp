#include "hgp/parametrize/live_edit.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/parametrize/live/drag_disc.h"
#include "hgp/parametrize/live/mend.h"
#include "hgp/parametrize/live/read_map.h"

namespace hgp {
namespace {

Failure refuse(std::string message, VertexId v) {
  return {ErrorCode::kUsage, "live", std::move(message), {{Where::Kind::kVertex, v.i}}};
}

/// Cut and system of a completed prescription.
Result<SeamlessSetup> setUp(PreparedSurface& surface, const CompleteSpec& spec) {
  Result<PrescribedField> field = surface.field(toSpec(spec));
  if (!field) return std::move(field).error();
  if (Status done = surface.requireConnection(); !done) return std::move(done).error();
  SeamlessSetup setup;
  setup.context = surface.share();
  setup.field = std::move(*field);
  for (const ConePoint& cone : setup.field.spec.cones) setup.cones.push_back(cone.vertex);
  cutOpen(surface.mesh(), setup);
  assemble(surface.mesh(), setup);
  return setup;
}

}  // namespace

const char* liveStateName(LiveState state) {
  static const char* const kNames[] = {"heat", "certified", "fails"};
  return kNames[static_cast<int>(state)];
}

/// Everything is of the last anchor: the map from which frames are computed.
struct LiveEdit::State {
  State(PreparedSurface& on, const CompleteSpec& asked, ConePoint moved)
      : surface(on), verifier(on.mesh()), spec(asked), cone(moved) {}

  PreparedSurface& surface;
  Verifier verifier;
  CompleteSpec spec;
  ConePoint cone;
  std::unique_ptr<SeamlessSetup> setup;
  std::unique_ptr<live::MovedCut> cut;
  std::unique_ptr<live::MovedField> field;
  std::unique_ptr<live::DragDisc> disc;  ///< null where maps cannot be computed this way
  CompleteSpec lastSpec;                 ///< of the last certified frame
  UvMap lastMap;
  VertexId last;
  int preparations = 0;

  Status anchor(const UvMap& map);
  CompleteSpec specAt(VertexId v) const;
  PerVertex<double> scale() const;
  int unknownOf(VertexId w, VertexId v) const;
  Eigen::VectorXcd solveAt(VertexId v);
  void mapAt(VertexId v, LiveFrame& frame);
  UvMap layOut(const Eigen::VectorXcd& x) const;
};

Status LiveEdit::State::anchor(const UvMap& map) {
  const TriMesh& mesh = surface.mesh();
  Result<SeamlessSetup> made = setUp(surface, spec);
  if (!made) return std::move(made).error();
  disc.reset();
  setup = std::make_unique<SeamlessSetup>(std::move(*made));
  Result<Eigen::VectorXcd> x = live::readMap(mesh, *setup, map);
  if (!x) return std::move(x).error();
  cut = std::make_unique<live::MovedCut>(mesh, setup->cut, setup->seams, setup->unknowns,
                                         cone.vertex);
  if (!field) field = std::make_unique<live::MovedField>(mesh, *setup->context);
  disc = live::DragDisc::make(mesh, *setup, cone.vertex, std::move(*x));
  lastSpec = spec;
  lastMap = map;
  last = cone.vertex;
  ++preparations;
  return Done{};
}

CompleteSpec LiveEdit::State::specAt(VertexId v) const {
  CompleteSpec out = spec;
  for (ConePoint& c : out.cones)
    if (c.vertex == cone.vertex) c.vertex = v;
  sortCones(out.cones);
  for (std::size_t i = 0; i < out.handles.size() && i < field->handleChange().size(); ++i)
    out.handles[i] = reduceTurn(out.handles[i] + field->handleChange()[i], out.q);
  return out;
}

PerVertex<double> LiveEdit::State::scale() const {
  PerVertex<double> u = setup->field.u;
  for (VertexId v : surface.mesh().vertices()) u[v] += field->scaleAt(v);
  return u;
}

UvMap LiveEdit::State::layOut(const Eigen::VectorXcd& x) const {
  const TriMesh& mesh = surface.mesh();
  UvMap map;
  map.cornerUv.resize(at(mesh.faceCount()));
  for (HalfedgeId h : mesh.halfedges())
    map.cornerUv[at(h.i / 3)][at(h.i % 3)] = setup->cut.copy[h].i;
  map.uv.resize(at(cut->uvCount()));
  const Eigen::VectorXcd z = setup->unknowns.copies * x;
  for (Eigen::Index i = 0; i < z.size(); ++i) map.uv[at(i)] = {z[i].real(), z[i].imag()};
  for (const live::MovedCut::Copy& copy : cut->copies()) {
    const Complex p = live::valueOf(copy.position, x);
    map.uv[at(copy.uv)] = {p.real(), p.imag()};
    for (HalfedgeId h : copy.corners) map.cornerUv[at(h.i / 3)][at(h.i % 3)] = copy.uv;
  }
  return map;
}

/// The unknown that is the position of w while the cone is at v; −1 where it is determined.
int LiveEdit::State::unknownOf(VertexId w, VertexId v) const {
  if (cut->reusedUnknown() < 0) return setup->unknowns.vertexUnknown[w];
  if (w == v) return -1;
  return w == cone.vertex ? cut->reusedUnknown() : setup->unknowns.vertexUnknown[w];
}

/// All unknowns with the cone at v; empty where there is no map.
Eigen::VectorXcd LiveEdit::State::solveAt(VertexId v) {
  if (cut->path().empty()) return disc->start();
  const live::DiscFrame frame = disc->frameAt(*cut, *field, v);
  const live::Mending mending{surface.mesh(),
                              *setup,
                              *cut,
                              v,
                              turnAngle(cone.k, spec.q),
                              [&](VertexId w) { return disc->hasRow(w, v); },
                              [&](VertexId w) { return unknownOf(w, v); },
                              [&](VertexId w) { return setup->field.u[w] + field->scaleAt(w); },
                              [&](FaceId f) { return disc->targetAt(*field, f); }};
  const Eigen::VectorXcd change = disc->solve(frame);
  if (change.size() == 0 || !change.allFinite()) return {};
  const bool isWrong =
      !live::wrongAmong(mending, disc->facesInside(), disc->changedInside(frame, change)).empty();
  if (isWrong)
    if (const Eigen::VectorXcd framed = disc->solveFramed(frame);
        framed.size() > 0 && framed.allFinite()) {
      Eigen::VectorXcd x = disc->changed(frame, framed);
      if (live::mend(mending, x)) return x;
    }
  Eigen::VectorXcd x = disc->changed(frame, change);
  live::mend(mending, x);
  return x;
}

void LiveEdit::State::mapAt(VertexId v, LiveFrame& frame) {
  const Eigen::VectorXcd x = solveAt(v);
  if (x.size() == 0) return;
  frame.map = layOut(x);
  frame.copyOf = setup->cut.parent.raw();
  frame.copyOf.resize(at(cut->uvCount()));
  for (const live::MovedCut::Copy& copy : cut->copies()) frame.copyOf[at(copy.uv)] = copy.vertex;
}

LiveEdit::LiveEdit(std::unique_ptr<State> state) : state_(std::move(state)) {}
LiveEdit::LiveEdit(LiveEdit&&) noexcept = default;
LiveEdit& LiveEdit::operator=(LiveEdit&&) noexcept = default;
LiveEdit::~LiveEdit() = default;

Result<LiveEdit> LiveEdit::begin(PreparedSurface& surface, const CompleteSpec& spec,
                                 const UvMap& map, VertexId cone) {
  const auto found = std::find_if(spec.cones.begin(), spec.cones.end(),
                                  [&](const ConePoint& c) { return c.vertex == cone; });
  if (found == spec.cones.end())
    return refuse(formatText("vertex %d is not a cone of this map; drag one that is", cone.i),
                  cone);
  HGP_CHECK(map.cornerUv.size() == at(surface.mesh().faceCount()), "%zu triangles have uv",
            map.cornerUv.size());
  auto state = std::make_unique<State>(surface, spec, *found);
  if (Status done = state->anchor(map); !done) return std::move(done).error();
  return LiveEdit(std::move(state));
}

Result<LiveFrame> LiveEdit::moveTo(VertexId v) {
  State& s = *state_;
  const TriMesh& mesh = s.surface.mesh();
  HGP_CHECK(v.i >= 0 && v.i < mesh.vertexCount() && !mesh.isIsolated(v), "vertex %d", v.i);
  if (mesh.isBoundary(v))
    return refuse(formatText("vertex %d is on the boundary, where no cone can be", v.i), v);
  for (const ConePoint& c : s.spec.cones)
    if (c.vertex == v && v != s.cone.vertex)
      return refuse(formatText("vertex %d is another cone; drop this one beside it", v.i), v);
  LiveFrame frame;
  frame.cone = v;
  std::vector<HalfedgeId> path;
  if (s.disc) path = s.disc->pathTo(v);
  const bool isReached = s.disc && (v == s.cone.vertex || !path.empty());
  s.cut->move(std::move(path));
  if (isReached)
    s.field->move(s.spec.q, s.cone, v, *s.cut);
  else
    s.field->moveScale(s.spec.q, s.cone, v);
  frame.u = s.scale();
  if (!isReached) {
    frame.spec = s.specAt(v);
    frame.wantsAnchor = s.disc != nullptr;
    return frame;
  }
  frame.spec = s.specAt(v);
  s.mapAt(v, frame);
  if (frame.map.uv.empty()) return frame;
  CertifyOptions verdict;
  verdict.measuresDistortion = false;
  frame.certificate = s.verifier.certify(toSpec(frame.spec), frame.map, verdict);
  frame.state = frame.certificate.isCertified ? LiveState::kCertified : LiveState::kFails;
  frame.wantsAnchor = frame.certificate.isCertified &&
                      static_cast<int>(s.cut->path().size()) + 1 >= s.disc->reach();
  if (frame.certificate.isCertified) {
    s.lastSpec = frame.spec;
    s.lastMap = frame.map;
    s.last = v;
  }
  return frame;
}

Status LiveEdit::beginHere() {
  State& s = *state_;
  if (s.last == s.cone.vertex) return Done{};
  s.cone.vertex = s.last;
  s.spec = s.lastSpec;
  const UvMap map = std::move(s.lastMap);
  return s.anchor(map);
}

Result<bool> LiveEdit::beginToward(VertexId v) {
  State& s = *state_;
  if (!s.disc) return false;
  int tries = 4;  // each costs a frame
  for (const VertexId to : s.disc->towards(v)) {
    if (to != s.last && tries-- > 0)
      if (const Result<LiveFrame> frame = moveTo(to); !frame) return frame.error();
    if (to != s.last) continue;  // its map is not certified
    if (Status done = beginHere(); !done) return std::move(done).error();
    return true;
  }
  return false;
}

LiveEdit::Reached LiveEdit::reached() const {
  const TriMesh& mesh = state_->surface.mesh();
  Reached out{state_->lastSpec, {}, {}};
  out.map.cornerUv = state_->lastMap.cornerUv;
  std::vector<int> name(state_->lastMap.uv.size(), -1);
  for (HalfedgeId h : mesh.halfedges()) {
    int& corner = out.map.cornerUv[at(h.i / 3)][at(h.i % 3)];
    int& renamed = name[at(corner)];
    if (renamed < 0) {
      renamed = static_cast<int>(out.map.uv.size());
      out.map.uv.push_back(state_->lastMap.uv[at(corner)]);
      out.copyOf.push_back(mesh.tail(h));
    }
    corner = renamed;
  }
  return out;
}

ConePoint LiveEdit::cone() const { return {state_->last, state_->cone.k}; }
int LiveEdit::preparations() const { return state_->preparations; }

}  // namespace hgp
