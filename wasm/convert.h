// Converts between JavaScript values and the results of the core.  Role: what arrays.h does not have.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "arrays.h"
#include "hgp/api/session.h"

namespace hgp::js {

/// Seam edges as rows of five integers: a0 a1 b0 b1 r.
inline val toSeams(const std::vector<api::SeamEdge>& seams) {
  std::vector<std::int32_t> flat;
  flat.reserve(5 * seams.size());
  for (const api::SeamEdge& s : seams)
    flat.insert(flat.end(), {s.a[0], s.a[1], s.b[0], s.b[1], s.r});
  return toTypedArray("Int32Array", flat);
}

/// The surface after welds and repairs.
inline val toRepaired(const api::Repaired& mesh) {
  val out = val::object();
  out.set("triangles", toTypedArray("Uint32Array", mesh.triangles));
  out.set("vertexOrigin", toTypedArray("Int32Array", mesh.vertexOrigin));
  out.set("vertexImage", toTypedArray("Int32Array", mesh.vertexImage));
  return out;
}

inline val toSolved(const api::SolvedTriangles& solved) {
  val out = val::object();
  out.set("triangles", toTypedArray("Uint32Array", solved.triangles));
  out.set("uvTriangles", toTypedArray("Uint32Array", solved.cornerToUv));
  out.set("origin", toTypedArray("Uint32Array", solved.origin));
  return out;
}

/// Facts about a surface.
inline val toFacts(const api::SurfaceFacts& facts) {
  val out = val::object();
  out.set("representative", toTypedArray("Int32Array", facts.representative));
  out.set("angle", toTypedArray("Float64Array", facts.angle));
  out.set("valence", toTypedArray("Uint32Array", facts.valence));
  out.set("isBoundary", toTypedArray("Uint8Array", facts.isBoundary));
  out.set("component", toTypedArray("Int32Array", facts.component));
  out.set("triangleComponent", toTypedArray("Int32Array", facts.triangleComponent));
  out.set("neighbourStart", toTypedArray("Uint32Array", facts.neighbourStart));
  out.set("neighbours", toTypedArray("Uint32Array", facts.neighbours));
  out.set("area", facts.area);
  return out;
}

/// Files as { name, bytes }.
inline val toFiles(const std::vector<io::OutputFile>& files) {
  val list = val::array();
  for (const io::OutputFile& file : files) {
    val entry = val::object();
    entry.set("name", file.name);
    entry.set("bytes", toTypedArray("Uint8Array", file.bytes));
    list.call<void>("push", entry);
  }
  return list;
}

}  // namespace hgp::js
