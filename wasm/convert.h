// Converts between JavaScript values and those of the core.  Role: the only file that uses views of the heap.
// A view becomes invalid when the memory grows, so data are copied immediately and views are never kept.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hgp/api/session.h"

namespace hgp::js {

using emscripten::val;

/// A typed array of JavaScript as a vector of its element type.
template <class T>
std::vector<T> toVector(const val& array) {
  std::vector<T> copy(array["length"].as<std::size_t>());
  if (!copy.empty()) {
    val(emscripten::typed_memory_view(copy.size(), copy.data())).call<void>("set", array);
  }
  return copy;
}

/// A copy owned by JavaScript. `type` is the name of the typed array, such as "Float64Array".
template <class T>
val toTypedArray(const char* type, const T* data, std::size_t size) {
  return val::global(type).new_(val(emscripten::typed_memory_view(size, data)));
}
template <class T>
val toTypedArray(const char* type, const std::vector<T>& data) {
  return data.empty() ? val::global(type).new_(0) : toTypedArray(type, data.data(), data.size());
}

/// options.name if it is defined, otherwise the default.
template <class T>
T option(const val& options, const char* name, T otherwise) {
  const val value = options[name];
  return value.isUndefined() || value.isNull() ? otherwise : value.as<T>();
}

/// A flat array as rows of three; an incomplete last row is dropped.
template <class Row, class T>
std::vector<Row> toRows(const std::vector<T>& flat) {
  std::vector<Row> rows(flat.size() / 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      rows[i][k] = static_cast<typename Row::value_type>(flat[3 * i + k]);
    }
  }
  return rows;
}

/// An array of strings or of typed arrays.
inline std::vector<std::string> toStrings(const val& array) {
  std::vector<std::string> strings(array["length"].as<std::size_t>());
  for (std::size_t i = 0; i < strings.size(); ++i) strings[i] = array[i].as<std::string>();
  return strings;
}

/// callback(stage, fraction, iteration, residual, round, maxRounds), which returns true to continue; empty if it is
/// undefined.
inline Progress toProgress(const val& callback) {
  if (callback.isUndefined()) return {};
  return [callback](const ProgressReport& r) {
    return callback(std::string(stageName(r.stage)), r.fraction, r.iteration, r.residual, r.round,
                    r.maxRounds)
        .as<bool>();
  };
}

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
