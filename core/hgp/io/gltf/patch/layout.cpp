#include "hgp/io/gltf/patch/layout.h"

#include <algorithm>

#include "hgp/base/check.h"

namespace hgp::io {
namespace {

std::size_t aligned(std::size_t offset) { return (offset + 3) / 4 * 4; }

/// The bytes of a buffer that a view reads: begin and end.
std::pair<std::size_t, std::size_t> spanIn(int buffer, const GltfView& view) {
  if (view.meshopt) {
    if (view.meshopt->buffer != buffer) return {0, 0};
    return {view.meshopt->offset, view.meshopt->offset + view.meshopt->length};
  }
  return view.buffer == buffer
             ? std::pair<std::size_t, std::size_t>(view.offset, view.offset + view.length)
             : std::pair<std::size_t, std::size_t>(0, 0);
}

}  // namespace

GltfLayout::GltfLayout(const GltfStore& store, JsonPatch& patch) : store_(store), patch_(patch) {
  const JsonText& json = store.json;
  views_ = json.children(json.find(JsonText::kRoot, "bufferViews"));
  buffer_ = static_cast<int>(store.buffers.size());
  const auto hasKind = [&](GltfBufferKind kind) {
    return std::any_of(store.buffers.begin(), store.buffers.end(),
                       [&](const GltfBuffer& b) { return b.kind == kind; });
  };
  if (hasKind(GltfBufferKind::kBin)) {
    sink_ = Sink::kBin;
    buffer_ = 0;
    bin_.assign(store.container.bin.begin(), store.container.bin.end());
  } else if (!store.container.isBinary && hasKind(GltfBufferKind::kFile)) {
    sink_ = Sink::kSideFile;
  }
  if (sink_ != Sink::kBin) continueBuffer();
  appendedAt_ = bin_.size();
}

/// Continues the buffer that an earlier run or mesh made for uv, so that a file has one of them.
void GltfLayout::continueBuffer() {
  const std::vector<int> nodes = store_.json.children(store_.json.find(JsonText::kRoot, "buffers"));
  const GltfBufferKind kind =
      sink_ == Sink::kSideFile ? GltfBufferKind::kFile : GltfBufferKind::kData;
  for (std::size_t b = 0; b < store_.buffers.size(); ++b) {
    if (store_.buffers[b].kind != kind) continue;
    if (store_.json.string(store_.json.find(nodes[b], "name")) != kGltfUvBuffer) continue;
    buffer_ = static_cast<int>(b);
    bufferNode_ = nodes[b];
    bin_.assign(store_.buffers[b].bytes.begin(), store_.buffers[b].bytes.end());
    return;
  }
}

void GltfLayout::release(const std::set<int>& views) {
  released_ = views;
  if (bin_.empty()) return;
  std::vector<std::pair<std::size_t, std::size_t>> live;
  for (std::size_t v = 0; v < store_.model.views.size(); ++v) {
    auto& list = released_.count(static_cast<int>(v)) > 0 ? holes_ : live;
    const auto span = spanIn(buffer_, store_.model.views[v]);
    if (span.second > span.first) list.push_back(span);
  }
  std::sort(live.begin(), live.end());
  std::sort(holes_.begin(), holes_.end());
  // Subtracts from the holes what is still read, in one sweep.
  std::vector<std::pair<std::size_t, std::size_t>> left;
  std::size_t done = 0, next = 0, liveEnd = 0;
  for (auto [begin, end] : holes_) {
    begin = std::max(begin, done);
    while (begin < end) {
      for (; next < live.size() && live[next].second <= begin; ++next) {
        liveEnd = std::max(liveEnd, live[next].second);
      }
      if (next < live.size() && live[next].first <= begin) {
        begin = live[next].second;
        continue;
      }
      const std::size_t stop = next < live.size() ? std::min(end, live[next].first) : end;
      const bool isNear =
          !left.empty() && left.back().second >= liveEnd && aligned(left.back().second) >= begin;
      if (isNear) {
        left.back().second = stop;  // only padding lies between them
      } else {
        left.emplace_back(begin, stop);
      }
      begin = stop;
    }
    done = std::max(done, end);
  }
  holes_ = std::move(left);
}

std::size_t GltfLayout::allocate(std::size_t size) {
  for (auto& [begin, end] : holes_) {
    const std::size_t offset = aligned(begin);
    if (offset > end || size > end - offset) continue;
    begin = offset + size;
    return offset;
  }
  const std::size_t offset = aligned(bin_.size());
  bin_.resize(offset + size, 0);
  return offset;
}

int GltfLayout::place(ByteView bytes, int target, std::uint64_t stride, int wanted) {
  const std::size_t offset = allocate(bytes.size());
  isPlaced_ = true;
  std::copy(bytes.begin(), bytes.end(), bin_.begin() + static_cast<std::ptrdiff_t>(offset));
  const auto view = wanted < 0 ? released_.begin() : released_.find(wanted);
  if (view == released_.end()) return addView(offset, bytes.size(), target, stride);
  const int reused = *view;
  released_.erase(view);
  showIn(reused, offset, bytes.size(), target, stride);
  return reused;
}

void GltfLayout::showIn(int view, std::size_t offset, std::size_t size, int target,
                        std::uint64_t stride) {
  const JsonText& json = store_.json;
  const int node = views_[static_cast<std::size_t>(view)];
  patch_.set(node, "buffer", std::to_string(buffer_));
  patch_.set(node, "byteOffset", std::to_string(offset));
  patch_.set(node, "byteLength", std::to_string(size));
  if (target != 0) patch_.set(node, "target", std::to_string(target));
  const int oldStride = json.find(node, "byteStride");
  if (stride != 0) {
    patch_.set(node, "byteStride", std::to_string(stride));
  } else if (oldStride >= 0) {
    patch_.remove(oldStride);
  }
  const int oldTarget = json.find(node, "target");
  if (target == 0 && oldTarget >= 0) patch_.remove(oldTarget);
  const int extensions = json.find(node, "extensions");
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const int extension = json.find(extensions, name);
    hasUnpacked_ = hasUnpacked_ || extension >= 0;
    if (extension >= 0) patch_.remove(extension);
  }
  if (extensions >= 0 && patch_.isEmptied(extensions)) patch_.remove(extensions);
}

