// Rewrites attributes and indices of pools whose vertices change, and plans all new data.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hgp/base/check.h"
#include "hgp/io/gltf/check/check.h"
#include "hgp/io/gltf/decode/accessor.h"
#include "hgp/io/gltf/patch/writer.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

std::uint32_t restartValue(int componentType) {
  return componentType == kGltfUnsignedByte    ? 0xFF
         : componentType == kGltfUnsignedShort ? 0xFFFF
                                               : 0xFFFFFFFF;
}

Bytes indexBytes(const std::vector<std::uint32_t>& indices, int componentType) {
  const std::size_t size = gltfComponentSize(componentType);
  Bytes out(indices.size() * size);
  // Little-endian: the low bytes come first.
  for (std::size_t k = 0; k < indices.size(); ++k) {
    std::memcpy(out.data() + k * size, &indices[k], size);
  }
  return out;
}

}  // namespace

Bytes GltfWriter::expanded(const Bytes& packed, std::size_t elementSize, int pool) const {
  const GltfSplit& split = splits_.pools[static_cast<std::size_t>(pool)];
  const std::size_t stride = (elementSize + 3) / 4 * 4;
  const std::size_t count = packed.size() / elementSize;
  Bytes out((count + split.copyOf.size()) * stride, 0);
  for (std::size_t i = 0; i < count + split.copyOf.size(); ++i) {
    const std::size_t from = i < count ? i : static_cast<std::size_t>(split.copyOf[i - count]);
    std::memcpy(out.data() + i * stride, packed.data() + from * elementSize, elementSize);
  }
  return out;
}

/// Makes `references` refer to new contents, in place of the old accessor if nothing else reads that.
int GltfWriter::redirect(int old, const std::set<int>& references, GltfNewAccessor fresh) {
  const std::vector<int>& all = accessorReferences_[old];
  // An extension that this program does not know cannot refer to what this program added.
  const bool areKnown = areReferencesKnown_ || accessor(old).isOwnUv;
  const bool isOurs = areKnown && std::all_of(all.begin(), all.end(), [&](int node) {
                        return references.count(node) > 0 || droppedAttributes_.count(node) > 0;
                      });
  const int node = accessorNodes_[static_cast<std::size_t>(old)];
  fresh.oldView = accessor(old).view;
  if (isOurs) {
    fresh.index = old;
    fresh.node = node;
    const int sparse = json_.find(node, "sparse");
    freedNodes_.insert({json_.find(node, "bufferView"),
                        json_.find(json_.find(sparse, "indices"), "bufferView"),
                        json_.find(json_.find(sparse, "values"), "bufferView")});
  } else {
    fresh.index = newAccessorCount_++;
    fresh.base = std::string(json_.raw(node));
    for (int reference : references) patch_.replace(reference, std::to_string(fresh.index));
    droppedAttributes_.insert(references.begin(), references.end());
  }
  fresh_.push_back(std::move(fresh));
  return static_cast<int>(fresh_.size()) - 1;
}

/// Sets min and max from the stored values where the old accessor states them; JSON has no infinity.
void GltfWriter::setRange(GltfNewAccessor& fresh, int old, ByteView data) const {
  GltfAccessor shape = accessor(old);
  const auto type = fresh.members.find("componentType");
  if (type != fresh.members.end()) shape.componentType = std::stoi(type->second);
  shape.isNormalized = false;
  const std::size_t stride = fresh.stride != 0 ? fresh.stride : shape.elementSize();
  const auto width = static_cast<std::size_t>(shape.components());
  std::vector<double> low(width, std::numeric_limits<double>::infinity()), high(width);
  std::fill(high.begin(), high.end(), -std::numeric_limits<double>::infinity());
  shape.count = 1;
  for (std::size_t at = 0; at + shape.elementSize() <= data.size(); at += stride) {
    const std::vector<double> element = realNumbers(shape, data.subspan(at, shape.elementSize()));
    for (std::size_t k = 0; k < width; ++k) {
      if (!std::isfinite(element[k])) continue;
      low[k] = std::min(low[k], element[k]);
      high[k] = std::max(high[k], element[k]);
    }
  }
  for (std::size_t k = 0; k < width; ++k)
    if (low[k] > high[k]) low[k] = high[k] = 0.0;
  const auto text = [](const std::vector<double>& values) {
    std::string out = "[";
    for (double value : values) {
      if (out.size() > 1) out += ',';
      text::appendDouble(out, value);
    }
    return out + "]";
  };
  const int node = accessorNodes_[static_cast<std::size_t>(old)];
  if (json_.find(node, "min") >= 0) fresh.members["min"] = text(low);
  if (json_.find(node, "max") >= 0) fresh.members["max"] = text(high);
}

/// The node in which EXT_mesh_manifold refers to positions, or −1.
int GltfWriter::manifoldPositions() const {
  const int manifold = json_.find(
      json_.find(json_.find(meshNode_, "extensions"), "EXT_mesh_manifold"), "manifoldPrimitive");
  return json_.find(json_.find(manifold, "attributes"), "POSITION");
}

/// Whether meshopt compressed the view of accessor a.
bool GltfWriter::isCompressed(int a) const {
  const int view = accessor(a).view;
  return view >= 0 && store_.model.views[static_cast<std::size_t>(view)].meshopt;
}

