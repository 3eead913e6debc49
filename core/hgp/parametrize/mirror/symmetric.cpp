#include "hgp/parametrize/mirror/symmetric.h"

#include <algorithm>
#include <utility>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/parametrize/along/along_features.h"
#include "hgp/parametrize/mirror/image_map.h"
#include "hgp/parametrize/mirror/mirrored_map.h"
#include "hgp/verify/certificate.h"

namespace hgp {
namespace {

void toWhole(const HalfSurface& half, std::vector<Where>& where) {
  movePlaces(
      where, [&](VertexId v) { return half.vertexOrigin[at(v.i)]; },
      [&](FaceId f) { return half.faceOrigin[at(f.i)]; });
}

bool isIn(const std::vector<ConePoint>& list, VertexId v, int k) {
  return std::any_of(list.begin(), list.end(),
                     [&](const ConePoint& other) { return other.vertex == v && other.k == k; });
}

/// Prescribed cones must come in pairs, or lie in the plane with an even k.
Status checkPairs(const Mirror& mirror, const HolonomySpec& spec) {
  std::vector<Where> where, odd;
  for (const ConePoint& cone : spec.cones) {
    const VertexId image = mirror.image.vertex[cone.vertex];
    if (cone.k != spec.q && !isIn(spec.cones, image, cone.k))
      where.push_back({Where::Kind::kVertex, cone.vertex.i});
    if (image == cone.vertex && cone.k % 2 != 0)
      odd.push_back({Where::Kind::kVertex, cone.vertex.i});
  }
  if (!where.empty()) return unpairedCones(std::move(where));
  if (odd.empty()) return Done{};
  return Failure{ErrorCode::kUsage, "symmetric",
                 counted(odd.size(), "cone in the plane has", "cones in the plane have") +
                     " an odd k, which has no half for either side. Choose an even k, move the "
                     "cone off the plane, with its image, or leave out symmetry.",
                 std::move(odd)};
}

/// What was prescribed beside features is what the map has.
Status checkAsked(const HolonomySpec& asked, const CompleteSpec& found) {
  std::vector<Where> where;
  const bool hasCones = !asked.cones.empty();
  for (const ConePoint& cone : asked.cones)
    if (cone.k != asked.q && !isIn(found.cones, cone.vertex, cone.k))
      where.push_back({Where::Kind::kVertex, cone.vertex.i});
  for (const ConePoint& cone : found.cones)
    if (hasCones && !isIn(asked.cones, cone.vertex, cone.k))
      where.push_back({Where::Kind::kVertex, cone.vertex.i});
  if (where.empty() && !asksOtherTurns(asked, found)) return Done{};
  return Failure{ErrorCode::kPrescription, "symmetric",
                 "In a symmetric map, cones, turnings and rotations along handles are those of a "
                 "field along the plane, which are not the prescribed ones. Leave out these or "
                 "symmetry.",
                 std::move(where)};
}

std::vector<EdgeId> featuresOfSide(const TriMesh& mesh, const HalfSurface& half,
                                   const std::vector<EdgeId>& features) {
  PerEdge<char> isFeature(at(mesh.edgeCount()), 0);
  for (EdgeId e : features) isFeature[e] = 1;
  std::vector<EdgeId> out;
  for (EdgeId e : half.mesh.edges())
    if (isFeature[mesh.edge(half.origin(half.mesh.halfedge(e)))]) out.push_back(e);
  return out;
}

/// The cones of one side. In the plane, where its rims turn by half of the angles, these are given as well; rims that leave the
/// plane keep the corners of a field, which are compared afterwards.
void addConesOfSide(const Mirror& mirror, const HalfSurface& half, const HolonomySpec& spec,
                    HolonomySpec& side) {
  if (spec.cones.empty()) return;
  PerVertex<int> k(at(mirror.image.vertex.size()), spec.q);
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  const auto originOf = [&](VertexId v) { return half.vertexOrigin[at(v.i)]; };
  for (VertexId v : half.mesh.vertices())
    if (!half.mesh.isBoundary(v) && k[originOf(v)] != spec.q)
      side.cones.push_back({v, k[originOf(v)]});
  const auto isOff = [&](HalfedgeId h) {
    const VertexId v = originOf(half.mesh.tail(h));
    return mirror.image.vertex[v] != v;
  };
  for (const BoundaryLoop& loop : computeTopology(half.mesh).loops) {
    if (std::any_of(loop.halfedges.begin(), loop.halfedges.end(), isOff)) continue;
    for (HalfedgeId h : loop.halfedges)
      side.corners.push_back({half.mesh.tail(h), k[originOf(half.mesh.tail(h))] / 2});
  }
}

/// The prescription that the whole map has, without turnings and handles; cones in the plane are read off the map.
CompleteSpec wholeSpec(const TriMesh& mesh, const Mirror& mirror, const HalfSurface& half,
                       const CompleteSpec& side, const Certificate& measured) {
  CompleteSpec spec;
  spec.q = side.q;
  for (const ConePoint& cone : side.cones) {
    const VertexId v = half.vertexOrigin[at(cone.vertex.i)];
    spec.cones.push_back({v, cone.k});
    spec.cones.push_back({mirror.image.vertex[v], cone.k});
  }
  for (const MeasuredCone& cone : measured.angles.cones)
    if (mirror.image.vertex[cone.vertex] == cone.vertex && cone.measured != spec.q)
      spec.cones.push_back({cone.vertex, cone.measured});
  sortCones(spec.cones);
  for (EdgeId e : side.features) {
    const HalfedgeId h = half.origin(half.mesh.halfedge(e));
    spec.features.push_back(mesh.edge(h));
    spec.features.push_back(mesh.edge(mirror.image.halfedge[h]));
  }
  std::sort(spec.features.begin(), spec.features.end());
  spec.features.erase(std::unique(spec.features.begin(), spec.features.end()), spec.features.end());
  readTurns(measured, spec);
  return spec;
}

/// Numbers of cells are those of both sides.
void doubleCells(const HalfSurface& half, GridReport& grid) {
  grid.cells *= 2.0;
  grid.workingCells *= 2.0;
  for (ConeDistance& pair : grid.closest)
    for (VertexId* v : {&pair.a, &pair.b}) *v = half.vertexOrigin[at(v->i)];
  if (!grid.reason) return;
  for (NoteValue& value : grid.reason->values)
    if (double* cells = value.name == "cells" ? std::get_if<double>(&value.value) : nullptr)
      *cells *= 2.0;
  toWhole(half, grid.reason->where);
}

}  // namespace

Failure unpairedCones(std::vector<Where> where) {
  return {ErrorCode::kUsage, "symmetric",
          counted(where.size(), "cone has", "cones have") +
              " no mirror image of the same angle among the prescribed ones. Add the images, or "
              "leave out symmetry.",
          std::move(where)};
}

Result<Parametrization> parametrizeSymmetric(const TriMesh& mesh,
                                             const std::shared_ptr<const Mirror>& mirror,
                                             const HolonomySpec& spec,
                                             const ParametrizeOptions& options) {
  if (Status pairs = checkPairs(*mirror, spec); !pairs) return std::move(pairs).error();
  const HalfSurface half = halfOf(mesh, mirror->image, mirror->plane);
  HGP_CHECK(2 * half.mesh.faceCount() == mesh.faceCount(), "one side is half of the surface");
  HolonomySpec asked;
  asked.q = spec.q;
  asked.features = featuresOfSide(mesh, half, spec.features);
  addConesOfSide(*mirror, half, spec, asked);
  PreparedSurface side(half.mesh);
  Result<Parametrization> run = parametrizeAlongFeatures(side, asked, options);
  if (!run) {
    Failure failure = std::move(run).error();
    toWhole(half, failure.where);
    if (!asked.cones.empty() || !asked.corners.empty())
      failure.message =
          "On one side of the plane, where cones in it count half: " + failure.message;
    return failure;
  }
  CopiedMap whole = mirroredMap(mesh, *mirror, half, {std::move(run->map), std::move(run->copyOf)});
  const Verifier verifier(mesh);
  HolonomySpec open;
  open.q = spec.q;
  const CompleteSpec found =
      wholeSpec(mesh, *mirror, half, run->spec, verifier.certify(open, whole.map));
  if (Status same = checkAsked(spec, found); !same) return std::move(same).error();
  run->map = std::move(whole.map);
  run->copyOf = std::move(whole.copyOf);
  run->spec = found;
  run->certificate = verifier.certify(toSpec(found), run->map);
  run->isCertified = run->certificate.isCertified;
  run->isUsable = run->certificate.isUsable;
  for (Note& note : run->notes) toWhole(half, note.where);
  for (FaceId& f : run->strained) f = half.faceOrigin[at(f.i)];
  if (run->grid) doubleCells(half, *run->grid);
  run->mirror = mirror;
  return run;
}

}  // namespace hgp
