#include "hgp/io/gltf/patch/remesh.h"

#include <algorithm>
#include <map>
#include <set>

#include "hgp/base/ids.h"
#include "hgp/io/gltf/patch/blend_attributes.h"
#include "hgp/io/gltf/patch/writer.h"
#include "hgp/mesh/refine.h"

namespace hgp::io {
namespace {

struct SharedAttribute {
  GltfAttributeOf of;
  std::vector<int> accessors;  ///< by pool
  std::set<int> references;
};
using SharedAttributes = std::map<std::pair<int, std::string>, SharedAttribute>;

/// Adds the attributes of a primitive; false where another one of its pool has another accessor.
bool share(const JsonText& json, int owner, const GltfAttributes& names, int target,
           const GltfRun& run, std::size_t pools, SharedAttributes& out) {
  for (const auto& [name, accessor] : names) {
    SharedAttribute& one = out[{target, name}];
    if (one.accessors.empty()) {
      one.of = {name, target, std::vector<int>(pools, -1)};
      one.accessors.assign(pools, -1);
    }
    int& known = one.accessors[at(run.pool)];
    if (known >= 0 && known != accessor) return false;
    known = accessor;
    one.of.primitive[at(run.pool)] = run.primitive;
    one.references.insert(json.find(owner, name));
  }
  return true;
}

}  // namespace

/// A primitive that has no triangles any more.
void GltfWriter::dropPrimitive(int p) {
  const int node = primitiveNodes_[at(p)];
  std::vector<int> owners = json_.children(json_.find(node, "targets"));
  owners.push_back(json_.find(node, "attributes"));
  for (const int owner : owners)
    for (const int reference : json_.children(owner)) droppedAttributes_.insert(reference);
  droppedAttributes_.insert(json_.find(node, "indices"));
  droppedDraco_ += primitive(p).draco ? 1 : 0;
  patch_.remove(node);
}

Status GltfWriter::remesh(const GltfSurface& part, const GltfRemesh& mesh) {
  begin(part);
  SharedAttributes shared;
  const std::size_t pools = part.pools.size();
  for (std::size_t r = 0; r < part.runs.size(); ++r) {
    const GltfRun& run = part.runs[r];
    if (mesh.triangles[r].empty()) {
      dropPrimitive(run.primitive);
      continue;
    }
    const GltfPrimitive& source = primitive(run.primitive);
    const int node = primitiveNodes_[at(run.primitive)];
    const std::vector<int> targets = json_.children(json_.find(node, "targets"));
    bool isShared =
        share(json_, json_.find(node, "attributes"), source.attributes, -1, run, pools, shared);
    for (std::size_t t = 0; t < targets.size(); ++t)
      isShared = isShared && share(json_, targets[t], source.targets[t], static_cast<int>(t), run,
                                   pools, shared);
    if (!isShared)
      return Failure{ErrorCode::kUnsupported,
                     "write",
                     "primitives that share their vertices differ in an attribute",
                     {}};
    const int wanted =
        source.indices >= 0 ? accessor(source.indices).componentType : kGltfUnsignedShort;
    planIndices(run, mesh.triangles[r],
                indexTypeFor(wanted, static_cast<int>(mesh.vertices.size())));
    if (source.mode != 4) patch_.set(node, "mode", "4");
    dropDraco(run.primitive);
  }
  const GltfBlender blender(store_, part, mesh.vertices);
  for (const auto& [key, one] : shared) {
    const bool isGiven = key == std::pair(-1, std::string("POSITION")) && !mesh.positions.empty();
    Result<GltfBlended> blended = isGiven
                                      ? Result<GltfBlended>(GltfBlender::positions(mesh.positions))
                                      : blender.blend(one.of);
    if (!blended) return blended.error();
    planShared(one.accessors, one.references, std::move(*blended), mesh.vertices.size());
  }
  dropOld();
  return Done{};
}

/// What described the old triangles.
void GltfWriter::dropOld() {
  if (json_.find(json_.find(meshNode_, "extensions"), "EXT_mesh_manifold") >= 0)
    dropManifold("write-manifold-other");
  const int extras = json_.find(meshNode_, "extras"), cones = json_.find(extras, kGltfConesKey);
  if (cones >= 0) patch_.remove(cones);
  if (cones >= 0 && patch_.isEmptied(extras)) patch_.remove(extras);
}

/// One accessor for all pools; those that nothing else reads show the same data, so that their old bytes are free.
void GltfWriter::planShared(const std::vector<int>& accessors, const std::set<int>& references,
                            GltfBlended blended, std::size_t count) {
  const int first = *std::find_if(accessors.begin(), accessors.end(), [](int a) { return a >= 0; });
  const std::uint64_t size = gltfComponentSize(blended.componentType) *
                             static_cast<std::uint64_t>(accessor(first).components());
  const auto freshOf = [&](int old) {
    GltfNewAccessor fresh;
    fresh.target = 34962;
    fresh.stride = blended.stride == size ? 0 : blended.stride;
    fresh.members["count"] = std::to_string(count);
    if (blended.componentType != accessor(old).componentType ||
        blended.isNormalized != accessor(old).isNormalized) {
      fresh.members["componentType"] = std::to_string(blended.componentType);
      fresh.members["normalized"] = blended.isNormalized ? "true" : "false";
    }
    setRange(fresh, old, blended.data);
    return fresh;
  };
  std::vector<GltfNewAccessor> aliases;
  for (const int old : std::set<int>(accessors.begin(), accessors.end())) {
    if (old < 0 || old == first || !areReferencesKnown_) continue;
    const auto& all = accessorReferences_[old];
    if (!std::all_of(all.begin(), all.end(), [&](int node) {
          return references.count(node) > 0 || droppedAttributes_.count(node) > 0;
        }))
      continue;
    aliases.push_back(freshOf(old));
    aliases.back().index = old;
    aliases.back().node = accessorNodes_[at(old)];
    aliases.back().oldView = accessor(old).view;
    freedNodes_.insert(json_.find(aliases.back().node, "bufferView"));
  }
  GltfNewAccessor fresh = freshOf(first);
  fresh.data = std::move(blended.data);
  const int planned = redirect(first, references, std::move(fresh));
  const int index = fresh_[at(planned)].index;
  for (const int reference : references)
    if (json_.integer(reference) != index) patch_.replace(reference, std::to_string(index));
  for (GltfNewAccessor& alias : aliases) {
    alias.sharedWith = planned;
    fresh_.push_back(std::move(alias));
  }
  droppedAttributes_.insert(references.begin(), references.end());
}

Result<Written> remeshGltf(const GltfStore& store, const GltfSurface& part, const GltfRemesh& mesh,
                           const WriteOptions& options) {
  GltfWriter writer(store, options);
  if (Status planned = writer.remesh(part, mesh); !planned) return planned.error();
  return writer.finish();
}

GltfRemesh splitGltfEdges(const GltfSurface& part, const MeshData& welded,
                          const std::vector<std::array<int, 2>>& edges) {
  const RefinedMesh refined = splitEdges(welded, edges);
  GltfRemesh out;
  const auto stored = static_cast<int>(part.welded.size());
  for (int v = 0; v < stored; ++v) out.vertices.push_back(blendOf({v, v, v}, {1, 0, 0}));
  // Midpoints by number and, where attributes have a seam, by the stored vertices between which they are.
  std::map<std::pair<int, Blend>, int> midpoints;
  const auto cornerAt = [&](std::size_t face, std::size_t k) {
    const auto& old = part.stored[at(refined.faceOrigin[face])];
    const auto& [i, j] = refined.cornerOrigin[face][k];
    return blendOf({old[at(i)], old[at(j)], -1}, {0.5, 0.5, 0});
  };
  const auto isNew = [](const Blend& blend) { return !blend.isOne(); };
  const auto& faces = refined.mesh.triangles;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (const Blend blend = cornerAt(f, k); isNew(blend)) midpoints[{faces[f][k], blend}] = 0;
  for (auto& [key, vertex] : midpoints) {
    vertex = static_cast<int>(out.vertices.size());
    out.vertices.push_back(key.second);
  }
  std::size_t f = 0;
  for (const GltfRun& run : part.runs) {
    auto& triangles = out.triangles.emplace_back();
    for (; f < faces.size() && refined.faceOrigin[f] < run.firstTriangle + run.triangleCount; ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Blend blend = cornerAt(f, k);
        triangles.push_back(static_cast<std::uint32_t>(
            isNew(blend) ? midpoints.at({faces[f][k], blend}) : blend.of[0]));
      }
  }
  return out;
}

}  // namespace hgp::io
