// The surfaces that a comparison runs over.  Role: a folder of files, or surfaces from a seed.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp::bench {

struct SurfaceSelection {
  std::string folder;
  int generated = 0;  ///< so many from a seed instead of the folder
  std::uint64_t seed = 1;
  std::vector<std::string> only, skip;
  int smallest = 0, largest = 0;  ///< triangles; largest 0: any

  void addOptions(CLI::App& app);
  bool isUsable() const;  ///< a folder that exists, or generated ones
};

/// Every connected component by itself, of files the smallest first ("torus.obj", "many.obj #3"); of
/// generated ones every genus to 6, closed and with holes, as bench/stress draws them ("7/surface 3").
/// What is refused is left out.
void eachSurface(const SurfaceSelection& selection,
                 const std::function<void(const std::string& name, const TriMesh& mesh)>& visit);

}  // namespace hgp::bench
