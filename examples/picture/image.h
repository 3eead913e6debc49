// Pictures as arrays of pixels.  Role: output of the renderer, written as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hgp::picture {

using Colour = std::array<double, 3>;  ///< 0 … 1, as shown

Colour mix(const Colour& a, const Colour& b, double t);

struct Image {
  int width = 0, height = 0;
  std::vector<Colour> pixels;  ///< rows from the top
  Image(int w, int h, const Colour& fill = {1, 1, 1});
  Colour& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Colour& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Averages n × n pixels, for antialiasing.
Image shrink(const Image& image, int n);

/// Panels of equal height side by side.
Image sideBySide(const std::vector<Image>& panels);
Image stacked(const std::vector<Image>& rows);

/// Writes 8 bits per channel. False if the file cannot be written.
bool writePng(const std::string& path, const Image& image);

}  // namespace hgp::picture
