// What a session hands out beside JSON.  Role: the words of session.h.
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/io/written.h"

namespace hgp::api {

/// A seam edge of the result: its two sides as uv indices, corresponding ends first, and r ∈ Z_q.
struct SeamEdge {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
  int r = 0;
};

/// What welds and repairs made of the surface; its vertex ids are its own.
struct Repaired {
  std::vector<std::uint32_t> triangles;  ///< × 3
  std::vector<int> vertexOrigin;         ///< vertex → a vertex of the surface
  std::vector<int> vertexImage;          ///< vertex of the surface → vertex, −1 when removed
};

/// A quad mesh as a file, and what is in it.
struct QuadFile {
  io::Bytes bytes;
  int vertices = 0, quads = 0;
  int clipped = 0;  ///< cells that a boundary cuts: left out
};

/// What write() made, and whether the certificate holds for the numbers in it: glTF rounds what OBJ holds.
struct WrittenMap : io::Written {
  bool isCertified = false;
};

}  // namespace hgp::api
