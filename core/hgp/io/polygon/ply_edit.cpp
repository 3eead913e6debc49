#include "hgp/io/polygon/ply_edit.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hgp/base/check.h"
#include "hgp/io/polygon/ply_rows.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// The bits of x in the given type, as an integer whose lowest byte is written first.
std::uint64_t bitsOf(PlyType type, double x) {
  std::uint64_t bits = 0;
  if (type == PlyType::kFloat64) {
    std::memcpy(&bits, &x, sizeof x);
  } else if (type == PlyType::kFloat32) {
    const auto single = static_cast<float>(x);
    std::memcpy(&bits, &single, sizeof single);
  } else {
    bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
  }
  return bits;
}

double largestOf(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return std::numeric_limits<std::int8_t>::max();
    case PlyType::kUint8:
      return std::numeric_limits<std::uint8_t>::max();
    case PlyType::kInt16:
      return std::numeric_limits<std::int16_t>::max();
    case PlyType::kUint16:
      return std::numeric_limits<std::uint16_t>::max();
    default:
      return std::numeric_limits<std::int32_t>::max();
  }
}

class PlyEdit {
 public:
  PlyEdit(std::string_view text, const PlyHeader& header, const RefinedPolygons& edited)
      : text_(text),
        body_(text.substr(header.bodyOffset)),
        header_(header),
        edited_(edited),
        isText_(header.encoding == PlyEncoding::kText),
        lineEnd_(header.lineEnd == PlyLineEnd::kOld ? "\r" : "\n"),
        hasMidpoints_(std::any_of(edited.parents.begin(), edited.parents.end(),
                                  [](const VertexPair& p) { return p[0] != p[1]; })) {}

