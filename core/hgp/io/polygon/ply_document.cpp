#include "hgp/io/polygon/ply_document.h"

#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/io/polygon/ply_edit.h"
#include "hgp/io/polygon/ply_rows.h"
#include "hgp/io/round_uv.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// A list of two numbers per corner fits a length of one byte up to this many corners.
constexpr std::size_t kMaxCornersOfByte = 127;
constexpr std::string_view kUvComment = "comment uv of ";

class PlyPatch {
 public:
  PlyPatch(std::string_view text, const PlyHeader& header, const PolygonMesh& polygons,
           const UvMap& map, const std::vector<int>& cornerUv, bool isDouble)
      : text_(text),
        header_(header),
        polygons_(polygons),
        map_(map),
        cornerUv_(cornerUv),
        isDouble_(isDouble) {
    for (int p = 0; p < polygons.polygonCount(); ++p) {
      const auto at = static_cast<std::size_t>(p);
      mostCorners_ =
          std::max<std::size_t>(mostCorners_, polygons.start[at + 1] - polygons.start[at]);
    }
    isWide_ = mostCorners_ > kMaxCornersOfByte;
    for (const PlyElement& element : header.elements) {
      hasFaces_ = hasFaces_ || element.name == "face";
      replacesUv_ =
          replacesUv_ || std::any_of(element.properties.begin(), element.properties.end(),
                                     [&](const PlyProperty& p) { return isOldUv(element, p); });
    }
  }

  std::string make(const std::string& generator) {
    out_.reserve(text_.size() + 18 * cornerUv_.size());
    patchHeader(generator);
    const std::string_view body = text_.substr(header_.bodyOffset);
    PlyRowReader rows(body, header_.encoding);
    PlyRow row;
    for (const PlyElement& element : header_.elements) {
      for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        if (!rows.next(element, row)) break;
        patchRow(body, element, row);
      }
      if (element.name == "tristrips" && !hasFaces_) addStripFaces();
    }
    out_ += body.substr(position_);
    return std::move(out_);
  }

  bool replacesUv() const { return replacesUv_; }

 private:
  static bool isOldUv(const PlyElement& element, const PlyProperty& property) {
    const bool isVertexUv = property.role == PlyRole::kU || property.role == PlyRole::kV;
    return (element.name == "vertex" && isVertexUv) ||
           (element.name == "face" && property.role == PlyRole::kUvList);
  }
  bool isDropped(const PlyElement& element) const {
    return element.name == "tristrips" && !hasFaces_;
  }

  std::string uvProperty() const {
    return std::string("property list ") + (isWide_ ? "ushort" : "uchar") +
           (isDouble_ ? " double" : " float") + " texcoord";
  }

  /// Rewrites the header line by line; the indices `element` and `property` follow.
  void patchHeader(const std::string& generator) {
    const char* end = header_.lineEnd == PlyLineEnd::kOld ? "\r" : "\n";
    const std::string_view head = text_.substr(0, header_.bodyOffset);
    int element = -1;
    std::size_t property = 0, position = 0;
    const auto current = [&]() -> const PlyElement* {
      return element < 0 ? nullptr : &header_.elements[static_cast<std::size_t>(element)];
    };
    while (position < head.size()) {
      const std::size_t next = std::min(head.find(*end, position), head.size() - 1) + 1;
      const std::string_view line = head.substr(position, next - position);
      const std::size_t last = line.find_last_not_of("\r\n \t");
      const std::string ending(last == std::string_view::npos ? line : line.substr(last + 1));
      text::WordReader words(line);
      const std::string_view keyword = words.next();
      position = next;
      if (line.substr(0, kUvComment.size()) == kUvComment) continue;  // of an earlier run
      if (keyword == "element" || keyword == "end_header") {
        if (current() != nullptr && current()->name == "face")
          out_.append(uvProperty()).append(ending);
        if (keyword == "end_header" && !generator.empty())
          out_.append(kUvComment).append(generator).append(ending);
        element += keyword == "element";
        property = 0;
        if (keyword == "element" && isDropped(*current())) {
          out_.append(formatText("element face %d", polygons_.polygonCount())).append(ending);
          out_.append("property list uchar int vertex_indices").append(ending);
          out_.append(uvProperty()).append(ending);
          continue;
        }
      } else if (keyword == "property" && current() != nullptr) {
        const PlyProperty& old = current()->properties[property++];
        if (isDropped(*current()) || isOldUv(*current(), old)) continue;
      }
      out_ += line;
    }
  }

  void patchRow(std::string_view body, const PlyElement& element, const PlyRow& row) {
    std::size_t corners = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.role == PlyRole::kCorners) corners = row.first[p + 1] - row.first[p];
      if (!isOldUv(element, property) && !isDropped(element)) continue;
      out_ += body.substr(position_, row.begin[p] - position_);
      position_ = row.end[p];
      // Removes the blank before a word that was removed.
      if (header_.encoding == PlyEncoding::kText && out_.back() == ' ') out_.pop_back();
    }
    if (isDropped(element)) return;
    const std::size_t end = row.end.back();
    out_ += body.substr(position_, end - position_);
    position_ = end;
    if (element.name != "face") return;
    addUv(corners >= 3 ? polygon_++ : -1);
  }

  void addLength(std::size_t length) {
    if (header_.encoding == PlyEncoding::kText) {
      out_ += ' ';
      text::appendInt(out_, static_cast<std::int64_t>(length));
    } else if (!isWide_) {
      out_ += static_cast<char>(length);
    } else {
      const char low = static_cast<char>(length & 0xFF), high = static_cast<char>(length >> 8);
      const bool isLittle = header_.encoding == PlyEncoding::kLittle;
      out_ += isLittle ? low : high;
      out_ += isLittle ? high : low;
    }
  }

  void addNumber(double x) {
    if (header_.encoding == PlyEncoding::kText) {
      out_ += ' ';
      text::appendDouble(out_, x);
      return;
    }
    std::uint64_t bits = 0;
    const auto single = static_cast<float>(x);
    const int size = isDouble_ ? 8 : 4;
    if (isDouble_) std::memcpy(&bits, &x, sizeof x);
    if (!isDouble_) std::memcpy(&bits, &single, sizeof single);
    for (int k = 0; k < size; ++k) {
      const int byte = header_.encoding == PlyEncoding::kLittle ? k : size - 1 - k;
      out_ += static_cast<char>(bits >> (8 * byte) & 0xFF);
    }
  }

  /// Appends the uv list of a face. @param polygon  −1: a face that was skipped, which gets an empty list
  void addUv(int polygon) {
    if (polygon < 0) return addLength(0);
    const auto p = static_cast<std::size_t>(polygon);
    addLength(2 * (polygons_.start[p + 1] - polygons_.start[p]));
    for (std::size_t c = polygons_.start[p]; c < polygons_.start[p + 1]; ++c)
      for (const double x : map_.uv[static_cast<std::size_t>(cornerUv_[c])]) addNumber(x);
  }

  void addStripFaces() {
    for (int p = 0; p < polygons_.polygonCount(); ++p) {
      const bool isText = header_.encoding == PlyEncoding::kText;
      out_ += isText ? "3" : "\x03";
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = polygons_.cornerVertex[3 * static_cast<std::size_t>(p) + k];
        if (isText) {
          out_ += ' ';
          text::appendInt(out_, v);
          continue;
        }
        for (int i = 0; i < 4; ++i) {
          const int byte = header_.encoding == PlyEncoding::kLittle ? i : 3 - i;
          out_ += static_cast<char>(static_cast<unsigned>(v) >> (8 * byte) & 0xFF);
        }
      }
      addUv(p);
      if (isText) out_ += '\n';
    }
  }

  std::string_view text_;
  const PlyHeader& header_;
  const PolygonMesh& polygons_;
  const UvMap& map_;
  const std::vector<int>& cornerUv_;
  std::string out_;
  std::size_t position_ = 0, mostCorners_ = 0;
  int polygon_ = 0;
  bool isWide_ = false, hasFaces_ = false, replacesUv_ = false;
  bool isDouble_;
};

}  // namespace

