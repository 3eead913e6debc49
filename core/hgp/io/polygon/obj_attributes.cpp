#include "hgp/io/polygon/obj_attributes.h"

#include <algorithm>
#include <map>

#include "hgp/text/text.h"

namespace hgp::io {
namespace {

class ObjAttributeReader {
 public:
  ObjAttributeReader(std::string_view text, const ObjText& places)
      : text_(text), places_(places), eol_(text::lineEndOf(text)) {}

  ObjAttributes read(std::size_t cornerCount) {
    out_.cornerNormal.reserve(cornerCount);
    while (position_ < text_.size()) {
      const bool isFace =
          face_ < places_.faceLines.size() && places_.faceLines[face_].begin == position_;
      const std::size_t lineEnd = std::min(text_.find(eol_, position_), text_.size() - 1) + 1;
      const std::size_t end = isFace ? places_.faceLines[face_].end : lineEnd;
      const char* p = text_.data() + position_;
      if (isFace)
        takeFace(p, text_.data() + end);
      else
        takeLine(p, text_.data() + end);
      position_ = end;
    }
    if (out_.uncolored == static_cast<int>(out_.colors.size())) {
      out_.colors.clear();
      out_.uncolored = 0;
    }
    if (!hasNormals_ || out_.cornerNormal.size() != cornerCount) out_.cornerNormal.clear();
    const int count = static_cast<int>(out_.normals.size());
    for (int& n : out_.cornerNormal)
      if (n >= count) n = -1;
    if (out_.materials.empty()) out_.polygonMaterial.clear();
    if (!hasSmoothing_) out_.polygonSmoothing.clear();
    return std::move(out_);
  }

 private:
  static std::string_view takeWord(const char*& p, const char* end) {
    text::skipBlanks(p, end);
    const char* begin = p;
    while (p != end && !text::isBlank(*p) && *p != '\n') ++p;
    return {begin, static_cast<std::size_t>(p - begin)};
  }

  std::string_view restOf(const char* p, const char* end) const {
    text::skipBlanks(p, end);
    std::string_view rest(p, static_cast<std::size_t>(end - p));
    while (!rest.empty() && (text::isBlank(rest.back()) || rest.back() == eol_))
      rest.remove_suffix(1);
    return rest;
  }

  void takeLine(const char* p, const char* end) {
    const std::string_view word = takeWord(p, end);
    if (word == "v") {
      takeVertex(p, end);
    } else if (word == "vn") {
      Vec3 n{};
      for (double& x : n) {
        text::skipBlanks(p, end);
        text::readDouble(p, end, x);
      }
      out_.normals.push_back(n);
    } else if (word == "usemtl") {
      const std::string_view name = restOf(p, end);
      const auto [found, isNew] =
          ids_.try_emplace(std::string(name), static_cast<int>(out_.materials.size()));
      if (isNew) out_.materials.emplace_back(name);
      material_ = found->second;
    } else if (word == "mtllib") {
      out_.libraries.emplace_back(restOf(p, end));
    } else if (word == "o" || word == "g") {
      out_.hasGroups = out_.hasGroups || groups_ > 0;
      ++groups_;
    } else if (word == "s") {
      takeSmoothing(takeWord(p, end));
    } else if (word == "l" || word == "p") {
      ++out_.linesAndPoints;
      if (word == "l") takePolyline(p, end);
    }
  }

  /// Reads the colour of "v x y z r g b"; a single fourth number is a weight.
  void takeVertex(const char* p, const char* end) {
    double numbers[6] = {};
    int count = 0;
    for (; count < 6; ++count) {
      text::skipBlanks(p, end);
      if (!text::readAnyDouble(p, end, numbers[count])) break;
    }
    out_.uncolored += count != 6;
    if (count == 6) {
      out_.colors.push_back({numbers[3], numbers[4], numbers[5]});
    } else {
      out_.colors.push_back({1, 1, 1});
    }
  }

  /// "s off" is group 0.
  void takeSmoothing(std::string_view word) {
    while (!word.empty() && word.back() == eol_) word.remove_suffix(1);
    const char* w = word.data();
    std::int64_t group = 0;
    if (!text::readInt(w, word.data() + word.size(), group) || group < 0 || group > INT32_MAX)
      group = 0;
    smoothing_ = static_cast<int>(group);
    hasSmoothing_ = true;
  }

  void takePolyline(const char* p, const char* end) {
    int before = -1;
    for (;;) {
      while (p != end && isSeparator(*p)) ++p;
      ObjCorner corner;
      if (p == end || *p == '#' || !takeObjCorner(p, end, corner)) return;
      std::int64_t index = 0;
      const char* v = corner.vertex.data();
      if (!text::readInt(v, v + corner.vertex.size(), index)) return;
      index += index < 0 ? static_cast<std::int64_t>(out_.colors.size()) : -1;
      if (index < 0 || index > INT32_MAX) return;
      const int here = static_cast<int>(index);
      if (before >= 0 && before != here) out_.lines.push_back({before, here});
      before = here;
    }
  }

  static bool isSeparator(char c) { return text::isBlank(c) || c == '\n' || c == '\\'; }

  void takeFace(const char* p, const char* end) {
    while (p != end && isSeparator(*p)) ++p;
    while (p != end && !isSeparator(*p)) ++p;  // skips the keyword f
    for (;;) {
      while (p != end && isSeparator(*p)) ++p;
      ObjCorner corner;
      if (p == end || *p == '#' || !takeObjCorner(p, end, corner)) break;
      std::int64_t index = 0;
      const char* n = corner.normal.data();
      const bool isThere =
          !corner.normal.empty() && text::readInt(n, n + corner.normal.size(), index);
      index += index < 0 ? static_cast<std::int64_t>(out_.normals.size()) : -1;
      const bool isUsable = isThere && index >= 0 && index <= INT32_MAX;
      hasNormals_ = hasNormals_ || isUsable;
      out_.cornerNormal.push_back(isUsable ? static_cast<int>(index) : -1);
    }
    out_.polygonMaterial.push_back(material_);
    out_.polygonSmoothing.push_back(smoothing_);
    ++face_;
  }

  std::string_view text_;
  const ObjText& places_;
  char eol_;
  ObjAttributes out_;
  std::map<std::string, int> ids_;
  std::size_t position_ = 0, face_ = 0;
  int material_ = -1, groups_ = 0, smoothing_ = 0;
  bool hasNormals_ = false, hasSmoothing_ = false;
};

}  // namespace

ObjAttributes readObjAttributes(std::string_view text, const ObjText& places,
                                std::size_t cornerCount) {
  return ObjAttributeReader(text, places).read(cornerCount);
}

}  // namespace hgp::io
