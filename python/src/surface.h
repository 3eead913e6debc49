// A loaded mesh and its maps for Python.  Role: hgp::api::Session, called by several threads.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "alone.h"
#include "arrays.h"
#include "hgp/api/session.h"

namespace hgp::python {

/// A file with its side files, or arrays; what a session loads, as often as necessary.
struct Source {
  std::string path;  ///< "" for arrays
  io::FileSet files;
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> triangles;
  api::LoadOptions options;

  Status load(api::Session& session) const;
};

/// A map with the session that computed it, which computes no other.
class Map {
 public:
  Map(api::Session session, std::shared_ptr<const Source> source)
      : session_(std::move(session)), source_(std::move(source)) {}

  /// Only getters of the result, which never changes, may be called without run().
  const api::Session& session() const { return session_; }
  py::dict measure();
  py::dict quads();
  /// Writes the cells as quads (.obj, .ply) or triangles (.glb) with the quads beside them, and returns notes.
  /// @param options  overwrite
  std::vector<std::string> saveQuads(const std::string& path, const py::dict& options);
  /// Writes the map, and returns notes. @param options  see Map.save in hgp/_map.py
  std::vector<std::string> save(const std::string& path, const py::dict& options);
  /// Writes maps of different meshes of one file into that file.
  static std::vector<std::string> saveAll(const std::vector<std::shared_ptr<Map>>& maps,
                                          const std::string& path, const py::dict& options);

 private:
  api::Session session_;
  std::shared_ptr<const Source> source_;
  Alone alone_;
};

class Surface {
 public:
  static std::shared_ptr<Surface> ofFile(const std::string& path, const std::string& root,
                                         const py::dict& options);
  static std::shared_ptr<Surface> ofArrays(const Reals& V, const py::array& F,
                                           const py::dict& options);
  /// Arrays with texture coordinates, for verify().
  static std::shared_ptr<Surface> ofMap(const Reals& V, const py::array& F, const Reals& uv,
                                        const py::array& fuv, const py::dict& options);

  /// (whether good, JSON)
  std::pair<bool, std::string> inspect();
  std::pair<bool, std::string> check(const py::dict& asked);
  std::pair<bool, std::string> verify(const py::dict& asked, const py::dict& options);
  std::string suggest(const py::dict& options, bool isReproducible, const py::object& progress);
  std::string convert(const py::dict& asked);
  std::string balance(const py::dict& asked);
  /// (hgp-cones, sentences about what has no place)
  std::pair<std::string, std::vector<std::string>> transfer(const py::dict& asked,
                                                            const Surface& from);
  /// Edges as a file of this name, and their numbers. Without any in `asked`: creases above 30 degrees.
  py::dict features(const py::dict& asked, const std::string& name);
  /// Maps every mesh of the file and writes them into `path`. @param saving  see Map.save in hgp/_map.py
  py::dict parametrizeFile(const py::dict& asked, const py::dict& options, const std::string& path,
                           const py::dict& saving, bool isReproducible, std::optional<double> limit,
                           const py::object& progress);
  /// The cones stored in the file as hgp-cones, or None.
  std::optional<std::string> embeddedCones();
  /// @param limit  seconds
  std::shared_ptr<Map> parametrize(const py::dict& asked, const py::dict& options,
                                   bool isReproducible, std::optional<double> limit,
                                   const py::object& progress);
  py::array positions();
  py::array triangles();
  py::dict loops();
  int meshCount();

 private:
  explicit Surface(Source source) : source_(std::make_shared<const Source>(std::move(source))) {}
  static std::shared_ptr<Surface> loaded(Source source);
  /// Runs `work` on the session, which is loaded again if a map has taken it over. Raises failures.
  template <class Work>
  auto with(Work work);
  Status ready();
  std::optional<prescription::Prescription> prescription(const py::dict& asked,
                                                         bool usesEmbedded = true);

  std::shared_ptr<const Source> source_;
  api::Session session_;
  bool isLoaded_ = false;
  Alone alone_;
};

}  // namespace hgp::python
