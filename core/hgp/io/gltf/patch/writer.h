// The plan of one patch.  Role: decides which accessors change and how; GltfLayout and JsonPatch carry it out.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hgp/io/gltf/patch/layout.h"
#include "hgp/io/gltf/patch/splice.h"
#include "hgp/io/gltf/patch/split.h"

namespace hgp::io {

/// New contents of an accessor: of the old one, in place, if nothing else reads it, and of a new one otherwise.
struct GltfNewAccessor {
  int index = -1;    ///< of the accessor in the written file
  int node = -1;     ///< the old accessor, edited in place; −1: a new one
  std::string base;  ///< text from which a new one is made; "{}" if there is no old one
  std::map<std::string, std::string> members;  ///< members to set in it
  Bytes data;
  int target = 0;  ///< of the view: 34962 vertices, 34963 indices, 0 neither
  std::uint64_t stride = 0;
  int oldView = -1;
  int sharedWith = -1;  ///< index in the plan of the accessor whose data contain this one's
  std::uint64_t sharedOffset = 0;
  int sparseIndices = -1, sparseValues = -1;  ///< indices in the plan
};

class GltfWriter {
 public:
  GltfWriter(const GltfStore& store, const GltfSurface& part, const WriteOptions& options);
  Result<Written> run(const UvMap& map);

 private:
  // writer.cpp
  Status chooseSet();
  int defaultSet();
  std::vector<int> ownUvReferences(int pool) const;
  void planPool(int pool);
  void planUv(int pool);
  void dropTangents(int primitive);
  bool isNormalMapFed(int primitive) const;
  // materials.cpp: which uv set the textures of materials use
  void tellOrPointMaterials();
  std::set<int> setsOfMaterials() const;
  void pointMaterials();
  bool isUsedElsewhere(int material) const;
  Status embedCones();
  Result<Written> finish();
  void noteSize(std::size_t written);
  // rewrite.cpp: attributes and indices of a pool whose vertices change
  void rewriteAttributes(int pool);
  void rewriteIndices(const GltfRun& run);
  Bytes expanded(const Bytes& packed, std::size_t elementSize, int pool) const;
  int redirect(int accessor, const std::set<int>& references, GltfNewAccessor fresh);
  void setRange(GltfNewAccessor& fresh, int accessor, ByteView data) const;
  void dropDraco(int primitive);
  int manifoldPositions() const;
  bool isCompressed(int accessor) const;
  int indexTypeFor(int wanted, int vertexCount) const;
  std::vector<std::uint32_t> writtenIndices(const GltfRun& run) const;
  void planIndices(const GltfRun& run, const std::vector<std::uint32_t>& indices, int type);
  // extensions.cpp: EXT_mesh_manifold, and names of extensions that are no longer used
  void rewriteManifold();
  bool planManifold();
  int planMerge(int extension, const char* key, const std::vector<std::uint32_t>& words);
  void dropManifold(const char* why);
  void dropUnusedExtensions();
  void dropName(const char* extension);
  void releaseViews();
  std::vector<std::size_t> placingOrder() const;
  void placeAccessors();
  std::string editedAccessor(const GltfNewAccessor& fresh) const;

  const GltfPrimitive& primitive(int p) const {
    return store_.model.meshes[static_cast<std::size_t>(part_.mesh)]
        .primitives[static_cast<std::size_t>(p)];
  }
  const GltfAccessor& accessor(int a) const {
    return store_.model.accessors[static_cast<std::size_t>(a)];
  }
  std::string semantic(int set) const { return "TEXCOORD_" + std::to_string(set); }
  bool isDraco(int pool) const;
  bool isEdited(const GltfRun& run) const;
  void note(std::string text) { notes_.push_back(std::move(text)); }

  const GltfStore& store_;
  const JsonText& json_;
  const GltfSurface& part_;
  const WriteOptions& options_;
  JsonPatch patch_;
  GltfLayout layout_;
  GltfSplits splits_;
  int set_ = 0;
  int meshNode_ = -1;
  std::vector<int> primitiveNodes_, accessorNodes_;
  std::map<int, std::vector<int>> accessorReferences_;  ///< by accessor
  bool areReferencesKnown_ = false;
  std::vector<GltfNewAccessor> fresh_;
  int newAccessorCount_ = 0;
  std::set<int> freedNodes_;         ///< references to views that the patch removes
  int droppedDraco_ = 0;             ///< primitives
  bool isRewritten_ = false;         ///< some pool has new vertices
  std::set<int> droppedAttributes_;  ///< references to accessors that the patch removes
  std::map<int, int> newIndices_;    ///< primitive → index in the plan
  std::vector<std::string> notes_;
};

/// The file with the patched text: the text itself, or a GLB with every other chunk kept.
Result<Bytes> packGltf(const GltfStore& store, const std::string& json, ByteView bin);
/// The same from the container alone.
Result<Bytes> packContainer(const GltfContainer& container, const std::string& json, ByteView bin);

}  // namespace hgp::io
