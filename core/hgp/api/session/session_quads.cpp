#include <algorithm>
#include <cctype>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/quads/cut_strips.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/quad_shapes.h"
#include "hgp/quads/unfold.h"
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

/// The quads of one component without edges that files cannot tell apart: strips are cut where there are some and,
/// should that fail, all cells.
Result<QuadMesh> quadsOf(const TriMesh& mesh, const UvMap& map, int q, QuadFile& out) {
  Result<QuadMesh> quads = extractQuads(mesh, map, q);
  if (!quads) return quads;
  const int pairs = countMultipleEdges(*quads).pairs;
  out.multipleEdges += pairs;
  if (pairs == 0) return quads;
  if (Result<CutQuads> cut = cutStrips(mesh, map, q)) {
    out.cuts += cut->cuts;
    out.replaced += cut->replaced;
    return std::move(cut->quads);
  }
  for (int halvings = 1; halvings <= kMaxHalvings; ++halvings) {
    out.halvings = std::max(out.halvings, halvings);
    quads = extractQuads(mesh, map, q, halvings);
    if (!quads || countMultipleEdges(*quads).pairs == 0) break;
  }
  return quads;
}

bool endsWith(const std::string& name, std::string_view end) {
  return name.size() > end.size() &&
         std::equal(end.rbegin(), end.rend(), name.rbegin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

}  // namespace

bool Session::isAligned() const { return isCertified() && state_->shown().solved->isAligned; }

Status canWriteQuads(const std::string& name) {
  if (name.empty() || name == "-" || endsWith(name, ".obj") || endsWith(name, ".glb"))
    return Done{};
  return Failure{ErrorCode::kUsage,
                 "quads",
                 formatText("quads are written as .obj, or as .glb of triangles, and not as '%s': "
                            "choose one of these names",
                            name.c_str()),
                 {}};
}

Result<QuadFile> Session::quads(const std::string& name) const {
  return guarded([&]() -> Result<QuadFile> {
    if (Status possible = canWriteQuads(name); !possible) return possible.error();
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
    const Model& model = *state_->shown().model;
    const StoredMap& stored = state_->shown().solved->stored;
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      const ModelComponent& component = model.components[p];
      Result<QuadMesh> part = quadsOf(component.mesh, mapOfComponent(component, stored.map),
                                      stored.certificates[p].q, out);
      if (!part) return toSurfaceIds(model, component, part.error());
      unfoldInSpace(component.mesh, *part);
      append(*part, all);
    }
    out.foldedQuads = countMultipleEdges(all).foldedQuads;
    out.foldedInSpace = countFoldedInSpace(all);
    out.vertices = static_cast<int>(all.positions.size());
    out.quads = static_cast<int>(all.quads.size());
    out.clipped = all.clipped;
    const std::string generator = std::string("hgp ") + version();
    if (endsWith(name, ".glb")) {
      out.bytes = quadsAsGlb(all, generator);
    } else {
      const std::string text = quadsAsObj(all, generator);
      out.bytes.assign(text.begin(), text.end());
    }
    return out;
  });
}

}  // namespace hgp::api
