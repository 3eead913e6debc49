// Numpy arrays and the vectors of the core.  Role: one copy on the way in, none on the way out.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "failures.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::python {

/// A C-ordered array of real numbers; hgp/_arrays.py makes it.
using Reals = py::array_t<double, py::array::c_style>;
using Integers = py::array_t<std::int64_t, py::array::c_style>;
using ShortIntegers = py::array_t<std::int32_t, py::array::c_style>;

std::vector<Vec3> toPositions(const Reals& rows);
/// The rows of triangles. Raises UsageError, naming the array and the entry, where an index is negative or not below
/// `count`.
std::vector<std::array<int, 3>> toTriangles(const py::array& rows, const char* name,
                                            py::ssize_t count);

/// A read-only view of `data`, which must live as long as `owner`. @param columns  0: one dimension
template <class T, class From>
py::array viewOf(const From* data, std::size_t size, py::ssize_t columns, py::handle owner) {
  static_assert(sizeof(T) == sizeof(From));
  const auto count = static_cast<py::ssize_t>(size);
  std::vector<py::ssize_t> shape{columns == 0 ? count : count / columns};
  if (columns > 0) shape.push_back(columns);
  py::array view(py::dtype::of<T>(), shape, data, owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

/// An array that takes over the memory of `values`.
template <class T, class From>
py::array taken(std::vector<From> values, py::ssize_t columns = 0) {
  static_assert(sizeof(T) == sizeof(From));
  auto kept = std::make_unique<std::vector<From>>(std::move(values));
  const From* data = kept->data();
  const std::size_t size = kept->size();
  const py::capsule owner(kept.release(),
                          [](void* held) { delete static_cast<std::vector<From>*>(held); });
  const auto count = static_cast<py::ssize_t>(size);
  std::vector<py::ssize_t> shape{columns == 0 ? count : count / columns};
  if (columns > 0) shape.push_back(columns);
  return py::array(py::dtype::of<T>(), shape, data, owner);
}

}  // namespace hgp::python
