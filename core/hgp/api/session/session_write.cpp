// Writes results: the original file with its map, and the map in other formats.
#include <algorithm>
#include <cmath>

#include "hgp/api/model/load_model.h"
#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/api/session/side_files.h"
#include "hgp/api/stored/pack_components.h"
#include "hgp/base/check.h"
#include "hgp/io/cone_files.h"
#include "hgp/io/grid_material.h"
#include "hgp/io/plain_surface.h"
#include "hgp/io/uv_layout.h"

namespace hgp::api {

std::string extensionOf(const std::string& name) {
  const std::size_t dot = name.find_last_of("./\\");
  if (dot == std::string::npos || name[dot] != '.') return "";
  std::string extension = name.substr(dot + 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return extension;
}

namespace {

constexpr double kTilesAcross = 40;  // default number of tiles across a map

std::string generator() { return std::string("hgp ") + version(); }

/// For each uv of a component, the component's vertex.
std::vector<VertexId> verticesOf(const TriMesh& mesh, const UvMap& map) {
  std::vector<VertexId> out(map.uv.size());
  for (std::size_t f = 0; f < map.cornerUv.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId corner{3 * static_cast<int>(f) + k};
      out[static_cast<std::size_t>(map.cornerUv[f][static_cast<std::size_t>(k)])] =
          mesh.tail(corner);
    }
  }
  return out;
}

/// The components of a result with their maps: unrounded if those were kept, otherwise as stored.
std::vector<ComponentMap> componentsOf(const Model& model, std::vector<ComponentMap> out,
                                       const StoredMap& stored) {
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!out[p].map.uv.empty()) continue;
    out[p].map = mapOfComponent(model.components[p], stored.map);
    out[p].copyOf = verticesOf(model.components[p].mesh, out[p].map);
    out[p].certificate = stored.certificates[p];
  }
  return out;
}

/// Whether two models have the same triangles of their files, joined at the same corners.
bool isSameSurface(const Model& a, const Model& b) {
  if (b.unusable || a.mesh.triangles.size() != b.mesh.triangles.size()) return false;
  const std::size_t corners = 3 * a.source().mesh.triangles.size();
  if (corners != 3 * b.source().mesh.triangles.size()) return false;
  std::vector<int> vertexOf(corners, -1);  // vertex of b, by corner of the file
  for (std::size_t c = 0; c < 3 * b.mesh.triangles.size(); ++c)
    vertexOf[at(b.cornerOrigin[MeshCornerId{static_cast<int>(c)}].i)] =
        b.mesh.triangles[c / 3][c % 3];
  std::vector<int> there(a.mesh.positions.size(), -1), back(b.mesh.positions.size(), -1);
  for (std::size_t c = 0; c < 3 * a.mesh.triangles.size(); ++c) {
    const int v = a.mesh.triangles[c / 3][c % 3];
    const int w = vertexOf[at(a.cornerOrigin[MeshCornerId{static_cast<int>(c)}].i)];
    if (w < 0 || (there[at(v)] >= 0 && there[at(v)] != w) || (back[at(w)] >= 0 && back[at(w)] != v))
      return false;
    there[at(v)] = w;
    back[at(w)] = v;
  }
  return true;
}

/// The mesh alone in another format, as it will be read with the same options. Fails with kUnsupported if the surface
/// would then differ from the one that was solved.
Result<Model> modelAs(const Model& model, const std::string& format) {
  Result<io::PlainFile> plain = model.document->plain(model.surface);
  if (!plain) return plain.error();
  io::FileSet files;
  files.name = "mesh." + format;
  files.main = format == "obj" ? plainObj(*plain, "") : plainGlb(*plain, generator());
  Result<io::DocumentPtr> document = io::openDocument(std::move(files), model.load.limits);
  if (!document) return document.error();
  LoadOptions options = model.load;  // with the same weld and repairs
  options.surface = -1;
  options.writesRepairs = false;
  Result<Model> made = modelOfDocument(std::move(*document), options);
  if (!made || isSameSurface(model, *made)) return made;
  return Failure{
      ErrorCode::kUnsupported,
      "write",
      format == "glb"
          ? "as a glTF this would be read as another surface than the one that was "
            "solved: vertices at one place, in single precision, are one vertex "
            "there; name the result -o x.glb (target: 'glb') to solve that"
          : "as " + format + " this would be read as another surface than the one that was solved",
      {}};
}

double chosenTiles(const UvMap& map, bool isAligned) {
  if (isAligned) return 2;
  const double extent = boxOf(map.uv).extent();
  return extent > 0 ? kTilesAcross / extent : 1;
}

Status addGrid(io::GridMaterial grid, const std::string& format, WrittenMap& written) {
  auto files = io::withGridMaterial(std::move(written.files), format, grid);
  if (!files) return files.error();
  written.files = std::move(*files);
  return Done{};
}

Failure wrongTiles() {
  return {ErrorCode::kUsage, "write", "a grid has a positive number of tiles per unit of uv", {}};
}

std::vector<io::UvEdge> bothSides(const std::vector<SeamEdge>& seams) {
  std::vector<io::UvEdge> out;
  out.reserve(2 * seams.size());
  for (const SeamEdge& s : seams) {
    out.push_back({s.a[0], s.a[1]});
    out.push_back({s.b[0], s.b[1]});
  }
  return out;
}

}  // namespace

