// The module hgp._core.  Role: names of Python for surface.h; hgp/*.py documents and types them.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "../../examples/cli/program.h"
#include "hgp/api/notes.h"
#include "hgp/api/option_table.h"
#include "hgp/base/threads.h"
#include "surface.h"

namespace hgp::python {
namespace {

/// Runs the command line as `hgp` would and returns its exit code.
int runCommandLine(std::vector<std::string> words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const py::gil_scoped_release release;
  return cli::runProgram(static_cast<int>(words.size()), pointers.data());
}

/// A read-only view of an array of the result, which the map owns and does not change.
template <class T, const std::vector<T>& (api::Session::*Getter)() const, class As,
          py::ssize_t Columns>
py::array resultArray(const py::object& self) {
  const std::vector<T>& values = (self.cast<const Map&>().session().*Getter)();
  return viewOf<As>(values.data(), values.size(), Columns, self);
}

/// Rows (a0, a1, b0, b1, r) of the seam edges.
py::array seams(const Map& map) {
  std::vector<std::int32_t> rows;
  rows.reserve(5 * map.session().seams().size());
  for (const api::SeamEdge& s : map.session().seams())
    rows.insert(rows.end(), {s.a[0], s.a[1], s.b[0], s.b[1], s.r});
  return taken<std::int32_t>(std::move(rows), 5);
}

py::tuple solved(const Map& map) {
  api::SolvedTriangles rows = map.session().solvedTriangles();
  py::tuple out = py::make_tuple(taken<std::int32_t>(std::move(rows.triangles), 3),
                                 taken<std::int32_t>(std::move(rows.cornerToUv), 3),
                                 taken<std::int32_t>(std::move(rows.origin)));
  for (const py::handle& array : out) array.attr("setflags")(py::arg("write") = false);
  return out;
}

/// Rows (call, name in JSON, flag of the command line, keyword of Python, words) of the core's table of options.
py::list optionRows() {
  py::list rows;
  const auto add = [&rows](const char* call, std::span<const api::OptionRow> some) {
    for (const api::OptionRow& row : some)
      rows.append(py::make_tuple(call, row.name, row.flag, row.keyword, api::wordsOf(row)));
  };
  add("load", api::optionRows<api::LoadOptions>());
  add("solve", api::optionRows<api::SolveOptions>());
  add("verify", api::optionRows<api::VerifyOptions>());
  add("write", api::optionRows<api::WriteOptions>());
  return rows;
}

void addMap(py::module_& module) {
  using S = api::Session;
  py::class_<Map, std::shared_ptr<Map>>(module, "Map")
      .def_property_readonly("uv", &resultArray<double, &S::uv, double, 2>)
      .def_property_readonly("fuv", &resultArray<std::uint32_t, &S::cornerToUv, std::int32_t, 3>)
      .def_property_readonly("positions", &resultArray<double, &S::positions, double, 3>)
      .def_property_readonly("triangles",
                             &resultArray<std::uint32_t, &S::triangles, std::int32_t, 3>)
      .def_property_readonly("uv_to_vertex",
                             &resultArray<std::uint32_t, &S::uvToVertex, std::int32_t, 0>)
      .def_property_readonly("seams", &seams)
      .def_property_readonly("solved", &solved)
      .def_property_readonly("certified", [](const Map& m) { return m.session().isCertified(); })
      .def_property_readonly("aligned", [](const Map& m) { return m.session().isAligned(); })
      .def_property_readonly("report", [](const Map& m) { return m.session().reportJson(); })
      .def_property_readonly("certificate",
                             [](const Map& m) { return m.session().certificateJson(); })
      .def_property_readonly("cones", [](const Map& m) { return m.session().conesJson(); })
      .def("measure", &Map::measure)
      .def("quads", &Map::quads)
      .def("save_quads", &Map::saveQuads)
      .def("save", &Map::save)
      .def_static("save_all", &Map::saveAll);
}

void addSurface(py::module_& module) {
  py::class_<Surface, std::shared_ptr<Surface>>(module, "Surface")
      .def_static("of_file", &Surface::ofFile)
      .def_static("of_arrays", &Surface::ofArrays)
      .def_static("of_map", &Surface::ofMap)
      .def("inspect", &Surface::inspect)
      .def("check", &Surface::check)
      .def("verify", &Surface::verify)
      .def("suggest", &Surface::suggest)
      .def("convert", &Surface::convert)
      .def("balance", &Surface::balance)
      .def("transfer", &Surface::transfer)
      .def("features", &Surface::features)
      .def("parametrize_file", &Surface::parametrizeFile)
      .def("embedded_cones", &Surface::embeddedCones)
      .def("parametrize", &Surface::parametrize)
      .def("positions", &Surface::positions)
      .def("triangles", &Surface::triangles)
      .def("loops", &Surface::loops)
      .def("mesh_count", &Surface::meshCount);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of hgp; not for direct use.";
  addMap(module);
  addSurface(module);
  module.def("version", &api::version);
  module.def("set_threads", &setThreads);
  module.def("default_threads", &defaultThreads);
  module.def("phrase", [](const std::string& note) { return api::phraseJson(note); });
  module.def("option_rows", &optionRows);
  module.def("run_command_line", &runCommandLine);
}

}  // namespace hgp::python
