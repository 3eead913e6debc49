#include "hgp/io/gltf/pack/pack.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/json/json.h"
#include "hgp/io/gltf/patch/splice.h"
#include "hgp/io/limits.h"

namespace hgp::io {
namespace {

constexpr const char* kMeshoptNames[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

std::string mimeTypeOf(ByteView bytes) {
  const auto starts = [&](std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  };
  if (starts("\x89PNG")) return "image/png";
  if (starts("\xFF\xD8")) return "image/jpeg";
  if (starts("\xABKTX 20")) return "image/ktx2";
  if (starts("RIFF")) return "image/webp";
  return "application/octet-stream";
}

std::vector<int> elementsOf(const JsonText& json, const char* list) {
  return json.children(json.find(JsonText::kRoot, list));
}

/// The bytes of a data URI or of a side file.
Result<Bytes> bytesOfUri(const std::string& uri, const Resolver& resolve) {
  if (isDataUri(uri)) {
    auto data = parseDataUri(uri);
    if (!data) return data.error();
    auto bytes = decodeBase64(data->base64);
    if (!bytes) return Failure{ErrorCode::kMalformed, "read", "a data URI is not base64", {}};
    return std::move(*bytes);
  }
  auto name = relativeName(uri);
  if (!name) return name.error();
  if (!resolve) return Failure{ErrorCode::kMalformed, "read", *name + " is missing", {}};
  return resolve(*name);
}

/// The geometry does not need images: a reference to one that does not exist is kept.
bool mayBeMissing(const Failure& failure) { return failure.code == ErrorCode::kMalformed; }

Note missingNote(const Failure& failure) {
  return Note("read-file-refused", {{"why", failure.message}});
}

Failure tooMany(const Limits& limits) {
  return {ErrorCode::kLimit,
          "read",
          "the side files together exceed " + byteLimit(limits.maxBytes),
          {},
          {Note("raise-bytes")}};
}

class GltfPacker {
 public:
  GltfPacker(const JsonText& json, const Resolver& resolve, const Limits& limits, Notes& notes)
      : json_(json), resolve_(resolve), limits_(limits), notes_(notes), patch_(json) {}

  Result<Bytes> run() {
    Status done = takeBuffers();
    if (done) done = takeImages();
    if (!done) return done.error();
    moveViews();
    std::string buffers = formatText("[{\"byteLength\":%zu}", bin_.size());
    for (const std::string& other : otherBuffers_) buffers += "," + other;
    patch_.set(JsonText::kRoot, "buffers", buffers + "]");
    return container();
  }

 private:
  Status addToBin(ByteView bytes) {
    while (bin_.size() % 4 != 0) bin_.push_back(0);
    if (bin_.size() + bytes.size() > std::min<std::uint64_t>(limits_.maxBytes, UINT32_MAX / 2))
      return tooMany(limits_);
    bin_.insert(bin_.end(), bytes.begin(), bytes.end());
    return Done{};
  }

  Status takeBuffers() {
    for (const int node : elementsOf(json_, "buffers")) {
      const std::string uri = json_.string(json_.find(node, "uri"));
      if (uri.empty()) {  // the fallback buffer of compressed views: it has no bytes and stays a buffer
        otherBuffers_.emplace_back(json_.raw(node));
        newBuffer_.push_back({static_cast<int>(otherBuffers_.size()), 0});
        continue;
      }
      auto bytes = bytesOfUri(uri, resolve_);
      if (!bytes) return bytes.error();
      const auto length = static_cast<std::size_t>(
          std::max<std::int64_t>(0, json_.integer(json_.find(node, "byteLength")).value_or(0)));
      if (bytes->size() < length)
        return Failure{
            ErrorCode::kMalformed,
            "read",
            formatText("a buffer declares %zu bytes, but there are %zu", length, bytes->size()),
            {}};
      const Status done = addToBin(ByteView(*bytes).first(length));
      if (!done) return done;
      newBuffer_.push_back({0, bin_.size() - length});
    }
    return Done{};
  }

  Status takeImages() {
    const std::vector<int> views = elementsOf(json_, "bufferViews");
    std::size_t viewCount = views.size();
    std::string added;
    for (const int node : elementsOf(json_, "images")) {
      const std::string uri = json_.string(json_.find(node, "uri"));
      if (uri.empty()) continue;
      auto bytes = bytesOfUri(uri, resolve_);
      if (!bytes && mayBeMissing(bytes.error())) {
        notes_.push_back(missingNote(bytes.error()));
        continue;
      }
      if (!bytes) return bytes.error();
      const Status done = addToBin(*bytes);
      if (!done) return done;
      const std::string view = formatText("{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}",
                                          bin_.size() - bytes->size(), bytes->size());
      if (views.empty())
        added += (added.empty() ? "" : ",") + view;
      else
        patch_.append(json_.find(JsonText::kRoot, "bufferViews"), view);
      patch_.remove(json_.find(node, "uri"));
      patch_.set(node, "bufferView", std::to_string(viewCount++));
      if (json_.find(node, "mimeType") < 0)
        patch_.set(node, "mimeType", quoteJson(mimeTypeOf(*bytes)));
    }
    if (!added.empty()) patch_.set(JsonText::kRoot, "bufferViews", "[" + added + "]");
    return Done{};
  }

  void moveReference(int owner) {
    const auto buffer = json_.integer(json_.find(owner, "buffer"));
    if (!buffer || *buffer < 0 || static_cast<std::size_t>(*buffer) >= newBuffer_.size()) return;
    const auto [index, shift] = newBuffer_[static_cast<std::size_t>(*buffer)];
    patch_.set(owner, "buffer", std::to_string(index));
    const auto offset = json_.integer(json_.find(owner, "byteOffset")).value_or(0);
    if (shift > 0)
      patch_.set(owner, "byteOffset", std::to_string(shift + static_cast<std::size_t>(offset)));
  }

  void moveViews() {
    for (const int view : elementsOf(json_, "bufferViews")) {
      moveReference(view);
      for (const char* name : kMeshoptNames)
        moveReference(json_.find(json_.find(view, "extensions"), name));
    }
  }

  Result<Bytes> container() const {
    std::string json = patch_.text();
    while (json.size() % 4 != 0) json += ' ';
    Bytes bin = bin_;
    while (bin.size() % 4 != 0) bin.push_back(0);
    const std::uint64_t total = 28 + std::uint64_t{json.size()} + bin.size();
    if (total > UINT32_MAX)
      return Failure{ErrorCode::kLimit, "write", "a GLB cannot be larger than 4 GiB", {}};
    Bytes out;
    out.reserve(total);
    const auto word = [&out](std::uint64_t x) {
      for (int k = 0; k < 4; ++k) out.push_back(static_cast<std::uint8_t>(x >> (8 * k) & 0xFF));
    };
    for (const std::uint64_t x : {std::uint64_t{0x46546C67}, std::uint64_t{2}, total,
                                  std::uint64_t{json.size()}, std::uint64_t{0x4E4F534A}})
      word(x);
    out.insert(out.end(), json.begin(), json.end());
    word(bin.size());
    word(0x004E4942);
    out.insert(out.end(), bin.begin(), bin.end());
    return out;
  }

  const JsonText& json_;
  const Resolver& resolve_;
  const Limits& limits_;
  Notes& notes_;
  JsonPatch patch_;
  Bytes bin_;
  std::vector<std::pair<int, std::size_t>> newBuffer_;  ///< old buffer → new one and offset
  std::vector<std::string> otherBuffers_;
};

}  // namespace

Result<Bytes> gltfAsGlb(const FileSet& files, const Limits& limits, Notes& notes) {
  auto container = openContainer(files.main);
  if (!container) return container.error();
  auto json = JsonText::parse(std::string(container->json));
  if (!json) return json.error();
  return GltfPacker(*json, files.resolve, limits, notes).run();
}

Result<Bytes> gltfWithEmbedded(ByteView text, const Resolver& resolve, const Limits& limits,
                               Notes& notes) {
  auto json = JsonText::parse(std::string(reinterpret_cast<const char*>(text.data()), text.size()));
  if (!json) return json.error();
  JsonPatch patch(*json);
  std::uint64_t total = text.size();
  for (const char* list : {"buffers", "images"}) {
    for (const int node : elementsOf(*json, list)) {
      const int member = json->find(node, "uri");
      const std::string uri = json->string(member);
      if (uri.empty() || isDataUri(uri)) continue;
      auto bytes = bytesOfUri(uri, resolve);
      const bool isImage = std::string_view(list) == "images";
      if (!bytes && isImage && mayBeMissing(bytes.error())) {
        notes.push_back(missingNote(bytes.error()));
        continue;
      }
      if (!bytes) return bytes.error();
      total += bytes->size();
      if (total > limits.maxBytes) return tooMany(limits);
      patch.replace(member,
                    "\"data:" + (isImage ? mimeTypeOf(*bytes) : "application/octet-stream") +
                        ";base64," + encodeBase64(*bytes) + "\"");
    }
  }
  return asBytes(patch.text());
}

Result<Written> glbAsGltf(ByteView glb, const std::string& name) {
  auto container = openContainer(glb);
  if (!container) return container.error();
  auto json = JsonText::parse(std::string(container->json));
  if (!json) return json.error();
  Written out;
  JsonPatch patch(*json);
  const int buffer = json->firstChild(json->find(JsonText::kRoot, "buffers"));
  const bool hasBin = container->hasBin && buffer >= 0 && json->find(buffer, "uri") < 0;
  OutputFile side;
  if (hasBin) {
    side.name = freeSideName(fileStem(name), gltfSideFiles(glb));
    const auto length = json->integer(json->find(buffer, "byteLength")).value_or(0);
    side.bytes.assign(container->bin.begin(), container->bin.end());
    side.bytes.resize(std::min(side.bytes.size(), static_cast<std::size_t>(length)));
    patch.set(buffer, "uri", quoteJson(uriFromName(side.name)));
  }
  std::string text = patch.text();
  text.resize(text.find_last_not_of(" \n") + 1);  // without the padding of the chunk
  out.files.push_back({name, asBytes(text)});
  if (hasBin) out.files.push_back(std::move(side));
  for (const GltfChunk& chunk : container->others)
    out.notes.push_back(Note("write-chunk-dropped", {{"bytes", chunk.bytes.size()},
                                                     {"type", formatText("%08X", chunk.type)}}));
  return out;
}

std::vector<std::string> gltfSideFiles(ByteView file, std::vector<std::string>* refused) {
  std::vector<std::string> out;
  auto container = openContainer(file);
  if (!container) return out;
  auto json = JsonText::parse(std::string(container->json));
  if (!json) return out;
  for (const char* list : {"buffers", "images"}) {
    for (const int node : elementsOf(*json, list)) {
      const std::string uri = json->string(json->find(node, "uri"));
      if (uri.empty() || isDataUri(uri)) continue;
      const auto name = relativeName(uri);
      const bool isRemote = uri.find("//") < 7;
      if (!name && !isRemote && refused) refused->push_back(name.error().message);
      if (name && std::find(out.begin(), out.end(), *name) == out.end()) out.push_back(*name);
    }
  }
  return out;
}

}  // namespace hgp::io
