#include "yardstick.h"

#include <suitesparse/cholmod.h>

#include <chrono>
#include <stdexcept>

#include "hgp/base/check.h"

namespace hgp::bench {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Lower triangle; duplicates are summed by CHOLMOD.
cholmod_sparse* laplacian(const MeshData& mesh, cholmod_common* common) {
  const std::size_t n = mesh.positions.size(), edges = 3 * mesh.triangles.size();
  cholmod_triplet* entries =
      cholmod_allocate_triplet(n, n, n + 3 * edges, -1, CHOLMOD_REAL, common);
  auto* const row = static_cast<int*>(entries->i);
  auto* const column = static_cast<int*>(entries->j);
  auto* const value = static_cast<double*>(entries->x);
  std::size_t& count = entries->nnz;
  const auto add = [&](int i, int j, double x) {
    row[count] = i > j ? i : j;
    column[count] = i > j ? j : i;
    value[count++] = x;
  };
  for (std::size_t v = 0; v < n; ++v) add(static_cast<int>(v), static_cast<int>(v), 1e-6);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3];
      add(i, i, 0.5);
      add(j, j, 0.5);
      add(i, j, -0.5);
    }
  cholmod_sparse* A = cholmod_triplet_to_sparse(entries, 0, common);
  cholmod_free_triplet(&entries, common);
  return A;
}

}  // namespace

Yardstick measureYardstick(const MeshData& mesh) {
  cholmod_common common;
  cholmod_start(&common);
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.postorder = 1;
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse* A = laplacian(mesh, &common);
  Yardstick result;
  auto start = Clock::now();
  cholmod_factor* L = cholmod_analyze(A, &common);
  result.orderSeconds = secondsSince(start);
  start = Clock::now();
  const bool isFactored = L != nullptr && cholmod_factorize(A, L, &common) != 0;
  result.factorSeconds = secondsSince(start);
  const bool isGood = isFactored && common.status == CHOLMOD_OK;
  cholmod_free_factor(&L, &common);
  cholmod_free_sparse(&A, &common);
  cholmod_finish(&common);
  if (!isGood) throw std::runtime_error("CHOLMOD could not factor the Laplacian");
  return result;
}

}  // namespace hgp::bench
