// Options and prescriptions of the core from dictionaries of Python.  Role: the core checks options by its own table.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "hgp/api/options.h"
#include "hgp/prescription/prescription.h"

namespace hgp::python {

namespace py = pybind11;

// optionsFromJson of dictionaries with the names of Python. Raise TypeError for values of the wrong type, UsageError otherwise.
api::LoadOptions toLoadOptions(const py::dict& options);
api::SolveOptions toSolveOptions(const py::dict& options);
api::VerifyOptions toVerifyOptions(const py::dict& options);
api::WriteOptions toWriteOptions(const py::dict& options);

/// A truth value, False if it is absent.
bool isSet(const py::dict& options, const char* name);
/// The order q of a prescription, where it is given.
std::optional<int> orderOf(const py::dict& asked);
/// What is prescribed: a file of cones or a document, a field, pairs of integers. Empty: nothing.
/// @param embedded  cones stored in the file, used if nothing else is prescribed and `ignore_embedded` is not set
std::optional<prescription::Prescription> toPrescription(
    const py::dict& asked, std::optional<prescription::Prescription> embedded);

/// What `rims`, `creases`, `marked` and `features` ask for; empty: nothing.
prescription::PrescribedFeatures toFeatures(const py::dict& asked);

}  // namespace hgp::python
