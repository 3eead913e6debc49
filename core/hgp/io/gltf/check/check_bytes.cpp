// Buffers, views and accessors: every byte range is checked as offset ≤ length and need ≤ length − offset,
// in 64 bits, so that no sum can overflow.
#include "hgp/base/check.h"
#include "hgp/io/gltf/check/check.h"
#include "hgp/io/gltf/json/model.h"
#include "hgp/io/limits.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

bool isInside(std::int64_t offset, std::int64_t need, std::int64_t length) {
  return offset <= length && need <= length - offset;
}

}  // namespace

std::string GltfChecker::overLimit(const std::string& what) const {
  return what + " would exceed " + byteLimit(limits_.maxBytes);
}

bool GltfChecker::checkBuffers() {
  std::int64_t total = 0;
  for (int buffer : buffers_) {
    std::int64_t length = 0;
    if (!json_.isObject(buffer)) return fail(buffer, "must be an object");
    if (!integer(buffer, "byteLength", -1, length)) return false;
    if (length < 1) return fail(buffer, "'byteLength' must be at least 1");
    const int uri = json_.find(buffer, "uri");
    if (uri >= 0 && !json_.isString(uri)) return fail(uri, "must be a string");
    // No overflow: `total` is checked after every addition, and one addition is below 2⁵³.
    total += length;
    if (static_cast<std::uint64_t>(total) > limits_.maxBytes) {
      return fail(buffer, "the buffers declare more than " + byteLimit(limits_.maxBytes),
                  ErrorCode::kLimit);
    }
  }
  return true;
}

bool GltfChecker::checkView(int view) {
  std::int64_t offset = 0, length = 0, stride = 0, bufferLength = 0;
  const int reference = json_.find(view, "buffer");
  if (reference < 0) return fail(view, "'buffer' is missing");
  if (!integer(view, "byteOffset", 0, offset) || !integer(view, "byteLength", -1, length) ||
      !integer(view, "byteStride", 0, stride) ||
      !integer(element("buffers", reference), "byteLength", -1, bufferLength)) {
    return false;
  }
  if (length < 1) return fail(view, "'byteLength' must be at least 1");
  if (json_.find(view, "byteStride") >= 0 && (stride < 4 || stride > 252 || stride % 4 != 0)) {
    return fail(view, formatText("'byteStride' is %lld; it must be a multiple of 4 from 4 to 252",
                                 static_cast<long long>(stride)));
  }
  if (!isInside(offset, length, bufferLength)) {
    return fail(view, formatText("bytes %lld + %lld are outside the buffer of %lld bytes",
                                 static_cast<long long>(offset), static_cast<long long>(length),
                                 static_cast<long long>(bufferLength)));
  }
  const int extensions = json_.find(view, "extensions");
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const int extension = json_.find(extensions, name);
    if (extension >= 0 && !checkMeshopt(view, extension, length)) return false;
  }
  return true;
}

