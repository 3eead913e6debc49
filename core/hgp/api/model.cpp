#include "hgp/api/model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/api/convert_document.h"
#include "hgp/api/mending.h"
#include "hgp/api/sha256.h"
#include "hgp/base/check.h"
#include "hgp/io/convert.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/nearby_order.h"

namespace hgp::api {
namespace {

std::vector<int> identity(std::size_t count) {
  std::vector<int> ids(count);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

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
        formatText("the file has %zu meshes; mesh %d is used", surfaces.size(), model.surface));
  }
  return Done{};
}

void weldNearVertices(Model& model, double tolerance) {
  io::Weld weld = io::weldNear(model.mesh.positions, tolerance);
  const std::size_t before = model.mesh.positions.size();
  if (weld.positions.size() == before) return;
  model.isChanged = true;
  model.notes.push_back(formatText("weld: %zu vertices became %zu", before, weld.positions.size()));
  model.mesh.positions = std::move(weld.positions);
  for (auto& t : model.mesh.triangles) {
    for (int& v : t) {
      if (v >= 0 && static_cast<std::size_t>(v) < before)
        v = weld.welded[static_cast<std::size_t>(v)];
    }
  }
  model.vertexOrigin = std::move(weld.firstStored);
  model.vertexImage = std::move(weld.welded);
}

/// Which corner of its original face each corner of a repaired face is. (No face has a vertex twice.)
std::array<int, 3> matchCorners(const Model& model, const std::array<int, 3>& after,
                                const std::array<int, 3>& original,
                                const std::vector<int>& vertexOrigin) {
  std::array<int, 3> corner{-1, -1, -1};
  std::array<bool, 3> isTaken{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = vertexOrigin[static_cast<std::size_t>(after[k])];
    for (std::size_t j = 0; j < 3 && corner[k] < 0; ++j) {
      const int image = model.vertexImage[static_cast<std::size_t>(original[j])];
      if (isTaken[j] || image < 0 || image != v) continue;
      corner[k] = static_cast<int>(j);
      isTaken[j] = true;
    }
  }
  return corner;
}

void repair(Model& model, const FixOptions& fix) {
  FixResult fixed = fixDefects(model.mesh, fix);
  model.notes.insert(model.notes.end(), fixed.notes.begin(), fixed.notes.end());
  if (fixed.notes.empty()) return;
  model.isChanged = true;
  const auto& original = model.source().mesh.triangles;
  std::vector<int> cornerOrigin(3 * fixed.faceOrigin.size(), -1);
  for (std::size_t f = 0; f < fixed.faceOrigin.size(); ++f) {
    const int old = fixed.faceOrigin[f];
    const auto corner = matchCorners(model, fixed.mesh.triangles[f],
                                     original[static_cast<std::size_t>(old)], fixed.vertexOrigin);
    for (std::size_t k = 0; k < 3; ++k) {
      HGP_CHECK(corner[k] >= 0, "repairs keep the corners of a face");
      cornerOrigin[3 * f + k] = 3 * old + corner[k];
    }
  }
  std::vector<int> image(model.mesh.positions.size(), -1);
  for (std::size_t v = fixed.vertexOrigin.size(); v-- > 0;) {
    const int old = fixed.vertexOrigin[v];
    if (old >= 0) image[static_cast<std::size_t>(old)] = static_cast<int>(v);
  }
  for (int& v : model.vertexImage) v = v < 0 ? -1 : image[static_cast<std::size_t>(v)];
  std::vector<int> vertexOrigin;
  for (int v : fixed.vertexOrigin) {
    vertexOrigin.push_back(v < 0 ? -1 : model.vertexOrigin[static_cast<std::size_t>(v)]);
  }
  model.vertexOrigin = std::move(vertexOrigin);
  model.faceOrigin = std::move(fixed.faceOrigin);
  model.cornerOrigin = std::move(cornerOrigin);
  model.leftOut = std::move(fixed.leftOut);
  model.splitVertices =
      static_cast<int>(fixed.mesh.positions.size()) - static_cast<int>(model.mesh.positions.size());
  model.mesh = std::move(fixed.mesh);
}

