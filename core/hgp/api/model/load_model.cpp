#include "hgp/api/model/load_model.h"

#include <algorithm>
#include <cmath>

#include "hgp/api/model/cell_lengths.h"
#include "hgp/api/model/convert_document.h"
#include "hgp/api/model/cracks.h"
#include "hgp/api/model/needed_repairs.h"
#include "hgp/api/model/repaired_model.h"
#include "hgp/api/model/written_repairs.h"
#include "hgp/api/sha256.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/convert.h"
#include "hgp/io/limits.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/nearby_order.h"

namespace hgp::api {
namespace {

/// Chooses the surface; −1 means the one with most triangles.
Status chooseSurface(Model& model, int wanted) {
  const auto& surfaces = model.document->surfaces();
  if (surfaces.empty()) {
    return Failure{ErrorCode::kUnsupported, "read", "the file has no triangles", {}};
  }
  if (wanted >= static_cast<int>(surfaces.size())) {
    return Failure{ErrorCode::kUsage,
                   "read",
                   formatText("mesh %d was asked for; the file has %zu (counted from 0)", wanted,
                              surfaces.size()),
                   {}};
  }
  model.surface = wanted;
  if (wanted >= 0) return Done{};
  const auto largest = std::max_element(surfaces.begin(), surfaces.end(),
                                        [](const io::Surface& a, const io::Surface& b) {
                                          return a.mesh.triangles.size() < b.mesh.triangles.size();
                                        });
  model.surface = static_cast<int>(largest - surfaces.begin());
  if (surfaces.size() > 1) {
    model.notes.push_back(
        Note("read-mesh-chosen", {{"meshes", surfaces.size()}, {"mesh", model.surface}}));
  }
  return Done{};
}

/// Renumbers a component whose triangles are in scattered order, for better locality.
void bringNeighboursTogether(ModelComponent& component) {
  if (!isScattered(component.mesh)) return;
  Numbering numbering = nearbyNumbering(component.mesh);
  component.mesh = renumbered(component.mesh, numbering);
  component.topology = computeTopology(component.mesh);
  component.meshVertex =
      IdMap<VertexId, VertexId>(std::move(numbering.vertices)).then(component.meshVertex);
  component.meshFace = IdMap<FaceId, FaceId>(std::move(numbering.faces)).then(component.meshFace);
}

/// Sets the maps from ids of a component to those of the surface; corners keep their order within a face.
void findSurfaceIds(const Model& model, ModelComponent& component) {
  component.vertex = component.meshVertex.then(model.vertexOrigin);
  component.face = component.meshFace.then(model.faceOrigin);
  std::vector<int> corners;
  corners.reserve(3 * at(component.meshFace.size()));
  for (int f : component.meshFace.raw())
    for (int k = 0; k < 3; ++k) corners.push_back(3 * f + k);
  component.corner = IdMap<HalfedgeId, MeshCornerId>(std::move(corners)).then(model.cornerOrigin);
}

void addComponent(Model& model, ModelComponent component) {
  bringNeighboursTogether(component);
  findSurfaceIds(model, component);
  model.components.push_back(std::move(component));
}

/// @pre model.defects has nothing fatal
Status splitIntoComponents(Model& model) {
  TriMesh whole = buildUsableMesh(model.mesh);
  model.topology = computeTopology(whole);
  model.components.reserve(static_cast<std::size_t>(model.topology.componentCount));
  const bool isOne = model.topology.componentCount == 1 && model.topology.isolatedVertexCount == 0;
  std::vector<std::vector<int>> loopsOf(static_cast<std::size_t>(model.topology.componentCount));
  for (std::size_t j = 0; j < model.topology.loops.size(); ++j) {
    const FaceId f = TriMesh::face(model.topology.loops[j].halfedges.front());
    loopsOf[static_cast<std::size_t>(model.topology.component[f])].push_back(static_cast<int>(j));
  }
  if (isOne) {
    ModelComponent all;
    all.mesh = std::move(whole);
    all.topology = model.topology;
    all.meshVertex = all.meshVertex.identity(model.mesh.positions.size());
    all.meshFace = all.meshFace.identity(model.mesh.triangles.size());
    all.loop = IdMap<LoopId, SurfaceLoopId>(std::move(loopsOf[0]));
    addComponent(model, std::move(all));
    return Done{};
  }
  int generators = 0;
  std::vector<Component> components = splitComponents(model.mesh, whole, model.topology);
  for (std::size_t c = 0; c < components.size(); ++c) {
    // Checked again, because a component alone may be too small to compute with. Triangles without area are
    // accepted here: if they are not allowed, the whole mesh was refused before.
    Result<TriMesh> mesh = buildTriMesh(components[c].mesh, true);
    if (!mesh) return mesh.error();
    ModelComponent part;
    part.mesh = std::move(*mesh);
    part.topology = computeTopology(part.mesh);
    part.meshVertex = IdMap<VertexId, MeshVertexId>(std::move(components[c].vertexOrigin));
    part.meshFace = IdMap<FaceId, MeshFaceId>(std::move(components[c].faceOrigin));
    part.loop = IdMap<LoopId, SurfaceLoopId>(std::move(loopsOf[c]));
    part.generatorOffset = generators;
    generators += 2 * part.topology.genus;
    addComponent(model, std::move(part));
  }
  return Done{};
}

void noteNotFinite(Model& model) {
  const std::vector<int> found = unusedNotFinite(model.source().mesh);
  if (found.empty()) return;
  model.notes.push_back(Note("read-not-finite",
                             {{"vertices", found.size()}, {"several", found.size() > 1 ? 1 : 0}},
                             {{Where::Kind::kVertex, found.front()}}));
}

/// Reads the cones stored in the file. They are optional: if they are invalid, a note says so.
void takeEmbeddedCones(OpenedFile& file, const io::Document& document, int surface) {
  Result<std::optional<prescription::Prescription>> cones = document.embeddedCones(surface);
  if (cones) {
    file.embeddedCones = std::move(*cones);
  } else {
    file.notes.push_back(Note("read-cones-unused", {{"why", cones.error().message}}));
  }
}

/// Replaces the document by the repaired file. The notes on its own repairs are dropped: in glTF, where copies at
/// equal positions are welded again, they would repeat what has been reported.
Status writeRepairs(Model& model, const LoadOptions& options) {
  const FaceEdits edits = editsOf(model);
  if (edits.faces.empty()) return Done{};
  Result<io::DocumentPtr> repaired = model.document->repaired(model.surface, edits);
  if (!repaired) return repaired.error();
  const auto vertices = static_cast<int>(model.source().mesh.positions.size());
  model.notes.push_back(noteOn(edits, vertices));
  const Notes notes = model.notes;
  model.document = std::move(*repaired);
  model.written = {edits.turned, static_cast<int>(edits.copyOf.size()), vertices};
  takeRepaired(model, options);
  model.notes = notes;
  return Done{};
}

Status prepare(Model& model, const LoadOptions& options) {
  model.load = options;
  if (Status chosen = chooseSurface(model, options.surface); !chosen) return chosen;
  if (!model.embeddedCones) takeEmbeddedCones(model, *model.document, model.surface);
  const MeshData& source = model.source().mesh;
  if (source.triangles.size() > options.limits.maxTriangles) {
    return io::tooManyTriangles(source.triangles.size(), options.limits.maxTriangles);
  }
  noteNotFinite(model);
  takeRepaired(model, options);
  if (model.unusable) return Done{};
  if (options.writesRepairs) {
    if (Status done = writeRepairs(model, options); !done) return done;
    if (model.unusable) return Done{};
  }
  if (options.weld < 0) addNotes(model, crackNotes(crackFacts(model.mesh)));
  return splitIntoComponents(model);
}

Status convert(OpenedFile& file, const io::FileSet& files, const LoadOptions& options) {
  Result<ConvertedDocument> made = convertDocument(*file.document, files, options);
  if (!made) return made.error();
  file.notes.insert(file.notes.end(), made->notes.begin(), made->notes.end());
  file.hasOwnVertexIds = made->hasOwnVertexIds;
  file.hasOwnFaceIds = made->hasOwnFaceIds;
  const bool isObj = options.target == "obj";
  if (file.hasOwnVertexIds && (isObj || std::string_view(file.document->format()) != "gltf"))
    takeEmbeddedCones(file, *file.document, 0);
  file.document = std::move(made->document);
  file.isJoined = std::string_view(file.document->format()) == "obj";
  return Done{};
}

}  // namespace

Result<OpenedFile> openFile(io::FileSet files, const LoadOptions& options) {
  OpenedFile file;
  file.fileName = files.name;
  file.notes = std::move(files.notes);
  file.byteCount = files.main.size();
  if (files.main.size() <= options.limits.maxBytes) {
    file.sha256 = sha256(files.main.data(), files.main.size());
  }
  const std::string_view start =
      std::string_view(reinterpret_cast<const char*>(files.main.data()), files.main.size())
          .substr(0, 4096);
  const bool isPacked = options.target == "glb" && start.substr(0, 4) != "glTF" &&
                        start.find('{') != std::string_view::npos;
  const io::FileSet copy = isPacked ?  // the GLB made from a .gltf
                               files
                                    : io::FileSet();
  files.target = options.target;
  Result<io::DocumentPtr> document = io::openDocument(std::move(files), options.limits);
  if (!document) return document.error();
  file.document = std::move(*document);
  if (!options.target.empty() && io::canConvert(*file.document, options.target)) {
    if (Status done = convert(file, copy, options); !done) return done.error();
  }
  file.cellLengths = cellLengths(*file.document);
  return file;
}

Result<Model> modelOfFile(OpenedFile file, const LoadOptions& options) {
  Model model;
  static_cast<OpenedFile&>(model) = std::move(file);
  LoadOptions of = options;
  if (model.isJoined) of.surface = -1;
  if (Status done = prepare(model, of); !done) return done.error();
  return model;
}

Result<Model> loadModel(io::FileSet files, const LoadOptions& options) {
  Result<OpenedFile> file = openFile(std::move(files), options);
  if (!file) return file.error();
  return modelOfFile(std::move(*file), options);
}

Result<Model> modelOfDocument(io::DocumentPtr document, const LoadOptions& options) {
  Model model;
  model.document = std::move(document);
  if (Status done = prepare(model, options); !done) return done.error();
  return model;
}

Result<Model> modelOfArrays(MeshData arrays, const LoadOptions& options) {
  Result<io::DocumentPtr> document = documentOfArrays(std::move(arrays));
  if (!document) return document.error();
  Model model;
  model.document = std::move(*document);
  const MeshData& mesh = model.document->surfaces()[0].mesh;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(mesh.positions.data());
  model.byteCount = mesh.positions.size() * sizeof(Vec3);
  model.sha256 = sha256(bytes, static_cast<std::size_t>(model.byteCount));
  if (Status done = prepare(model, options); !done) return done.error();
  return model;
}

}  // namespace hgp::api
