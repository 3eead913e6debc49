#include "image.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace hgp::picture {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append32(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

/// Appends a PNG chunk: length, type, data, checksum over type and data.
void appendChunk(Bytes& file, const char* kind, const Bytes& data) {
  append32(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = file.size();
  file.insert(file.end(), kind, kind + 4);
  file.insert(file.end(), data.begin(), data.end());
  append32(file, static_cast<std::uint32_t>(
                     crc32(0, file.data() + begin, static_cast<uInt>(data.size() + 4))));
}

std::uint8_t paeth(int left, int up, int corner) {
  const int guess = left + up - corner;
  const int dl = std::abs(guess - left), du = std::abs(guess - up), dc = std::abs(guess - corner);
  return static_cast<std::uint8_t>(dl <= du && dl <= dc ? left : du <= dc ? up : corner);
}

/// One row minus the prediction of a filter; filters 0 (none) and 4 (Paeth) suffice here.
Bytes filtered(const Bytes& row, const Bytes& above, int filter) {
  Bytes out{static_cast<std::uint8_t>(filter)};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i < 3 ? 0 : row[i - 3], corner = i < 3 ? 0 : above[i - 3];
    const int guess = filter == 0 ? 0 : paeth(left, above[i], corner);
    out.push_back(static_cast<std::uint8_t>(row[i] - guess));
  }
  return out;
}

long long roughness(const Bytes& row) {
  long long sum = 0;
  for (std::size_t i = 1; i < row.size(); ++i) sum += std::abs(static_cast<std::int8_t>(row[i]));
  return sum;
}

Bytes scanlines(const Image& image) {
  Bytes all, above(static_cast<std::size_t>(image.width) * 3, 0);
  for (int y = 0; y < image.height; ++y) {
    Bytes row;
    for (int x = 0; x < image.width; ++x) {
      for (double c : image.at(x, y)) {
        // Six bits look the same here and halve the file size.
        const double level = std::round(std::clamp(c, 0.0, 1.0) * 63) / 63;
        row.push_back(static_cast<std::uint8_t>(std::lround(255 * level)));
      }
    }
    const Bytes plain = filtered(row, above, 0), predicted = filtered(row, above, 4);
    const Bytes& best = roughness(predicted) < roughness(plain) ? predicted : plain;
    all.insert(all.end(), best.begin(), best.end());
    above = std::move(row);
  }
  return all;
}

}  // namespace

Colour mix(const Colour& a, const Colour& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Image::Image(int w, int h, const Colour& fill)
    : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, fill) {}

Image shrink(const Image& image, int n) {
  Image out(image.width / n, image.height / n, {0, 0, 0});
  for (int y = 0; y < out.height * n; ++y) {
    for (int x = 0; x < out.width * n; ++x) {
      for (int i = 0; i < 3; ++i) out.at(x / n, y / n)[i] += image.at(x, y)[i] / (n * n);
    }
  }
  return out;
}

Image sideBySide(const std::vector<Image>& panels) {
  int width = 0, height = 0;
  for (const Image& p : panels) {
    width += p.width;
    height = std::max(height, p.height);
  }
  Image out(width, height);
  int left = 0;
  for (const Image& p : panels) {
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) out.at(left + x, y) = p.at(x, y);
    }
    left += p.width;
  }
  return out;
}

Image stacked(const std::vector<Image>& rows) {
  int width = 0, height = 0;
  for (const Image& r : rows) {
    width = std::max(width, r.width);
    height += r.height;
  }
  Image out(width, height);
  int top = 0;
  for (const Image& r : rows) {
    for (int y = 0; y < r.height; ++y) {
      for (int x = 0; x < r.width; ++x) out.at(x, top + y) = r.at(x, y);
    }
    top += r.height;
  }
  return out;
}

bool writePng(const std::string& path, const Image& image) {
  const Bytes raw = scanlines(image);
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  Bytes packed(size);
  if (compress2(packed.data(), &size, raw.data(), static_cast<uLong>(raw.size()), 9) != Z_OK) {
    return false;
  }
  packed.resize(size);
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append32(header, static_cast<std::uint32_t>(image.width));
  append32(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {8, 2, 0, 0, 0});  // 8 bits, RGB, deflate, filters, no interlacing
  appendChunk(file, "IHDR", header);
  appendChunk(file, "IDAT", packed);
  appendChunk(file, "IEND", {});
  std::FILE* out = std::fopen(path.c_str(), "wb");
  if (!out) return false;
  const bool isWritten = std::fwrite(file.data(), 1, file.size(), out) == file.size();
  return std::fclose(out) == 0 && isWritten;
}

}  // namespace hgp::picture
