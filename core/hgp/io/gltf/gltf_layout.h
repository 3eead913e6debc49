// Where new data goes: buffer views and bytes.  Role: reuses views and bytes that nobody reads any
// more, appends the rest; old bytes never move.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hgp/io/gltf/gltf_splice.h"
#include "hgp/io/gltf/gltf_store.h"

namespace hgp::io {

class GltfLayout {
 public:
  GltfLayout(const GltfStore& store, JsonPatch& patch);

  /// Says that these views have lost their last reader. Call before the first place().
  void release(const std::set<int>& views);
  /// Stores bytes and returns the view that shows them: `wanted` when it has been released, any
  /// released one when none is wanted, else a new one.
  /// @param target  34962 vertices, 34963 indices, 0 neither    @param stride  0: tight
  int place(ByteView bytes, int target, std::uint64_t stride, int wanted = -1);
  /// Records the changes of buffers in the patch. The side file is empty when none is needed.
  Result<OutputFile> finish(const std::string& mainName);
  /// The BIN chunk after finish().
  const Bytes& bin() const { return bin_; }

  /// A view that was compressed holds plain bytes now.
  bool hasUnpacked() const { return hasUnpacked_; }

 private:
  enum class Sink { kBin, kSideFile, kDataUri };
  std::size_t allocate(std::size_t size);
  void showIn(int view, std::size_t offset, std::size_t size, int target, std::uint64_t stride);
  int addView(std::size_t offset, std::size_t size, int target, std::uint64_t stride);

  const GltfStore& store_;
  JsonPatch& patch_;
  Sink sink_ = Sink::kDataUri;
  int buffer_ = 0;  ///< index of the buffer written to
  Bytes bin_;       ///< the chunk, or the new buffer
  bool hasUnpacked_ = false;
  std::vector<std::pair<std::size_t, std::size_t>> holes_;  ///< begin, end; ascending
  std::set<int> released_;
  std::vector<int> views_;  ///< nodes of the text
  std::vector<std::string> newViews_;
  std::size_t appendedAt_ = 0;
};

}  // namespace hgp::io