bool GltfChecker::checkMeshoptMode(int extension, const std::string& mode, std::int64_t stride) {
  const int filterNode = json_.find(extension, "filter");
  const std::string filter = filterNode < 0 ? "NONE" : json_.string(filterNode);
  const bool isVertices = mode == "ATTRIBUTES";
  if (!isVertices && mode != "TRIANGLES" && mode != "INDICES") {
    return fail(extension, "unknown mode " + text::inQuotes(mode) +
                               "; it must be ATTRIBUTES, TRIANGLES or INDICES");
  }
  const bool isStrideGood =
      isVertices ? stride >= 4 && stride <= 256 && stride % 4 == 0 : stride == 2 || stride == 4;
  if (!isStrideGood) {
    return fail(extension, formatText("'byteStride' %lld does not suit the mode: %s",
                                      static_cast<long long>(stride),
                                      isVertices ? "ATTRIBUTES need a multiple of 4 from 4 to 256"
                                                 : "indices have 2 or 4 bytes"));
  }
  const bool isFilterGood =
      filter == "NONE" || (isVertices && filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
      (isVertices && filter == "QUATERNION" && stride == 8) ||
      (isVertices && filter == "EXPONENTIAL");
  if (isFilterGood) return true;
  return fail(extension, "filter " + text::inQuotes(filter) + " does not suit mode " + mode +
                             formatText(" with 'byteStride' %lld", static_cast<long long>(stride)));
}

bool GltfChecker::checkMeshopt(int view, int extension, std::int64_t viewLength) {
  std::int64_t offset = 0, length = 0, stride = 0, count = 0, bufferLength = 0;
  const int reference = json_.find(extension, "buffer");
  if (reference < 0) return fail(extension, "'buffer' is missing");
  if (!integer(extension, "byteOffset", 0, offset) ||
      !integer(extension, "byteLength", -1, length) ||
      !integer(extension, "byteStride", -1, stride) || !integer(extension, "count", -1, count) ||
      !integer(element("buffers", reference), "byteLength", -1, bufferLength)) {
    return false;
  }
  if (!isInside(offset, length, bufferLength)) {
    return fail(
        extension,
        formatText("the compressed bytes %lld + %lld are outside their buffer of %lld bytes",
                   static_cast<long long>(offset), static_cast<long long>(length),
                   static_cast<long long>(bufferLength)));
  }
  const std::string mode = json_.string(json_.find(extension, "mode"));
  if (!checkMeshoptMode(extension, mode, stride)) return false;
  if (mode == "TRIANGLES" && count % 3 != 0) {
    return fail(extension, formatText("'count' is %lld; mode TRIANGLES needs a multiple of 3",
                                      static_cast<long long>(count)));
  }
  if (count < 1 || count > viewLength || count * stride != viewLength) {
    return fail(extension,
                formatText("%lld elements of %lld bytes do not fill the view's %lld bytes",
                           static_cast<long long>(count), static_cast<long long>(stride),
                           static_cast<long long>(viewLength)));
  }
  zeroBytes_ += static_cast<std::uint64_t>(viewLength);
  if (zeroBytes_ <= limits_.maxBytes) return true;
  return fail(view, overLimit("the decoded data"), ErrorCode::kLimit);
}

bool GltfChecker::checkSpan(int node, int view, std::int64_t offset, std::int64_t count,
                            std::int64_t elementSize, std::int64_t componentSize, bool isSparse) {
  std::int64_t viewOffset = 0, length = 0, stride = 0;
  if (!integer(view, "byteOffset", 0, viewOffset) || !integer(view, "byteLength", -1, length) ||
      !integer(view, "byteStride", 0, stride)) {
    return false;
  }
  if (isSparse && stride != 0) {
    return fail(node, formatText("sparse data must be tightly packed, but its view has the "
                                 "byteStride %lld",
                                 static_cast<long long>(stride)));
  }
  if (stride == 0) stride = elementSize;
  if (stride < elementSize) {
    return fail(node,
                formatText("elements of %lld bytes at a stride of %lld overlap",
                           static_cast<long long>(elementSize), static_cast<long long>(stride)));
  }
  if (offset % componentSize != 0 || viewOffset % componentSize != 0) {
    return fail(node, formatText("byteOffset %lld, in a view at %lld, is not aligned to "
                                 "components of %lld bytes",
                                 static_cast<long long>(offset), static_cast<long long>(viewOffset),
                                 static_cast<long long>(componentSize)));
  }
  // count ≤ length is tested first, so that the product stays far below 2⁶³.
  if (count > length || !isInside(offset, stride * (count - 1) + elementSize, length)) {
    return fail(node, formatText("%lld elements do not fit the view of %lld bytes: they start at "
                                 "byte %lld and have a stride of %lld",
                                 static_cast<long long>(count), static_cast<long long>(length),
                                 static_cast<long long>(offset), static_cast<long long>(stride)));
  }
  return true;
}

bool GltfChecker::checkAccessor(int accessor) {
  std::int64_t offset = 0, count = 0, componentType = 0;
  if (!json_.isObject(accessor)) return fail(accessor, "must be an object");
  if (!integer(accessor, "byteOffset", 0, offset) || !integer(accessor, "count", -1, count) ||
      !integer(accessor, "componentType", -1, componentType)) {
    return false;
  }
  if (count < 1) return fail(accessor, "'count' must be at least 1");
  GltfAccessor shape;
  shape.componentType = componentType < 10'000 ? static_cast<int>(componentType) : 0;
  if (shape.componentSize() == 0) {
    return fail(accessor,
                formatText("unknown componentType %lld", static_cast<long long>(componentType)));
  }
  const std::string type = json_.string(json_.find(accessor, "type"));
  if (!gltfShape(type, shape)) return fail(accessor, "unknown type " + text::inQuotes(type));
  const int normalized = json_.find(accessor, "normalized");
  if (normalized >= 0 && !json_.isTrue(normalized) && !json_.isKind(normalized, JsonKind::kFalse)) {
    return fail(normalized, "must be true or false");
  }
  if (json_.isTrue(normalized) &&
      (componentType == kGltfFloat || componentType == kGltfUnsignedInt)) {
    return fail(normalized, "floats and 32-bit integers cannot be normalized");
  }
  const auto elementSize = static_cast<std::int64_t>(shape.elementSize());
  const int view = json_.find(accessor, "bufferView");
  if (view >= 0) {
    if (!checkSpan(accessor, element("bufferViews", view), offset, count, elementSize,
                   static_cast<std::int64_t>(shape.componentSize()), false)) {
      return false;
    }
  } else {
    const bool isHuge = static_cast<std::uint64_t>(count) > limits_.maxBytes;
    zeroBytes_ += isHuge ? limits_.maxBytes + 1 : static_cast<std::uint64_t>(count * elementSize);
    if (zeroBytes_ > limits_.maxBytes) {
      return fail(accessor,
                  overLimit(formatText("%lld elements without data of their own",
                                       static_cast<long long>(count))),
                  ErrorCode::kLimit);
    }
  }
  const int sparse = json_.find(accessor, "sparse");
  return sparse < 0 || checkSparse(accessor, sparse, count, elementSize);
}

bool GltfChecker::checkSparse(int accessor, int sparse, std::int64_t count,
                              std::int64_t elementSize) {
  const int indices = json_.find(sparse, "indices");
  const int values = json_.find(sparse, "values");
  if (!json_.isObject(indices) || !json_.isObject(values)) {
    return fail(sparse, "needs the objects 'indices' and 'values'");
  }
  std::int64_t changed = 0, indexOffset = 0, indexType = 0, valueOffset = 0;
  if (!integer(sparse, "count", -1, changed) || !integer(indices, "byteOffset", 0, indexOffset) ||
      !integer(indices, "componentType", -1, indexType) ||
      !integer(values, "byteOffset", 0, valueOffset)) {
    return false;
  }
  if (changed < 1 || changed > count) {
    return fail(sparse, formatText("'count' must be from 1 to the accessor's %lld, not %lld",
                                   static_cast<long long>(count), static_cast<long long>(changed)));
  }
  if (indexType != kGltfUnsignedByte && indexType != kGltfUnsignedShort &&
      indexType != kGltfUnsignedInt) {
    return fail(indices, formatText("'componentType' must be that of an unsigned integer (5121, "
                                    "5123 or 5125), not %lld",
                                    static_cast<long long>(indexType)));
  }
  // tinygltf stores these in 32 bits.
  if (indexOffset > INT32_MAX || valueOffset > INT32_MAX || changed > INT32_MAX) {
    return fail(sparse, "sparse data beyond 2 GiB is not supported", ErrorCode::kLimit);
  }
  const int indexView = json_.find(indices, "bufferView");
  const int valueView = json_.find(values, "bufferView");
  if (indexView < 0 || valueView < 0) {
    return fail(sparse, "'indices' and 'values' need a 'bufferView'");
  }
  std::int64_t componentType = 0;
  if (!integer(accessor, "componentType", -1, componentType)) return false;
  const auto indexSize = static_cast<std::int64_t>(gltfComponentSize(static_cast<int>(indexType)));
  const auto componentSize =
      static_cast<std::int64_t>(gltfComponentSize(static_cast<int>(componentType)));
  sparseElements_ += static_cast<std::uint64_t>(changed * elementSize);
  if (sparseElements_ > limits_.maxBytes) {
    return fail(sparse, overLimit("all sparse data together"), ErrorCode::kLimit);
  }
  return checkSpan(indices, element("bufferViews", indexView), indexOffset, changed, indexSize,
                   indexSize, true) &&
         checkSpan(values, element("bufferViews", valueView), valueOffset, changed, elementSize,
                   componentSize, true);
}

}  // namespace hgp::io
