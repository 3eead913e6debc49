#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/cone_files.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/obj_attributes.h"
#include "hgp/io/polygon/obj_refine.h"
#include "hgp/io/polygon/obj_scan.h"
#include "hgp/io/polygon/polygon_document.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Writes the original text with new vt lines and f lines that refer to them; nothing else changes.
class ObjPatch {
 public:
  ObjPatch(std::string_view text, const ObjText& places, const UvMap& map,
           const std::vector<int>& cornerUv, const WriteOptions& options)
      : text_(text), places_(places), map_(map), cornerUv_(cornerUv), options_(options) {}

  std::string make() {
    out_.reserve(text_.size() + map_.uv.size() * 42 + cornerUv_.size() * 8);
    const std::size_t firstLine = text_.find('\n');
    if (firstLine != std::string_view::npos && firstLine > 0 && text_[firstLine - 1] == '\r') {
      lineEnd_ = "\r\n";
    } else if (text::lineEndOf(text_) == '\r') {
      lineEnd_ = "\r";
    }
    std::size_t face = 0, uvRun = 0, element = 0;
    bool isEmbeddedOpen = places_.embedded.end > 0;
    for (;;) {
      const std::size_t f = beginOf(places_.faceLines, face);
      const std::size_t u = beginOf(places_.uvLines, uvRun);
      const std::size_t e = beginOf(places_.elementLines, element);
      const std::size_t c = isEmbeddedOpen ? places_.embedded.begin : text_.size();
      const std::size_t next = std::min({f, u, e, c});
      copyUntil(next);
      if (next == text_.size()) break;
      if (next == f || next == u) insertUv();
      if (next == f) {
        patchFace(places_.faceLines[face++]);
      } else if (next == u) {
        position_ = places_.uvLines[uvRun++].end;
      } else if (next == e) {
        patchElement(places_.elementLines[element++]);
      } else {
        isEmbeddedOpen = false;
        if (options_.cones)
          position_ = places_.embedded.end;
        else
          copyUntil(places_.embedded.end);
      }
    }
    return std::move(out_);
  }

 private:
  std::size_t beginOf(const std::vector<TextSpan>& spans, std::size_t i) const {
    return i < spans.size() ? spans[i].begin : text_.size();
  }
  void copyUntil(std::size_t end) {
    out_.append(text_.substr(position_, end - position_));
    position_ = end;
  }
  void insertUv() {
    if (isInserted_) return;
    isInserted_ = true;
    appendEmbeddedCones(out_, options_, lineEnd_);
    appendUvLines(out_, map_.uv, lineEnd_);
  }

  static bool isSeparator(char c) { return text::isBlank(c) || c == '\n' || c == '\\'; }

  /// Copies a line and passes every word after the keyword to `rewrite`.
  template <class Rewrite>
  void patchWords(const TextSpan& line, Rewrite rewrite) {
    const char* p = text_.data() + line.begin;
    const char* end = text_.data() + line.end;
    const auto copyWhile = [&](auto accept) {
      const char* begin = p;
      while (p != end && accept(*p)) ++p;
      out_.append(begin, p);
    };
    copyWhile(isSeparator);
    copyWhile([](char c) { return !isSeparator(c); });
    while (p != end) {
      copyWhile(isSeparator);
      ObjCorner corner;
      if (p == end || *p == '#' || !takeObjCorner(p, end, corner)) break;
      rewrite(corner);
    }
    out_.append(p, end);
    position_ = line.end;
  }

  void patchFace(const TextSpan& line) {
    patchWords(line, [&](const ObjCorner& corner) {
      out_ += corner.vertex;
      out_ += '/';
      text::appendInt(out_, cornerUv_[corner_++] + 1);
      if (corner.normal.empty()) return;
      out_ += '/';
      out_ += corner.normal;
    });
  }
  /// Removes a polyline's references to the vt lines that are replaced.
  void patchElement(const TextSpan& line) {
    patchWords(line, [&](const ObjCorner& corner) { out_ += corner.vertex; });
  }

  std::string_view text_;
  const ObjText& places_;
  const UvMap& map_;
  const std::vector<int>& cornerUv_;
  const WriteOptions& options_;
  std::string out_;
  std::string_view lineEnd_ = "\n";
  std::size_t position_ = 0;
  std::size_t corner_ = 0;
  bool isInserted_ = false;
};

class ObjDocument final : public PolygonDocument {
 public:
  ObjDocument() : PolygonDocument("obj") {}

  Status read(Bytes text, std::uint64_t maxTriangles) {
    text_ = std::move(text);
    Result<ObjText> scanned = scanObj(asText(text_), maxTriangles);
    if (!scanned) return scanned.error();
    places_ = std::move(*scanned);
    PolygonFile file{std::move(places_.polygons), std::move(places_.uv),
                     std::move(places_.cornerUv), std::move(places_.notes), -1};
    return take(std::move(file));
  }

