// Options of the core from dictionaries that hgp/_options.py makes.  Role: words become values, and wrong ones are
// refused by name.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "hgp/api/options.h"
#include "hgp/prescription/prescription.h"

namespace hgp::python {

namespace py = pybind11;

api::LoadOptions toLoadOptions(const py::dict& options);
/// @param isAutomatic  whether nothing is prescribed, so that `q` is that of the automatic cones
api::SolveOptions toSolveOptions(const py::dict& options);
api::VerifyOptions toVerifyOptions(const py::dict& options);

/// What is prescribed: a file of cones or a document, a field, pairs of integers. Empty: nothing.
/// @param embedded  cones stored in the file, used if nothing else is prescribed and `ignore_embedded` is not set
std::optional<io::Prescription> toPrescription(const py::dict& asked,
                                               std::optional<io::Prescription> embedded);

}  // namespace hgp::python
