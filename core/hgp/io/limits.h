#pragma once

// What readers say of a file that is larger than the caller allows: the limit, and the option that raises it, in one
// wording for all formats.

#include <cstddef>
#include <cstdint>
#include <string>

#include "hgp/base/result.h"

namespace hgp::io {

/// "the limit of N bytes", of a failure whose advice is Note("raise-bytes").
std::string byteLimit(std::uint64_t maxBytes);

/// "the limit of N triangles", of a failure whose advice is Note("raise-triangles").
std::string triangleLimit(std::uint64_t maxTriangles);

/// kLimit: a file of `bytes` bytes.
Failure tooManyBytes(std::size_t bytes, std::uint64_t maxBytes);

/// kLimit: a file whose triangles were counted only up to the limit.
Failure tooManyTriangles(std::uint64_t maxTriangles);

/// kLimit: a mesh of `triangles` triangles.
Failure tooManyTriangles(std::size_t triangles, std::uint64_t maxTriangles);

}  // namespace hgp::io
