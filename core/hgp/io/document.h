// A loaded file, whatever its format: surfaces out, uv back in, everything else untouched.
// Role: bytes ↔ MeshData and the lossless patch back. No file system, no network, no exceptions of
// its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/written.h"
#include "hgp/mesh/face_edits.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/prescription/prescription.h"

namespace hgp::io {

/// What a reader may take before it ends with kLimit. Checked before memory is asked for.
struct Limits {
  std::uint64_t maxBytes = std::uint64_t{2} << 30;  ///< of all files together, and of decoded data
  std::uint64_t maxTriangles = 16'000'000;          ///< of one document
};

/// Hands over a side file by the relative name that the main file uses (percent-decoded, '/'). The
/// caller decides what may be seen; io refuses names that leave the folder before asking.
using Resolver = std::function<Result<Bytes>(const std::string& relativeName)>;

struct GltfDecoders;  // gltf_decoders.h
/// The main file and a way to its companions (a .gltf's .bin). `resolve` may be empty.
struct FileSet {
  std::string name;  ///< as the user wrote it; only its extension and messages use it
  Bytes main;
  Resolver resolve;
  std::vector<std::string> notes;  ///< what the one who opened the files wants to be told with them
  std::shared_ptr<const GltfDecoders> decoders;  ///< of compressed glTF; empty: those of this build
};

/// One mesh of a document as the method sees it.
struct Surface {
  std::string name;                ///< the file's own name, or ""
  MeshData mesh;                   ///< welded for glTF and STL, the file's connectivity otherwise
  int storedVertexCount = 0;       ///< before welding
  bool isWelded = false;           ///< vertex ids are welded ids (decided by exact position)
  std::vector<int> uvSets;         ///< sets that existingUv can give, ascending
  std::vector<std::string> notes;  ///< what a person should know (points skipped, n-gons cut …)
};

enum class UvPrecision { kFloat32, kFloat64 };

struct PlainFile;  // plain_surface.h

/// A loaded file. Immutable; all vertex and triangle ids are those of `surfaces()[surface].mesh`. uv always
/// has v pointing up; formats whose v points down are mirrored on both ways.
class Document {
 public:
  virtual ~Document() = default;
  virtual const char* format() const = 0;        ///< "obj" "off" "ply" "stl" "gltf" "glb"
  virtual const char* outputFormat() const = 0;  ///< what write() makes: "obj" "gltf" "glb"
  virtual bool canWriteAs(std::string_view format) const { return format == outputFormat(); }
  virtual const std::vector<Surface>& surfaces() const = 0;
  virtual UvPrecision uvPrecision() const = 0;

  /// uv stored in the file, exactly; nothing when some corner has none.
  virtual std::optional<UvMap> existingUv(int surface, int set) const = 0;
  /// The same for verifying, unrounded: v is −(stored v) where 1 − (stored v) is no double.
  virtual std::optional<UvMap> exactUv(int s, int set) const { return existingUv(s, set); }

  /// Exactly the map that existingUv gives after write() and reading again: rounded to float32, polygons
  /// kept whole: what a certificate must measure. Corners may be re-indexed.
  virtual UvMap asStored(int surface, const UvMap& map) const = 0;

  /// Cones stored inside the file, or nothing.
  virtual Result<std::optional<Prescription>> embeddedCones(int surface) const = 0;

  /// The original with `map` as a uv set of this surface. `map` must come from asStored.
  virtual Result<Written> write(int surface, const UvMap& map, const WriteOptions& o) const = 0;

  /// What other formats can hold, too; `surface` −1: all of the file, where its nodes put it.
  virtual Result<PlainFile> plain(int surface) const = 0;

  /// The same file after splitEdges(), what it stores interpolated, without cones; not for glTF.
  virtual Result<std::unique_ptr<Document>> refined(
      int surface, const std::vector<std::array<int, 2>>& edges) const = 0;

  /// The same file with these edits of its faces; of cones stored in it nothing is promised. In glTF,
  /// where vertices at one place are one, copies are stored apart and read as one again.
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

/// A plain OBJ of one mesh with its uv (may be empty), numbers printed so that doubles survive.
Bytes writePlainObj(const MeshData& mesh, const UvMap& map, const std::string& generator);

}  // namespace hgp::io
