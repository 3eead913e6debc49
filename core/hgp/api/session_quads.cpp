#include "hgp/api/guard.h"
#include "hgp/api/session_state.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/write_quads.h"

namespace hgp::api {
namespace {

void append(const QuadMesh& part, QuadMesh& all) {
  const int first = static_cast<int>(all.positions.size());
  all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
  all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
  for (const auto& q : part.quads)
    all.quads.push_back({q[0] + first, q[1] + first, q[2] + first, q[3] + first});
  all.clipped += part.clipped;
}

Result<QuadMesh> quadsOf(const Model& model, const StoredMap& stored, int halvings) {
  QuadMesh all;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    Result<QuadMesh> part = extractQuads(component.mesh, mapOfComponent(component, stored.map),
                                         stored.certificates[p].q, halvings);
    if (!part) return toSurfaceIds(model, component, part.error());
    append(*part, all);
  }
  return all;
}

}  // namespace

bool Session::isAligned() const { return isCertified() && state_->shown().solved->isAligned; }

Result<QuadFile> Session::quads(const std::string& name) const {
  return guarded([&]() -> Result<QuadFile> {
    if (!hasResult()) return Failure{ErrorCode::kUsage, "quads", "there is no result yet", {}};
    if (!isAligned()) {
      return Failure{ErrorCode::kNoMap,
                     "quads",
                     "the map is not aligned to a grid; the report says why and names a number of "
                     "cells that works",
                     {}};
    }
    QuadFile out;
    QuadMesh all;
    for (;; ++out.halvings) {
      Result<QuadMesh> quads =
          quadsOf(*state_->shown().model, state_->shown().solved->stored, out.halvings);
      if (!quads) return quads.error();
      all = std::move(*quads);
      const MultipleEdges multiple = countMultipleEdges(all);
      if (out.halvings == 0) out.multipleEdges = multiple.pairs;
      out.foldedQuads = multiple.foldedQuads;
      if (multiple.pairs == 0 || out.halvings == kMaxHalvings) break;
    }
    out.vertices = static_cast<int>(all.positions.size());
    out.quads = static_cast<int>(all.quads.size());
    out.clipped = all.clipped;
    const std::string generator = std::string("hgp ") + version();
    const bool isGlb = name.size() > 4 && name.compare(name.size() - 4, 4, ".glb") == 0;
    if (isGlb) {
      out.bytes = quadsAsGlb(all, generator);
    } else {
      const std::string text = quadsAsObj(all, generator);
      out.bytes.assign(text.begin(), text.end());
    }
    return out;
  });
}

}  // namespace hgp::api
