// SHA-256 (FIPS 180-4).  Role: identifies the input of a report and the mesh of a cone file. Any thread may call it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace hgp::api {

/// 64 lower-case hexadecimal digits.
std::string sha256(const std::uint8_t* bytes, std::size_t size);

}  // namespace hgp::api