void GltfWriter::rewriteAttributes(int pool) {
  struct Source {
    int primitive;
    std::string semantic;
    int target;
    std::set<int> references;
  };
  std::map<std::pair<int, std::string>, Source> sources;
  const auto add = [&](int p, int owner, const GltfAttributes& attributes, int target) {
    for (const auto& [name, index] : attributes) {
      const int reference = json_.find(owner, name);
      if (droppedAttributes_.count(reference) > 0) continue;
      const bool isFromDraco =
          target < 0 && primitive(p).draco && primitive(p).draco->ids.count(name);
      auto& source =
          sources.try_emplace({index, isFromDraco ? name : ""}, Source{p, name, target, {}})
              .first->second;
      source.references.insert(reference);
    }
  };
  for (int p : part_->pools[static_cast<std::size_t>(pool)].primitives) {
    const int node = primitiveNodes_[static_cast<std::size_t>(p)];
    add(p, json_.find(node, "attributes"), primitive(p).attributes, -1);
    const std::vector<int> targets = json_.children(json_.find(node, "targets"));
    for (std::size_t t = 0; t < targets.size(); ++t) {
      add(p, targets[t], primitive(p).targets[t], static_cast<int>(t));
    }
  }
  const int manifoldPosition = manifoldPositions();
  for (auto& [key, source] : sources) {
    const int old = key.first;
    if (manifoldPosition >= 0 && source.semantic == "POSITION" && source.target < 0 &&
        json_.integer(manifoldPosition) == old) {
      source.references.insert(manifoldPosition);
    }
    const std::size_t size = accessor(old).elementSize();
    GltfNewAccessor fresh;
    fresh.data = expanded(
        packedAttribute(store_, part_->mesh, source.primitive, source.semantic, source.target),
        size, pool);
    fresh.stride = size % 4 == 0 ? 0 : (size + 3) / 4 * 4;
    fresh.target = 34962;
    const std::size_t step = fresh.stride != 0 ? fresh.stride : size;
    fresh.members["count"] = std::to_string(fresh.data.size() / step);
    if (!key.second.empty() || isCompressed(old)) setRange(fresh, old, fresh.data);
    redirect(old, source.references, std::move(fresh));
  }
}

int GltfWriter::indexTypeFor(int wanted, int vertexCount) const {
  for (int type : {kGltfUnsignedByte, kGltfUnsignedShort}) {
    if (type >= wanted && static_cast<std::uint32_t>(vertexCount) <= restartValue(type))
      return type;
  }
  return kGltfUnsignedInt;
}

std::vector<std::uint32_t> GltfWriter::writtenIndices(const GltfRun& run) const {
  std::vector<std::uint32_t> out;
  for (int t = run.firstTriangle; t < run.firstTriangle + run.triangleCount; ++t) {
    for (int v : splits_.corner[static_cast<std::size_t>(t)]) {
      out.push_back(static_cast<std::uint32_t>(v));
    }
  }
  if (primitive(run.primitive).mode != 4) return out;
  const auto old = readIndices(store_, part_->mesh, run.primitive);
  for (std::size_t k = out.size(); old && k < old->size(); ++k) out.push_back((*old)[k]);
  return out;
}

void GltfWriter::rewriteIndices(const GltfRun& run) {
  const GltfPool& pool = part_->pools[static_cast<std::size_t>(run.pool)];
  const GltfPrimitive& source = primitive(run.primitive);
  const GltfSplit& split = splits_.pools[static_cast<std::size_t>(run.pool)];
  // A primitive without indices draws all vertices, including the copies made for other primitives.
  bool isChanged =
      source.draco.has_value() || (source.indices < 0 && !split.copyOf.empty()) || isEdited(run);
  for (int face = run.firstTriangle; face < run.firstTriangle + run.triangleCount; ++face) {
    const auto t = static_cast<std::size_t>(face);
    for (std::size_t k = 0; k < 3; ++k) {
      isChanged = isChanged || splits_.corner[t][k] != part_->stored[t][k] - pool.firstStored;
    }
  }
  if (!isChanged) return;
  const int wanted =
      source.indices >= 0 ? accessor(source.indices).componentType : kGltfUnsignedShort;
  const int type = indexTypeFor(wanted, pool.vertexCount + static_cast<int>(split.copyOf.size()));
  planIndices(run, writtenIndices(run), type);
  if (source.mode == 4) return;
  patch_.set(primitiveNodes_[static_cast<std::size_t>(run.primitive)], "mode", "4");
  note("write-list", {{"primitive", run.primitive}});
}

void GltfWriter::planIndices(const GltfRun& run, const std::vector<std::uint32_t>& indices,
                             int type) {
  const int node = primitiveNodes_[static_cast<std::size_t>(run.primitive)];
  const int old = primitive(run.primitive).indices;
  GltfNewAccessor fresh;
  fresh.data = indexBytes(indices, type);
  fresh.target = 34963;
  fresh.members = {{"componentType", std::to_string(type)},
                   {"count", std::to_string(indices.size())}};
  if (old >= 0) {
    setRange(fresh, old, fresh.data);
    newIndices_[run.primitive] = redirect(old, {json_.find(node, "indices")}, std::move(fresh));
    return;
  }
  fresh.index = newAccessorCount_++;
  fresh.base = "{}";
  fresh.members["type"] = "\"SCALAR\"";
  patch_.set(node, "indices", std::to_string(fresh.index));
  fresh_.push_back(std::move(fresh));
  newIndices_[run.primitive] = static_cast<int>(fresh_.size()) - 1;
}

void GltfWriter::dropDraco(int p) {
  if (!primitive(p).draco) return;
  const int extensions = json_.find(primitiveNodes_[static_cast<std::size_t>(p)], "extensions");
  const int draco = json_.find(extensions, "KHR_draco_mesh_compression");
  freedNodes_.insert(json_.find(draco, "bufferView"));
  patch_.remove(draco);
  if (patch_.isEmptied(extensions)) patch_.remove(extensions);
  ++droppedDraco_;
  if (!options_.isCompressedLater) note("write-draco-unpacked", {{"primitive", p}});
}

}  // namespace hgp::io
