// Updates EXT_mesh_manifold, removes the names of extensions that are no longer used, and places new data.
#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/io/gltf/check/check.h"
#include "hgp/io/gltf/decode/accessor.h"
#include "hgp/io/gltf/patch/writer.h"

namespace hgp::io {
namespace {

constexpr const char* kManifold = "EXT_mesh_manifold";

Bytes wordBytes(const std::vector<std::uint32_t>& words) {
  Bytes out(words.size() * 4);
  if (!words.empty()) std::memcpy(out.data(), words.data(), out.size());
  return out;
}

/// Entries of `merged` that differ from `base`: their indices and values.
struct Differences {
  std::vector<std::uint32_t> where, values;
};
Differences differencesOf(const Bytes& merged, int componentType,
                          const std::vector<std::uint32_t>& base) {
  Differences out;
  for (std::size_t k = 0; k < base.size(); ++k) {
    const std::uint32_t value = unsignedAt(merged, componentType, k);
    if (value == base[k]) continue;
    out.where.push_back(static_cast<std::uint32_t>(k));
    out.values.push_back(value);
  }
  return out;
}

}  // namespace

void GltfWriter::rewriteManifold() {
  const int extension = json_.find(json_.find(meshNode_, "extensions"), kManifold);
  if (extension < 0) return;
  if (!part_->copy.empty()) return dropManifold("write-manifold-repaired");
  if (!part_->isWeldedByExtension || !planManifold()) dropManifold("write-manifold-other");
}

void GltfWriter::dropManifold(const char* code) {
  const int extensions = json_.find(meshNode_, "extensions");
  patch_.remove(json_.find(extensions, kManifold));
  if (patch_.isEmptied(extensions)) patch_.remove(extensions);
  note(code);
  ++droppedManifolds_;
}

/// The manifold's indices are those of all primitives in one array, with sparse values that map
/// every copy to one vertex. Old vertices keep their indices, so the old merged values remain valid;
/// what changes is the base array and the set of entries that differ from it.
bool GltfWriter::planManifold() {
  const auto& manifold = store_.model.meshes[static_cast<std::size_t>(part_->mesh)].manifold;
  if (!manifold || part_->pools.size() != 1) return false;
  const auto starts = manifoldStarts(store_, part_->mesh, part_->runs);
  if (!starts) return false;
  const GltfAccessor& whole = accessor(manifold->indices);
  std::vector<std::uint32_t> base(whole.count, UINT32_MAX);
  for (std::size_t r = 0; r < part_->runs.size(); ++r) {
    const std::vector<std::uint32_t> indices = writtenIndices(part_->runs[r]);
    const std::size_t start = (*starts)[r];
    if (indices.size() > base.size() - start) return false;
    std::copy(indices.begin(), indices.end(), base.begin() + static_cast<std::ptrdiff_t>(start));
  }
  if (std::find(base.begin(), base.end(), UINT32_MAX) != base.end()) return false;

  const Differences merges =
      differencesOf(packedElements(store_, manifold->indices), whole.componentType, base);
  if (merges.where.empty()) return false;
  const int extension = json_.find(json_.find(meshNode_, "extensions"), kManifold);
  const int mergeIndices = planMerge(extension, "mergeIndices", merges.where);
  const int mergeValues = planMerge(extension, "mergeValues", merges.values);
  GltfNewAccessor all;
  all.data = wordBytes(base);
  all.members = {{"componentType", std::to_string(kGltfUnsignedInt)},
                 {"count", std::to_string(base.size())}};
  all.target = 34963;
  all.sparseIndices = mergeIndices;
  all.sparseValues = mergeValues;
  const int manifoldPrimitive = json_.find(extension, "manifoldPrimitive");
  setRange(all, manifold->indices, all.data);
  const int shared =
      redirect(manifold->indices, {json_.find(manifoldPrimitive, "indices")}, std::move(all));
  for (std::size_t r = 0; r < part_->runs.size(); ++r) {
    const GltfRun& run = part_->runs[r];
    if (newIndices_.count(run.primitive) == 0) {
      planIndices(run, writtenIndices(run), kGltfUnsignedInt);
    }
    GltfNewAccessor& own = fresh_[static_cast<std::size_t>(newIndices_.at(run.primitive))];
    own.members["componentType"] = std::to_string(kGltfUnsignedInt);
    own.data.clear();
    own.sharedWith = shared;
    own.sharedOffset = 4 * (*starts)[r];
  }
  return true;
}

/// Gives the accessor that the extension names as `key` the values `words`. @return  index in the plan
int GltfWriter::planMerge(int extension, const char* key, const std::vector<std::uint32_t>& words) {
  const int reference = json_.find(extension, key);
  GltfNewAccessor fresh;
  fresh.data = wordBytes(words);
  fresh.members = {
      {"componentType", "5125"}, {"count", std::to_string(words.size())}, {"type", "\"SCALAR\""}};
  const auto old = json_.integer(reference);
  if (old) {
    setRange(fresh, static_cast<int>(*old), fresh.data);
    return redirect(static_cast<int>(*old), {reference}, std::move(fresh));
  }
  fresh.index = newAccessorCount_++;
  fresh.base = "{}";
  patch_.set(extension, key, std::to_string(fresh.index));
  fresh_.push_back(std::move(fresh));
  return static_cast<int>(fresh_.size()) - 1;
}

void GltfWriter::dropUnusedExtensions() {
  int dracoCount = 0, manifoldCount = 0;
  for (const GltfMesh& mesh : store_.model.meshes) {
    for (const GltfPrimitive& p : mesh.primitives) dracoCount += p.draco ? 1 : 0;
  }
  for (const int mesh : meshNodes_)
    manifoldCount += json_.find(json_.find(mesh, "extensions"), kManifold) >= 0 ? 1 : 0;
  if (droppedManifolds_ > 0 && droppedManifolds_ == manifoldCount) dropName(kManifold);
  if (droppedDraco_ > 0 && droppedDraco_ == dracoCount) dropName("KHR_draco_mesh_compression");
}

/// Removes a name from extensionsUsed and extensionsRequired, and a list that becomes empty.
void GltfWriter::dropName(const char* extension) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    const int array = json_.find(JsonText::kRoot, list);
    for (int name : json_.children(array)) {
      if (json_.string(name) == extension) patch_.remove(name);
    }
    if (array >= 0 && json_.node(array).count > 0 && patch_.isEmptied(array)) patch_.remove(array);
  }
}

