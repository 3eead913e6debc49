#include "hgp/api/model/repaired_model.h"

#include <algorithm>

#include "hgp/api/model/needed_repairs.h"
#include "hgp/base/check.h"
#include "hgp/io/weld.h"

namespace hgp::api {
namespace {

void weldNearVertices(Model& model, double tolerance) {
  io::Weld weld = io::weldNear(model.mesh.positions, tolerance);
  const std::size_t before = model.mesh.positions.size();
  if (weld.positions.size() == before) return;
  model.isChanged = true;
  model.notes.push_back(Note("weld", {{"before", before}, {"after", weld.positions.size()}}));
  model.mesh.positions = std::move(weld.positions);
  for (auto& t : model.mesh.triangles) {
    for (int& v : t) {
      if (v >= 0 && static_cast<std::size_t>(v) < before)
        v = weld.welded[static_cast<std::size_t>(v)];
    }
  }
  model.vertexOrigin = IdMap<MeshVertexId, SurfaceVertexId>(std::move(weld.firstStored));
  model.vertexImage = IdMap<SurfaceVertexId, MeshVertexId>(std::move(weld.welded));
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
      const int image = model.vertexImage[SurfaceVertexId{original[j]}].i;
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
  // Ids before and after the repairs.
  using BeforeId = MeshVertexId;
  model.vertexImage = model.vertexImage.then(IdMap<BeforeId, MeshVertexId>(std::move(image)));
  model.vertexOrigin =
      IdMap<MeshVertexId, BeforeId>(std::move(fixed.vertexOrigin)).then(model.vertexOrigin);
  model.faceOrigin = IdMap<MeshFaceId, SurfaceFaceId>(std::move(fixed.faceOrigin));
  model.cornerOrigin = IdMap<MeshCornerId, SurfaceCornerId>(std::move(cornerOrigin));
  model.leftOut = std::move(fixed.leftOut);
  model.splitVertices =
      static_cast<int>(fixed.mesh.positions.size()) - static_cast<int>(model.mesh.positions.size());
  model.mesh = std::move(fixed.mesh);
}

/// Takes the surface as it is in the file.
void takeSource(Model& model) {
  model.mesh = model.source().mesh;
  const std::size_t vertices = model.mesh.positions.size(), faces = model.mesh.triangles.size();
  model.vertexOrigin = model.vertexOrigin.identity(vertices);
  model.vertexImage = model.vertexImage.identity(vertices);
  model.faceOrigin = model.faceOrigin.identity(faces);
  model.cornerOrigin = model.cornerOrigin.identity(3 * faces);
}

/// Copies the members that repairs change.
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
  addNotes(model, weldNotes(facts, joins));
}

Failure nothingLeft(const Model& model) {
  const bool isRounded = model.load.target == "glb" && !model.hasOwnVertexIds;
  return {
      ErrorCode::kUnsupported,
      "topology",
      formatText("nothing is left to parametrize: %sno triangle of %zu has an area of its own%s",
                 isRounded ? "as glTF, with coordinates in single precision, " : "",
                 model.source().mesh.triangles.size(),
                 isRounded
                     ? "; move the mesh to the origin, or name the result -o x.obj (target: 'obj')"
                     : ""),
      {}};
}

/// Repairs the mesh, then sets `unusable` if defects remain.
void repairAndCheck(Model& model, const FixOptions& fix) {
  if (fix.isAny()) repair(model, fix);
  model.unusable.reset();
  if (model.mesh.triangles.empty()) {
    model.unusable = nothingLeft(model);
    return;
  }
  model.defects = findDefects(model.mesh);
  if (Status usable = requireUsable(model.defects, fix.degenerate); !usable) {
    model.unusable = usable.error();
    return;
  }
  for (const Defect& defect : model.defects) {
    if (defect.kind != DefectKind::kZeroArea) continue;
    model.notes.push_back(Note("repair-lengths", {{"triangles", defect.where.size()}}));
  }
}

/// Makes the repairs that the options name; otherwise those that the defects need, and then all of them if the mesh
/// is still unusable, since one defect can hide another.
void repairAsAsked(Model& model, const LoadOptions& options) {
  const bool isAutomatic = !options.fix.isAny() && !options.isStrict;
  FixOptions fix = options.fix;
  if (isAutomatic) {
    const std::vector<Defect> defects = findDefects(model.mesh);
    fix = neededRepairs(defects);
    for (const Defect& defect : defects)
      if (fix.isAny() && isFatal(defect.kind)) model.notes.push_back(noteOn(defect, true));
  }
  const bool mayTryAll = isAutomatic && fix.isAny() && !(fix.orient && fix.split && fix.degenerate);
  Model before;
  if (mayTryAll) keepSurface(model, before);
  repairAndCheck(model, fix);
  if (model.unusable && mayTryAll) {
    keepSurface(before, model);
    repairAndCheck(model, {true, true, true});
  }
  if (model.unusable && !options.isStrict) {
    model.unusable->advice = adviceAfter(model.unusable->advice, fix, isAutomatic);
  }
}

}  // namespace

void addNotes(Model& model, Notes more) { hgp::addNotes(model.notes, std::move(more)); }

void takeRepaired(Model& model, const LoadOptions& options) {
  model.leftOut.clear();
  model.splitVertices = 0;
  takeSource(model);
  weld(model, options);
  repairAsAsked(model, options);
}

}  // namespace hgp::api
