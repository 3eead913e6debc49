// The rules that a glTF text must satisfy before any other code uses it.  Role: assumes nothing about the
// text; every error names the value by its JSON pointer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/json/json.h"

namespace hgp::io {

/// Checks structure, extensions, references, byte ranges, the node tree and primitives in the text alone;
/// every buffer is assumed to be as long as it declares. Fails with kMalformed where a rule is broken, and with
/// kLimit where decoded or zero-filled accessors or triangles would exceed `limits`.
Status checkGltf(const JsonText& json, const Limits& limits);

/// Every value of a checked text that is an index into the top-level array `target` ("accessors" or
/// "bufferViews"), in the core format and in the extensions known here.
std::vector<int> gltfReferences(const JsonText& json, std::string_view target);
/// False when the file uses an extension whose references gltfReferences cannot know.
bool areGltfReferencesKnown(const JsonText& json);

/// Records the first broken rule; every check returns false from then on.
class GltfChecker {
 public:
  GltfChecker(const JsonText& json, const Limits& limits) : json_(json), limits_(limits) {}
  Status run();

 private:
  // check.cpp: the asset, extensions and references
  bool checkAsset();
  bool checkExtensionNames();
  bool checkReferences();
  bool checkReference(int node, std::string_view path, const char* target);
  // check_bytes.cpp: buffers, views and accessors
  bool checkBuffers();
  bool checkView(int view);
  bool checkMeshopt(int view, int extension, std::int64_t viewLength);
  bool checkMeshoptMode(int extension, const std::string& mode, std::int64_t stride);
  bool checkAccessor(int accessor);
  bool checkSparse(int accessor, int sparse, std::int64_t count, std::int64_t elementSize);
  bool checkSpan(int node, int view, std::int64_t offset, std::int64_t count,
                 std::int64_t elementSize, std::int64_t componentSize, bool isSparse);
  // check_scene.cpp: nodes, meshes and primitives
  bool checkNodes();
  bool checkMesh(int mesh);
  bool checkPrimitive(int primitive);
  bool checkVertexAttributes(int attributes, std::int64_t& count, bool isTarget);
  bool checkIndices(int primitive, std::int64_t& count);
  bool checkDraco(int primitive);

  bool fail(int node, const std::string& message, ErrorCode code = ErrorCode::kMalformed);
  /// "`what` would exceed the limit of … bytes".
  std::string overLimit(const std::string& what) const;
  /// Reads a non-negative integer member; a missing one is `fallback`, or an error if that is −1.
  bool integer(int object, const char* key, std::int64_t fallback, std::int64_t& out);
  /// The i-th element of a top-level array whose reference has been checked.
  int element(const char* array, int referenceNode) const;

  const JsonText& json_;
  const Limits& limits_;
  std::optional<Failure> failure_;
  std::vector<int> buffers_, views_, accessors_, meshes_, nodes_;
  std::uint64_t zeroBytes_ = 0;  ///< of accessors without data of their own
  std::uint64_t sparseElements_ = 0;
  std::uint64_t triangles_ = 0;
};

}  // namespace hgp::io