  Result<std::optional<prescription::Prescription>> embeddedCones(int) const override {
    const std::string_view text = asText(text_);
    if (places_.embedded.end > 0) {
      const std::size_t begin = places_.embedded.begin;
      std::string_view line = text.substr(begin, places_.embedded.end - begin);
      line.remove_prefix(line.find(kEmbeddedConesMark) + kEmbeddedConesMark.size());
      Result<prescription::Prescription> cones = prescription::readConesJson(line);
      if (!cones) return cones.error();
      return std::optional<prescription::Prescription>(std::move(*cones));
    }
    if (places_.coneLines.empty()) return std::optional<prescription::Prescription>();
    Result<prescription::Prescription> cones =
        readHgpConeLines(text, places_.coneLines, polygons_, corners_);
    if (!cones) return cones.error();
    return std::optional<prescription::Prescription>(std::move(*cones));
  }

  Result<PlainFile> plain(int surface) const override {
    Result<PlainFile> file = PolygonDocument::plain(surface);
    if (!file) return file;
    PlainSurface& out = file->surfaces[0];
    const std::size_t cornerCount = polygons_.cornerVertex.size();
    ObjAttributes extras = readObjAttributes(asText(text_), places_, cornerCount);
    const std::size_t triangles = out.mesh.triangles.size();
    if (!extras.cornerNormal.empty()) {
      out.normals = std::move(extras.normals);
      out.cornerNormal.resize(triangles);
      for (std::size_t t = 0; t < triangles; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto c = corners_.empty() ? 3 * t + k : static_cast<std::size_t>(corners_[t][k]);
          out.cornerNormal[t][k] = extras.cornerNormal[c];
        }
      }
    }
    out.colors.reserve(extras.colors.size());
    for (const auto& c : extras.colors)
      out.colors.push_back({linearFromSrgb(c[0]), linearFromSrgb(c[1]), linearFromSrgb(c[2]), 1});
    out.triangleSmoothing = byTriangle(extras.polygonSmoothing);
    out.lines = std::move(extras.lines);
    if (!extras.polygonMaterial.empty()) {
      out.materials = std::move(extras.materials);
      out.libraries = std::move(extras.libraries);
      out.triangleMaterial = byTriangle(extras.polygonMaterial);
      file->lost.push_back(Note("convert-materials-lost"));
    }
    if (extras.uncolored > 0)
      file->lost.push_back(Note("convert-uncoloured", {{"vertices", extras.uncolored}}));
    if (extras.linesAndPoints > 0)
      file->lost.push_back(Note("convert-lines-lost", {{"lines", extras.linesAndPoints}}));
    if (extras.hasGroups) file->lost.push_back(Note("convert-groups-joined"));
    return file;
  }

  Result<Written> write(int, const UvMap& map, const WriteOptions& options) const override {
    const std::vector<int> cornerUv = polygonCornerUv(map);
    if (cornerUv.empty()) {
      return Failure{ErrorCode::kInternal, "write", "the map does not fit this document", {}};
    }
    Written written;
    const std::string text = ObjPatch(asText(text_), places_, map, cornerUv, options).make();
    written.files.push_back({options.name, asBytes(text)});
    if (!places_.uvLines.empty()) written.notes.push_back(Note("write-vt-replaced"));
    if (!places_.elementLines.empty()) {
      written.notes.push_back(Note("write-lines-without-vt"));
    }
    return written;
  }

  Result<DocumentPtr> refined(int, const std::vector<VertexPair>& edges) const override {
    return withFaces(splitEdges(polygons_, corners_, surfaces_[0].mesh, edges));
  }
  Result<DocumentPtr> repaired(int, const FaceEdits& edits) const override {
    return withFaces(editFaces(polygons_, corners_, edits));
  }

 private:
  /// Values of polygons, per triangle; none for none.
  std::vector<int> byTriangle(const std::vector<int>& values) const {
    std::vector<int> out;
    if (values.empty()) return out;
    out.reserve(surfaces_[0].mesh.triangles.size());
    for (int p = 0; p < polygons_.polygonCount(); ++p)
      for (int t = polygons_.firstTriangle(p); t < polygons_.firstTriangle(p + 1); ++t)
        out.push_back(values[static_cast<std::size_t>(p)]);
    return out;
  }

  Result<DocumentPtr> withFaces(RefinedPolygons refined) const {
    const std::string text =
        rewriteObjFaces(asText(text_), places_, polygons_, cornerUv_, std::move(refined));
    auto document = std::make_unique<ObjDocument>();
    if (Status done = document->read(asBytes(text), ~std::uint64_t{0}); !done) return done.error();
    return DocumentPtr(std::move(document));
  }

  Bytes text_;
  ObjText places_;  ///< without its mesh, which was moved into the base class
};

}  // namespace

Result<DocumentPtr> readObj(FileSet files, const Limits& limits) {
  if (files.main.size() > limits.maxBytes) {
    return tooManyBytes(files.main.size(), limits.maxBytes);
  }
  auto document = std::make_unique<ObjDocument>();
  if (Status done = document->read(std::move(files.main), limits.maxTriangles); !done) {
    return done.error();
  }
  return DocumentPtr(std::move(document));
}

}  // namespace hgp::io
