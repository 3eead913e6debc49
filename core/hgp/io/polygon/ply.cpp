#include <cstring>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/not_finite.h"
#include "hgp/io/polygon/ply_document.h"
#include "hgp/io/polygon/ply_lines.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Reads the numbers of the body in order, in any of the three encodings.
class PlyBody {
 public:
  PlyBody(std::string_view body, PlyEncoding encoding)
      : text_(body), body_(body), encoding_(encoding) {}

  bool next(PlyType type, double& out) {
    if (encoding_ == PlyEncoding::kText) return nextWord(out);
    const std::size_t size = plySize(type);
    if (body_.size() - offset_ < size) return false;
    unsigned char raw[8] = {};
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t from = encoding_ == PlyEncoding::kLittle ? i : size - 1 - i;
      raw[i] = static_cast<unsigned char>(body_[offset_ + from]);
    }
    offset_ += size;
    out = plyNumber(type, raw);
    return true;
  }
  std::size_t offset() const { return offset_; }
  int line() const { return text_.line(); }
  std::string word() const { return text::inQuotes(text_.word()); }

 private:
  /// Skips comments, which some writers put between the rows.
  bool nextWord(double& out) {
    while (!text_.nextAnyDouble(out)) {
      if (text_.word() != "comment" && text_.word() != "obj_info") return false;
      text_.restOfLine();
    }
    return true;
  }

  text::WordReader text_;
  std::string_view body_;
  PlyEncoding encoding_;
  std::size_t offset_ = 0;
};

class PlyReader {
 public:
  PlyReader(std::string_view text, std::uint64_t maxTriangles, std::string target, Notes notes)
      : text_(text), maxTriangles_(maxTriangles), target_(std::move(target)) {
    file_.notes = std::move(notes);
  }

  /// The document keeps `bytes`, of which the text is a part.
  Result<DocumentPtr> read(Bytes bytes, std::size_t textOffset) {
    Result<PlyHeader> header = readPlyHeader(text_);
    if (!header) return header.error();
    header_ = std::move(*header);
    PlyBody body(text_.substr(header_.bodyOffset), header_.encoding);
    body_ = &body;
    for (const PlyElement& element : header_.elements) {
      if (!takeElement(element)) return std::move(failure_);
    }
    if (file_.polygons.positions.empty() || file_.polygons.polygonCount() == 0) {
      return text::malformedByte(
          header_.bodyOffset,
          formatText("%s and %s: not a surface (a point cloud?)",
                     counted(file_.polygons.positions.size(), "vertex", "vertices").c_str(),
                     counted(file_.polygons.polygonCount(), "face").c_str()));
    }
    if (!finishUv()) return std::move(failure_);
    if (const auto used = firstUsed(notFinite_, file_.polygons))
      return notFiniteFailure(used->where, used->vertex);
    addNotes();
    return PlyDocument::make(std::move(bytes), std::move(header_), textOffset, std::move(file_),
                             target_);
  }

 private:
  bool fail(const std::string& message) {
    if (header_.encoding == PlyEncoding::kText) {
      failure_ = text::malformedLine(header_.lineCount + body_->line(), message);
    } else {
      failure_ = text::malformedByte(header_.bodyOffset + body_->offset(), message);
    }
    return false;
  }

  bool take(PlyType type, double& out) {
    if (body_->next(type, out)) return true;
    return header_.encoding == PlyEncoding::kText
               ? fail("expected a number, not " + body_->word())
               : fail("the file ends inside its data; it may be truncated");
  }

