#include "hgp/io/limits.h"

#include "hgp/base/check.h"

namespace hgp::io {

std::string byteLimit(std::uint64_t maxBytes) {
  return formatText("the limit of %llu bytes", static_cast<unsigned long long>(maxBytes));
}

std::string triangleLimit(std::uint64_t maxTriangles) {
  return formatText("the limit of %llu triangles", static_cast<unsigned long long>(maxTriangles));
}

Failure tooManyBytes(std::size_t bytes, std::uint64_t maxBytes) {
  return {ErrorCode::kLimit,
          "read",
          formatText("the file has %zu bytes, more than ", bytes) + byteLimit(maxBytes),
          {},
          {Note("raise-bytes")}};
}

Failure tooManyTriangles(std::uint64_t maxTriangles) {
  return {ErrorCode::kLimit,
          "read",
          "more than " + triangleLimit(maxTriangles),
          {},
          {Note("raise-triangles")}};
}

Failure tooManyTriangles(std::size_t triangles, std::uint64_t maxTriangles) {
  return {ErrorCode::kLimit,
          "read",
          formatText("%zu triangles, more than ", triangles) + triangleLimit(maxTriangles),
          {},
          {Note("raise-triangles")}};
}

}  // namespace hgp::io
