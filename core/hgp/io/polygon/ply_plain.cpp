// Normals and colours of a PLY, for the formats that can store them.
#include <algorithm>

#include "hgp/io/polygon/ply_document.h"
#include "hgp/io/polygon/ply_rows.h"

namespace hgp::io {
namespace {

/// Which numbers of a vertex row are normals and colours; integer colours are fractions of their type's maximum.
struct PlyExtras {
  std::array<int, 3> normal{-1, -1, -1};
  std::array<int, 4> color{-1, -1, -1, -1};
  std::array<double, 4> largest{1, 1, 1, 1};

  explicit PlyExtras(const PlyElement& element) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const auto role = static_cast<int>(property.role);
      const int n = role - static_cast<int>(PlyRole::kNormalX);
      const int c = role - static_cast<int>(PlyRole::kRed);
      if (n >= 0 && n < 3) normal[static_cast<std::size_t>(n)] = static_cast<int>(p);
      if (c < 0 || c > 3) continue;
      color[static_cast<std::size_t>(c)] = static_cast<int>(p);
      if (property.type == PlyType::kUint8) largest[static_cast<std::size_t>(c)] = 255;
      if (property.type == PlyType::kUint16) largest[static_cast<std::size_t>(c)] = 65535;
    }
  }
  bool hasNormals() const { return *std::min_element(normal.begin(), normal.end()) >= 0; }
  bool hasColors() const { return *std::min_element(color.begin(), color.begin() + 3) >= 0; }
};

/// Normals, and colours as they are stored: fractions of their maximum.
void takeExtras(const PlyExtras& extras, const PlyRow& row, VertexExtras& out) {
  const auto number = [&](int p) { return row.numbers[row.first[static_cast<std::size_t>(p)]]; };
  if (extras.hasNormals())
    out.normals.push_back(
        {number(extras.normal[0]), number(extras.normal[1]), number(extras.normal[2])});
  if (!extras.hasColors()) return;
  std::array<double, 4> color{0, 0, 0, 1};
  for (std::size_t k = 0; k < 4; ++k)
    if (extras.color[k] >= 0) color[k] = number(extras.color[k]) / extras.largest[k];
  out.colors.push_back(color);
}

/// Whether VertexExtras, uv or the mesh have this property.
bool isKept(const PlyElement& element, const PlyExtras& extras, PlyRole role) {
  if (element.name != "vertex") return role == PlyRole::kCorners || role == PlyRole::kUvList;
  if (role >= PlyRole::kRed) return extras.hasColors();
  if (role >= PlyRole::kNormalX) return extras.hasNormals();
  return role != PlyRole::kNone;
}

/// Names of what no other format has, such as "vertex quality".
std::string othersOf(const PlyHeader& header) {
  std::string out;
  const auto add = [&](const std::string& name) { out += (out.empty() ? "" : ", ") + name; };
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    const PlyExtras extras(element);
    if (element.name != "vertex" && element.name != "face" && element.name != "tristrips") {
      add(element.name);
      continue;
    }
    for (const PlyProperty& property : element.properties)
      if (!isKept(element, extras, property.role)) add(element.name + " " + property.name);
  }
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return out;
}

}  // namespace

VertexExtras PlyDocument::extras() const {
  VertexExtras out;
  const std::string_view text = asText(bytes_).substr(textOffset_);
  PlyRowReader rows(text.substr(header_.bodyOffset), header_.encoding);
  PlyRow row;
  for (const PlyElement& element : header_.elements) {
    const PlyExtras extras(element);
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      if (!rows.next(element, row)) break;
      if (element.name == "vertex") takeExtras(extras, row, out);
    }
    if (element.name == "vertex") break;
  }
  return out;
}

Result<PlainFile> PlyDocument::plain(int surface) const {
  Result<PlainFile> file = PolygonDocument::plain(surface);
  if (!file) return file;
  PlainSurface& out = file->surfaces[0];
  VertexExtras found = extras();
  for (std::array<double, 4>& color : found.colors)
    for (std::size_t k = 0; k < 3; ++k) color[k] = linearFromSrgb(color[k]);
  out.normals = std::move(found.normals);
  out.colors = std::move(found.colors);
  if (!out.normals.empty()) out.cornerNormal = out.mesh.triangles;
  if (std::string others = othersOf(header_); !others.empty())
    file->lost.push_back(Note("convert-others-lost", {{"names", std::move(others)}}));
  return file;
}

Result<Written> PlyDocument::writeObj(int, const UvMap& map, const WriteOptions& options) const {
  const std::vector<int> cornerUv = polygonCornerUv(map);
  if (cornerUv.empty())
    return Failure{ErrorCode::kInternal, "write", "the map does not fit this document", {}};
  const VertexExtras found = extras();
  Written written;
  written.files.push_back(
      {options.name, writePolygonObj(polygons_, map.uv, cornerUv, options, found)});
  const bool hasNormals = !found.normals.empty(), hasColours = !found.colors.empty();
  written.notes.push_back(Note("write-as-obj", {{"normals", hasNormals ? 1 : 0},
                                                {"onlyColours", hasColours && !hasNormals ? 1 : 0},
                                                {"andColours", hasColours && hasNormals ? 1 : 0}}));
  return written;
}

}  // namespace hgp::io
