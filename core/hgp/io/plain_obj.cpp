#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/io/plain_surface.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// The name without spaces, because OBJ has no quoted names.
std::string objName(const std::string& name, const std::string& otherwise) {
  std::string out = name.empty() ? otherwise : name;
  for (char& c : out)
    if (static_cast<unsigned char>(c) <= ' ' || c == '\\' || c == '#') c = '_';
  return out;
}

void appendNumbers(std::string& out, const char* word, const Vec3& numbers) {
  out += word;
  for (const double x : numbers) {
    out += ' ';
    text::appendDouble(out, x);
  }
}

class PlainObjText {
 public:
  std::string out;

  void add(const PlainSurface& surface, std::size_t index) {
    out += "o " + objName(surface.name, formatText("mesh_%zu", index)) + "\n";
    for (std::size_t v = 0; v < surface.mesh.positions.size(); ++v) {
      appendNumbers(out, "v", surface.mesh.positions[v]);
      if (!surface.colors.empty()) {
        for (std::size_t k = 0; k < 3; ++k)
          out += formatText(" %.6g", srgbFromLinear(surface.colors[v][k]));
      }
      out += '\n';
    }
    for (const Vec3& n : surface.normals) {
      appendNumbers(out, "vn", n);
      out += '\n';
    }
    int material = -1;
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
      const int next = surface.triangleMaterial.empty() ? -1 : surface.triangleMaterial[t];
      if (next >= 0 && next != material) {
        out += "usemtl " + objName(surface.materials[static_cast<std::size_t>(next)], "material") +
               "\n";
      }
      material = next;
      addFace(surface, t);
    }
    firstVertex_ += static_cast<int>(surface.mesh.positions.size());
    firstNormal_ += static_cast<int>(surface.normals.size());
  }

 private:
  void addFace(const PlainSurface& surface, std::size_t t) {
    out += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      out += ' ';
      text::appendInt(out, surface.mesh.triangles[t][k] + firstVertex_);
      const int normal = surface.cornerNormal.empty() ? -1 : surface.cornerNormal[t][k];
      if (normal < 0) continue;
      out += "//";
      text::appendInt(out, normal + firstNormal_);
    }
    out += '\n';
  }

  int firstVertex_ = 1, firstNormal_ = 1;
};

}  // namespace

double linearFromSrgb(double x) {
  return x <= 0.04045 ? x / 12.92 : portable::pow((x + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double x) {
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * portable::pow(x, 1.0 / 2.4) - 0.055;
  return std::clamp(y, 0.0, 1.0);
}

Bytes plainObj(const PlainFile& file, const std::string& generator) {
  PlainObjText text;
  if (!generator.empty()) text.out = "# " + generator + "\n";
  for (std::size_t i = 0; i < file.surfaces.size(); ++i) text.add(file.surfaces[i], i);
  return asBytes(text.out);
}

}  // namespace hgp::io
