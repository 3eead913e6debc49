// What the fuzz targets share.  Role: bytes in, laws that must hold out.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/decode/draco_header.h"

namespace hgp::fuzz {

/// Ends the run with the law that was broken.
inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", law);
  std::abort();
}

inline io::Limits smallLimits() {
  io::Limits limits;
  limits.maxBytes = 32 << 20;
  limits.maxTriangles = 100'000;
  return limits;
}

/// meshopt as in every native build; Draco's own code has fuzzers of its own, so what stands in for
/// it hands out arrays of the size asked for, made of the input.
inline std::shared_ptr<const io::GltfDecoders> decoders() {
  auto out = std::make_shared<io::GltfDecoders>(io::builtInDecoders());
  out->draco = [](const io::DracoRequest& request) -> Result<io::DracoMesh> {
    const Status header = io::checkDracoHeader(request);
    if (!header) return header.error();
    io::DracoMesh mesh;
    for (std::uint64_t k = 0; k < request.indexCount; ++k) {
      mesh.indices.push_back(request.source[k % request.source.size()]);
    }
    for (const io::DracoAttribute& attribute : request.attributes) {
      const std::uint64_t size = attribute.componentType <= 5121   ? 1
                                 : attribute.componentType <= 5123 ? 2
                                                                   : 4;
      io::Bytes& bytes = mesh.attributes.emplace_back();
      bytes.resize(request.vertexCount * size * static_cast<std::uint64_t>(attribute.components));
      for (std::size_t k = 0; k < bytes.size(); ++k) {
        bytes[k] = request.source[k % request.source.size()];
      }
    }
    return mesh;
  };
  return out;
}

/// Relative, without a drive or a scheme, and no step of it leads up ("..62f.." is a name like others).
inline bool isBesideTheFile(const std::string& relative) {
  if (relative.empty() || relative[0] == '/' || relative.find(':') != std::string::npos)
    return false;
  const std::string steps = '/' + relative + '/';
  return steps.find("/../") == std::string::npos;
}

inline io::FileSet fileSet(const char* name, const std::uint8_t* data, std::size_t size) {
  io::FileSet files;
  files.name = name;
  files.main.assign(data, data + size);
  files.decoders = decoders();
  files.resolve = [](const std::string& relative) -> Result<io::Bytes> {
    require(isBesideTheFile(relative), "only names beside the file are asked for");
    return io::Bytes(1024, 1);
  };
  return files;
}

/// Corners that a split must tell apart: by triangle for every third one, by vertex otherwise.
inline UvMap madeUpMap(const MeshData& mesh) {
  UvMap map;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto& corners = map.cornerUv.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<int>(map.uv.size());
      const double v = mesh.triangles[t][k];
      const double part = t % 3 == 0 ? static_cast<double>(t) : 0.0;
      map.uv.push_back({v * 0.37 + part, 0.01 * v * v - part});
    }
  }
  return map;
}

inline bool isFinite(const UvMap& map) {
  for (const Vec2& uv : map.uv) {
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) return false;
  }
  return true;
}

inline bool isSameMap(const UvMap& a, const UvMap& b) {
  if (a.cornerUv.size() != b.cornerUv.size()) return false;
  for (std::size_t t = 0; t < a.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.uv[static_cast<std::size_t>(a.cornerUv[t][k])] !=
          b.uv[static_cast<std::size_t>(b.cornerUv[t][k])]) {
        return false;
      }
    }
  }
  return true;
}

/// NaN positions come back as NaN, which no comparison of numbers shows.
inline bool isSameMesh(const MeshData& a, const MeshData& b) {
  return a.triangles == b.triangles && a.positions.size() == b.positions.size() &&
         (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                             a.positions.size() * sizeof(Vec3)) == 0);
}

}  // namespace hgp::fuzz
