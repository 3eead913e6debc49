// Small helpers of the io tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "hgp/io/document.h"

namespace hgp::test {

using namespace io;

inline Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }
inline std::string textOf(const Bytes& bytes) { return std::string(bytes.begin(), bytes.end()); }

inline FileSet fileSet(const std::string& name, const std::string& text) {
  FileSet files;
  files.name = name;
  files.main = bytesOf(text);
  return files;
}

inline Result<DocumentPtr> openText(const std::string& name, const std::string& text) {
  return openDocument(fileSet(name, text), Limits());
}

/// Where the optional data are; tests that need them skip aloud when they are not there.
inline std::string sharedMeshes() {
  const char* given = std::getenv("HGP_SHARED_MESHES");
  return given ? given : HGP_SHARED_MESHES_DEFAULT;
}
inline bool readShared(const std::string& name, std::string& out) {
  std::ifstream file(sharedMeshes() + "/" + name, std::ios::binary);
  if (!file) return false;
  out.assign(std::istreambuf_iterator<char>(file), {});
  return true;
}

/// Every corner its own uv, all different: a map whose every number must come back.
inline UvMap cornerMap(const MeshData& mesh) {
  UvMap map;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      map.cornerUv.push_back({});
      map.cornerUv.resize(t + 1);
      map.cornerUv[t][k] = static_cast<int>(map.uv.size());
      map.uv.push_back({0.1 * static_cast<double>(map.uv.size()) + 1.0 / 3.0,
                        -1.0 / (7.0 + static_cast<double>(map.uv.size()))});
    }
  }
  return map;
}

/// The first three coordinates: a map with one uv per vertex.
inline UvMap vertexMap(const MeshData& mesh) {
  UvMap map;
  for (const Vec3& p : mesh.positions) map.uv.push_back({p[0] + 0.3 * p[2], p[1] / 3.0});
  map.cornerUv = mesh.triangles;
  return map;
}

/// The text of what a document writes for a map.
inline std::string written(const Document& document, const UvMap& map,
                           const WriteOptions& options = {}) {
  Result<Written> out = document.write(0, document.asStored(0, map), options);
  EXPECT_TRUE(out.hasValue()) << (out ? "" : out.error().message);
  return out ? textOf(out->files[0].bytes) : "";
}

}  // namespace hgp::test
