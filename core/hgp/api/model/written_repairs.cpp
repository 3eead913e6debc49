#include "hgp/api/model/written_repairs.h"

#include <algorithm>
#include <map>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/stable_order.h"

namespace hgp::api {

FaceEdits editsOf(const Model& model) {
  FaceEdits edits;
  const MeshData& source = model.source().mesh;
  const auto before = static_cast<int>(source.positions.size());
  std::map<std::pair<int, int>, int> copies;  // vertex of the surface, vertex of the mesh → copy
  for (std::size_t f = 0; f < model.mesh.triangles.size(); ++f) {
    const MeshFaceId inMesh{static_cast<int>(f)};
    EditedFace edit{model.faceOrigin[inMesh].i, {}, {}};
    const auto& stored = source.triangles[static_cast<std::size_t>(edit.face)];
    bool isChanged = false;
    for (std::size_t k = 0; k < 3; ++k) {
      edit.corner[k] =
          model.cornerOrigin[MeshCornerId{3 * inMesh.i + static_cast<int>(k)}].i - 3 * edit.face;
      const int own = stored[static_cast<std::size_t>(edit.corner[k])];
      const int mine = model.mesh.triangles[f][k];
      edit.vertex[k] = own;
      if (model.vertexImage[SurfaceVertexId{own}].i != mine) {
        const int next = before + static_cast<int>(edits.copyOf.size());
        const auto [it, isNew] = copies.try_emplace({own, mine}, next);
        if (isNew) edits.copyOf.push_back(own);
        edit.vertex[k] = it->second;
      }
      isChanged = isChanged || edit.vertex[k] != own;
    }
    const bool isTurned = (edit.corner[1] - edit.corner[0] + 3) % 3 == 2;
    edits.turned += isTurned;
    if (isTurned || isChanged) edits.faces.push_back(edit);
  }
  const auto byFace = [](const EditedFace& a, const EditedFace& b) { return a.face < b.face; };
  sortStably(edits.faces, byFace);
  for (const LeftOutFace& left : model.leftOut) edits.outside.push_back(left.face);
  std::sort(edits.outside.begin(), edits.outside.end());
  return edits;
}

Note noteOn(const FaceEdits& edits, int surfaceVertices) {
  return Note("repairs-written", {{"turned", edits.turned},
                                  {"comma", edits.turned > 0 && !edits.copyOf.empty() ? 1 : 0},
                                  {"copies", edits.copyOf.size()},
                                  {"last", surfaceVertices - 1}});
}

}  // namespace hgp::api
