// Cones that are completed, and cones that move to another reading of a surface.
#include <algorithm>
#include <map>
#include <set>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/cones/balance_cones.h"
#include "hgp/io/cone_files.h"

namespace hgp::api {
namespace {

/// Where the vertices of one reading are in another one.
class VertexPlaces {
 public:
  enum class Kind { kFound, kRemoved, kGone, kSeveral };
  struct Place {
    Kind kind = Kind::kGone;
    int vertex = -1;
    int count = 0;
  };

  VertexPlaces(const MeshData& before, const MeshData& now, const SurfaceFacts& facts)
      : before_(before), facts_(facts) {
    isSame_ = before.positions == now.positions && before.triangles == now.triangles;
    if (isSame_) return;
    for (std::size_t v = 0; v < now.positions.size(); ++v)
      if (facts.representative[v] >= 0 && facts.component[v] >= 0)
        at_[now.positions[v]].insert(facts.representative[v]);
  }

  /// Whether both readings have the same vertices and triangles, so that ids stay.
  bool isSame() const { return isSame_; }

  Place operator()(int vertex) const {
    if (vertex < 0 || at(vertex) >= before_.positions.size()) return {};
    if (isSame_) {
      const int image = facts_.representative[at(vertex)];
      return {image < 0 ? Kind::kRemoved : Kind::kFound, image, 1};
    }
    const auto found = at_.find(before_.positions[at(vertex)]);
    if (found == at_.end()) return {};
    const auto count = static_cast<int>(found->second.size());
    return {count > 1 ? Kind::kSeveral : Kind::kFound, *found->second.begin(), count};
  }

 private:
  const MeshData& before_;
  const SurfaceFacts& facts_;
  bool isSame_ = false;
  std::map<Vec3, std::set<int>> at_;  ///< by position, exactly
};

class Mover {
 public:
  Mover(const prescription::Prescription& cones, const VertexPlaces& places,
        const SurfaceFacts& facts)
      : cones_(cones), places_(places), facts_(facts) {}

  MovedCones take(const SurfaceLoops& before, const SurfaceLoops& now) {
    out_.cones.q = cones_.q;
    out_.cones.hasCones = cones_.hasCones;
    for (const prescription::PrescribedCone& cone : cones_.cones) moveCone(cone);
    for (const prescription::PrescribedTurning& turning : cones_.boundaries)
      moveTurning(turning, before, now);
    for (const prescription::PrescribedHandle& handle : cones_.handles)
      moveHandle(handle, before, now);
    return std::move(out_);
  }

 private:
  void lose(const char* code, int vertex, std::vector<NoteValue> more = {}) {
    std::vector<NoteValue> values = {{"vertex", vertex}};
    values.insert(values.end(), more.begin(), more.end());
    out_.lost.emplace_back(code, std::move(values));
  }

  void moveCone(const prescription::PrescribedCone& cone) {
    const VertexPlaces::Place to = places_(cone.vertex);
    switch (to.kind) {
      case VertexPlaces::Kind::kRemoved:
        return lose("moved-cone-removed", cone.vertex);
      case VertexPlaces::Kind::kGone:
        return lose("moved-cone-gone", cone.vertex);
      case VertexPlaces::Kind::kSeveral:
        return lose("moved-cone-several", cone.vertex, {{"count", to.count}});
      case VertexPlaces::Kind::kFound:
        break;
    }
    if (facts_.isBoundary[at(to.vertex)] != 0) return lose("moved-cone-boundary", cone.vertex);
    const int triangle = places_.isSame() ? cone.triangle : -1;
    const auto [there, isNew] = taken_.try_emplace({to.vertex, triangle}, cone.vertex);
    if (!isNew) return lose("moved-cone-joined", cone.vertex, {{"other", there->second}});
    out_.cones.cones.push_back({to.vertex, cone.k, std::nullopt, triangle});
  }

