#include "failures.h"

namespace hgp::python {
py::list placesOf(const Failure& failure) {
  py::list places;
  for (const Where& w : failure.where) {
    const bool isEdge = w.kind == Where::Kind::kEdge;
    places.append(py::make_tuple(kindName(w.kind), w.id,
                                 isEdge ? py::object(py::int_(w.other)) : py::none()));
  }
  return places;
}

py::object errorOf(const Failure& failure) {
  // Messages may contain names from files, with any bytes.
  const std::string message = told(failure);
  const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
      message.data(), static_cast<Py_ssize_t>(message.size()), "backslashreplace"));
  return py::module_::import("hgp._errors")
      .attr("error_of")(errorName(failure.code), failure.stage, text, placesOf(failure));
}

void raise(const Failure& failure) {
  const py::object error = errorOf(failure);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  throw py::error_already_set();
}

void raiseUsage(const std::string& message) {
  raise(Failure{ErrorCode::kUsage, "arguments", message, {}});
}

}  // namespace hgp::python
