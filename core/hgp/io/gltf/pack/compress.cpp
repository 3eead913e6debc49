#include "hgp/io/gltf/pack/compress.h"

#include <algorithm>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/gltf/check/check.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/decode/store.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/pack/encoders.h"
#include "hgp/io/gltf/patch/writer.h"

namespace hgp::io {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr const char* kMeshoptKinds[] = {kMeshopt, "KHR_meshopt_compression"};

/// Bytes of JSON text that a compressed view needs beyond those of a plain one.
constexpr std::size_t kDescription = 190;

/// What a view is used for.
struct ViewUse {
  std::vector<int> accessors;
  bool hasOthers = false;  ///< images, sparse values or Draco data, which are not compressed
};

class GltfCompressor {
 public:
  GltfCompressor(const GltfStore& store, const std::string& name)
      : store_(store), json_(store.json), patch_(store.json), name_(name) {
    views_ = json_.children(json_.find(JsonText::kRoot, "bufferViews"));
  }

  Result<Written> run() {
    findUses();
    for (std::size_t v = 0; v < views_.size(); ++v) {
      const Status done = takeView(static_cast<int>(v));
      if (!done) return done.error();
    }
    nameExtension();
    return finish();
  }

 private:
  void findUses() {
    uses_.resize(views_.size());
    const std::vector<int> accessors = json_.children(json_.find(JsonText::kRoot, "accessors"));
    std::map<int, int> indexOf;
    for (std::size_t a = 0; a < accessors.size(); ++a) indexOf[accessors[a]] = static_cast<int>(a);
    for (int node : gltfReferences(json_, "bufferViews")) {
      ViewUse& use = uses_[static_cast<std::size_t>(*json_.integer(node))];
      const auto owner = indexOf.find(json_.node(node).parent);
      if (owner == indexOf.end())
        use.hasOthers = true;
      else
        use.accessors.push_back(owner->second);
    }
  }

  const GltfAccessor& accessor(int a) const {
    return store_.model.accessors[static_cast<std::size_t>(a)];
  }

  bool isEvery(const ViewUse& use, bool (*test)(const GltfAccessor&)) const {
    return std::all_of(use.accessors.begin(), use.accessors.end(),
                       [&](int a) { return test(accessor(a)); });
  }

  /// The compressed view; empty where it stays uncompressed.
  std::optional<PackedView> packed(int v) const {
    const GltfView& view = store_.model.views[static_cast<std::size_t>(v)];
    const ViewUse& use = uses_[static_cast<std::size_t>(v)];
    if (use.hasOthers || use.accessors.empty() || view.length == 0) return std::nullopt;
    const GltfAccessor& first = accessor(use.accessors[0]);
    const std::uint64_t size = first.elementSize();
    for (const int a : use.accessors)
      if (view.stride == 0 && accessor(a).elementSize() != size) return std::nullopt;
    const std::uint64_t stride = view.stride != 0 ? view.stride : size;
    if (view.length % stride != 0) return std::nullopt;
    const bool areIndices =
        (stride == 2 || stride == 4) &&
        isEvery(use,
                [](const GltfAccessor& a) {
                  return a.components() == 1 && (a.componentType == kGltfUnsignedShort ||
                                                 a.componentType == kGltfUnsignedInt);
                }) &&
        first.componentSize() == stride;
    const bool areFloats =
        isEvery(use, [](const GltfAccessor& a) { return a.componentType == kGltfFloat; });
    const GltfContent content = areIndices  ? GltfContent::kIndices
                                : areFloats ? GltfContent::kFloats
                                            : GltfContent::kOther;
    return packView(store_.viewBytes(v), stride, content);
  }

  std::size_t add(ByteView bytes) {
    const std::size_t offset = (data_.size() + 3) / 4 * 4;
    data_.resize(offset);
    data_.insert(data_.end(), bytes.begin(), bytes.end());
    return offset;
  }

