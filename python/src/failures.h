// Failures of the core as exceptions of Python.  Role: the only place where they are raised.
#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "hgp/base/result.h"

namespace hgp::python {

namespace py = pybind11;

/// The exception of hgp/_errors.py for this failure, not raised. @pre the GIL is held
py::object errorOf(const Failure& failure);
/// Raises the exception of hgp/_errors.py for this failure. @pre the GIL is held
[[noreturn]] void raise(const Failure& failure);
[[noreturn]] void raiseUsage(const std::string& message);
/// (kind, id, other) of every place.
py::list placesOf(const Failure& failure);

/// The value, or the exception of its failure.
template <class T>
T must(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

}  // namespace hgp::python