  static int indexOf(int vertex, const SurfaceLoops& loops) {
    for (std::size_t j = 0; j < loops.boundaries.size(); ++j) {
      const std::vector<int>& loop = loops.boundaries[j];
      if (std::find(loop.begin(), loop.end(), vertex) != loop.end()) return static_cast<int>(j);
    }
    return -1;
  }

  /// A loop is found by a vertex on it; where both readings have one loop only, it is that.
  void moveTurning(const prescription::PrescribedTurning& turning, const SurfaceLoops& before,
                   const SurfaceLoops& now) {
    int to = before.boundaries.size() == 1 && now.boundaries.size() == 1 ? 0 : -1;
    if (to < 0 && turning.loop >= 0 && at(turning.loop) < before.boundaries.size()) {
      for (const int v : before.boundaries[at(turning.loop)]) {
        const VertexPlaces::Place place = places_(v);
        if (place.kind == VertexPlaces::Kind::kFound) to = indexOf(place.vertex, now);
        if (to >= 0) break;
      }
    }
    if (to < 0) {
      out_.lost.push_back(Note("moved-turning-gone", {{"loop", turning.loop}}));
      return;
    }
    out_.cones.boundaries.push_back({to, turning.l, -1});
  }

  /// Generators follow from the triangles, so that a rotation is kept where they are the same.
  void moveHandle(const prescription::PrescribedHandle& handle, const SurfaceLoops& before,
                  const SurfaceLoops& now) {
    const auto g = static_cast<std::size_t>(handle.generator);
    const bool isThere = places_.isSame() && handle.generator >= 0 && g < before.handles.size() &&
                         g < now.handles.size() && before.handles[g] == now.handles[g];
    if (isThere)
      out_.cones.handles.push_back(handle);
    else
      out_.lost.push_back(Note("moved-handle-gone", {{"generator", handle.generator}}));
  }

  const prescription::Prescription& cones_;
  const VertexPlaces& places_;
  const SurfaceFacts& facts_;
  MovedCones out_;
  std::map<std::pair<int, int>, int> taken_;
};

Failure fieldRefused(const char* what) {
  return {ErrorCode::kUsage,
          "cones",
          formatText("%s takes cones; a field and features have their own", what),
          {}};
}

bool isOnlyCones(const prescription::Prescription& p) {
  return !p.field && p.features.isEmpty() && p.totalAngles.empty();
}

}  // namespace

Result<std::string> Session::balance(const prescription::Prescription& prescription) const {
  return guarded([&]() -> Result<std::string> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    if (prescription.field || !prescription.features.isEmpty()) return fieldRefused("balance");
    const Model& model = *state_->model;
    Result<Request> request = resolve(model, prescription);
    if (!request) return request.error();
    std::vector<HolonomySpec> specs;
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      Result<HolonomySpec> spec =
          balanceCones(state_->surfaceOf(p), std::move(request->components[p].spec));
      state_->dropLarge(p);
      if (!spec) return toSurfaceIds(model, model.components[p], spec.error());
      specs.push_back(std::move(*spec));
    }
    return prescription::writeConesJson(describe(model, specs));
  });
}

Result<MovedCones> Session::transfer(const prescription::Prescription& prescription,
                                     const Session& from) const {
  return guarded([&]() -> Result<MovedCones> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    if (!from.state_->model) return notLoaded();
    if (!isOnlyCones(prescription)) return fieldRefused("transfer");
    const Result<SurfaceFacts> now = facts();
    if (!now) return now.error();
    // Readings that cannot be solved have no loops.
    const Result<SurfaceLoops> before = from.loops(), after = loops();
    if (!after) return after.error();
    const VertexPlaces places(from.state_->model->source().mesh, state_->model->source().mesh,
                              *now);
    MovedCones moved =
        Mover(prescription, places, *now).take(before ? *before : SurfaceLoops(), *after);
    for (prescription::PrescribedCone& cone : moved.cones.cones)
      cone.position = state_->model->source().mesh.positions[at(cone.vertex)];
    moved.cones.sha256 = state_->model->sha256;
    moved.json = prescription::writeConesJson(moved.cones);
    return moved;
  });
}

}  // namespace hgp::api