/// Views without any reader after the patch may be reused for new data.
void GltfWriter::releaseViews() {
  std::map<int, bool> isFree;
  for (int node : gltfReferences(json_, "bufferViews")) {
    const int view = static_cast<int>(*json_.integer(node));
    const auto known = isFree.try_emplace(view, true).first;
    known->second = known->second && freedNodes_.count(node) > 0;
  }
  std::set<int> free, own;
  for (const GltfAccessor& one : store_.model.accessors)
    if (one.isOwnUv) own.insert(one.view);
  for (const auto& [view, isUnread] : isFree) {
    if (isUnread && (areReferencesKnown_ || own.count(view) > 0)) free.insert(view);
  }
  layout_.release(free);
}

/// Accessors that others refer to come first; those without an old view take the released views that remain.
std::vector<std::size_t> GltfWriter::placingOrder() const {
  std::set<int> isPointedAt;
  for (const GltfNewAccessor& fresh : fresh_)
    isPointedAt.insert({fresh.sparseIndices, fresh.sparseValues});
  return stableOrder(fresh_.size(), [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t i) {
      const GltfNewAccessor& fresh = fresh_[i];
      if (isPointedAt.count(static_cast<int>(i)) > 0) return 0;
      return fresh.sharedWith >= 0 ? 2 : fresh.sparseIndices >= 0 ? 1 : fresh.oldView < 0 ? 3 : 0;
    };
    return rank(a) < rank(b);
  });
}

void GltfWriter::placeAccessors() {
  releaseViews();
  std::vector<int> viewOf(fresh_.size(), -1);
  std::map<int, std::string> appended;
  for (std::size_t i : placingOrder()) {
    GltfNewAccessor& fresh = fresh_[i];
    if (fresh.sharedWith >= 0) {
      viewOf[i] = viewOf[static_cast<std::size_t>(fresh.sharedWith)];
      fresh.members["byteOffset"] = std::to_string(fresh.sharedOffset);
    } else {
      viewOf[i] = layout_.place(fresh.data, fresh.target, fresh.stride, fresh.oldView);
      Bytes().swap(fresh.data);
    }
    fresh.members["bufferView"] = std::to_string(viewOf[i]);
    if (fresh.sparseIndices >= 0) {
      const auto& where = fresh_[static_cast<std::size_t>(fresh.sparseIndices)];
      fresh.members["sparse"] = formatText(
          "{\"count\":%s,\"indices\":{\"bufferView\":%d,\"componentType\":5125},"
          "\"values\":{\"bufferView\":%d}}",
          where.members.at("count").c_str(), viewOf[static_cast<std::size_t>(fresh.sparseIndices)],
          viewOf[static_cast<std::size_t>(fresh.sparseValues)]);
    }
    if (fresh.node < 0) {
      appended[fresh.index] = editedAccessor(fresh);
      continue;
    }
    for (const char* gone : {"byteOffset", "sparse"}) {
      const int member = json_.find(fresh.node, gone);
      if (member >= 0 && fresh.members.count(gone) == 0) patch_.remove(member);
    }
    for (const auto& [key, raw] : fresh.members) patch_.set(fresh.node, key, raw);
  }
  const int array = json_.find(JsonText::kRoot, "accessors");
  for (const auto& [index, text] : appended) patch_.append(array, text);
}

/// The text of a new accessor, which keeps the name, extras and type of an old one.
std::string GltfWriter::editedAccessor(const GltfNewAccessor& fresh) const {
  const auto base = JsonText::parse(fresh.base);
  HGP_CHECK(base.hasValue(), "an accessor's own text cannot be read again");
  JsonPatch patch(*base);
  for (const char* gone : {"byteOffset", "sparse"}) {
    const int member = base->find(JsonText::kRoot, gone);
    if (member >= 0 && fresh.members.count(gone) == 0) patch.remove(member);
  }
  for (const auto& [key, raw] : fresh.members) patch.set(JsonText::kRoot, key, raw);
  return patch.text();
}

}  // namespace hgp::io