  /// Points the view into the fallback buffer, which has no bytes, at the place of its decoded bytes.
  void showDecoded(int node, std::uint64_t size) {
    decodedSize_ = (decodedSize_ + 3) / 4 * 4;
    patch_.set(node, "buffer", "1");
    patch_.set(node, "byteOffset", std::to_string(decodedSize_));
    decodedSize_ += size;
  }

  Status takeView(int v) {
    const GltfView& view = store_.model.views[static_cast<std::size_t>(v)];
    const int node = views_[static_cast<std::size_t>(v)];
    if (view.meshopt) return keepPacked(view, node);
    const ByteView bytes = store_.viewBytes(v);
    if (bytes.size() != view.length) {
      return Failure{ErrorCode::kUnsupported,
                     "write",
                     formatText("compressing: view %d has no bytes of its own", v),
                     {}};
    }
    const std::optional<PackedView> pack = packed(v);
    if (!pack || pack->bytes.size() + kDescription > view.length) {
      patch_.set(node, "buffer", "0");
      patch_.set(node, "byteOffset", std::to_string(add(bytes)));
      return Done{};
    }
    const std::size_t offset = add(pack->bytes);
    showDecoded(node, view.length);
    before_ += view.length;
    after_ += pack->bytes.size();
    ++packedCount_;
    std::string text = formatText(
        "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"byteStride\":%zu,\"count\":%zu,"
        "\"mode\":\"%s\"",
        offset, pack->bytes.size(), static_cast<std::size_t>(pack->stride),
        static_cast<std::size_t>(pack->count), pack->mode);
    if (std::string_view(pack->filter) != "NONE")
      text += formatText(",\"filter\":\"%s\"", pack->filter);
    const int extensions = json_.find(node, "extensions");
    if (json_.isObject(extensions))
      patch_.set(extensions, kMeshopt, text + "}");
    else
      patch_.set(node, "extensions", formatText("{\"%s\":", kMeshopt) + text + "}}");
    return Done{};
  }

  Status keepPacked(const GltfView& view, int node) {
    const ByteView source = store_.buffers[static_cast<std::size_t>(view.meshopt->buffer)].bytes;
    const std::size_t offset = add(source.subspan(view.meshopt->offset, view.meshopt->length));
    for (const char* kind : kMeshoptKinds) {
      const int extension = json_.find(json_.find(node, "extensions"), kind);
      if (extension < 0) continue;
      patch_.set(extension, "buffer", "0");
      patch_.set(extension, "byteOffset", std::to_string(offset));
    }
    showDecoded(node, view.length);
    return Done{};
  }

  /// In extensionsUsed and, because the file does not contain the decoded bytes, in extensionsRequired.
  void nameExtension() {
    if (packedCount_ == 0) return;
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      const int array = json_.find(JsonText::kRoot, list);
      const std::vector<int> names = json_.children(array);
      const bool isThere = std::any_of(names.begin(), names.end(),
                                       [&](int n) { return json_.string(n) == kMeshopt; });
      if (isThere) continue;
      if (array >= 0)
        patch_.append(array, quoteJson(kMeshopt));
      else
        patch_.set(JsonText::kRoot, list, formatText("[\"%s\"]", kMeshopt));
    }
  }

  /// The text of a buffer of the file with another length and URI.
  std::string bufferText(int like, std::size_t size, const std::string& uri) const {
    const auto base = JsonText::parse(like >= 0 ? std::string(json_.raw(like)) : "{}");
    HGP_CHECK(base.hasValue(), "a buffer's own text cannot be read again");
    JsonPatch patch(*base);
    patch.set(JsonText::kRoot, "byteLength", std::to_string(size));
    const int old = base->find(JsonText::kRoot, "uri");
    if (!uri.empty())
      patch.set(JsonText::kRoot, "uri", quoteJson(uri));
    else if (old >= 0)
      patch.remove(old);
    return patch.text();
  }

