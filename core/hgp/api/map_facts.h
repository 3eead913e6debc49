// What is certified of a result, as numbers.  Role: the contents of hgp-certificate without JSON. Plain values that may be
// copied and read by any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hgp/verify/certificate.h"

namespace hgp::api {

/// A seam edge of the result: the uv indices of its two sides, in corresponding order, and r ∈ Z_q.
struct SeamEdge {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
  int r = 0;
};

/// A vertex with the angle sum 2πk/q in the map.
struct ConeFact {
  int vertex = -1;  ///< of the surface
  int k = 0;
  double distance = 0;  ///< of the measured angle from that, radians
};
/// A boundary loop that turns by 2πl/q; numbers of loops and generators are those of a prescription.
struct TurningFact {
  int loop = -1;
  int l = 0;
};
/// A handle generator along which directions turn by 2πr/q; empty if a seam on it has no rotation.
struct HandleFact {
  int generator = -1;
  std::optional<int> r;
};

struct ComponentFacts {
  bool isCertified = false;
  std::vector<Reason> reasons;  ///< why not, with places on the surface; empty if certified
  int triangles = 0, genus = 0, boundaries = 0;
  int positive = 0;  ///< triangles with exactly positive area: all of them if certified
  std::vector<ConeFact> cones;
  std::vector<TurningFact> turnings;
  std::vector<HandleFact> handles;
};

/// Of a map as it is stored. A map is certified if every component is.
struct MapFacts {
  int q = 0;
  bool isCertified = false;
  std::vector<ComponentFacts> components;
};

/// The arrays of a result, moved out of its session. Shapes as in session.h.
struct MapArrays {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerToUv, uvToVertex;
  std::vector<SeamEdge> seams;
};

}  // namespace hgp::api
