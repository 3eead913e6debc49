// Random prescriptions that pass every check, with a fixed seed.  Role: what laws about "any cones,
// any turning, any handles" are tested on.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "hgp/mesh/holonomy_spec.h"
#include "support/random.h"

namespace hgp::test {

/// Interior vertices far from each other: each the farthest from those before it.
inline std::vector<VertexId> spreadVertices(const TriMesh& mesh, int count) {
  std::vector<VertexId> chosen;
  PerVertex<double> distance(static_cast<std::size_t>(mesh.vertexCount()), 1e300);
  while (static_cast<int>(chosen.size()) < count) {
    VertexId best;
    for (VertexId v : mesh.vertices())
      if (!mesh.isIsolated(v) && !mesh.isBoundary(v) &&
          (!best.isValid() || distance[v] > distance[best]))
        best = v;
    chosen.push_back(best);
    for (VertexId v : mesh.vertices()) {
      double square = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = mesh.position(v)[i] - mesh.position(best)[i];
        square += d * d;
      }
      distance[v] = std::min(distance[v], square);
    }
  }
  return chosen;
}

struct RandomSpecOptions {
  int q = 4;
  int cones = 4;
  bool areHandlesGiven = true;
  bool isTurningGiven = false;  ///< the nearest admissible ones, shuffled by a unit
};

/// Uniform over cone indices 1 ≤ k < 2q at random interior vertices, the last one balancing
/// Lemma 6.2 where the surface is closed; nothing when no draw passes checkPrescription.
inline std::optional<HolonomySpec> randomSpec(const TriMesh& mesh, const Topology& topology,
                                              const RandomSpecOptions& options,
                                              std::mt19937& random) {
  std::vector<VertexId> inner;
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && !mesh.isBoundary(v)) inner.push_back(v);
  const auto count = std::min<std::size_t>(static_cast<std::size_t>(options.cones), inner.size());
  const int q = options.q;
  const bool isClosed = topology.loops.empty();
  for (int attempt = 0; attempt < 2000; ++attempt) {
    HolonomySpec spec;
    spec.q = q;
    for (std::size_t i = 0; i < count; ++i)
      std::swap(inner[i], inner[i + static_cast<std::size_t>(
                                        randomBelow(random, static_cast<int>(inner.size() - i)))]);
    long long left = static_cast<long long>(q) * (2 - 2 * topology.genus);
    for (std::size_t i = 0; i < count; ++i) {
      const bool isLast = isClosed && i + 1 == count;
      const long long k = isLast ? q - left : 1 + randomBelow(random, std::max(1, 2 * q - 1));
      if (k < 1 || k > 1000) break;
      left -= q - k;
      spec.cones.push_back({inner[i], static_cast<int>(k)});
    }
    if (spec.cones.size() != count || (isClosed && left != 0)) continue;
    if (isClosed && std::any_of(spec.cones.begin(), spec.cones.end(),
                                [&](const ConePoint& c) { return c.k == q; }))
      continue;
    if (options.areHandlesGiven)
      for (int i = 0; i < 2 * topology.genus; ++i)
        spec.handles.emplace_back(randomBelow(random, q));
    if (options.isTurningGiven && !isClosed) {
      long long rest = left - static_cast<long long>(q) * static_cast<int>(topology.loops.size());
      for (std::size_t j = 0; j + 1 < topology.loops.size(); ++j) {
        const int l = randomBelow(random, 2 * q + 1) - q;
        spec.turning.emplace_back(l);
        rest -= l;
      }
      spec.turning.emplace_back(static_cast<int>(rest));
    }
    if (checkPrescription(mesh, topology, spec)) return spec;
  }
  return {};
}

}  // namespace hgp::test
