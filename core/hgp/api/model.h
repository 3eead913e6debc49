// A loaded surface made ready: repaired where asked, checked, split into connected components, with the
// ways back to the file's ids.  Role: what every call of a session works on.
#pragma once

#include "hgp/api/id_map.h"
#include "hgp/api/options.h"
#include "hgp/mesh/topology.h"

namespace hgp::api {

/// One connected component of the surface. Its numbers are its own; its loops and generators are told
/// by those of the file (TriMesh::givenFace).
struct ModelComponent {
  TriMesh mesh;
  Topology topology;
  IdMap<VertexId, MeshVertexId> meshVertex;
  IdMap<FaceId, MeshFaceId> meshFace;
  IdMap<LoopId, SurfaceLoopId> loop;
  int generatorOffset = 0;  ///< handle generators are numbered through all components

  /// The ways through Model::mesh to the surface.
  IdMap<VertexId, SurfaceVertexId> vertex;
  IdMap<FaceId, SurfaceFaceId> face;
  IdMap<HalfedgeId, SurfaceCornerId> corner;
};

/// What LoadOptions::writesRepairs changed in the file.
struct WrittenRepairs {
  int facesTurned = 0;
  int verticesCopied = 0;
  int verticesBefore = 0;  ///< of the surface
};

struct Model {
  io::DocumentPtr document;
  LoadOptions load;  ///< as it was asked for
  std::string fileName;
  std::string sha256;  ///< of the main file
  std::uint64_t byteCount = 0;
  int surface = 0;

  MeshData mesh;                                      ///< after welding and repairs
  IdMap<MeshVertexId, SurfaceVertexId> vertexOrigin;  ///< one of those that became it
  IdMap<SurfaceVertexId, MeshVertexId> vertexImage;   ///< one of those it became; none when removed
  IdMap<MeshFaceId, SurfaceFaceId> faceOrigin;
  IdMap<MeshCornerId, SurfaceCornerId> cornerOrigin;
  std::vector<LeftOutFace> leftOut;       ///< faces of the surface that are not in `mesh`
  int splitVertices = 0;                  ///< vertices that repairs added
  std::optional<WrittenRepairs> written;  ///< where `document` is the repaired file
  /// Of a file that was converted: its own ids are those of `source()`.
  bool hasOwnVertexIds = true, hasOwnFaceIds = true;
  bool isChanged = false;          ///< a weld or a repair did something
  std::vector<std::string> notes;  ///< what reading, weld and repairs did
  std::optional<io::Prescription>
      embeddedCones;  ///< stored in the file; broken ones are only noted

  std::vector<Defect> defects;      ///< of `mesh`
  std::optional<Failure> unusable;  ///< why there are no components
  Topology topology;                ///< of the whole `mesh`
  std::vector<ModelComponent> components;

  const io::Surface& source() const {
    return document->surfaces()[static_cast<std::size_t>(surface)];
  }
};

/// Ids of a component in `where` become ids of the surface.
Failure toSurfaceIds(const Model& model, const ModelComponent& component, Failure failure);
void toSurfaceIds(const ModelComponent& component, std::vector<Where>& where);

}  // namespace hgp::api
