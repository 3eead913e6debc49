#include "gzip.h"

#include <algorithm>

#ifdef HGP_HAS_ZLIB
#include <zlib.h>
#endif

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/limits.h"

namespace hgp::cli {

Failure tooLarge(std::uint64_t maxBytes) {
  return {ErrorCode::kLimit,
          "read",
          "the input is larger than " + io::byteLimit(maxBytes),
          {},
          {Note("raise-bytes")}};
}

#ifdef HGP_HAS_ZLIB

namespace {
constexpr std::size_t kMinRoom = std::size_t{1} << 16;

Failure damaged(const char* why) {
  return {ErrorCode::kMalformed, "read", std::string("the gzip data are ") + why, {}};
}
}  // namespace

struct Gunzip::Stream {
  z_stream z{};
  std::uint64_t maxBytes = 0, packedBytes = 0, ignoredBytes = 0;
  enum class State { kInside, kBetween, kBehind } state = State::kBetween;
  std::size_t magicSeen = 0;  ///< how many of the next member's first two bytes were read
  bool isReady = false, hasMember = false;

  /// Skips zeros between members; data that does not start with a member's first two bytes is no longer gzip.
  std::size_t passBetween(io::ByteView packed) {
    constexpr std::uint8_t kMagic[2] = {0x1f, 0x8b};
    std::size_t i = 0;
    while (i < packed.size() && magicSeen < 2) {
      if (packed[i] == kMagic[magicSeen]) {
        ++magicSeen;
      } else if (packed[i] != 0 || magicSeen > 0) {
        state = State::kBehind;
        return i;
      }
      ++i;
    }
    if (magicSeen < 2) return i;
    if (!beginMember()) state = State::kBehind;
    return i;
  }

  /// Passes the two bytes to zlib, which needs them.
  bool beginMember() {
    std::uint8_t magic[2] = {0x1f, 0x8b}, nothing = 0;
    magicSeen = 0;
    if (isReady ? inflateReset(&z) != Z_OK : inflateInit2(&z, 15 + 16) != Z_OK) return false;
    isReady = hasMember = true;
    state = State::kInside;
    z.next_in = magic;
    z.avail_in = 2;
    z.next_out = &nothing;
    z.avail_out = 1;
    return inflate(&z, Z_NO_FLUSH) == Z_OK;
  }

  Status inflateSome(io::ByteView& packed, io::Bytes& out) {
    const std::size_t size = out.size();
    if (out.capacity() < size + kMinRoom) {
      out.reserve(std::min<std::size_t>(maxBytes, 2 * size) + 2 * kMinRoom);
    }
    out.resize(std::min(out.capacity(), size + 4 * kMinRoom));
    z.next_in = const_cast<Bytef*>(packed.data());
    z.avail_in = static_cast<uInt>(packed.size());
    z.next_out = out.data() + size;
    z.avail_out = static_cast<uInt>(out.size() - size);
    const int status = inflate(&z, Z_NO_FLUSH);
    packedBytes += packed.size() - z.avail_in;
    packed = packed.subspan(packed.size() - z.avail_in);
    out.resize(out.size() - z.avail_out);
    if (status == Z_STREAM_END) state = State::kBetween;
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
      return damaged("damaged");
    }
    return Done{};
  }

  Status checkSize(std::size_t size) const {
    if (size > maxBytes) return tooLarge(maxBytes);
    if (size > kSuspiciousBytes && size / kSuspiciousRatio > packedBytes) {
      return Failure{ErrorCode::kLimit,
                     "read",
                     formatText("%llu packed bytes unpack to more than %zu; where that is right, "
                                "unpack the file first",
                                static_cast<unsigned long long>(packedBytes), size),
                     {}};
    }
    return Done{};
  }
};

Gunzip::Gunzip(std::uint64_t maxBytes) : stream_(std::make_unique<Stream>()) {
  stream_->maxBytes = maxBytes;
}

Gunzip::~Gunzip() {
  if (stream_->isReady) inflateEnd(&stream_->z);
}

Status Gunzip::take(io::ByteView packed, io::Bytes& out) {
  Stream& s = *stream_;
  while (!packed.empty()) {
    if (s.state == Stream::State::kBetween) packed = packed.subspan(s.passBetween(packed));
    if (s.state == Stream::State::kBehind) {
      s.ignoredBytes += packed.size();
      return Done{};
    }
    while (s.state == Stream::State::kInside) {
      const std::size_t before = out.size();
      if (Status done = s.inflateSome(packed, out); !done) return done;
      if (Status fits = s.checkSize(out.size()); !fits) return fits;
      // Output that did not fit may remain after all input has been consumed.
      if (packed.empty() && (out.size() == before || s.z.avail_out > 0)) break;
    }
  }
  return Done{};
}

Status Gunzip::finish() const {
  const Stream& s = *stream_;
  if (!s.hasMember || s.state == Stream::State::kInside) return damaged("damaged or cut off");
  return Done{};
}

std::uint64_t Gunzip::ignoredBytes() const { return stream_->ignoredBytes; }

#else

struct Gunzip::Stream {};
Gunzip::Gunzip(std::uint64_t) {}
Gunzip::~Gunzip() = default;
Status Gunzip::take(io::ByteView, io::Bytes&) {
  return Failure{ErrorCode::kUnsupported, "read", "this build cannot unpack gzip", {}};
}
Status Gunzip::finish() const { return Done{}; }
std::uint64_t Gunzip::ignoredBytes() const { return 0; }

#endif

}  // namespace hgp::cli
