#include "hgp/parametrize/mirror/image_map.h"

#include <algorithm>

#include "hgp/verify/certificate.h"

namespace hgp {
namespace {

FaceId imageOf(FaceId f, const Reflection& image) {
  return TriMesh::face(image.halfedge[TriMesh::halfedge(f, 0)]);
}

CopiedMap reflected(const CopiedMap& first, const TriMesh& mesh, const Reflection& image) {
  CopiedMap out;
  for (const Vec2& p : first.map.uv) out.map.uv.push_back({0.0 - p[0], p[1]});
  for (const VertexId v : first.copyOf) out.copyOf.push_back(image.vertex[v]);
  out.map.cornerUv.resize(at(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f)
    for (int k = 0; k < 3; ++k) {
      // The tail of a halfedge has its image at the head of the halfedge's.
      const HalfedgeId h = TriMesh::next(image.halfedge[TriMesh::halfedge(FaceId{f}, k)]);
      out.map.cornerUv[at(TriMesh::face(h).i)][at(h.i % 3)] = first.map.cornerUv[at(f)][at(k)];
    }
  return out;
}

/// With turnings and rotations along handles as they are measured.
CompleteSpec specOf(const CompleteSpec& first, const TriMesh& from, const TriMesh& mesh,
                    const Reflection& image) {
  CompleteSpec spec;
  spec.q = first.q;
  for (const ConePoint& cone : first.cones)
    spec.cones.push_back({image.vertex[cone.vertex], cone.k});
  sortCones(spec.cones);
  for (EdgeId e : first.features)
    spec.features.push_back(mesh.edge(image.halfedge[from.halfedge(e)]));
  std::sort(spec.features.begin(), spec.features.end());
  return spec;
}

GridReport gridOf(GridReport grid, const Reflection& image) {
  for (ConeDistance& pair : grid.closest)
    for (VertexId* v : {&pair.a, &pair.b}) *v = image.vertex[*v];
  if (grid.reason)
    movePlaces(
        grid.reason->where, [&](VertexId v) { return image.vertex[v]; },
        [&](FaceId f) { return imageOf(f, image); });
  return grid;
}

}  // namespace

void readTurns(const Certificate& measured, CompleteSpec& spec) {
  for (const MeasuredTurning& turning : measured.angles.turnings)
    spec.turning.push_back(turning.measured);
  for (const MeasuredHandle& handle : measured.seams.handles)
    spec.handles.push_back(handle.measured.value_or(0));
}

bool asksOtherTurns(const HolonomySpec& asked, const CompleteSpec& found) {
  const auto isOther = [](const std::vector<std::optional<int>>& a, const std::vector<int>& b) {
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
      if (a[i] && *a[i] != b[i]) return true;
    return false;
  };
  return isOther(asked.turning, found.turning) || isOther(asked.handles, found.handles);
}

Result<Parametrization> imageOfMap(const CopiedMap& first, const Parametrization& run,
                                   const TriMesh& from, const TriMesh& mesh,
                                   const std::shared_ptr<const Mirror>& mirror,
                                   const HolonomySpec& asked) {
  const Reflection& image = mirror->image;
  CopiedMap map = reflected(first, mesh, image);
  const Verifier verifier(mesh);
  HolonomySpec open;
  open.q = run.spec.q;
  Parametrization out;
  out.spec = specOf(run.spec, from, mesh, image);
  readTurns(verifier.certify(open, map.map), out.spec);
  if (asksOtherTurns(asked, out.spec))
    return Failure{ErrorCode::kPrescription,
                   "symmetric",
                   "The mirror image of another component has turnings and rotations along handles "
                   "that are images of the other's, which are not the prescribed ones. Leave out "
                   "these or symmetry.",
                   {}};
  out.map = std::move(map.map);
  out.copyOf = std::move(map.copyOf);
  out.certificate = verifier.certify(toSpec(out.spec), out.map);
  out.isCertified = out.certificate.isCertified;
  out.isUsable = out.certificate.isUsable;
  out.isImpossible = run.isImpossible;
  out.improvement = run.improvement;
  if (run.grid) out.grid = gridOf(*run.grid, image);
  for (const FaceId f : run.strained) out.strained.push_back(imageOf(f, image));
  out.mirror = mirror;
  return out;
}

}  // namespace hgp
