#include "hgp/io/grid_material.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/patch/grid.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// A PNG of 64 × 64 pixels: two by two squares of a checkerboard with lines between them.
constexpr std::array<std::uint8_t, 227> kPicture = {
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x40, 0x08, 0x02, 0x00, 0x00, 0x00, 0x25, 0x0B, 0xE6,
    0x89, 0x00, 0x00, 0x00, 0xAA, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0xD5, 0xC1, 0x31, 0x0D, 0xC2,
    0x50, 0x00, 0x00, 0xD1, 0xEB, 0xA5, 0x36, 0x70, 0xC1, 0x8E, 0x05, 0x82, 0x85, 0x4E, 0x8C, 0x08,
    0x60, 0x42, 0x40, 0xC7, 0xBA, 0x68, 0x10, 0x52, 0x51, 0x24, 0x24, 0x95, 0xF0, 0x87, 0x7B, 0x6F,
    0xBA, 0xDC, 0x16, 0xCA, 0x24, 0x4E, 0xE2, 0x66, 0x4E, 0xC7, 0xBE, 0x32, 0xC0, 0xF5, 0xF1, 0xE2,
    0xEF, 0xBB, 0xBD, 0x19, 0x40, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24,
    0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E,
    0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x6E, 0xBA,
    0xDC, 0x16, 0xCA, 0x24, 0x4E, 0xE2, 0x66, 0x4E, 0xDF, 0xED, 0xCD, 0x00, 0xF7, 0xE7, 0x87, 0xBF,
    0x63, 0x5F, 0x19, 0x40, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E,
    0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2,
    0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0x4E, 0xE2, 0x24, 0xEE, 0x07, 0x6A,
    0xD8, 0x0B, 0xCE, 0xA2, 0x91, 0xC1, 0x96, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE,
    0x42, 0x60, 0x82};

ByteView picture() { return {kPicture.data(), kPicture.size()}; }

std::string_view textOf(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// How often the picture repeats per unit of uv. Not by printf, which writes a comma in some locales.
std::string scaleOf(double tiles) {
  std::string out;
  text::appendDouble(out, tiles / 2);
  return out;
}

/// Turns lines that name materials or libraries into comments; every other line stays byte for byte.
Bytes objWithGrid(const Bytes& file, const std::string& head) {
  Bytes out(head.begin(), head.end());
  out.reserve(head.size() + file.size() + 64);
  const std::string_view text = textOf(file);
  for (std::size_t line = 0; line < text.size();) {
    const std::size_t end = std::min(text.find('\n', line), text.size() - 1) + 1;
    const std::size_t word = std::min(text.find_first_not_of(" \t", line), end);
    const std::string_view first = text.substr(word, 6);
    if (first == "usemtl" || first == "mtllib") out.insert(out.end(), {'#', ' '});
    out.insert(out.end(), file.begin() + static_cast<std::ptrdiff_t>(line),
               file.begin() + static_cast<std::ptrdiff_t>(end));
    line = end;
  }
  return out;
}

/// The name without spaces, because OBJ has no quoted names.
std::string gridStem(const std::string& name) {
  std::string out = fileStem(name);
  for (char& c : out) {
    const bool isWord = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || text::isDigit(c) ||
                        c == '_' || c == '.' || c == '-';
    if (!isWord) c = '_';
  }
  return out + ".grid";
}

}  // namespace

Result<std::vector<OutputFile>> withGridMaterials(std::vector<OutputFile> files,
                                                  const std::vector<GridMaterial>& grids) {
  HGP_CHECK(!files.empty(), "there is a main file");
  std::vector<GltfGridPlace> places;
  places.reserve(grids.size());
  for (const GridMaterial& grid : grids)
    places.push_back({grid.mesh, grid.uvSet, scaleOf(grid.tiles)});
  Result<Bytes> made = gltfWithGrids(files.front().bytes, places, picture());
  if (!made) return made.error();
  files.front().bytes = std::move(*made);
  return files;
}

Result<std::vector<OutputFile>> withGridMaterial(std::vector<OutputFile> files,
                                                 std::string_view format,
                                                 const GridMaterial& grid) {
  HGP_CHECK(!files.empty(), "there is a main file");
  if (format == "glb" || format == "gltf") return withGridMaterials(std::move(files), {grid});
  if (format != "obj") {
    return Failure{
        ErrorCode::kUnsupported,
        "write",
        "a grid as material needs a format with materials: glTF or OBJ, not " + std::string(format),
        {}};
  }
  OutputFile& main = files.front();
  const std::string stem = gridStem(main.name);
  main.bytes = objWithGrid(main.bytes, "mtllib " + stem + ".mtl\nusemtl hgp_grid\n");
  const std::string scale = scaleOf(grid.tiles);
  files.push_back({stem + ".mtl", asBytes("newmtl hgp_grid\nKd 1 1 1\nmap_Kd -s " + scale + " " +
                                          scale + " 1 " + stem + ".png\n")});
  files.push_back({stem + ".png", Bytes(kPicture.begin(), kPicture.end())});
  return files;
}

}  // namespace hgp::io
