// The decoders of a native build: libdraco and libmeshoptimizer where they are installed.
#include "hgp/io/gltf/decode/decoders.h"

#include <algorithm>

#ifdef HGP_HAS_DRACO
#include <draco/compression/decode.h>
#endif
#ifdef HGP_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/draco_header.h"

namespace hgp::io {
namespace {

#ifdef HGP_HAS_MESHOPTIMIZER
Result<Bytes> decodeMeshopt(const MeshoptRequest& request) {
  const std::size_t count = request.count, stride = request.stride;
  const unsigned char* source = request.source.data();
  const std::size_t size = request.source.size();
  Bytes out(count * stride);
  int error = 0;
  if (request.mode == "ATTRIBUTES") {
    error = meshopt_decodeVertexBuffer(out.data(), count, stride, source, size);
  } else if (request.mode == "TRIANGLES") {
    error = meshopt_decodeIndexBuffer(out.data(), count, stride, source, size);
  } else {
    error = meshopt_decodeIndexSequence(out.data(), count, stride, source, size);
  }
  if (error != 0) {
    return Failure{ErrorCode::kMalformed, "read", "the meshopt data is damaged", {}};
  }
  if (request.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), count, stride);
  if (request.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), count, stride);
  if (request.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
  return out;
}
#endif

#ifdef HGP_HAS_DRACO
/// The value of every point, converted to T, tightly packed. False when a value does not fit.
template <class T>
bool copyValues(const draco::PointAttribute& attribute, std::uint32_t points, int components,
                Bytes& out) {
  const auto size = sizeof(T) * static_cast<std::size_t>(components);
  out.resize(size * points);
  for (std::uint32_t i = 0; i < points; ++i) {
    T values[4] = {};
    const auto index = attribute.mapped_index(draco::PointIndex(i));
    if (!attribute.ConvertValue<T>(index, static_cast<std::int8_t>(components), values))
      return false;
    std::copy_n(reinterpret_cast<const std::uint8_t*>(values), size, out.data() + size * i);
  }
  return true;
}

bool copyAttribute(const draco::Mesh& mesh, const DracoAttribute& wanted, Bytes& out) {
  const draco::PointAttribute* attribute =
      mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(wanted.uniqueId));
  if (attribute == nullptr || wanted.components > 4 ||
      attribute->num_components() != wanted.components) {
    return false;
  }
  const auto points = mesh.num_points();
  switch (wanted.componentType) {
    case 5120:
      return copyValues<std::int8_t>(*attribute, points, wanted.components, out);
    case 5121:
      return copyValues<std::uint8_t>(*attribute, points, wanted.components, out);
    case 5122:
      return copyValues<std::int16_t>(*attribute, points, wanted.components, out);
    case 5123:
      return copyValues<std::uint16_t>(*attribute, points, wanted.components, out);
    case 5125:
      return copyValues<std::uint32_t>(*attribute, points, wanted.components, out);
    default:
      return copyValues<float>(*attribute, points, wanted.components, out);
  }
}

Result<DracoMesh> decodeDraco(const DracoRequest& request) {
  const auto damaged = [](const std::string& what) {
    return Failure{ErrorCode::kMalformed, "read", "the Draco data " + what, {}};
  };
  const Status header = checkDracoHeader(request);
  if (!header) return header.error();
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(request.source.data()), request.source.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return damaged(std::string("is damaged: ") + decoded.status().error_msg());
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  if (mesh->num_points() != request.vertexCount ||
      std::uint64_t{mesh->num_faces()} * 3 != request.indexCount) {
    return damaged(formatText(
        "has %u vertices and %u triangles, but the accessors have %llu "
        "vertices and %llu indices",
        mesh->num_points(), mesh->num_faces(), static_cast<unsigned long long>(request.vertexCount),
        static_cast<unsigned long long>(request.indexCount)));
  }
  DracoMesh out;
  out.indices.reserve(request.indexCount);
  for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f) {
    for (const draco::PointIndex& point : mesh->face(f)) out.indices.push_back(point.value());
  }
  for (const DracoAttribute& wanted : request.attributes) {
    if (!copyAttribute(*mesh, wanted, out.attributes.emplace_back())) {
      return damaged(formatText("has no attribute %d of the stated type", wanted.uniqueId));
    }
  }
  return out;
}
#endif

}  // namespace

GltfDecoders builtInDecoders() {
  GltfDecoders out;
#ifdef HGP_HAS_MESHOPTIMIZER
  out.meshopt = decodeMeshopt;
#endif
#ifdef HGP_HAS_DRACO
  out.draco = decodeDraco;
#endif
  return out;
}

}  // namespace hgp::io
