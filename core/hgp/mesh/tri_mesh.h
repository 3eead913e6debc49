// S, an oriented manifold triangle mesh.  Role: the object to be parametrized [BCW17 §3.3, §4]. Threads may share a const one.
#pragma once

#include <array>
#include <vector>

#include "hgp/base/ids.h"
#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// Immutable connectivity and positions. Halfedge 3f + k runs from corner k to corner k + 1 of face
/// f, so face, next and previous are arithmetic; a boundary halfedge has no twin.
class TriMesh {
 public:
  int vertexCount() const { return positions_.size(); }
  int faceCount() const { return twin_.size() / 3; }
  int halfedgeCount() const { return twin_.size(); }
  int edgeCount() const { return edgeHalfedge_.size(); }

  IdRange<VertexId> vertices() const { return IdRange<VertexId>(vertexCount()); }
  IdRange<FaceId> faces() const { return IdRange<FaceId>(faceCount()); }
  IdRange<HalfedgeId> halfedges() const { return IdRange<HalfedgeId>(halfedgeCount()); }
  IdRange<EdgeId> edges() const { return IdRange<EdgeId>(edgeCount()); }

  static FaceId face(HalfedgeId h) { return FaceId(h.i / 3); }
  static HalfedgeId halfedge(FaceId f, int corner) { return HalfedgeId(3 * f.i + corner); }
  static HalfedgeId next(HalfedgeId h) { return HalfedgeId(h.i % 3 == 2 ? h.i - 2 : h.i + 1); }
  static HalfedgeId previous(HalfedgeId h) { return HalfedgeId(h.i % 3 == 0 ? h.i + 2 : h.i - 1); }

  VertexId tail(HalfedgeId h) const { return corner_[h]; }
  VertexId head(HalfedgeId h) const { return corner_[next(h)]; }
  /// The same edge seen from the other face; invalid on the boundary.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }
  bool isBoundary(HalfedgeId h) const { return !twin_[h].isValid(); }
  std::array<VertexId, 3> corners(FaceId f) const {
    return {corner_[halfedge(f, 0)], corner_[halfedge(f, 1)], corner_[halfedge(f, 2)]};
  }

  /// The n-th face in the order of the input. Where faces were renumbered (nearby_order.h), loops and
  /// generators are still found, and therefore numbered, in this order.
  FaceId givenFace(int n) const {
    return givenFace_.empty() ? FaceId(n) : givenFace_[static_cast<std::size_t>(n)];
  }
  HalfedgeId givenHalfedge(int n) const { return halfedge(givenFace(n / 3), n % 3); }

  EdgeId edge(HalfedgeId h) const { return edge_[h]; }
  /// The halfedge of smaller index on this edge.
  HalfedgeId halfedge(EdgeId e) const { return edgeHalfedge_[e]; }

  /// A halfedge leaving v. On the boundary it is the one whose face comes first counterclockwise
  /// (it has no twin). Invalid for a vertex without faces.
  HalfedgeId outgoing(VertexId v) const { return outgoing_[v]; }
  bool isIsolated(VertexId v) const { return !outgoing_[v].isValid(); }
  bool isBoundary(VertexId v) const { return isBoundaryVertex_[v]; }
  /// The next halfedge leaving the same vertex counterclockwise; invalid past the last face of a
  /// boundary vertex.
  HalfedgeId nextOutgoing(HalfedgeId h) const { return twin_[previous(h)]; }
  /// Number of faces around v.
  int valence(VertexId v) const;

  const Vec3& position(VertexId v) const { return positions_[v]; }

 private:
  friend TriMesh buildUsableMesh(const MeshData& data, std::vector<FaceId> givenFace);
  PerVertex<Vec3> positions_;
  PerHalfedge<VertexId> corner_;
  PerHalfedge<HalfedgeId> twin_;
  PerHalfedge<EdgeId> edge_;
  PerEdge<HalfedgeId> edgeHalfedge_;
  PerVertex<HalfedgeId> outgoing_;
  PerVertex<char> isBoundaryVertex_;
  std::vector<FaceId> givenFace_;  ///< empty: as numbered
};

/// for (HalfedgeId h : outgoingHalfedges(mesh, v)): the halfedges leaving v, counterclockwise.
class OutgoingRange {
 public:
  OutgoingRange(const TriMesh& mesh, VertexId v) : mesh_(&mesh), first_(mesh.outgoing(v)) {}
  struct Sentinel {};
  struct Iterator {
    const TriMesh* mesh;
    HalfedgeId first, current;
    bool isStarted;
    HalfedgeId operator*() const { return current; }
    Iterator& operator++() {
      current = mesh->nextOutgoing(current);
      isStarted = true;
      return *this;
    }
    bool operator!=(Sentinel) const {
      return current.isValid() && !(isStarted && current == first);
    }
  };
  Iterator begin() const { return {mesh_, first_, first_, false}; }
  Sentinel end() const { return {}; }

 private:
  const TriMesh* mesh_;
  HalfedgeId first_;
};
inline OutgoingRange outgoingHalfedges(const TriMesh& mesh, VertexId v) { return {mesh, v}; }

/// Builds S. Fails with kUnsupported, a count and the places when the data is not an oriented
/// manifold (findDefects lists everything that is wrong).
/// @param allowsZeroArea  accept faces without area; computeGeometry gives them lengths
Result<TriMesh> buildTriMesh(const MeshData& data, bool allowsZeroArea = false);
/// The same without the checks. @pre no defect of findDefects(data) is fatal
/// @param givenFace  see TriMesh::givenFace; empty for the order of the data
TriMesh buildUsableMesh(const MeshData& data, std::vector<FaceId> givenFace = {});

}  // namespace hgp