/// A component in scattered order gets numbers of its own.
void bringNeighboursTogether(ModelComponent& component) {
  if (!isScattered(component.mesh)) return;
  Numbering numbering = nearbyNumbering(component.mesh);
  component.mesh = renumbered(component.mesh, numbering);
  component.topology = computeTopology(component.mesh);
  for (int& v : numbering.vertices) v = component.vertexOrigin[static_cast<std::size_t>(v)];
  for (int& f : numbering.faces) f = component.faceOrigin[static_cast<std::size_t>(f)];
  component.vertexOrigin = std::move(numbering.vertices);
  component.faceOrigin = std::move(numbering.faces);
}

/// @pre model.defects has nothing fatal
Status splitIntoComponents(Model& model) {
  TriMesh whole = buildUsableMesh(model.mesh);
  model.topology = computeTopology(whole);
  const bool isOne = model.topology.componentCount == 1 && model.topology.isolatedVertexCount == 0;
  std::vector<std::vector<int>> loopsOf(static_cast<std::size_t>(model.topology.componentCount));
  for (std::size_t j = 0; j < model.topology.loops.size(); ++j) {
    const FaceId f = TriMesh::face(model.topology.loops[j].halfedges.front());
    loopsOf[static_cast<std::size_t>(model.topology.component[f])].push_back(static_cast<int>(j));
  }
  if (isOne) {
    model.components.push_back({std::move(whole), model.topology,
                                identity(model.mesh.positions.size()),
                                identity(model.mesh.triangles.size()), loopsOf[0], 0});
    bringNeighboursTogether(model.components.back());
    return Done{};
  }
  int generators = 0;
  std::vector<Component> components = splitComponents(model.mesh, whole, model.topology);
  for (std::size_t c = 0; c < components.size(); ++c) {
    // Judged again: alone it may be too small to compute with. Triangles without area were allowed, or
    // have been refused.
    Result<TriMesh> mesh = buildTriMesh(components[c].mesh, true);
    if (!mesh) return mesh.error();
    Topology topology = computeTopology(*mesh);
    const int genus = topology.genus;
    model.components.push_back({std::move(*mesh), std::move(topology),
                                std::move(components[c].vertexOrigin),
                                std::move(components[c].faceOrigin), loopsOf[c], generators});
    bringNeighboursTogether(model.components.back());
    generators += 2 * genus;
  }
  return Done{};
}

/// Cones inside a file are an offer: where they cannot be read, the rest of the file still can.
void takeEmbeddedCones(Model& model, const io::Document& document, int surface) {
  Result<std::optional<io::Prescription>> cones = document.embeddedCones(surface);
  if (cones) {
    model.embeddedCones = std::move(*cones);
  } else {
    model.notes.push_back("the cones stored in the file are not used: " + cones.error().message);
  }
}

