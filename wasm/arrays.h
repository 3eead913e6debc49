// Arrays, options and progress between JavaScript and the core.  Role: the only file that uses views of the heap.
// A view becomes invalid when the memory grows, so data are copied immediately and views are never kept.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hgp/base/progress.h"

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

}  // namespace hgp::js
