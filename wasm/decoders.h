// Decoders of compressed glTF provided by JavaScript. Role: they return bytes only, and io checks all sizes.
// They never throw: errors are in `error` of their reply.
#pragma once

#include <memory>
#include <string>

#include "convert.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/decode/draco_header.h"
#include "reply.h"

namespace hgp::js {

inline Failure undecodable(const char* kind, const val& reply) {
  return {ErrorCode::kMalformed,
          "read",
          std::string("the ") + kind + " data is damaged: " + reply["error"].as<std::string>(),
          {}};
}

/// decode({ source, count, stride, mode, filter }) → { bytes } or { error }
inline Result<io::Bytes> decodeMeshopt(const val& decode, const io::MeshoptRequest& request) {
  val asked = val::object();
  asked.set("source", toTypedArray("Uint8Array", request.source.data(), request.source.size()));
  asked.set("count", static_cast<double>(request.count));
  asked.set("stride", static_cast<double>(request.stride));
  asked.set("mode", request.mode);
  asked.set("filter", request.filter);
  const val reply = decode(asked);
  if (!reply["error"].isUndefined()) return undecodable("meshopt", reply);
  return toVector<std::uint8_t>(reply["bytes"]);
}

/// decode({ source, vertexCount, indexCount, attributes: [{ uniqueId, componentType, components }] })
/// → { indices, attributes: [bytes] } or { error }
inline Result<io::DracoMesh> decodeDraco(const val& decode, const io::DracoRequest& request) {
  if (Status header = io::checkDracoHeader(request); !header) return header.error();
  val attributes = val::array();
  for (const io::DracoAttribute& wanted : request.attributes) {
    val attribute = val::object();
    attribute.set("uniqueId", wanted.uniqueId);
    attribute.set("componentType", wanted.componentType);
    attribute.set("components", wanted.components);
    attributes.call<void>("push", attribute);
  }
  val asked = val::object();
  asked.set("source", toTypedArray("Uint8Array", request.source.data(), request.source.size()));
  asked.set("vertexCount", static_cast<double>(request.vertexCount));
  asked.set("indexCount", static_cast<double>(request.indexCount));
  asked.set("attributes", attributes);
  const val reply = decode(asked);
  if (!reply["error"].isUndefined()) return undecodable("Draco", reply);
  io::DracoMesh mesh;
  mesh.indices = toVector<std::uint32_t>(reply["indices"]);
  for (std::size_t i = 0; i < request.attributes.size(); ++i) {
    mesh.attributes.push_back(toVector<std::uint8_t>(reply["attributes"][i]));
  }
  return mesh;
}

/// Which decoders a glTF needs: { draco, meshopt }. `json` is its text as bytes.
inline val neededDecoders(const val& json) {
  return guarded([&] {
    const io::GltfNeeds needs = io::gltfNeeds(toVector<std::uint8_t>(json));
    val reply = val::object();
    reply.set("draco", needs.draco);
    reply.set("meshopt", needs.meshopt);
    return reply;
  });
}

/// { draco, meshopt }: functions, or undefined for decoders that are not loaded.
inline std::shared_ptr<const io::GltfDecoders> toDecoders(const val& functions) {
  auto decoders = std::make_shared<io::GltfDecoders>();
  const val meshopt = functions["meshopt"], draco = functions["draco"];
  if (!meshopt.isUndefined()) {
    decoders->meshopt = [meshopt](const io::MeshoptRequest& request) {
      return decodeMeshopt(meshopt, request);
    };
  }
  if (!draco.isUndefined()) {
    decoders->draco = [draco](const io::DracoRequest& request) {
      return decodeDraco(draco, request);
    };
  }
  return decoders;
}

}  // namespace hgp::js
