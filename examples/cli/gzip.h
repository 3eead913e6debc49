// gzip as it comes in, piece by piece.  Role: a small file that would unpack to gigabytes ends early.
#pragma once

#include <memory>
#include <string>

#include "hgp/io/document.h"

namespace hgp::cli {

/// More than this is refused as soon as it is this many times larger than what was read of the packed
/// data: meshes pack 3 to 30 times, a bomb a thousand times.
inline constexpr std::uint64_t kSuspiciousBytes = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kSuspiciousRatio = 200;

Failure tooLarge(std::uint64_t maxBytes);

/// Unpacks the members of a gzip stream one after the other (RFC 1952: there may be several).
class Gunzip {
 public:
  explicit Gunzip(std::uint64_t maxBytes);
  ~Gunzip();
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// Appends what these packed bytes unpack to. Fails with kMalformed (damaged) or kLimit.
  Status take(io::ByteView packed, io::Bytes& out);
  /// Fails with kMalformed when the last member was not complete.
  Status finish() const;
  /// What was ignored behind the last member, or "".
  std::string note() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace hgp::cli
