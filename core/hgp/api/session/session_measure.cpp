// Measurements of a result and of a surface beyond those of the verifier.
#include <algorithm>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/seams/chains.h"
#include "hgp/verify/face_values.h"
#include "hgp/verify/orientation.h"

namespace hgp::api {
namespace {

/// The triangles covered by the certificate without positive uv area, each with the orientation in which it was
/// verified: a triangle that repairs reversed does not count as flipped, and copies that were left out do not count.
std::vector<int> notPositiveAsVerified(const Model& model, const UvMap& map) {
  std::vector<int> found;
  for (int f = 0; f < model.faceOrigin.size(); ++f) {
    std::array<Vec2, 3> uv;
    for (int k = 0; k < 3; ++k) {
      const int corner = model.cornerOrigin[MeshCornerId{3 * f + k}].i;
      uv[at(k)] = map.uv[at(map.cornerUv[at(corner / 3)][at(corner % 3)])];
    }
    if (orientationSign(uv[0], uv[1], uv[2]) <= 0)
      found.push_back(model.faceOrigin[MeshFaceId{f}].i);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The chain of every seam edge, component after component.
std::vector<std::uint32_t> seamChains(const Model& model, const StoredMap& stored, int q) {
  std::vector<std::uint32_t> out;
  int count = 0;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    std::vector<EdgeId> edges;
    std::vector<int> turn;
    for (const MeasuredSeam& seam : stored.certificates[p].seams.seams) {
      edges.push_back(seam.edge);
      turn.push_back(seam.r);
    }
    int next = count;
    for (const int chain : chainsOfEdges(model.components[p].mesh, edges, turn, q)) {
      out.push_back(static_cast<std::uint32_t>(count + chain));
      next = std::max(next, count + chain + 1);
    }
    count = next;
  }
  return out;
}

}  // namespace

Result<MapMeasures> Session::measure() const {
  return guarded([&]() -> Result<MapMeasures> {
    if (!hasResult()) return Failure{ErrorCode::kUsage, "measure", "there is no result yet", {}};
    const State& shown = state_->shown();
    const UvMap& map = shown.solved->stored.map;
    FaceValues faces =
        measureFaces(shown.model->source().mesh, map, componentOfTriangle(*shown.model));
    OverlapPairs overlaps = findOverlapPairs(map);
    MapMeasures out;
    out.stretch = std::move(faces.stretch);
    out.logArea = std::move(faces.logArea);
    out.notPositive = shown.model->isChanged ? notPositiveAsVerified(*shown.model, map)
                                             : std::move(faces.notPositive);
    out.surfaceArea = faces.surfaceArea;
    out.uvArea = faces.uvArea;
    out.overlapPairs = overlaps.pairs;
    out.overlapping = std::move(overlaps.triangles);
    out.areMorePairs = overlaps.isMore;
    out.seamChain = seamChains(*shown.model, shown.solved->stored, shown.solved->prescription.q);
    return out;
  });
}

Result<SurfaceLoops> Session::loops() const {
  return guarded([&]() -> Result<SurfaceLoops> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    const Model& model = *state_->model;
    SurfaceLoops out;
    out.boundaries.resize(model.topology.loops.size());
    for (const ModelComponent& part : model.components) {
      for (std::size_t j = 0; j < part.topology.loops.size(); ++j) {
        std::vector<int>& loop = out.boundaries[at(part.loop[LoopId{static_cast<int>(j)}].i)];
        for (const HalfedgeId h : part.topology.loops[j].halfedges)
          loop.push_back(part.vertex[part.mesh.tail(h)].i);
      }
      if (part.topology.genus == 0) continue;
      for (const DualLoop& generator : handleGenerators(part.mesh)) {
        std::vector<std::array<int, 2>> crossed;
        crossed.reserve(generator.crossed.size());
        for (const HalfedgeId h : generator.crossed)
          crossed.push_back({part.vertex[part.mesh.tail(h)].i, part.vertex[part.mesh.head(h)].i});
        out.handles.push_back(std::move(crossed));
      }
    }
    return out;
  });
}

SolvedTriangles Session::solvedTriangles() const {
  SolvedTriangles out;
  if (!hasResult()) return out;
  const Model& model = *state_->shown().model;
  const UvMap& map = state_->shown().solved->stored.map;
  const auto& stored = model.source().mesh.triangles;
  const auto corners = at(model.cornerOrigin.size());
  out.triangles.reserve(corners);
  out.cornerToUv.reserve(corners);
  out.origin.reserve(corners / 3);
  for (int c = 0; c < model.cornerOrigin.size(); ++c) {
    const int from = model.cornerOrigin[MeshCornerId{c}].i;
    out.triangles.push_back(static_cast<std::uint32_t>(stored[at(from / 3)][at(from % 3)]));
    out.cornerToUv.push_back(static_cast<std::uint32_t>(map.cornerUv[at(from / 3)][at(from % 3)]));
    if (c % 3 == 0) out.origin.push_back(static_cast<std::uint32_t>(from / 3));
  }
  return out;
}

}  // namespace hgp::api
