#include "hgp/io/gltf/patch/writer.h"

#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/io/gltf/check/check.h"

namespace hgp::io {
namespace {

/// All missing sets below the chosen one must be filled; this limits how many.
constexpr int kHighestSet = 15;
/// As many sets as common viewers read; the specification asks for two.
constexpr int kUsualSets = 4;

Bytes bytesOf(const std::vector<float>& values) {
  Bytes out(values.size() * sizeof(float));
  if (!values.empty()) std::memcpy(out.data(), values.data(), out.size());
  return out;
}

}  // namespace

GltfWriter::GltfWriter(const GltfStore& store, const WriteOptions& options)
    : store_(store),
      json_(store.json),
      options_(options),
      patch_(store.json),
      layout_(store, patch_) {
  const auto list = [&](const char* name) {
    return json_.children(json_.find(JsonText::kRoot, name));
  };
  accessorNodes_ = list("accessors");
  newAccessorCount_ = static_cast<int>(accessorNodes_.size());
  meshNodes_ = list("meshes");
  materialNodes_ = list("materials");
  areReferencesKnown_ = areGltfReferencesKnown(json_);
  for (int node : gltfReferences(json_, "accessors")) {
    accessorReferences_[static_cast<int>(*json_.integer(node))].push_back(node);
  }
}

void GltfWriter::begin(const GltfSurface& part) {
  part_ = &part;
  meshNode_ = meshNodes_[static_cast<std::size_t>(part.mesh)];
  primitiveNodes_ = json_.children(json_.find(meshNode_, "primitives"));
  isRewritten_ = false;
  newIndices_.clear();
  notes_.clear();
  ++meshCount_;
}

Result<Notes> GltfWriter::add(const GltfMap& one) {
  const GltfSurface& part = *one.part;
  begin(part);
  askedSet_ = one.uvSet;
  pointsMaterials_ = one.pointsMaterials;
  auto splits = splitForUv(part, *one.map);
  if (!splits) return splits.error();
  splits_ = std::move(*splits);
  Status status = chooseSet();
  if (!status) return status.error();
  for (std::size_t p = 0; p < part_->pools.size(); ++p) planPool(static_cast<int>(p));
  tellOrPointMaterials();
  if (isRewritten_ || !part_->copy.empty()) rewriteManifold();
  status = embedCones(one.cones);
  if (!status) return status.error();
  collectXref();
  return std::move(notes_);
}

Result<Written> GltfWriter::finish() {
  pointMaterials();
  placeAccessors();
  dropUnusedExtensions();
  Written out;
  auto side = layout_.finish(options_.name);
  if (!side) return side.error();
  auto main = packGltf(store_, patch_.text(), layout_.bin());
  if (!main) return main.error();
  const bool isUnpacked = droppedDraco_ > 0 || layout_.hasUnpacked();
  if (isUnpacked && !options_.isCompressedLater)
    out.notes.push_back(sizeNote(main->size() + side->bytes.size()));
  out.files.push_back({options_.name, std::move(*main)});
  if (!side->name.empty()) out.files.push_back(std::move(*side));
  for (const GltfBuffer& buffer : store_.buffers) {
    if (buffer.kind == GltfBufferKind::kFile && options_.isSideFileNoted)
      out.notes.push_back(Note("write-keep-beside", {{"name", buffer.name}}));
  }
  if (meshCount_ == 1) out.xref = std::move(xref_);
  return out;
}

/// The set that hgp wrote before; otherwise the one after the last, even if an earlier one is missing, since the last
/// set is the one that is verified. Where all sets that viewers have are taken, the highest that no material uses.
int GltfWriter::defaultSet() {
  const auto isTaken = [&](int set, bool isOwn) {
    return std::any_of(part_->runs.begin(), part_->runs.end(), [&](const GltfRun& run) {
      const int a = primitive(run.primitive).attribute(semantic(set));
      return a >= 0 && (!isOwn || accessor(a).isOwnUv);
    });
  };
  for (int set = kHighestSet; set >= 0; --set)
    if (isTaken(set, true)) return set;
  int next = kHighestSet + 1;
  while (next > 0 && !isTaken(next - 1, false)) --next;
  if (next < kUsualSets) return next;
  const std::set<int> used = setsOfMaterials();
  for (int set = kUsualSets - 1; set > 0; --set) {
    if (used.count(set) > 0) continue;
    note("write-set-unread", {{"set", set}});
    return set;
  }
  return next;
}

Status GltfWriter::chooseSet() {
  set_ = askedSet_ >= 0 ? askedSet_ : defaultSet();
  if (set_ <= kHighestSet) {
    if (set_ >= kUsualSets) note("write-set-high", {{"set", set_}});
    return Done{};
  }
  return Failure{
      ErrorCode::kUsage,
      "write",
      formatText("uv set %d cannot be written; choose one from 0 to %d", set_, kHighestSet),
      {}};
}

void GltfWriter::planPool(int pool) {
  const GltfPool& source = part_->pools[static_cast<std::size_t>(pool)];
  for (int p : source.primitives) dropTangents(p);
  for (const int reference : ownUvReferences(pool)) droppedAttributes_.insert(reference);
  const std::size_t copies = splits_.pools[static_cast<std::size_t>(pool)].copyOf.size();
  if (copies > 0 || isDraco(pool)) {
    isRewritten_ = true;
    rewriteAttributes(pool);
    for (const GltfRun& run : part_->runs) {
      if (run.pool == pool) rewriteIndices(run);
    }
    for (int p : source.primitives) dropDraco(p);
  } else {
    for (const GltfRun& run : part_->runs) {
      if (run.pool == pool && isEdited(run)) rewriteIndices(run);
    }
  }
  if (copies > 0) {
    note("write-vertices-copied",
         {{"before", source.vertexCount},
          {"after", static_cast<std::size_t>(source.vertexCount) + copies}});
  }
  planUv(pool);
}

bool GltfWriter::isDraco(int pool) const {
  const std::vector<int>& list = part_->pools[static_cast<std::size_t>(pool)].primitives;
  return std::any_of(list.begin(), list.end(),
                     [&](int p) { return primitive(p).draco.has_value(); });
}

/// Whether repairs changed a triangle of the run.
bool GltfWriter::isEdited(const GltfRun& run) const {
  if (part_->copy.empty()) return false;
  const auto first = part_->copy.begin() + run.firstTriangle;
  return std::any_of(first, first + run.triangleCount,
                     [](const auto& c) { return c[0] != GltfSurface::kUnedited; });
}

/// References to uv that hgp wrote before and that are replaced now: all of one accessor that it wrote in this form.
std::vector<int> GltfWriter::ownUvReferences(int pool) const {
  int own = -1;
  std::vector<int> references;
  for (const int p : part_->pools[static_cast<std::size_t>(pool)].primitives) {
    const int attributes = json_.find(primitiveNodes_[static_cast<std::size_t>(p)], "attributes");
    const int chosen = primitive(p).attribute(semantic(set_));
    if (chosen < 0 || !accessor(chosen).isOwnUv || (own >= 0 && own != chosen)) return {};
    own = chosen;
    for (int set = 0; set <= kHighestSet; ++set)
      if (primitive(p).attribute(semantic(set)) == own)
        references.push_back(json_.find(attributes, semantic(set)));
  }
  const int node = own < 0 ? -1 : accessorNodes_[static_cast<std::size_t>(own)];
  const bool isAsWritten = own >= 0 && accessor(own).componentType == kGltfFloat &&
                           !accessor(own).sparse && json_.find(node, "min") < 0 &&
                           json_.find(node, "max") < 0;
  return isAsWritten ? references : std::vector<int>();
}

void GltfWriter::planUv(int pool) {
  const GltfSplit& split = splits_.pools[static_cast<std::size_t>(pool)];
  GltfNewAccessor fresh;
  fresh.base = "{}";
  fresh.members = {{"componentType", "5126"},
                   {"count", std::to_string(split.uv.size() / 2)},
                   {"type", "\"VEC2\""}};
  fresh.data = bytesOf(split.uv);
  fresh.target = 34962;
  if (const std::vector<int> own = ownUvReferences(pool); !own.empty()) {
    const int old = static_cast<int>(*json_.integer(own.front()));
    redirect(old, {own.begin(), own.end()}, std::move(fresh));
    return;
  }
  fresh.members["extras"] = kGltfUvExtras;
  fresh.index = newAccessorCount_++;
  const std::string index = std::to_string(fresh.index);
  fresh_.push_back(std::move(fresh));
  for (int p : part_->pools[static_cast<std::size_t>(pool)].primitives) {
    const int attributes = json_.find(primitiveNodes_[static_cast<std::size_t>(p)], "attributes");
    for (int set = 0; set <= set_; ++set) {
      const int old = json_.find(attributes, semantic(set));
      if (old >= 0 && set < set_) continue;
      if (old < 0 && set < set_) {
        note("write-set-filled", {{"primitive", p}, {"set", set}});
      }
      patch_.set(attributes, semantic(set), index);
    }
  }
}

bool GltfWriter::isNormalMapFed(int p) const {
  const int material = primitive(p).material;
  if (material < 0) return false;
  const int map = json_.find(materialNodes_[static_cast<std::size_t>(material)], "normalTexture");
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
      note("write-tangents-dropped", {{"primitive", p}, {"set", set_}});
    }
  }
}

Status GltfWriter::embedCones(const std::optional<std::string>& text) {
  if (!text) return Done{};
  const auto cones = JsonText::parse(*text);
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
    note("write-cones-extras");
  }
  return Done{};
}

/// Compares the size of what is written with that of what was read, side files included.
Note GltfWriter::sizeNote(std::size_t written) const {
  std::size_t before = store_.container.isBinary ? store_.file.size() : json_.text().size();
  for (const GltfBuffer& buffer : store_.buffers) {
    if (buffer.kind != GltfBufferKind::kFile) continue;
    before += buffer.bytes.size();
    written += buffer.bytes.size();
  }
  return Note(
      "write-unpacked",
      {{"bytes", written}, {"ratio", static_cast<double>(written) / static_cast<double>(before)}});
}

void GltfWriter::collectXref() {
  for (std::size_t p = 0; isRewritten_ && p < part_->pools.size(); ++p) {
    const GltfPool& pool = part_->pools[p];
    for (int v = 0; v < pool.vertexCount; ++v) xref_.push_back(pool.firstStored + v);
    for (int v : splits_.pools[p].copyOf) xref_.push_back(pool.firstStored + v);
  }
}

}  // namespace hgp::io
