#include "hgp/io/gltf/gltf_writer.h"

#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/io/gltf/gltf_check.h"

namespace hgp::io {
namespace {

/// All missing sets below the chosen one must be filled; this limits how many.
constexpr int kHighestSet = 15;

Bytes bytesOf(const std::vector<float>& values) {
  Bytes out(values.size() * sizeof(float));
  if (!values.empty()) std::memcpy(out.data(), values.data(), out.size());
  return out;
}

}  // namespace

GltfWriter::GltfWriter(const GltfStore& store, const GltfSurface& part, const WriteOptions& options)
    : store_(store),
      json_(store.json),
      part_(part),
      options_(options),
      patch_(store.json),
      layout_(store, patch_) {
  const auto list = [&](const char* name) {
    return json_.children(json_.find(JsonText::kRoot, name));
  };
  accessorNodes_ = list("accessors");
  newAccessorCount_ = static_cast<int>(accessorNodes_.size());
  meshNode_ = list("meshes")[static_cast<std::size_t>(part.mesh)];
  primitiveNodes_ = json_.children(json_.find(meshNode_, "primitives"));
  areReferencesKnown_ = areGltfReferencesKnown(json_);
  for (int node : gltfReferences(json_, "accessors")) {
    accessorReferences_[static_cast<int>(*json_.integer(node))].push_back(node);
  }
}

Result<Written> GltfWriter::run(const UvMap& map) {
  auto splits = splitForUv(part_, map);
  if (!splits) return splits.error();
  splits_ = std::move(*splits);
  Status status = chooseSet();
  if (!status) return status.error();
  for (std::size_t p = 0; p < part_.pools.size(); ++p) planPool(static_cast<int>(p));
  tellOrPointMaterials();
  if (isRewritten_ || !part_.copy.empty()) rewriteManifold();
  placeAccessors();
  dropUnusedExtensions();
  status = embedCones();
  if (!status) return status.error();
  return finish();
}

Status GltfWriter::chooseSet() {
  set_ = options_.uvSet;
  const auto isTaken = [&](int set) {
    return std::any_of(part_.runs.begin(), part_.runs.end(), [&](const GltfRun& run) {
      return primitive(run.primitive).attribute(semantic(set)) >= 0;
    });
  };
  // After the last set, even if an earlier one is missing: the last set is the one that is verified.
  if (set_ < 0) {
    set_ = kHighestSet + 1;
    while (set_ > 0 && !isTaken(set_ - 1)) --set_;
  }
  if (set_ <= kHighestSet) return Done{};
  return Failure{
      ErrorCode::kUsage,
      "write",
      formatText("uv set %d cannot be written; choose one from 0 to %d", set_, kHighestSet),
      {}};
}

void GltfWriter::planPool(int pool) {
  const GltfPool& source = part_.pools[static_cast<std::size_t>(pool)];
  for (int p : source.primitives) dropTangents(p);
  const std::size_t copies = splits_.pools[static_cast<std::size_t>(pool)].copyOf.size();
  if (copies > 0 || isDraco(pool)) {
    isRewritten_ = true;
    rewriteAttributes(pool);
    for (const GltfRun& run : part_.runs) {
      if (run.pool == pool) rewriteIndices(run);
    }
    for (int p : source.primitives) dropDraco(p);
  } else {
    for (const GltfRun& run : part_.runs) {
      if (run.pool == pool && isEdited(run)) rewriteIndices(run);
    }
  }
  if (copies > 0) {
    note(formatText("%d vertices became %zu along seams", source.vertexCount,
                    static_cast<std::size_t>(source.vertexCount) + copies));
  }
  planUv(pool);
}

bool GltfWriter::isDraco(int pool) const {
  const std::vector<int>& list = part_.pools[static_cast<std::size_t>(pool)].primitives;
  return std::any_of(list.begin(), list.end(),
                     [&](int p) { return primitive(p).draco.has_value(); });
}

/// Whether repairs changed a triangle of the run.
bool GltfWriter::isEdited(const GltfRun& run) const {
  if (part_.copy.empty()) return false;
  const auto first = part_.copy.begin() + run.firstTriangle;
  return std::any_of(first, first + run.triangleCount,
                     [](const auto& c) { return c[0] != GltfSurface::kUnedited; });
}

void GltfWriter::planUv(int pool) {
  const GltfSplit& split = splits_.pools[static_cast<std::size_t>(pool)];
  GltfNewAccessor& fresh = fresh_.emplace_back();
  fresh.index = newAccessorCount_++;
  fresh.base = "{}";
  fresh.members = {{"componentType", "5126"},
                   {"count", std::to_string(split.uv.size() / 2)},
                   {"type", "\"VEC2\""}};
  fresh.data = bytesOf(split.uv);
  fresh.target = 34962;
  for (int p : part_.pools[static_cast<std::size_t>(pool)].primitives) {
    const int attributes = json_.find(primitiveNodes_[static_cast<std::size_t>(p)], "attributes");
    for (int set = 0; set <= set_; ++set) {
      const int old = json_.find(attributes, semantic(set));
      if (old >= 0 && set < set_) continue;
      if (old < 0 && set < set_) {
        note(formatText("primitive %d had no TEXCOORD_%d; it has the new uv there too", p, set));
      }
      patch_.set(attributes, semantic(set), std::to_string(fresh.index));
    }
  }
}

bool GltfWriter::isNormalMapFed(int p) const {
  const int material = primitive(p).material;
  if (material < 0) return false;
  const std::vector<int> materials = json_.children(json_.find(JsonText::kRoot, "materials"));
  const int map = json_.find(materials[static_cast<std::size_t>(material)], "normalTexture");
  if (map < 0) return false;
  const int transform = json_.find(json_.find(map, "extensions"), "KHR_texture_transform");
  const auto moved = json_.integer(json_.find(transform, "texCoord"));
  return moved.value_or(json_.integer(json_.find(map, "texCoord")).value_or(0)) == set_;
}

void GltfWriter::dropTangents(int p) {
  if (primitive(p).attribute(semantic(set_)) < 0) return;
  const int node = primitiveNodes_[static_cast<std::size_t>(p)];
  const int attributes = json_.find(node, "attributes");
  droppedAttributes_.insert(json_.find(attributes, semantic(set_)));
  if (!isNormalMapFed(p)) return;
  std::vector<int> owners = json_.children(json_.find(node, "targets"));
  owners.push_back(attributes);
  for (int owner : owners) {
    const int tangent = json_.find(owner, "TANGENT");
    if (tangent < 0) continue;
    droppedAttributes_.insert(tangent);
    patch_.remove(tangent);
    if (owner == attributes) {
      note(formatText("primitive %d: TANGENT dropped, it belonged to the replaced TEXCOORD_%d", p,
                      set_));
    }
  }
}

Status GltfWriter::embedCones() {
  if (!options_.cones) return Done{};
  const auto cones = JsonText::parse(*options_.cones);
  if (!cones || !cones->isObject(JsonText::kRoot)) {
    return Failure{
        ErrorCode::kWriteFailed, "write", "the cones to embed are not a JSON object", {}};
  }
  const std::string raw(cones->raw(JsonText::kRoot));
  const int extras = json_.find(meshNode_, "extras");
  if (extras < 0) {
    patch_.set(
        meshNode_, "extras",
        std::string("{").append(quoteJson(kGltfConesKey)).append(":").append(raw).append("}"));
  } else if (json_.isObject(extras)) {
    patch_.set(extras, kGltfConesKey, raw);
  } else {
    note("cones are not embedded: the mesh's extras are not an object");
  }
  return Done{};
}

/// Compares the size of what is written with that of what was read, side files included.
void GltfWriter::noteSize(std::size_t written) {
  std::size_t before = store_.container.isBinary ? store_.file.size() : json_.text().size();
  for (const GltfBuffer& buffer : store_.buffers) {
    if (buffer.kind != GltfBufferKind::kFile) continue;
    before += buffer.bytes.size();
    written += buffer.bytes.size();
  }
  note(formatText("what was compressed is stored uncompressed: %zu bytes, %.2g times the input",
                  written, static_cast<double>(written) / static_cast<double>(before)));
}

Result<Written> GltfWriter::finish() {
  Written out;
  auto side = layout_.finish(options_.name);
  if (!side) return side.error();
  auto main = packGltf(store_, patch_.text(), layout_.bin());
  if (!main) return main.error();
  const bool isUnpacked = droppedDraco_ > 0 || layout_.hasUnpacked();
  if (isUnpacked && !options_.isCompressedLater) noteSize(main->size() + side->bytes.size());
  out.files.push_back({options_.name, std::move(*main)});
  if (!side->name.empty()) out.files.push_back(std::move(*side));
  for (const GltfBuffer& buffer : store_.buffers) {
    if (buffer.kind == GltfBufferKind::kFile && options_.isSideFileNoted)
      note("keep " + buffer.name + " next to the new file");
  }
  for (std::size_t p = 0; isRewritten_ && p < part_.pools.size(); ++p) {
    const GltfPool& pool = part_.pools[p];
    for (int v = 0; v < pool.vertexCount; ++v) out.xref.push_back(pool.firstStored + v);
    for (int v : splits_.pools[p].copyOf) out.xref.push_back(pool.firstStored + v);
  }
  out.notes = std::move(notes_);
  return out;
}

}  // namespace hgp::io
