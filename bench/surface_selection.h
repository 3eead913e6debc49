// The surfaces of a comparison: a folder of files, or random surfaces from a seed.
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
  int generated = 0;  ///< > 0: this many random surfaces instead of the folder
  std::uint64_t seed = 1;
  std::vector<std::string> only, skip;
  int smallest = 0, largest = 0;  ///< triangles; largest 0: any

  void addOptions(CLI::App& app);
  bool isUsable() const;  ///< a folder that exists, or generated ones
};

/// Visits every connected component: of files, smallest first ("torus.obj", "many.obj #3"), or random surfaces of
/// genus up to 6, closed and with holes, as in bench/stress ("7/surface 3"). Refused meshes are skipped.
void eachSurface(const SurfaceSelection& selection,
                 const std::function<void(const std::string& name, const TriMesh& mesh)>& visit);

}  // namespace hgp::bench
