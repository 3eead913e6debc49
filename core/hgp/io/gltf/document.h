// A glTF asset as a Document.  Role: hands out surfaces and writes uv; the store stays as it was read.
#pragma once

#include <memory>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/placements.h"
#include "hgp/io/gltf/decode/store.h"
#include "hgp/io/gltf/decode/weld.h"

namespace hgp::io {

class GltfDocument : public Document {
 public:
  /// @param decoders  with which a copy of the file is read; empty: those of this build
  GltfDocument(std::shared_ptr<const GltfStore> store, std::vector<GltfSurface> parts,
               std::shared_ptr<const GltfDecoders> decoders);

  const GltfDocument* asGltf() const override { return this; }
  const char* format() const override { return store_->container.isBinary ? "glb" : "gltf"; }
  const char* outputFormat() const override { return format(); }
  /// Besides its own format: a GLB as a .gltf with a side file.
  bool canWriteAs(std::string_view wanted) const override {
    return wanted == format() || (wanted == "gltf" && store_->container.isBinary);
  }
  const std::vector<Surface>& surfaces() const override { return surfaces_; }
  UvPrecision uvPrecision() const override { return UvPrecision::kFloat32; }
  std::optional<UvMap> existingUv(int surface, int set) const override;
  std::optional<UvMap> exactUv(int surface, int set) const override;
  using Document::asStored;
  UvMap asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const override;
  Result<std::optional<prescription::Prescription>> embeddedCones(int surface) const override;
  Result<Written> write(int surface, const UvMap& map, const WriteOptions& options) const override;
  Result<WrittenMaps> writeAll(const std::vector<SurfaceUv>& maps,
                               const WriteOptions& options) const override;
  std::vector<Placements> placements() const override { return placementsOf(*store_, parts_); }
  Result<PlainFile> plain(int surface) const override;
  Result<DocumentPtr> refined(int surface,
                              const std::vector<std::array<int, 2>>& edges) const override;
  Result<DocumentPtr> repaired(int surface, const FaceEdits& edits) const override;
  Result<Written> remeshed(int surface, const Remesh& remesh,
                           const Resolver& resolve) const override;

 private:
  /// Side files that a patch wrote, and else those of the file; images are among the others.
  Resolver resolverWith(std::vector<OutputFile> sides, Resolver others) const;
  WriteOptions likeThis() const;
  Status storeApart(Written& written, const WriteOptions& options) const;
  /// The uv set with v = top − stored v; empty if a triangle primitive does not have it.
  std::optional<UvMap> readUv(int surface, int set, double top) const;

  std::shared_ptr<const GltfStore> store_;
  std::vector<GltfSurface> parts_;  ///< without their `surface`, which is in surfaces_
  std::vector<Surface> surfaces_;
  std::shared_ptr<const GltfDecoders> decoders_;
};

}  // namespace hgp::io
