#include "hgp/io/gltf/json/file.h"

#include <array>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"

std::uint32_t word(ByteView bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) |
         static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

Failure notGltf(std::size_t offset, const std::string& message) {
  return text::malformedByte(offset, "not a glTF file: " + message);
}

/// Reads the chunks of a GLB, the last of which must end where `file` does. A length that is not a multiple
/// of 4 is accepted if the next chunk, or the end, follows immediately: some writers do not pad.
class ChunkReader {
 public:
  explicit ChunkReader(ByteView file) : file_(file) { out_.isBinary = true; }

  Result<GltfContainer> read() {
    for (int index = 0; at_ < file_.size(); ++index) {
      if (file_.size() - at_ < 8) return failure(at_, "a chunk header is cut off");
      const std::size_t length = word(file_, at_);
      if (length % 4 != 0 && unpadded_ == 0) unpadded_ = at_;
      if (length > file_.size() - at_ - 8) {
        return failure(at_,
                       formatText("a chunk of %zu bytes, but only %zu are left; the file may be "
                                  "truncated",
                                  length, file_.size() - at_ - 8));
      }
      const Status taken = take(index, word(file_, at_ + 4), file_.subspan(at_ + 8, length));
      if (!taken) return taken.error();
      at_ += 8 + length;
    }
    if (unpadded_ > 0) out_.notes.push_back(Note("read-glb-unpadded"));
    return std::move(out_);
  }

 private:
  Failure failure(std::size_t at, const std::string& message) const {
    return unpadded_ > 0 ? notGltf(unpadded_, "a chunk length is not a multiple of 4")
                         : notGltf(at, message);
  }

  Status take(int index, std::uint32_t type, ByteView content) {
    if ((index == 0) != (type == kJsonChunk)) {
      return failure(at_ + 4, "there must be one JSON chunk and it must come first");
    }
    if (type == kJsonChunk) {
      out_.json = {reinterpret_cast<const char*>(content.data()), content.size()};
    } else if (type == kBinChunk) {
      if (out_.hasBin) return failure(at_ + 4, "more than one BIN chunk");
      if (index != 1) return failure(at_ + 4, "the BIN chunk must be the second");
      out_.hasBin = true;
      out_.bin = content;
    } else {
      out_.others.push_back({type, content});
    }
    return Done{};
  }

  ByteView file_;
  GltfContainer out_;
  std::size_t at_ = 12;
  std::size_t unpadded_ = 0;  ///< offset of the first chunk without padding; 0: none
};

/// A file that is longer than its header states: the bytes beyond the stated length are ignored, unless they
/// contain the BIN chunk or the chunks can be read only as a whole.
Result<GltfContainer> openLonger(ByteView file, std::size_t length) {
  const std::size_t behind = file.size() - length;
  std::optional<GltfContainer> part;
  if (length >= 20) {
    Result<GltfContainer> read = ChunkReader(file.first(length)).read();
    if (read) {
      read->notes.push_back(Note("read-glb-followed", {{"bytes", behind}}));
      if (read->hasBin) return read;
      part = std::move(*read);
    }
  }
  Result<GltfContainer> all = ChunkReader(file).read();
  if (all && (all->hasBin || !part)) {
    all->notes.push_back(Note("read-glb-longer", {{"bytes", behind}}));
    return all;
  }
  if (part) return std::move(*part);
  return all;
}

Result<GltfContainer> openBinary(ByteView file) {
  if (file.size() < 20) return notGltf(file.size(), "the GLB header is cut off");
  if (word(file, 4) != 2) {
    return notGltf(4, formatText("GLB version %u is not supported, only 2; export the file as glTF "
                                 "2.0",
                                 word(file, 4)));
  }
  const std::size_t length = word(file, 8);
  if (length == file.size()) return ChunkReader(file).read();
  if (length < file.size()) {
    Result<GltfContainer> out = openLonger(file, length);
    if (out) return out;
  }
  return notGltf(8, formatText("the GLB header says %zu bytes, but the file has %zu%s", length,
                               file.size(), length > file.size() ? "; it may be truncated" : ""));
}

int base64Value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string_view withoutPadding(std::string_view base64) {
  for (int k = 0; k < 2 && !base64.empty() && base64.back() == '='; ++k) base64.remove_suffix(1);
  return base64;
}

int hexValue(char c) {
  if (text::isDigit(c)) return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Percent-decodes once; empty when a '%' is not followed by two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      out.push_back(uri[i]);
      continue;
    }
    if (uri.size() - i < 3 || hexValue(uri[i + 1]) < 0 || hexValue(uri[i + 2]) < 0) {
      return std::nullopt;
    }
    out.push_back(static_cast<char>(hexValue(uri[i + 1]) * 16 + hexValue(uri[i + 2])));
    i += 2;
  }
  return out;
}

