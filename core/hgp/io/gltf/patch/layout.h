// Places new data in buffer views and buffers.  Role: reuses views and bytes that nothing reads any
// more, appends the rest, and never moves old bytes.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hgp/io/gltf/decode/store.h"
#include "hgp/io/gltf/patch/splice.h"

namespace hgp::io {

class GltfLayout {
 public:
  GltfLayout(const GltfStore& store, JsonPatch& patch);

  /// Marks views that nothing reads any more. Call before the first place().
  void release(const std::set<int>& views);
  /// Stores bytes and returns their view: `wanted` if it has been released, any released one if `wanted` is
  /// −1, a new one otherwise.
  /// @param target  34962 vertices, 34963 indices, 0 neither    @param stride  0: tight
  int place(ByteView bytes, int target, std::uint64_t stride, int wanted = -1);
  /// Records the changes of buffers in the patch. The returned side file is empty if none is needed.
  Result<OutputFile> finish(const std::string& mainName);
  /// The BIN chunk after finish().
  const Bytes& bin() const { return bin_; }

  /// Whether a view that was compressed now has uncompressed bytes.
  bool hasUnpacked() const { return hasUnpacked_; }

 private:
  enum class Sink { kBin, kSideFile, kDataUri };
  void continueBuffer();
  std::size_t allocate(std::size_t size);
  void showIn(int view, std::size_t offset, std::size_t size, int target, std::uint64_t stride);
  int addView(std::size_t offset, std::size_t size, int target, std::uint64_t stride);

  const GltfStore& store_;
  JsonPatch& patch_;
  Sink sink_ = Sink::kDataUri;
  int buffer_ = 0;         ///< index of the buffer written to
  int bufferNode_ = -1;    ///< JSON node of an old buffer for uv that is continued
  bool isPlaced_ = false;  ///< something was placed
  Bytes bin_;              ///< the BIN chunk, or the bytes of the buffer
  bool hasUnpacked_ = false;
  std::vector<std::pair<std::size_t, std::size_t>> holes_;  ///< unused [begin, end), ascending
  std::set<int> released_;
  std::vector<int> views_;  ///< JSON nodes
  std::vector<std::string> newViews_;
  std::size_t appendedAt_ = 0;
};

}  // namespace hgp::io
