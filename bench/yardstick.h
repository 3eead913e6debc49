// The time of one factorization of the mesh's Laplacian by another library.  Role: the unit of bench/speed, so
// that figures of different machines and days can be compared.
#pragma once

#include "hgp/mesh/mesh_data.h"

namespace hgp::bench {

struct Yardstick {
  double orderSeconds = 0;   ///< METIS ordering and symbolic analysis
  double factorSeconds = 0;  ///< supernodal numeric factorization
  double total() const { return orderSeconds + factorSeconds; }
};

/// CHOLMOD on the real |V| × |V| graph Laplacian of the edges (+ 1e-6), one thread.
Yardstick measureYardstick(const MeshData& mesh);

}  // namespace hgp::bench