void append(std::vector<std::string>& notes, std::vector<std::string> more) {
  notes.insert(notes.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

/// The surface as the file has it.
void takeSource(Model& model) {
  model.mesh = model.source().mesh;
  model.vertexOrigin = identity(model.mesh.positions.size());
  model.vertexImage = model.vertexOrigin;
  model.faceOrigin = identity(model.mesh.triangles.size());
  model.cornerOrigin = identity(3 * model.mesh.triangles.size());
}

/// Copies what repairs change.
void keepSurface(const Model& from, Model& to) {
  to.mesh = from.mesh;
  to.vertexOrigin = from.vertexOrigin;
  to.vertexImage = from.vertexImage;
  to.faceOrigin = from.faceOrigin;
  to.cornerOrigin = from.cornerOrigin;
  to.leftOut = from.leftOut;
  to.splitVertices = from.splitVertices;
  to.isChanged = from.isChanged;
  to.notes = from.notes;
}

void weld(Model& model, const LoadOptions& options) {
  if (options.weld >= 0) return weldNearVertices(model, options.weld);
  const WeldFacts facts = weldFacts(model.mesh);
  const bool joins = facts.isSoup && options.weld != LoadOptions::kWeldNever && !options.isStrict;
  if (joins) weldNearVertices(model, 0);
  append(model.notes, weldNotes(facts, joins));
}

bool isAny(const FixOptions& fix) { return fix.orient || fix.split || fix.degenerate; }

/// Repairs, then says in `unusable` what is still wrong.
void judgeRepaired(Model& model, const FixOptions& fix) {
  if (isAny(fix)) repair(model, fix);
  model.unusable.reset();
  if (model.mesh.triangles.empty()) {
    model.unusable = Failure{ErrorCode::kUnsupported,
                             "topology",
                             formatText("nothing is left to parametrize: none of the %zu triangles "
                                        "has an area of its own",
                                        model.source().mesh.triangles.size()),
                             {}};
    return;
  }
  model.defects = findDefects(model.mesh);
  if (Status usable = requireUsable(model.defects, fix.degenerate); !usable) {
    model.unusable = usable.error();
    return;
  }
  for (const Defect& defect : model.defects) {
    if (defect.kind != DefectKind::kZeroArea) continue;
    model.notes.push_back(
        formatText("%zu triangle%s no area: all edges are taken a little longer, so that every "
                   "triangle has one",
                   defect.where.size(), defect.where.size() == 1 ? " has" : "s have"));
  }
}

/// With repairs named, those; otherwise those that the defects ask for, and all of them where one
/// defect was hidden by another.
void mend(Model& model, const LoadOptions& options) {
  const bool isAutomatic = !isAny(options.fix) && !options.isStrict;
  FixOptions fix = options.fix;
  if (isAutomatic) {
    const std::vector<Defect> defects = findDefects(model.mesh);
    fix = neededRepairs(defects);
    if (isAny(fix)) {
      model.notes.push_back("repaired: " + withoutAdvice(requireUsable(defects).error().message));
    }
  }
  const bool mayTryAll = isAutomatic && isAny(fix) && !(fix.orient && fix.split && fix.degenerate);
  Model before;
  if (mayTryAll) keepSurface(model, before);
  judgeRepaired(model, fix);
  if (model.unusable && mayTryAll) {
    keepSurface(before, model);
    judgeRepaired(model, {true, true, true});
  }
  if (model.unusable && !options.isStrict) {
    model.unusable->message = withoutGiven(model.unusable->message, fix, isAutomatic);
  }
}

Status prepare(Model& model, const LoadOptions& options) {
  model.load = options;
  if (Status chosen = chooseSurface(model, options.surface); !chosen) return chosen;
  if (!model.embeddedCones) takeEmbeddedCones(model, *model.document, model.surface);
  const MeshData& source = model.source().mesh;
  if (source.triangles.size() > options.limits.maxTriangles) {
    return Failure{ErrorCode::kLimit,
                   "read",
                   formatText("%zu triangles exceed the limit", source.triangles.size()),
                   {}};
  }
  takeSource(model);
  weld(model, options);
  mend(model, options);
  if (model.unusable) return Done{};
  if (!options.isStrict && options.weld < 0)
    append(model.notes, crackNotes(crackFacts(model.mesh)));
  return splitIntoComponents(model);
}

Status convert(Model& model, const io::FileSet& files, const LoadOptions& options) {
  Result<ConvertedDocument> made = convertDocument(*model.document, files, options);
  if (!made) return made.error();
  append(model.notes, std::move(made->notes));
  model.hasOwnVertexIds = made->hasOwnVertexIds;
  model.hasOwnFaceIds = made->hasOwnFaceIds;
  const bool isObj = options.target == "obj";
  if (model.hasOwnVertexIds && (isObj || std::string_view(model.document->format()) != "gltf"))
    takeEmbeddedCones(model, *model.document, 0);
  model.document = std::move(made->document);
  return Done{};
}

}  // namespace

Result<Model> loadModel(io::FileSet files, const LoadOptions& options) {
  Model model;
  model.fileName = files.name;
  model.notes = std::move(files.notes);
  model.byteCount = files.main.size();
  if (files.main.size() <= options.limits.maxBytes) {
    model.sha256 = sha256(files.main.data(), files.main.size());
  }
  const std::string_view start =
      std::string_view(reinterpret_cast<const char*>(files.main.data()), files.main.size())
          .substr(0, 4096);
  const bool isPacked = options.target == "glb" && start.substr(0, 4) != "glTF" &&
                        start.find('{') != std::string_view::npos;
  const io::FileSet copy = isPacked ?  // a .gltf: from its own bytes
                               files
                                    : io::FileSet();
  Result<io::DocumentPtr> document = io::openDocument(std::move(files), options.limits);
  if (!document) return document.error();
  model.document = std::move(*document);
  LoadOptions of = options;
  if (!options.target.empty() && io::canConvert(*model.document, options.target)) {
    if (Status done = convert(model, copy, options); !done) return done.error();
    of.surface = std::string_view(model.document->format()) == "obj" ? -1 : options.surface;
  }
  if (Status done = prepare(model, of); !done) return done.error();
  return model;
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
