// The plan of one patch, for the maps of one or more meshes.  Role: decides which accessors change and how; GltfLayout
// and JsonPatch carry it out.
// budget: one class, in six sources
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hgp/io/gltf/patch/layout.h"
#include "hgp/io/gltf/patch/map.h"
#include "hgp/io/gltf/patch/new_accessor.h"
#include "hgp/io/gltf/patch/splice.h"
#include "hgp/io/gltf/patch/split.h"

namespace hgp::io {

struct GltfBlended;  // blend_attributes.h
struct GltfRemesh;   // remesh.h

class GltfWriter {
 public:
  GltfWriter(const GltfStore& store, const WriteOptions& options);
  /// Plans the map of one mesh, each mesh at most once. @return  notes on it; on failure nothing can be written
  Result<Notes> add(const GltfMap& one);
  /// Plans other vertices and triangles for one mesh, instead of a map. (remesh.cpp)
  Status remesh(const GltfSurface& part, const GltfRemesh& mesh);
  /// The file with all maps. Written::xref is that of the mesh if there is one.
  Result<Written> finish();

 private:
  // writer.cpp
  void begin(const GltfSurface& part);
  Status chooseSet();
  int defaultSet();
  std::vector<int> ownUvReferences(int pool) const;
  void planPool(int pool);
  void planUv(int pool);
  void dropTangents(int primitive);
  bool isNormalMapFed(int primitive) const;
  void tellOrPointMaterials();  // materials.cpp: which uv set the textures of materials use
  std::set<int> setsOf(const GltfRun& run) const;
  std::set<int> setsOfMaterials() const;
  bool hasArea(const GltfRun& run, int set) const;
  void planMaterials(const std::set<int>& sets);
  void pointMaterials();
  Status embedCones(const std::optional<std::string>& cones);
  void collectXref();
  Note sizeNote(std::size_t written) const;
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
  // remesh.cpp
  void dropPrimitive(int primitive);
  void dropOld();
  void planShared(const std::vector<int>& accessors, const std::set<int>& references,
                  GltfBlended blended, std::size_t count);
  // extensions.cpp: EXT_mesh_manifold, and names of extensions that are no longer used
  void rewriteManifold();
  bool planManifold();
  int planMerge(int extension, const char* key, const std::vector<std::uint32_t>& words);
  void dropManifold(const char* code);
  void dropUnusedExtensions();
  void dropName(const char* extension);
  void releaseViews();
  std::vector<std::size_t> placingOrder() const;
  void placeAccessors();
  std::string editedAccessor(const GltfNewAccessor& fresh) const;

  const GltfPrimitive& primitive(int p) const {
    return store_.model.meshes[static_cast<std::size_t>(part_->mesh)]
        .primitives[static_cast<std::size_t>(p)];
  }
  const GltfAccessor& accessor(int a) const {
    return store_.model.accessors[static_cast<std::size_t>(a)];
  }
  std::string semantic(int set) const { return "TEXCOORD_" + std::to_string(set); }
  bool isDraco(int pool) const;
  bool isEdited(const GltfRun& run) const;
  void note(const char* code, std::vector<NoteValue> values = {}) {
    notes_.emplace_back(code, std::move(values));
  }

  const GltfStore& store_;
  const JsonText& json_;
  const WriteOptions& options_;
  JsonPatch patch_;
  GltfLayout layout_;
  std::vector<int> meshNodes_, materialNodes_, accessorNodes_;
  std::map<int, std::vector<int>> accessorReferences_;  ///< by accessor
  bool areReferencesKnown_ = false;
  std::vector<GltfNewAccessor> fresh_;
  int newAccessorCount_ = 0;
  std::set<int> freedNodes_;         ///< references to views that the patch removes
  int droppedDraco_ = 0;             ///< primitives
  int droppedManifolds_ = 0;         ///< meshes
  std::set<int> droppedAttributes_;  ///< references to accessors that the patch removes or moves
  using Pointed = std::map<std::pair<int, std::set<int>>, std::vector<int>>;
  std::map<int, Pointed> pointed_;  ///< material → new set, sets it replaces → primitive nodes
  int meshCount_ = 0;
  std::vector<int> xref_;

  // Of the mesh that is added.
  const GltfSurface* part_ = nullptr;
  GltfSplits splits_;
  int set_ = 0;
  int meshNode_ = -1;
  std::vector<int> primitiveNodes_;
  int askedSet_ = -1;                    ///< WriteOptions::uvSet of the mesh
  std::optional<bool> pointsMaterials_;  ///< likewise
  bool isRewritten_ = false;             ///< some pool has new vertices
  std::map<int, int> newIndices_;        ///< primitive → index in the plan
  Notes notes_;
};

/// The file with the patched text: the text itself, or a GLB with every other chunk kept.
Result<Bytes> packGltf(const GltfStore& store, const std::string& json, ByteView bin);
/// The same from the container alone.
Result<Bytes> packContainer(const GltfContainer& container, const std::string& json, ByteView bin);

}  // namespace hgp::io
