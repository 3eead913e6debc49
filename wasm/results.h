// Results of the core that a call returns whole, as JavaScript objects.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "arrays.h"
#include "hgp/api/notes.h"
#include "hgp/api/session.h"

namespace hgp::js {

inline val toMeasures(const api::MapMeasures& made) {
  val reply = val::object(), overlaps = val::object();
  reply.set("stretch", toTypedArray("Float32Array", made.stretch));
  reply.set("area", toTypedArray("Float32Array", made.logArea));
  reply.set("flipped", toTypedArray("Uint32Array", made.notPositive));
  reply.set("surfaceArea", made.surfaceArea);
  reply.set("uvArea", made.uvArea);
  overlaps.set("pairs", static_cast<double>(made.overlapPairs));
  overlaps.set("triangles", toTypedArray("Uint32Array", made.overlapping));
  overlaps.set("isMore", made.areMorePairs);
  reply.set("overlaps", overlaps);
  reply.set("seamChains", toTypedArray("Uint32Array", made.seamChain));
  return reply;
}

inline val toLoops(const api::SurfaceLoops& made) {
  val reply = val::object(), boundaries = val::array(), handles = val::array();
  for (const auto& loop : made.boundaries)
    boundaries.call<void>("push", toTypedArray("Uint32Array", loop));
  for (const auto& edges : made.handles) {
    std::vector<int> flat;
    flat.reserve(2 * edges.size());
    for (const auto& edge : edges) flat.insert(flat.end(), edge.begin(), edge.end());
    handles.call<void>("push", toTypedArray("Uint32Array", flat));
  }
  reply.set("boundaries", boundaries);
  reply.set("handles", handles);
  return reply;
}

/// By mesh of the file.
inline val toPlacements(const std::vector<io::Placements>& placements) {
  val reply = val::object(), meshes = val::array();
  for (const io::Placements& one : placements) {
    val mesh = val::object();
    std::vector<double> numbers;
    for (const auto& m : one.matrices) numbers.insert(numbers.end(), m.begin(), m.end());
    mesh.set("count", static_cast<double>(one.count));
    mesh.set("isMirrored", one.isMirrored);
    mesh.set("matrices", toTypedArray("Float64Array", numbers));
    meshes.call<void>("push", mesh);
  }
  reply.set("meshes", meshes);
  return reply;
}

inline val toQuads(const api::QuadFile& quads) {
  val reply = val::object();
  reply.set("bytes", toTypedArray("Uint8Array", quads.bytes));
  reply.set("vertices", quads.vertices);
  reply.set("quads", quads.quads);
  reply.set("clipped", quads.clipped);
  reply.set("multipleEdges", quads.multipleEdges);
  reply.set("cuts", quads.cuts);
  reply.set("replaced", quads.replaced);
  reply.set("halvings", quads.halvings);
  reply.set("foldedInSpace", quads.foldedInSpace);
  reply.set("foldedQuads", quads.foldedQuads);
  reply.set("acrossSeams", quads.acrossSeams);
  reply.set("notes", api::notesDocument(quads.notes));
  return reply;
}

}  // namespace hgp::js