PlyDocument::PlyDocument(PlyHeader header, std::size_t textOffset, std::string target)
    : PolygonDocument("ply"),
      header_(std::move(header)),
      textOffset_(textOffset),
      target_(std::move(target)) {
  const auto hasList = [&](PlyType type) {
    for (const PlyElement& element : header_.elements)
      for (const PlyProperty& property : element.properties)
        if (element.name == "face" && property.role == PlyRole::kUvList && property.type == type)
          return true;
    return false;
  };
  isFloat_ = target_ == "ply" ? !hasList(PlyType::kFloat64)
                              : target_.empty() && hasList(PlyType::kFloat32);
}

UvMap PlyDocument::asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const {
  const UvMap whole = PolygonDocument::asStored(surface, map, partOf);
  return isFloat_ ? roundToFloat32(surfaces()[0].mesh, whole, partOf) : whole;
}

Result<DocumentPtr> PlyDocument::make(Bytes bytes, PlyHeader header, std::size_t textOffset,
                                      PolygonFile file, const std::string& target) {
  std::unique_ptr<PlyDocument> document(new PlyDocument(std::move(header), textOffset, target));
  document->bytes_ = std::move(bytes);
  if (Status taken = document->take(std::move(file)); !taken) return taken.error();
  return DocumentPtr(std::move(document));
}

Result<Written> PlyDocument::write(int surface, const UvMap& map,
                                   const WriteOptions& options) const {
  if (options.format != "ply") return writeObj(surface, map, options);
  const std::vector<int> cornerUv = polygonCornerUv(map);
  if (cornerUv.empty()) {
    return Failure{ErrorCode::kInternal, "write", "the map does not fit this document", {}};
  }
  const std::string_view text = asText(bytes_).substr(textOffset_);
  PlyPatch patch(text, header_, polygons_, map, cornerUv, !isFloat_);
  Written written;
  written.files.push_back({options.name, asBytes(patch.make(options.generator))});
  if (patch.replacesUv()) written.notes.push_back(Note("write-uv-replaced"));
  if (options.cones) written.notes.push_back(Note("write-cones-ply"));
  return written;
}

Result<DocumentPtr> PlyDocument::repaired(int, const FaceEdits& edits) const {
  return withFaces(editFaces(polygons_, corners_, edits));
}

Result<DocumentPtr> PlyDocument::refined(int surface, const std::vector<VertexPair>& edges) const {
  Result<DocumentPtr> own = withFaces(splitEdges(polygons_, corners_, surfaces_[0].mesh, edges));
  return own ? std::move(own) : PolygonDocument::refined(surface, edges);
}

Result<DocumentPtr> PlyDocument::withFaces(const RefinedPolygons& faces) const {
  const std::string_view text = asText(bytes_).substr(textOffset_);
  Result<std::string> edited = editPlyFaces(text, header_, faces);
  if (!edited) return edited.error();
  FileSet files;
  files.main = asBytes(*edited);
  files.target = target_;
  return readPly(std::move(files), {~std::uint64_t{0}, ~std::uint64_t{0}});
}

}  // namespace hgp::io
