#include "hgp/io/gltf/pack/encoders.h"

#ifdef HGP_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hgp/io/gltf/decode/decoders.h"

namespace hgp::io {
namespace {

/// The decoder forms 2^e as a float with exponent bits e + 127; bits of 0 would be a zero or subnormal.
constexpr int kLowestExponent = -126, kHighestExponent = 127;
/// The magnitude of a mantissa is below 2^23.
constexpr int kMantissaBits = 23;

/// A finite float as mantissa · 2^exponent, the mantissa odd or zero.
struct Dyadic {
  int mantissa = 0, exponent = 0;
  int bits = 0;  ///< of the mantissa
};

Dyadic dyadicOf(float value) {
  if (value == 0.0F) return {};
  int exponent = 0;
  auto mantissa = static_cast<int>(std::ldexp(std::frexp(value, &exponent), 24));
  exponent -= 24;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  int bits = 0;
  for (int rest = std::abs(mantissa); rest > 0; rest /= 2) ++bits;
  return {mantissa, exponent, bits};
}

#ifdef HGP_HAS_MESHOPTIMIZER

/// Replaces `best` by `packed` if that is shorter and decodes to the same bytes.
void offer(std::optional<PackedView>& best, PackedView packed, ByteView bytes) {
  if (packed.bytes.empty() || packed.bytes.size() >= (best ? best->bytes.size() : bytes.size()))
    return;
  MeshoptRequest request;
  request.source = packed.bytes;
  request.count = packed.count;
  request.stride = packed.stride;
  request.mode = packed.mode;
  request.filter = packed.filter;
  const Result<Bytes> back = builtInDecoders().meshopt(request);
  const bool isSame = back && back->size() == bytes.size() &&
                      std::memcmp(back->data(), bytes.data(), bytes.size()) == 0;
  if (isSame) best = std::move(packed);
}

PackedView packAttributes(const std::uint8_t* bytes, std::uint64_t count, std::uint64_t stride,
                          const char* filter) {
  PackedView out{{}, count, stride, "ATTRIBUTES", filter};
  out.bytes.resize(meshopt_encodeVertexBufferBound(count, stride));
  out.bytes.resize(
      meshopt_encodeVertexBuffer(out.bytes.data(), out.bytes.size(), bytes, count, stride));
  return out;
}

PackedView packIndices(const std::vector<unsigned>& indices, std::uint64_t stride, bool isList) {
  PackedView out{{}, indices.size(), stride, isList ? "TRIANGLES" : "INDICES", "NONE"};
  const std::size_t vertices = std::size_t{1} + *std::max_element(indices.begin(), indices.end());
  out.bytes.resize(isList ? meshopt_encodeIndexBufferBound(indices.size(), vertices)
                          : meshopt_encodeIndexSequenceBound(indices.size(), vertices));
  out.bytes.resize(isList ? meshopt_encodeIndexBuffer(out.bytes.data(), out.bytes.size(),
                                                      indices.data(), indices.size())
                          : meshopt_encodeIndexSequence(out.bytes.data(), out.bytes.size(),
                                                        indices.data(), indices.size()));
  return out;
}

#endif

}  // namespace

std::optional<Bytes> exponentialFilter(ByteView bytes, std::uint64_t stride) {
  const std::size_t width = stride / sizeof(float), count = bytes.size() / stride;
  std::vector<Dyadic> values(width * count);
  std::vector<int> finest(width, kHighestExponent);
  for (std::size_t i = 0; i < values.size(); ++i) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
    if (!std::isfinite(value)) return std::nullopt;
    values[i] = dyadicOf(value);
    if (values[i].bits > kMantissaBits || values[i].exponent > kHighestExponent)
      return std::nullopt;
    if (values[i].bits > 0) finest[i % width] = std::min(finest[i % width], values[i].exponent);
  }
  Bytes out(bytes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Dyadic& value = values[i];
    const int common = std::max(finest[i % width], kLowestExponent);
    // A value that is too large for the common exponent gets its own.
    const int exponent =
        value.bits == 0 ? common : std::max(common, value.exponent + value.bits - kMantissaBits);
    if (value.bits > 0 && exponent > value.exponent) return std::nullopt;
    const int mantissa = value.bits == 0 ? 0 : value.mantissa * (1 << (value.exponent - exponent));
    const std::uint32_t word = static_cast<std::uint32_t>(exponent) << 24 |
                               (static_cast<std::uint32_t>(mantissa) & 0xFFFFFFU);
    std::memcpy(out.data() + i * sizeof word, &word, sizeof word);
  }
  return out;
}

#ifdef HGP_HAS_MESHOPTIMIZER

bool canPackViews() { return true; }

std::optional<PackedView> packView(ByteView bytes, std::uint64_t stride, GltfContent content) {
  std::optional<PackedView> best;
  const std::size_t count = bytes.size() / stride;
  if (count == 0) return best;
  if (content == GltfContent::kIndices) {
    meshopt_encodeIndexVersion(1);  // the version that the extension prescribes
    std::vector<unsigned> indices(count, 0);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(&indices[i], bytes.data() + i * stride, stride);
    if (count % 3 == 0) offer(best, packIndices(indices, stride, true), bytes);
    offer(best, packIndices(indices, stride, false), bytes);
    return best;
  }
  if (stride % 4 != 0 || stride > 256) return best;
  meshopt_encodeVertexVersion(0);  // the version that the extension prescribes
  offer(best, packAttributes(bytes.data(), count, stride, "NONE"), bytes);
  if (content != GltfContent::kFloats) return best;
  if (const auto filtered = exponentialFilter(bytes, stride))
    offer(best, packAttributes(filtered->data(), count, stride, "EXPONENTIAL"), bytes);
  return best;
}

#else

bool canPackViews() { return false; }

std::optional<PackedView> packView(ByteView, std::uint64_t, GltfContent) { return std::nullopt; }

#endif

}  // namespace hgp::io
