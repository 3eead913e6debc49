#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/store.h"
#include "hgp/io/limits.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Loads the buffers one after the other and counts their bytes against the limit.
class BufferLoader {
 public:
  BufferLoader(GltfStore& store, const Resolver& resolve, const Limits& limits)
      : store_(store), resolve_(resolve), limits_(limits), taken_(store.file.size()) {}

  Status run() {
    const JsonText& json = store_.json;
    const std::vector<int> list = json.children(json.find(JsonText::kRoot, "buffers"));
    store_.buffers.resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Status status = load(list[i], i);
      if (!status) return status;
    }
    for (std::size_t v = 0; v < store_.model.views.size(); ++v) {
      const GltfView& view = store_.model.views[v];
      const int buffer = view.meshopt ? view.meshopt->buffer : view.buffer;
      if (store_.buffers[static_cast<std::size_t>(buffer)].kind != GltfBufferKind::kNone) continue;
      return refuse(formatText("/bufferViews/%zu", v),
                    formatText("buffer %d has no data of its own: it has no 'uri', and it is not "
                               "the first buffer of a GLB",
                               buffer));
    }
    return Done{};
  }

 private:
  static Failure refuse(const std::string& pointer, const std::string& message,
                        ErrorCode code = ErrorCode::kMalformed) {
    Failure failure{code, "read", pointer + ": " + message, {}};
    if (code == ErrorCode::kLimit) failure.advice = {Note("raise-bytes")};
    return failure;
  }

  Status load(int node, std::size_t index) {
    const JsonText& json = store_.json;
    GltfBuffer& buffer = store_.buffers[index];
    const std::string pointer = json.pointer(node);
    const auto declared =
        static_cast<std::uint64_t>(json.integer(json.find(node, "byteLength")).value_or(0));
    const int uriNode = json.find(node, "uri");
    if (uriNode >= 0) {
      const std::string uri = json.string(uriNode);
      const Status status = isDataUri(uri) ? loadData(buffer, pointer, uri, declared)
                                           : loadFile(buffer, pointer, uri, declared);
      if (!status) return status;
      buffer.bytes = buffer.owned;
    } else if (index == 0 && store_.container.hasBin) {
      buffer.kind = GltfBufferKind::kBin;
      buffer.bytes = store_.container.bin;
    } else {
      return Done{};  // a fallback buffer of meshopt; run() refuses a view that needs it
    }
    if (buffer.bytes.size() >= declared) return Done{};
    return refuse(pointer,
                  formatText("declares %llu bytes, but there are %zu; the file may be truncated",
                             static_cast<unsigned long long>(declared), buffer.bytes.size()));
  }

  Status take(const std::string& pointer, std::uint64_t bytes) {
    if (bytes > limits_.maxBytes || taken_ > limits_.maxBytes - bytes) {
      return refuse(pointer, "the files together exceed " + byteLimit(limits_.maxBytes),
                    ErrorCode::kLimit);
    }
    taken_ += bytes;
    return Done{};
  }

  Status loadData(GltfBuffer& buffer, const std::string& pointer, const std::string& uri,
                  std::uint64_t declared) {
    const auto data = parseDataUri(uri);
    if (!data) return refuse(pointer, data.error().message);
    const auto size = decodedSize(data->base64);
    if (!size) return refuse(pointer, "the base64 text of its data URI is cut off");
    if (*size < declared) {
      return refuse(pointer, formatText("declares %llu bytes, but its data URI holds %zu",
                                        static_cast<unsigned long long>(declared), *size));
    }
    const Status status = take(pointer, *size);
    if (!status) return status;
    auto bytes = decodeBase64(data->base64);
    if (!bytes) return refuse(pointer, "its data URI is not base64");
    buffer.kind = GltfBufferKind::kData;
    buffer.owned = std::move(*bytes);
    return Done{};
  }

  Status loadFile(GltfBuffer& buffer, const std::string& pointer, const std::string& uri,
                  std::uint64_t declared) {
    auto name = relativeName(uri);
    if (!name) return refuse(pointer, name.error().message);
    const Status fits = take(pointer, declared);
    if (!fits) return fits;
    if (!resolve_) {
      return refuse(pointer, "needs the file " + text::inQuotes(*name, 120) +
                                 ", which was not given; load it together with the glTF");
    }
    auto bytes = resolve_(*name);
    if (!bytes) {
      Failure failure = std::move(bytes).error();
      failure.message = pointer + ": " + failure.message;
      return failure;
    }
    taken_ -= declared;
    const Status status = take(pointer, bytes->size());
    if (!status) return status;
    buffer.kind = GltfBufferKind::kFile;
    buffer.name = std::move(*name);
    buffer.owned = std::move(*bytes);
    return Done{};
  }

  GltfStore& store_;
  const Resolver& resolve_;
  const Limits& limits_;
  std::uint64_t taken_;
};

}  // namespace

Status loadGltfBuffers(GltfStore& store, const Resolver& resolve, const Limits& limits) {
  return BufferLoader(store, resolve, limits).run();
}

}  // namespace hgp::io
