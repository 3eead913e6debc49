// Options of the calls of session.h and their verdicts.
// Role: types for clients that do not include the session itself. Plain values that any thread may copy and read.
#pragma once

#include <optional>
#include <string>

#include "hgp/base/progress.h"
#include "hgp/cones/choose_cones.h"
#include "hgp/grid/grid_options.h"
#include "hgp/improve/improve_options.h"
#include "hgp/io/document.h"
#include "hgp/mesh/defects.h"
#include "hgp/parametrize/method.h"

namespace hgp::api {

struct LoadOptions {
  io::Limits limits;
  int surface = -1;  ///< which mesh of the file; −1: the one with the most triangles
  /// Join vertices closer than this, in the file's unit. kWeldNever: only where the format requires it (glTF, STL);
  /// kWeldAutomatic: also at equal positions if no two faces share a vertex.
  double weld = kWeldAutomatic;
  static constexpr double kWeldAutomatic = -1.0, kWeldNever = -2.0;
  /// Convert the file to this format when it is read, so that the result can be written in it: "obj", "glb" or "gltf".
  /// "", or a format that the document can be written in anyway, changes nothing; "ply" (of a PLY) stores floats.
  std::string target;
  FixOptions fix;         ///< repairs to make; none named: those that the defects need
  bool isStrict = false;  ///< if no repairs are named: make none and refuse meshes that need one
  /// Write flipped faces and split vertices into the output; otherwise the file keeps its
  /// faces and vertices, and the certificate counts the differences.
  bool writesRepairs = false;
};

enum class BoundaryKind {
  kFree,
  kConvex,     ///< disks onto a convex polygon, without cones (parametrizeConvex)
  kRectangle,  ///< disks onto a rectangle: rims are features, with four corners
};
enum class FrameSource {
  kAuto,  ///< those of a trivial connection computed here, with the prescribed holonomy
  kFile,  ///< those of the field that came with the prescription
};
enum class Scale {
  kSolved,  ///< as solved
  kUnit,    ///< mean uv edge length 1
  kFit,     ///< uniformly into [0, 1]²
};

/// The normal of the plane across which a map is symmetric; kAuto: whichever mirrors the mesh.
enum class Symmetry { kNone, kAuto, kX, kY, kZ };

struct SolveOptions {
  int q = 4;          ///< for automatic cones; a prescription has its own
  int coneCount = 0;  ///< automatic cones: this many if possible; 0: chosen by conesFor
  ConesFor conesFor = ConesFor::kBalanced;
  bool alignToCurvature = false;
  BoundaryKind boundary = BoundaryKind::kFree;
  int maxRounds = 24;
  Method method = Method::kAuto;
  std::optional<ImproveOptions> improve;  ///< empty: the map as solved
  FrameSource frames = FrameSource::kAuto;
  Scale scale = Scale::kSolved;
  /// A component without a map keeps the uv of the file, or is cut open to a disk, instead of ending the run; the
  /// result as a whole is then not certified.
  bool keepsGoing = false;
  /// Where there is no map, split edges and solve again on the refined mesh, which is then written.
  bool refines = false;
  /// Certify only maps in which every polygon of the file is convex; uv are moved for that after the solve.
  bool convexPolygons = false;
  GridOptions grid;  ///< the number of cells is that of all components together
  /// Align to a grid also where `grid` has neither a number of cells nor their length: automaticCells of them. Where the
  /// map is then not aligned, or not with the number that `grid` has, one with which it is, up to 100 000 triangles.
  bool choosesCells = false;
  /// One side of a plane is solved and the other is its mirror image, bit for bit; the plane is a feature.
  Symmetry symmetry = Symmetry::kNone;
  Progress progress;
};

struct VerifyOptions {
  int q = 0;               ///< order of rotations if there is no prescription; 0: 4
  int uvSet = -1;          ///< −1: the set that hgp wrote, or the last one
  double tolerance = 0.0;  ///< CertifyOptions::tolerance: of a seam edge's length; radians
};

/// The format in which write() stores a result.
enum class MapFormat {
  kSame,     ///< the original with the result as a uv set, and nothing else changed
  kGlb,      ///< the mesh alone, as a GLB
  kGltf,     ///< the mesh alone, as a .gltf with a .bin file
  kObj,      ///< the mesh alone, as an OBJ
  kFlatObj,  ///< the map as a flat mesh, as an OBJ
  kSvg,      ///< the edges of the map as a drawing
};

struct WriteOptions {
  MapFormat format = MapFormat::kSame;
  /// A grid as the material, for glTF and OBJ: number of tiles per unit of uv; 0: two per cell of an aligned
  /// map, about 40 across any other.
  std::optional<double> gridTiles;
  int uvSet = -1;    ///< −1: the one that hgp wrote before, otherwise the next free one
  std::string name;  ///< of the main output
  bool embedCones = false;
  bool allowUncertified = false;  ///< otherwise write() fails with kNoMap
  /// glTF: whether the materials' textures use the written set; unset: those whose own set is missing or without area.
  std::optional<bool> pointsMaterials;
  bool isSideFileNoted = true;  ///< a note names the side files that the new file needs
  bool isCompressedLater =
      false;  ///< glTF: omits notes on what is stored uncompressed; see compressed()
};

/// A JSON document with its verdict: whether a mesh is usable, a prescription valid or a map certified.
struct Verdict {
  bool isGood = false;
  std::string json;
  std::optional<Failure> reason;  ///< set if one broken rule determines a bad verdict
};

}  // namespace hgp::api
