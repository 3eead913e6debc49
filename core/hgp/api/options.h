// Options of the calls of session.h, and their verdicts.
// Role: types that clients use without the session itself.
#pragma once

#include <optional>
#include <string>

#include "hgp/base/progress.h"
#include "hgp/field/choose_cones.h"
#include "hgp/grid/grid_options.h"
#include "hgp/improve/improve_options.h"
#include "hgp/io/document.h"
#include "hgp/mesh/defects.h"
#include "hgp/parametrize/method.h"

namespace hgp::api {

struct LoadOptions {
  io::Limits limits;
  int surface = -1;  ///< which mesh of the file; −1: the one with most triangles
  /// Join vertices closer than this. kWeldAutomatic: what the format needs, and equal positions where
  /// every face is a component of its own; kWeldNever: what the format needs.
  double weld = kWeldAutomatic;
  static constexpr double kWeldAutomatic = -1.0, kWeldNever = -2.0;
  /// Convert the file to this format when it is read, so that the result can be written in it: "obj", "glb" or "gltf".
  /// "", or a format that the document can be written in anyway, changes nothing.
  std::string target;
  FixOptions fix;         ///< repairs to make; none: those that the defects need
  bool isStrict = false;  ///< with no repairs named: make none, refuse meshes that need one
  /// Write flipped faces and split vertices into the output; otherwise the file keeps its
  /// faces and vertices, and the certificate counts the differences.
  bool writesRepairs = false;
};

enum class BoundaryKind { kFree, kConvex };
enum class FrameSource {
  kAuto,  ///< our own smooth connection with the prescribed holonomy
  kFile,  ///< the directions of the field that came with the prescription
};
enum class Scale {
  kSolved,  ///< as solved
  kUnit,    ///< mean uv edge length 1
  kFit,     ///< uniformly into [0, 1]²
};

struct SolveOptions {
  int q = 4;          ///< for automatic cones; a prescription has its own
  int coneCount = 0;  ///< automatic cones: this many where possible; 0: as conesFor says
  ConesFor conesFor = ConesFor::kBalanced;
  bool alignToCurvature = false;
  BoundaryKind boundary = BoundaryKind::kFree;
  int maxRounds = 24;
  Method method = Method::kAuto;
  std::optional<ImproveOptions> improve;  ///< nothing: the map as solved
  FrameSource frames = FrameSource::kAuto;
  Scale scale = Scale::kSolved;
  /// A component without a map keeps the uv of the file, or is cut open to a disk, instead of ending the run; the
  /// result as a whole is then not certified.
  bool keepsGoing = false;
  /// Where there is no map, split edges and solve again on the refined mesh, which is then written.
  bool refines = false;
  GridOptions grid;  ///< cells are of all components together
  Progress progress;
};

/// The balance of ImproveOptions that a word asks for: "isometric" (0), "conformal" (−1), "area" (1) or
/// a number from −1 to 1; nothing for other words.
std::optional<double> improveBalance(const std::string& word);
/// The word for a balance, "" between the three.
std::string improveWord(double balance);

struct VerifyOptions {
  int q = 0;               ///< order to verify with when there is no prescription; 0: 4
  int uvSet = -1;          ///< −1: the last set, which is where param writes
  double tolerance = 0.0;  ///< CertifyOptions::tolerance: of a seam edge's length; radians
};

/// The format in which write() stores a result.
enum class MapFormat {
  kSame,     ///< the original with the result as a uv set, and nothing else changed
  kGlb,      ///< the mesh on its own, as a GLB …
  kGltf,     ///< … as a .gltf with a .bin beside it …
  kObj,      ///< … as an OBJ
  kFlatObj,  ///< the map laid flat as an OBJ
  kSvg,      ///< its edges as a drawing
};

/// "same", "glb", "gltf", "obj", "flat-obj" or "svg"; nothing for other words.
std::optional<MapFormat> mapFormatNamed(const std::string& word);

struct WriteOptions {
  MapFormat format = MapFormat::kSame;
  /// A grid as the material, for glTF and OBJ: number of tiles per unit of uv; 0: two per cell of an aligned
  /// map, about 40 across any other.
  std::optional<double> gridTiles;
  int uvSet = -1;    ///< −1: next free
  std::string name;  ///< of the main output
  bool embedCones = false;
  bool allowUncertified = false;  ///< otherwise write() fails with kNoMap
  bool pointsMaterials = false;   ///< glTF: the materials' pictures use the written set
  bool isSideFileNoted = true;    ///< a note names the side files that the new file needs
  bool isCompressedLater =
      false;  ///< glTF: no notes on what is stored uncompressed; see compressed()
};

/// A JSON document with its verdict: usable mesh, valid prescription or certified map.
struct Verdict {
  bool isGood = false;
  std::string json;
  std::optional<Failure> reason;  ///< where the verdict is bad because of one rule
};

}  // namespace hgp::api