  /// The node of the first buffer that has bytes, or of the first that has none.
  int bufferNode(bool hasBytes) const {
    const std::vector<int> nodes = json_.children(json_.find(JsonText::kRoot, "buffers"));
    for (std::size_t b = 0; b < nodes.size(); ++b)
      if ((store_.buffers[b].kind != GltfBufferKind::kNone) == hasBytes) return nodes[b];
    return -1;
  }

  Result<Written> finish() {
    OutputFile side;
    std::string uri;
    if (!store_.container.isBinary) {
      std::vector<std::string> taken;
      for (const GltfBuffer& buffer : store_.buffers)
        if (buffer.kind == GltfBufferKind::kFile) taken.push_back(buffer.name);
      if (!taken.empty()) side.name = freeSideName(fileStem(name_) + "-packed", taken);
      uri = taken.empty()
                ? std::string("data:application/octet-stream;base64,") + encodeBase64(data_)
                : uriFromName(side.name);
    }
    std::string buffers = "[";
    buffers += bufferText(bufferNode(true), data_.size(), uri);
    if (decodedSize_ > 0) {
      const int fallback = bufferNode(false);
      if (fallback >= 0)
        buffers.append(",").append(bufferText(fallback, decodedSize_, ""));
      else
        buffers += formatText(",{\"byteLength\":%zu,\"extensions\":{\"%s\":{\"fallback\":true}}}",
                              static_cast<std::size_t>(decodedSize_), kMeshopt);
    }
    patch_.set(JsonText::kRoot, "buffers", buffers + "]");
    auto main = packGltf(store_, patch_.text(), data_);
    if (!main) return main.error();
    Written out;
    std::size_t total = main->size();
    out.files.push_back({name_, std::move(*main)});
    if (!side.name.empty()) {
      total += data_.size();
      side.bytes = std::move(data_);
      out.files.push_back(std::move(side));
    }
    out.notes.push_back(sizeNote(total));
    return out;
  }

  Note sizeNote(std::size_t total) const {
    if (packedCount_ == 0) return Note("write-not-shorter", {{"bytes", total}});
    return Note(
        "write-packed",
        {{"bytes", total}, {"views", packedCount_}, {"before", before_}, {"after", after_}});
  }

  const GltfStore& store_;
  const JsonText& json_;
  JsonPatch patch_;
  std::string name_;
  std::vector<int> views_;  ///< JSON nodes
  std::vector<ViewUse> uses_;
  Bytes data_;
  std::uint64_t decodedSize_ = 0, before_ = 0, after_ = 0;
  int packedCount_ = 0;
};

Failure cannotCompress(const char* why) {
  return {ErrorCode::kUsage, "write", std::string("compressing: ") + why, {}};
}
Failure noEncoder() {
  return cannotCompress("this build has no meshopt encoder (libmeshoptimizer)");
}
Failure unknownReferences() {
  return cannotCompress(
      "an extension of this file may point into its buffers; leave the option out");
}

}  // namespace

Status canCompressGltf(ByteView main) {
  if (!canPackViews()) return noEncoder();
  const auto container = openContainer(main);
  if (!container) return Done{};
  const auto json = JsonText::parse(std::string(container->json));
  return json && !areGltfReferencesKnown(*json) ? Status(unknownReferences()) : Status(Done{});
}

Result<Written> compressGltf(const std::vector<OutputFile>& files, const Resolver& resolve,
                             const Limits& limits) {
  if (!canPackViews()) return noEncoder();
  FileSet set;
  set.name = files[0].name;
  set.main = files[0].bytes;
  set.resolve = [&](const std::string& name) -> Result<Bytes> {
    for (std::size_t i = 1; i < files.size(); ++i)
      if (files[i].name == name) return files[i].bytes;
    if (resolve) return resolve(name);
    return Failure{ErrorCode::kMalformed, "write", name + " is missing", {}};
  };
  auto store = loadGltf(std::move(set), limits, builtInDecoders());
  if (!store) return store.error();
  if (!areGltfReferencesKnown((*store)->json)) return unknownReferences();
  (*store)->container.hasBin = true;
  return GltfCompressor(**store, files[0].name).run();
}

}  // namespace hgp::io