int GltfLayout::addView(std::size_t offset, std::size_t size, int target, std::uint64_t stride) {
  std::string text =
      formatText("{\"buffer\":%d,\"byteOffset\":%zu,\"byteLength\":%zu", buffer_, offset, size);
  if (stride != 0) text += ",\"byteStride\":" + std::to_string(stride);
  if (target != 0) text += ",\"target\":" + std::to_string(target);
  newViews_.push_back(text + "}");
  return static_cast<int>(views_.size() + newViews_.size()) - 1;
}

Result<OutputFile> GltfLayout::finish(const std::string& mainName) {
  const JsonText& json = store_.json;
  const auto appendAll = [&](const char* array, const std::vector<std::string>& items) {
    const int node = json.find(JsonText::kRoot, array);
    std::string fresh;
    for (const std::string& item : items) {
      if (node >= 0) patch_.append(node, item);
      fresh += (fresh.empty() ? "[" : ",") + item;
    }
    if (node < 0 && !items.empty()) patch_.set(JsonText::kRoot, array, fresh + "]");
  };
  appendAll("bufferViews", newViews_);
  OutputFile side;
  if (!isPlaced_) return side;
  if (sink_ == Sink::kBin) {
    if (bin_.size() == appendedAt_) return side;
    const int node = json.firstChild(json.find(JsonText::kRoot, "buffers"));
    patch_.set(node, "byteLength", std::to_string(bin_.size()));
    return side;
  }
  std::string uri;
  if (sink_ == Sink::kSideFile) {
    side.name = fileStem(mainName) + "-uv.bin";
    const auto isTaken = [&] {
      for (std::size_t b = 0; b < store_.buffers.size(); ++b)
        if (static_cast<int>(b) != buffer_ && store_.buffers[b].name == side.name) return true;
      return false;
    };
    for (int n = 2; isTaken(); ++n) side.name = fileStem(mainName) + formatText("-uv%d.bin", n);
    uri = uriFromName(side.name);
    side.bytes = bin_;
  } else {
    uri = "data:application/octet-stream;base64," + encodeBase64(bin_);
  }
  if (bufferNode_ >= 0) {
    patch_.set(bufferNode_, "byteLength", std::to_string(bin_.size()));
    patch_.set(bufferNode_, "uri", quoteJson(uri));
    return side;
  }
  appendAll("buffers", {formatText("{\"name\":\"%s\",\"byteLength\":%zu,\"uri\":", kGltfUvBuffer,
                                   bin_.size()) +
                        quoteJson(uri) + "}"});
  return side;
}

}  // namespace hgp::io
