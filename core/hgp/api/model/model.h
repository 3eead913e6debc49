// A loaded surface, repaired, checked and split into connected components, with maps between its ids and those of the
// file.  Role: the state that every call of a session uses.
#pragma once

#include "hgp/api/model/id_map.h"
#include "hgp/api/options.h"
#include "hgp/mesh/topology.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// One connected component of the surface, renumbered; its loops and generators are numbered in the order of the
/// file (TriMesh::givenFace).
struct ModelComponent {
  TriMesh mesh;
  Topology topology;
  IdMap<VertexId, MeshVertexId> meshVertex;
  IdMap<FaceId, MeshFaceId> meshFace;
  IdMap<LoopId, SurfaceLoopId> loop;
  int generatorOffset = 0;  ///< number of handle generators of the components before

  /// Maps to ids of the surface, composed with those of Model::mesh.
  IdMap<VertexId, SurfaceVertexId> vertex;
  IdMap<FaceId, SurfaceFaceId> face;
  IdMap<HalfedgeId, SurfaceCornerId> corner;
};

/// The changes that LoadOptions::writesRepairs made to the file.
struct WrittenRepairs {
  int facesTurned = 0;
  int verticesCopied = 0;
  int verticesBefore = 0;  ///< of the surface
};

/// A file that is read, before one of its meshes is chosen: what all of them share.
struct OpenedFile {
  std::shared_ptr<const io::Document> document;
  std::string fileName;
  std::string sha256;  ///< of the main file
  std::uint64_t byteCount = 0;
  /// False after a conversion to another format: ids of the file are then not those of `source()`.
  bool hasOwnVertexIds = true, hasOwnFaceIds = true;
  bool isJoined =
      false;  ///< all meshes of the file became one, which LoadOptions::surface does not name
  std::vector<double> cellLengths;  ///< of automatic grids, by surface; {} of one surface
  Notes notes;                      ///< what reading, welding and repairs did
  std::optional<prescription::Prescription>
      embeddedCones;  ///< stored in the file; invalid ones only give a note
};

struct Model : OpenedFile {
  LoadOptions load;  ///< the options with which it was loaded
  int surface = 0;

  MeshData mesh;                                      ///< after welding and repairs
  IdMap<MeshVertexId, SurfaceVertexId> vertexOrigin;  ///< one of the vertices joined into it
  IdMap<SurfaceVertexId, MeshVertexId> vertexImage;   ///< one of its copies; none if removed
  IdMap<MeshFaceId, SurfaceFaceId> faceOrigin;
  IdMap<MeshCornerId, SurfaceCornerId> cornerOrigin;
  std::vector<LeftOutFace> leftOut;       ///< faces of the surface that are not in `mesh`
  int splitVertices = 0;                  ///< vertices that repairs added
  std::optional<WrittenRepairs> written;  ///< set if `document` is the repaired file
  bool isChanged = false;                 ///< a weld or a repair changed the surface

  std::vector<Defect> defects;      ///< of `mesh`
  std::optional<Failure> unusable;  ///< why there are no components
  Topology topology;                ///< of the whole `mesh`
  std::vector<ModelComponent> components;

  const io::Surface& source() const {
    return document->surfaces()[static_cast<std::size_t>(surface)];
  }
};

/// Replaces the ids of a component in `where` by ids of the surface.
Failure toSurfaceIds(const Model& model, const ModelComponent& component, Failure failure);
void toSurfaceIds(const ModelComponent& component, std::vector<Where>& where);
/// Also the id in its message.
Reason toSurfaceIds(const ModelComponent& component, Reason reason);

}  // namespace hgp::api