  bool takeElement(const PlyElement& element) {
    // Every row takes at least one byte, so a count above the file's size must be wrong.
    if (element.properties.empty()) return true;
    if (element.count > text_.size()) {
      return fail(formatText("the count of elements %s, %llu, does not fit a file of %zu bytes",
                             text::inQuotes(element.name).c_str(),
                             static_cast<unsigned long long>(element.count), text_.size()));
    }
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (element.name == "vertex" ? !takeVertex(element) : !takeRow(element)) return false;
    }
    return true;
  }

  bool takeVertex(const PlyElement& element) {
    Vec3 p{};
    Vec2 uv{};
    bool hasUv[2] = {false, false};
    for (const PlyProperty& property : element.properties) {
      if (property.isList) {
        if (!takeList(property)) return false;
        continue;
      }
      double x = 0;
      if (!take(property.type, x)) return false;
      const PlyRole role = property.role;
      if (role == PlyRole::kX || role == PlyRole::kY || role == PlyRole::kZ) {
        p[static_cast<std::size_t>(role) - static_cast<std::size_t>(PlyRole::kX)] = x;
      } else if (role == PlyRole::kU || role == PlyRole::kV) {
        const std::size_t k = role == PlyRole::kU ? 0 : 1;
        uv[k] = x;
        hasUv[k] = true;
      }
    }
    if (header_.encoding == PlyEncoding::kText && !isFinite(p)) {
      notFinite_.push_back(
          {static_cast<int>(file_.polygons.positions.size()), header_.lineCount + body_->line()});
    }
    file_.polygons.positions.push_back(p);
    if (hasUv[0] && hasUv[1]) vertexUv_.push_back(uv);
    return true;
  }

  bool takeList(const PlyProperty& property) {
    double length = 0;
    list_.clear();
    if (!take(property.countType, length)) return false;
    const double most = isStrip_                            ? static_cast<double>(text_.size())
                        : property.role == PlyRole::kUvList ? 2.0 * kMaxPolygonCorners
                                                            : 1.0 * kMaxPolygonCorners;
    if (!(length >= 0 && length <= most)) {
      return fail(formatText("a list of %g entries; from 0 to %g are supported", length, most));
    }
    for (int i = 0; i < static_cast<int>(length); ++i) {
      double x = 0;
      if (!take(property.type, x)) return false;
      list_.push_back(x);
    }
    return true;
  }

  bool takeRow(const PlyElement& element) {
    const bool isFace = element.name == "face";
    isStrip_ = element.name == "tristrips";
    std::size_t corners = 0;
    std::vector<double> uv;
    for (const PlyProperty& property : element.properties) {
      double ignored = 0;
      if (!property.isList) {
        if (!take(property.type, ignored)) return false;
        continue;
      }
      if (!takeList(property)) return false;
      if (isFace && property.role == PlyRole::kUvList) uv = list_;
      if (isStrip_ && property.role == PlyRole::kCorners && !takeStrips()) return false;
      if (!isFace || property.role != PlyRole::kCorners) continue;
      if (list_.size() < 3) {
        ++skippedFaces_;
        continue;
      }
      corners = list_.size();
      if (!takeCorners()) return false;
    }
    if (uv.size() == 2 * corners && corners > 0) {
      for (std::size_t c = 0; c < corners; ++c) {
        file_.cornerUv.push_back(static_cast<int>(file_.uv.size()));
        file_.uv.push_back({uv[2 * c], uv[2 * c + 1]});
      }
    }
    return true;
  }

  bool takeCorners() {
    for (double v : list_) {
      if (!(v >= 0 && v <= 2147483647.0 &&
            v == static_cast<double>(static_cast<std::int64_t>(v)))) {
        return fail(
            formatText("a face has vertex index %g, which must be a non-negative integer", v));
      }
      file_.polygons.cornerVertex.push_back(static_cast<int>(v));
      largest_ = std::max(largest_, static_cast<int>(v));
    }
    file_.polygons.start.push_back(static_cast<std::uint32_t>(file_.polygons.cornerVertex.size()));
    triangles_ += list_.size() - 2;
    if (triangles_ <= maxTriangles_) return true;
    failure_ = tooManyTriangles(maxTriangles_);
    return false;
  }

  /// Reads triangle strips: one list in which a negative number ends each strip. Every second triangle of a strip
  /// is reversed; triangles with a repeated vertex only connect strips and are skipped.
  bool takeStrips() {
    const std::vector<double> strip = std::move(list_);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      if (strip[i] < 0) begin = i + 1;
      if (i < begin + 2) continue;
      const double a = strip[i - 2], b = strip[i - 1], c = strip[i];
      if (a == b || b == c || c == a) continue;
      const bool isTurned = (i - begin) % 2 == 1;
      list_ = {isTurned ? b : a, isTurned ? a : b, c};
      if (!takeCorners()) return false;
    }
    ++strips_;
    return true;
  }

  void addNotes() {
    if (strips_ > 0) file_.notes.push_back(Note("read-strips"));
    if (skippedFaces_ > 0) {
      file_.notes.push_back(Note("read-small-faces-skipped", {{"faces", skippedFaces_}}));
    }
  }

  bool finishUv() {
    const std::size_t vertices = file_.polygons.positions.size();
    if (static_cast<std::size_t>(largest_) >= vertices) {
      return fail(formatText("vertex %d is out of range (there are %zu, counted from 0)", largest_,
                             vertices));
    }
    if (file_.cornerUv.size() == file_.polygons.cornerVertex.size()) return true;
    file_.uv.clear();
    file_.cornerUv.clear();
    if (vertexUv_.size() == vertices) {
      file_.uv = std::move(vertexUv_);
      file_.cornerUv = file_.polygons.cornerVertex;
    }
    return true;
  }

  std::string_view text_;
  std::uint64_t maxTriangles_;
  std::string target_;  ///< FileSet::target
  PlyHeader header_;
  PlyBody* body_ = nullptr;
  PolygonFile file_;
  Failure failure_;
  std::vector<double> list_;
  std::vector<Vec2> vertexUv_;
  std::vector<NotFiniteVertex> notFinite_;  ///< in text only; in binary they are mesh defects
  int largest_ = -1, strips_ = 0, skippedFaces_ = 0;
  bool isStrip_ = false;
  std::uint64_t triangles_ = 0;
};

}  // namespace

Result<DocumentPtr> readPly(FileSet files, const Limits& limits) {
  std::string_view text = withoutByteOrderMark(asText(files.main));
  Notes notes;
  if (const Result<PlyHeader> header = readPlyHeader(text); header) {
    if (header->unknownLines > 0)
      notes.push_back(Note("read-unknown-lines", {{"lines", header->unknownLines}}));
    if (std::optional<PlyTrimmed> trimmed = trimmedPly(text, *header)) {
      notes.push_back(Note("read-extra-values", {{"lines", trimmed->lines}}));
      files.main = asBytes(trimmed->text);
      text = asText(files.main);
    }
  }
  const std::size_t offset = files.main.size() - text.size();
  PlyReader reader(text, limits.maxTriangles, std::move(files.target), std::move(notes));
  return reader.read(std::move(files.main), offset);
}

}  // namespace hgp::io
