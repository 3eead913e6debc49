// Where a file puts its meshes.  Role: a type of documents that have nodes.
#pragma once

#include <array>
#include <vector>

namespace hgp::io {

/// The nodes that show one surface of a file.
struct Placements {
  long long count = 0;      ///< with the copies of EXT_mesh_gpu_instancing
  bool isMirrored = false;  ///< by one of them
  /// By columns, of each node whose matrix is invertible and finite; without the copies.
  std::vector<std::array<double, 16>> matrices = {};
};

/// The factor of lengths under the matrix that shows a surface largest; 1 without one, and beyond the range of doubles.
double scaleOf(const Placements& placements);

}  // namespace hgp::io
