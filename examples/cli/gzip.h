// Decompresses gzip incrementally.  Role: stops early at a small file that would expand to gigabytes.
#pragma once

#include <memory>
#include <string>

#include "hgp/io/document.h"

namespace hgp::cli {

/// Beyond this size, data are refused as soon as their ratio to the compressed data read so far exceeds this:
/// meshes compress by a factor of 3 to 30, a decompression bomb by a thousand.
inline constexpr std::uint64_t kSuspiciousBytes = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kSuspiciousRatio = 200;

Failure tooLarge(std::uint64_t maxBytes);

/// Decompresses the members of a gzip stream in order (RFC 1952 allows several).
class Gunzip {
 public:
  explicit Gunzip(std::uint64_t maxBytes);
  ~Gunzip();
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// Decompresses these bytes and appends the result. Fails with kMalformed (damaged) or kLimit.
  Status take(io::ByteView packed, io::Bytes& out);
  /// Fails with kMalformed if the last member is incomplete.
  Status finish() const;
  /// Bytes after the last member, which are ignored.
  std::uint64_t ignoredBytes() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace hgp::cli
