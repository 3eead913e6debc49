// The map of a surface that is the mirror image of another.  Role: a pair of components is solved once.
#pragma once

#include <memory>

#include "hgp/parametrize/mirror/mirrored_map.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// The map (−u, v) of the image of a surface with the map (u, v), uv by uv, verified on it; without the rounds, times and notes
/// of the run that found that. Fails with kPrescription where `asked` has other turnings or rotations along handles.
/// @param first   the map of the first surface; @param run  all else of its result
/// @param mirror  from the surface `from` to `mesh`
Result<Parametrization> imageOfMap(const CopiedMap& first, const Parametrization& run,
                                   const TriMesh& from, const TriMesh& mesh,
                                   const std::shared_ptr<const Mirror>& mirror,
                                   const HolonomySpec& asked);

/// Sets the turnings and rotations along handles to those that were measured.
void readTurns(const Certificate& measured, CompleteSpec& spec);
/// Whether any that are asked for are others.
bool asksOtherTurns(const HolonomySpec& asked, const CompleteSpec& found);

/// Replaces vertices, edges and triangles by their images.
template <class VertexOf, class FaceOf>
void movePlaces(std::vector<Where>& where, const VertexOf& vertexOf, const FaceOf& faceOf) {
  const auto vertex = [&](std::int64_t id) { return vertexOf(VertexId{static_cast<int>(id)}).i; };
  for (Where& w : where) {
    if (w.kind == Where::Kind::kVertex || w.kind == Where::Kind::kEdge) w.id = vertex(w.id);
    if (w.kind == Where::Kind::kEdge && w.other >= 0) w.other = vertex(w.other);
    if (w.kind == Where::Kind::kFace) w.id = faceOf(FaceId{static_cast<int>(w.id)}).i;
  }
}

}  // namespace hgp
