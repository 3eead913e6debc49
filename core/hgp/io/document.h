// A loaded file of any format: hands out surfaces, writes uv, and leaves everything else unchanged.
// Role: bytes → MeshData, and the lossless patch back. Uses neither file system nor network and throws nothing itself.
// budget: the one interface of all formats
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/placements.h"
#include "hgp/io/polygons.h"
#include "hgp/io/written.h"
#include "hgp/mesh/face_edits.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/prescription/prescription.h"

namespace hgp::io {

class GltfDocument;

/// Beyond these a reader fails with kLimit. They are checked before memory is allocated.
struct Limits {
  std::uint64_t maxBytes = std::uint64_t{2} << 30;  ///< of all files together, and of decoded data
  std::uint64_t maxTriangles = 16'000'000;          ///< of one document
};

/// Returns the bytes of a side file, given the relative name in the main file (percent-decoded, with '/'). The
/// caller decides which files may be read; io itself refuses names that leave the folder.
using Resolver = std::function<Result<Bytes>(const std::string& relativeName)>;

struct GltfDecoders;  // decoders.h
/// The main file and access to its side files (such as a .gltf's .bin). `resolve` may be empty.
struct FileSet {
  std::string name;  ///< as the user wrote it; used for its extension and in messages
  Bytes main;
  std::string target;  ///< the format that will be written, as far as it is known
  Resolver resolve;
  Notes notes;                                   ///< of the caller that opened the files, for users
  std::shared_ptr<const GltfDecoders> decoders;  ///< for glTF; empty: those of this build
};

/// One mesh of a document, as it is parametrized.
struct Surface {
  std::string name;           ///< the file's own name, or ""
  MeshData mesh;              ///< welded for glTF and STL, the file's connectivity otherwise
  int meshInFile = 0;         ///< glTF: its index in the file, where meshes without triangles count
  int storedVertexCount = 0;  ///< before welding
  bool isWelded = false;      ///< vertex ids are welded ids (decided by exact position)
  std::vector<int> uvSets;    ///< sets that existingUv can read, ascending
  int ownUvSet = -1;          ///< the one of them that hgp wrote, if it is marked
  Notes notes;                ///< for users (points skipped, polygons triangulated …)
};

enum class UvPrecision { kFloat32, kFloat64 };

struct PlainFile;  // plain_surface.h
struct Remesh;     // remesh.h

/// A loaded file. Immutable; all vertex and triangle ids are those of `surfaces()[surface].mesh`. uv always
/// has v pointing up; formats whose v points down are mirrored on both ways.
class Document {
 public:
  virtual ~Document() = default;
  virtual const GltfDocument* asGltf() const { return nullptr; }
  virtual const char* format() const = 0;        ///< "obj" "off" "ply" "stl" "gltf" "glb"
  virtual const char* outputFormat() const = 0;  ///< written by default: "obj" "gltf" "glb"
  virtual bool canWriteAs(std::string_view format) const { return format == outputFormat(); }
  virtual const std::vector<Surface>& surfaces() const = 0;
  virtual UvPrecision uvPrecision() const = 0;

  /// The uv stored in the file, exactly; empty if the surface does not have this set.
  virtual std::optional<UvMap> existingUv(int surface, int set) const = 0;
  /// The same without rounding, for verification: v is −(stored v) if 1 − (stored v) is not exact in a double.
  virtual std::optional<UvMap> exactUv(int s, int set) const { return existingUv(s, set); }

  /// Exactly the map that existingUv returns once the file is written and read again, for instance rounded to
  /// float32; polygons stay whole. A certificate must be measured on this map. Corners may be re-indexed.
  /// @param partOf  the independent part of every triangle, −1 if it follows others; empty: found by connectivity
  virtual UvMap asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const = 0;
  UvMap asStored(int surface, const UvMap& map) const { return asStored(surface, map, {}); }
  /// The uv of a file in which only some corners have any, −1 elsewhere; no set of the surface.
  virtual std::optional<UvMap> incompleteUv(int) const { return std::nullopt; }
  /// The polygons that the triangles of a surface are cut from; {} if all of them are triangles.
  virtual PolygonsView polygons(int) const { return {}; }

  /// Cones stored inside the file; empty if there are none.
  virtual Result<std::optional<prescription::Prescription>> embeddedCones(int surface) const = 0;

  /// The original with `map` as a uv set of this surface. `map` must come from asStored.
  virtual Result<Written> write(int surface, const UvMap& map, const WriteOptions& o) const = 0;
  /// The same for several surfaces of a glTF, in time linear in their number; kUnsupported in other formats.
  virtual Result<WrittenMaps> writeAll(const std::vector<SurfaceUv>&, const WriteOptions&) const;
  /// By surface; {} without nodes.
  virtual std::vector<Placements> placements() const { return {}; }

  /// The content that other formats can store as well; `surface` −1: the whole file, as placed by its nodes.
  virtual Result<PlainFile> plain(int surface) const = 0;
  /// The same file after splitEdges(): stored attributes are interpolated, cones are left out. In glTF all primitives then
  /// share their vertices. Fails with kUnsupported where the file cannot store that.
  virtual Result<std::unique_ptr<Document>> refined(
      int surface, const std::vector<std::array<int, 2>>& edges) const = 0;

  /// The same file, as a GLB, with triangles of these polygons in place of a surface's; kUnsupported in other formats.
  /// @param resolve  gives images that are side files; may be empty: these stay outside
  virtual Result<Written> remeshed(int surface, const Remesh& remesh,
                                   const Resolver& resolve) const;

  /// The same file with these edits of its faces; cones stored in it may be lost. In glTF, where vertices at
  /// equal positions are welded, copies are stored separately but welded again when the file is read; the other
  /// surfaces of the result are empty.
  virtual Result<std::unique_ptr<Document>> repaired(int surface, const FaceEdits& edits) const = 0;
};
using DocumentPtr = std::unique_ptr<Document>;

Result<DocumentPtr> readObj(FileSet files, const Limits& limits);
Result<DocumentPtr> readOff(FileSet files, const Limits& limits);
Result<DocumentPtr> readPly(FileSet files, const Limits& limits);
Result<DocumentPtr> readStl(const FileSet& files, const Limits& limits);
Result<DocumentPtr> readGltf(FileSet files, const Limits& limits);  ///< GLB as well, by content

/// Chooses the reader by content first, then by the name's extension.
Result<DocumentPtr> openDocument(FileSet files, const Limits& limits);

/// A plain OBJ of one mesh with its uv (may be empty); numbers are printed so that they read back exactly.
Bytes writePlainObj(const MeshData& mesh, const UvMap& map, const std::string& generator);

}  // namespace hgp::io