/// What is wrong with a decoded name, or nullptr.
const char* nameProblem(std::string_view name) {
  if (name.empty()) return "the name is empty";
  if (name.front() == '/') return "the path is absolute";
  for (char c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return "it has a control character";
    if (c == '\\') return "it has a backslash; separate folders by '/'";
    if (c == ':') return "only files next to this one are read: no scheme, host or drive";
  }
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    if (part == "..") return "it leaves the folder";
    if (part.empty()) return "it has an empty path segment";
    begin = end + 1;
  }
  return nullptr;
}

}  // namespace

Result<GltfContainer> openContainer(ByteView file) {
  if (file.size() >= 4 && word(file, 0) == kMagic) return openBinary(file);
  std::size_t at =
      file.size() >= 3 && file[0] == 0xEF && file[1] == 0xBB && file[2] == 0xBF ? 3 : 0;
  while (at < file.size() &&
         (file[at] == ' ' || file[at] == '\n' || file[at] == '\r' || file[at] == '\t')) {
    ++at;
  }
  if (at == file.size()) return notGltf(at, "it is empty");
  if (file[at] != '{') return notGltf(at, "it starts with neither the GLB magic nor a JSON object");
  GltfContainer out;
  out.json = {reinterpret_cast<const char*>(file.data()), file.size()};
  return out;
}

bool isDataUri(std::string_view uri) {
  return uri.size() >= 5 && (uri[0] | 0x20) == 'd' && (uri[1] | 0x20) == 'a' &&
         (uri[2] | 0x20) == 't' && (uri[3] | 0x20) == 'a' && uri[4] == ':';
}

Result<DataUri> parseDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  const std::string_view head = uri.substr(0, std::min(comma, uri.size()));
  if (comma == std::string_view::npos || head.size() < 7 ||
      head.substr(head.size() - 7) != ";base64") {
    return Failure{ErrorCode::kMalformed, "read", "its data URI is not base64 (no ';base64,')", {}};
  }
  return DataUri{uri.substr(comma + 1)};
}

std::optional<std::size_t> decodedSize(std::string_view base64) {
  const std::string_view digits = withoutPadding(base64);
  const std::size_t rest = digits.size() % 4;
  if (rest == 1) return std::nullopt;
  return digits.size() / 4 * 3 + (rest == 0 ? 0 : rest - 1);
}

std::optional<Bytes> decodeBase64(std::string_view base64) {
  const auto size = decodedSize(base64);
  if (!size) return std::nullopt;
  Bytes out;
  out.reserve(*size);
  std::uint32_t bits = 0;
  int filled = 0;
  for (char c : withoutPadding(base64)) {
    const int value = base64Value(c);
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xFFFFFF;
    filled += 6;
    if (filled < 8) continue;
    filled -= 8;
    out.push_back(static_cast<std::uint8_t>(bits >> filled));
  }
  return out;
}

std::string encodeBase64(ByteView bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::array<std::uint32_t, 3> b{};
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < have; ++k) b[k] = bytes[i + k];
    const std::uint32_t bits = b[0] << 16 | b[1] << 8 | b[2];
    for (std::size_t k = 0; k < 4; ++k) {
      out.push_back(k <= have ? kDigits[bits >> (18 - 6 * k) & 63] : '=');
    }
  }
  return out;
}

Result<std::string> relativeName(std::string_view uri) {
  const auto refuse = [&](const char* why) {
    return Failure{
        ErrorCode::kMalformed,
        "read",
        "the file refers to " + text::inQuotes(uri, 120) + ", which is not loaded: " + why,
        {}};
  };
  if (uri.find_first_of("?#") != std::string_view::npos)
    return refuse("it has a query or a fragment; encode '?' as %3F and '#' as %23");
  const auto name = percentDecoded(uri);
  if (!name) return refuse("its percent-encoding is invalid; encode '%' as %25");
  if (const char* problem = nameProblem(*name)) return refuse(problem);
  std::string_view plain = *name;
  while (plain.substr(0, 2) == "./") plain.remove_prefix(2);
  return std::string(plain);
}

std::string fileStem(const std::string& name) {
  const std::size_t slash = name.find_last_of('/');
  const std::string base = slash == std::string::npos ? name : name.substr(slash + 1);
  return base.substr(0, std::min(base.find_last_of('.'), base.size()));
}

std::string freeSideName(const std::string& stem, const std::vector<std::string>& taken) {
  std::string name = stem + ".bin";
  for (int n = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++n)
    name = stem + formatText("-%d.bin", n);
  return name;
}

std::string uriFromName(std::string_view name) {
  std::string out;
  for (char c : name) {
    const bool isPlain = text::isDigit(c) || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z') ||
                         std::string_view("-._~/").find(c) != std::string_view::npos;
    if (isPlain) {
      out.push_back(c);
    } else {
      out += formatText("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return out;
}

}  // namespace hgp::io
