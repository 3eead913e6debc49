#include <algorithm>
#include <cctype>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/quads_on_input.h"
#include "hgp/api/session/session_state.h"
#include "hgp/quads/cut_strips.h"
#include "hgp/quads/multiple_edges.h"
#include "hgp/quads/quad_shapes.h"
#include "hgp/quads/unfold.h"

namespace hgp::api {
namespace {

/// The quads of one component without edges that files cannot tell apart: strips are cut where there are some and,
/// should that fail, all cells.
Result<QuadMesh> quadsOf(const TriMesh& mesh, const UvMap& map, int q,
                         const std::vector<EdgeId>& features, QuadFile& out) {
  Result<QuadMesh> quads = extractQuads(mesh, map, q, 0, features);
  if (!quads) return quads;
  const int pairs = countMultipleEdges(*quads).pairs;
  out.multipleEdges += pairs;
  if (pairs == 0) return quads;
  if (Result<CutQuads> cut = cutStrips(mesh, map, q, features)) {
    out.cuts += cut->cuts;
    out.replaced += cut->replaced;
    return std::move(cut->quads);
  }
  for (int halvings = 1; halvings <= kMaxHalvings; ++halvings) {
    out.halvings = std::max(out.halvings, halvings);
    quads = extractQuads(mesh, map, q, halvings, features);
    if (!quads || countMultipleEdges(*quads).pairs == 0) break;
  }
  return quads;
}

/// "obj" for names without an extension; empty where quads are not written in that format.
std::string formatOf(const std::string& name) {
  if (name.empty() || name == "-") return "obj";
  const std::string extension = extensionOf(name);
  return extension == "obj" || extension == "ply" || extension == "glb" ? extension : "";
}

}  // namespace

bool Session::isAligned() const { return isCertified() && state_->shown().solved->isAligned; }

Status canWriteQuads(const std::string& name) {
  if (!formatOf(name).empty()) return Done{};
  return Failure{
      ErrorCode::kUsage,
      "quads",
      formatText("quads are written as .obj or .ply, or as .glb of triangles, and not as "
                 "'%s': choose one of these names",
                 name.c_str()),
      {}};
}

Result<QuadFile> Session::quads(const std::string& name, const io::Resolver& resolve) const {
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
    const Model& model = *state_->shown().model;
    const StoredMap& stored = state_->shown().solved->stored;
    QuadsOnInput all(model);
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      const ModelComponent& component = model.components[p];
      Result<QuadMesh> part =
          quadsOf(component.mesh, mapOfComponent(component, stored.map), stored.certificates[p].q,
                  state_->shown().solved->components[p].spec.features, out);
      if (!part) return toSurfaceIds(model, component, part.error());
      unfoldInSpace(component.mesh, *part);
      out.foldedQuads += countMultipleEdges(*part).foldedQuads;
      out.foldedInSpace += countFoldedInSpace(*part);
      out.vertices += static_cast<int>(part->positions.size());
      out.quads += static_cast<int>(part->quads.size());
      out.clipped += part->clipped;
      all.add(component, *part);
    }
    const std::string format = formatOf(name);
    QuadsOnInput::File file = all.file(format, std::string("hgp ") + version(), resolve);
    out.bytes = std::move(file.bytes);
    out.notes = std::move(file.notes);
    out.acrossSeams = all.acrossSeams();
    return out;
  });
}

}  // namespace hgp::api