io::WriteOptions ioOptions(const WriteOptions& options) {
  io::WriteOptions out;
  out.uvSet = options.uvSet;
  out.name = options.name;
  out.isSideFileNoted = options.isSideFileNoted;
  out.isCompressedLater = options.isCompressedLater;
  out.pointsMaterials = options.pointsMaterials;
  out.generator = generator();
  return out;
}

double Session::State::tilesOfGrid(const WriteOptions& options) const {
  const double asked = options.gridTiles.value_or(0);
  return asked > 0 ? asked : chosenTiles(solved->stored.map, solved->isAligned);
}

Result<WrittenMap> Session::State::writeOriginal(const WriteOptions& options) const {
  io::WriteOptions out = ioOptions(options);
  out.format = extensionOf(options.name);
  if (!model->document->canWriteAs(out.format)) out.format.clear();
  if (options.embedCones) out.cones = prescription::writeConesJson(solved->prescription, -1);
  Result<io::Written> written = model->document->write(model->surface, solved->stored.map, out);
  if (!written) return written.error();
  WrittenMap made{std::move(*written), solved->stored.isCertified};
  const std::string format =
      out.format.empty() ? std::string(model->document->outputFormat()) : out.format;
  if (options.gridTiles) {
    const io::GridMaterial grid{tilesOfGrid(options), model->source().meshInFile, options.uvSet};
    if (Status done = addGrid(grid, format, made); !done) return done.error();
  }
  return made;
}

bool Session::State::writesSplitMesh(std::string_view format) const {
  return finer && !finer->model->document->canWriteAs(format) &&
         model->document->canWriteAs(format) && (format == "glb" || format == "gltf");
}

Result<WrittenMap> Session::State::writeMesh(const WriteOptions& options) const {
  const bool isObj = options.format == MapFormat::kObj;
  Result<Model> there = modelAs(*model, isObj ? "obj" : "glb");
  if (!there) return there.error();
  const StorePlace place{*there->document, 0};
  const std::vector<ComponentMap> components =
      componentsOf(*model, solved->components, solved->stored);
  StoredMap stored = certifyAsItIs(*model, place, components, solved->stored.map);
  if (!stored.isCertified) stored = storeMap(*model, place, components, solved->options.scale);
  if (!stored.isCertified && !options.allowUncertified) {
    return Failure{ErrorCode::kNoMap,
                   "write",
                   isObj ? std::string("the map is certified in single precision, but not in the "
                                       "double precision of OBJ")
                         : std::string("the map is certified in double precision, but not in the "
                                       "single precision of glTF"),
                   {}};
  }
  io::WriteOptions out = ioOptions(options);
  out.uvSet = -1;
  if (options.embedCones && there->source().mesh.triangles == model->source().mesh.triangles)
    out.cones = prescription::writeConesJson(solved->prescription, -1);
  Result<io::Written> written = there->document->write(0, stored.map, out);
  if (!written) return written.error();
  WrittenMap made{std::move(*written), stored.isCertified};
  made.notes.insert(made.notes.end(), stored.notes.begin(), stored.notes.end());
  if (options.gridTiles) {
    const io::GridMaterial grid{tilesOfGrid(options), 0, -1};
    if (Status done = addGrid(grid, isObj ? "obj" : "glb", made); !done) return done.error();
  }
  if (options.format != MapFormat::kGltf) return made;
  Result<io::Written> apart = asGltf(std::move(made.files), options.name);
  if (!apart) return apart.error();
  made.files = std::move(apart->files);
  return made;
}

Result<WrittenMap> Session::write(const WriteOptions& options) const {
  return guarded([&]() -> Result<WrittenMap> {
    if (!hasResult()) return Failure{ErrorCode::kUsage, "write", "there is no result yet", {}};
    if (!isCertified() && !options.allowUncertified) {
      return Failure{ErrorCode::kNoMap, "write", "the map is not certified", {}};
    }
    if (options.gridTiles && !(*options.gridTiles >= 0 && std::isfinite(*options.gridTiles)))
      return wrongTiles();
    const State& shown = state_->shown();
    WrittenMap flat;
    flat.isCertified = isCertified();
    switch (options.format) {
      case MapFormat::kSame: {
        if (Status possible = canWrite(options.name); !possible) return possible.error();
        const std::string format = extensionOf(options.name);
        if (!state_->writesSplitMesh(format)) return shown.writeOriginal(options);
        WriteOptions mesh = options;
        mesh.format = format == "glb" ? MapFormat::kGlb : MapFormat::kGltf;
        return shown.writeMesh(mesh);
      }
      case MapFormat::kFlatObj:
        flat.files = {{options.name, io::flatObj(shown.solved->stored.map, generator())}};
        return flat;
      case MapFormat::kSvg:
        flat.files = {{options.name,
                       io::uvLayoutSvg(shown.solved->stored.map, bothSides(shown.solved->seams))}};
        return flat;
      default: {
        WriteOptions mesh = options;
        mesh.embedCones = false;
        return shown.writeMesh(mesh);
      }
    }
  });
}

}  // namespace hgp::api