  std::string make() {
    PlyRowReader rows(body_, header_.encoding);
    PlyRow row;
    for (const PlyElement& element : header_.elements) {
      std::vector<Vertex> vertices;
      for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        if (!rows.next(element, row)) break;
        if (element.name == "vertex") vertices.push_back(vertexOf(row));
        if (element.name == "face") takeFace(element, row);
      }
      if (element.name == "vertex") addVertices(element, vertices, row);
    }
    out_ += body_.substr(position_);
    return headOf(text_.substr(0, header_.bodyOffset)) + out_;
  }

 private:
  void copyUntil(std::size_t end) {
    out_ += body_.substr(position_, end - position_);
    position_ = end;
  }

  struct Vertex {
    std::string_view text;
    PlyRow row;  ///< where there are midpoints
  };
  Vertex vertexOf(const PlyRow& row) const {
    return {body_.substr(row.begin.front(), row.end.back() - row.begin.front()),
            hasMidpoints_ ? row : PlyRow()};
  }

  void addVertices(const PlyElement& element, const std::vector<Vertex>& vertices,
                   const PlyRow& last) {
    if (edited_.parents.empty() || vertices.empty()) return;
    copyUntil(last.end.back());
    for (const VertexPair& parent : edited_.parents) {
      if (isText_) out_ += lineEnd_;
      const Vertex& a = vertices[static_cast<std::size_t>(parent[0])];
      if (parent[0] == parent[1])
        out_ += a.text;
      else
        addMidpoint(element, a.row, vertices[static_cast<std::size_t>(parent[1])].row);
    }
  }

  /// Means of all numbers; normals have length 1, and lists are those of a.
  void addMidpoint(const PlyElement& element, const PlyRow& a, const PlyRow& b) {
    std::vector<double> mean(element.properties.size());
    double normal = 0.0;
    const auto isNormal = [&](std::size_t p) {
      const PlyRole role = element.properties[p].role;
      return role == PlyRole::kNormalX || role == PlyRole::kNormalY || role == PlyRole::kNormalZ;
    };
    for (std::size_t p = 0; p < mean.size(); ++p) {
      if (element.properties[p].isList) continue;
      mean[p] = 0.5 * a.numbers[a.first[p]] + 0.5 * b.numbers[b.first[p]];
      if (isNormal(p)) normal += mean[p] * mean[p];
    }
    for (std::size_t p = 0; p < mean.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (isText_ && p > 0) out_ += ' ';
      if (property.isList) {
        out_ += body_.substr(a.begin[p], a.end[p] - a.begin[p]);
        continue;
      }
      const bool isReal = property.type == PlyType::kFloat32 || property.type == PlyType::kFloat64;
      if (isNormal(p) && isReal && normal > 0.0) mean[p] /= std::sqrt(normal);
      addNumber(property.type, isReal ? mean[p] : std::round(mean[p]), true);
    }
  }

  void takeFace(const PlyElement& element, const PlyRow& row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      if (element.properties[p].role == PlyRole::kCorners && row.first[p + 1] - row.first[p] < 3)
        return;
    const int origin = polygon_++;
    const std::size_t first = next_;
    while (next_ < edited_.polygonOrigin.size() && edited_.polygonOrigin[next_] == origin) ++next_;
    addedFaces_ += next_ - first - 1;
    const std::size_t before = corner_;
    for (std::size_t p = 0; p < element.properties.size(); ++p)
      if (element.properties[p].role == PlyRole::kCorners)
        corner_ += row.first[p + 1] - row.first[p];
    if (edited_.isSame[first]) return;
    copyUntil(row.begin.front());
    for (std::size_t child = first; child < next_; ++child) {
      if (isText_ && child > first) out_ += lineEnd_;
      addFace(element, row, child, before);
    }
    position_ = row.end.back();
  }

  std::size_t cornersOf(std::size_t polygon) const {
    return edited_.polygons.start[polygon + 1] - edited_.polygons.start[polygon];
  }

  /// @param firstCorner  index, before the edit, of the first corner of the row's face
  void addFace(const PlyElement& element, const PlyRow& row, std::size_t child,
               std::size_t firstCorner) {
    std::size_t from = row.begin.front();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const bool isCorners = property.role == PlyRole::kCorners;
      if (!isCorners && property.role != PlyRole::kUvList) continue;
      out_ += body_.substr(from, row.begin[p] - from);
      from = row.end[p];
      const std::size_t count = cornersOf(child), width = isCorners ? 1 : 2;
      const bool isWhole = row.first[p + 1] - row.first[p] >= width * count;
      addNumber(property.countType, static_cast<double>(isWhole ? width * count : 0), true);
      for (std::size_t c = edited_.polygons.start[child];
           isWhole && c < edited_.polygons.start[child + 1]; ++c) {
        if (isCorners) {
          addNumber(property.type, edited_.polygons.cornerVertex[c], false);
          continue;
        }
        for (const std::size_t part : {0, 1}) {
          const auto uv = [&](int corner) {
            return row.numbers[row.first[p] + 2 * (static_cast<std::size_t>(corner) - firstCorner) +
                               part];
          };
          const VertexPair& pair = edited_.corners[c];
          addNumber(property.type,
                    pair[0] == pair[1] ? uv(pair[0]) : 0.5 * uv(pair[0]) + 0.5 * uv(pair[1]),
                    false);
        }
      }
    }
    out_ += body_.substr(from, row.end.back() - from);
  }

  void addNumber(PlyType type, double x, bool isFirst) {
    if (isText_) {
      if (!isFirst) out_ += ' ';
      return text::appendDouble(out_, x);
    }
    const std::uint64_t bits = bitsOf(type, x);
    const auto size = static_cast<int>(plySize(type));
    for (int k = 0; k < size; ++k) {
      const int byte = header_.encoding == PlyEncoding::kLittle ? k : size - 1 - k;
      out_ += static_cast<char>(bits >> (8 * byte) & 0xFF);
    }
  }

  /// The header with the new counts.
  std::string headOf(std::string_view head) const {
    std::string out;
    for (std::size_t at = 0; at < head.size();) {
      const std::size_t next = std::min(head.find(*lineEnd_, at), head.size() - 1) + 1;
      const std::string_view line = head.substr(at, next - at);
      at = next;
      text::WordReader words(line);
      std::int64_t count = 0;
      const bool isElement = words.next() == "element";
      const std::string_view name = isElement ? words.next() : std::string_view();
      if ((name != "vertex" && name != "face") || !words.nextInt(count)) {
        out += line;
        continue;
      }
      const std::size_t added = name == "vertex" ? edited_.parents.size() : addedFaces_;
      const std::size_t end = line.find_last_not_of("\r\n \t") + 1;
      out += "element " + std::string(name) + ' ';
      text::appendInt(out, count + static_cast<std::int64_t>(added));
      out += line.substr(end);
    }
    return out;
  }

  std::string_view text_, body_;
  const PlyHeader& header_;
  const RefinedPolygons& edited_;
  bool isText_;
  const char* lineEnd_;
  bool hasMidpoints_;
  std::string out_;
  std::size_t position_ = 0, addedFaces_ = 0;
  std::size_t next_ = 0;    ///< next polygon of `edited`
  std::size_t corner_ = 0;  ///< next corner of the polygons before the edit
  int polygon_ = 0;
};

Failure unwritable(const char* why) {
  return {ErrorCode::kUnsupported,
          "repair",
          formatText("the changed faces cannot be written into this PLY: %s", why),
          {},
          {Note("write-obj")}};
}

}  // namespace

Result<std::string> editPlyFaces(std::string_view text, const PlyHeader& header,
                                 const RefinedPolygons& edited) {
  const auto faces = std::find_if(header.elements.begin(), header.elements.end(),
                                  [](const PlyElement& e) { return e.name == "face"; });
  if (faces == header.elements.end()) return unwritable("its faces are triangle strips");
  const auto last = static_cast<double>(edited.polygons.positions.size()) - 1;
  for (const PlyProperty& p : faces->properties)
    if (p.role == PlyRole::kCorners && largestOf(p.type) < last)
      return unwritable("the type of its vertex indices is too small for the new vertices");
  return PlyEdit(text, header, edited).make();
}

}  // namespace hgp::io
