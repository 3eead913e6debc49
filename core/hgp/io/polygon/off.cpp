#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/not_finite.h"
#include "hgp/io/polygon/polygon_document.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Reads "[ST][C][N]OFF", the counts, the vertices and the faces; whitespace between numbers is free. The keyword
/// and the number of edges may be missing, and what follows a vertex may vary, as in the files of many programs.
class OffReader {
 public:
  OffReader(std::string_view text, std::uint64_t maxTriangles)
      : words_(text), size_(text.size()), maxTriangles_(maxTriangles) {}

  Result<DocumentPtr> read() {
    if (!takeHeader() || !takeCounts() || !takeVertices() || !takeFaces()) {
      return std::move(failure_);
    }
    if (const auto used = firstUsed(notFinite_, file_.polygons))
      return notFiniteFailure(used->where, used->vertex);
    if (skippedFaces_ > 0) {
      file_.notes.push_back(Note("read-small-faces-skipped", {{"faces", skippedFaces_}}));
    }
    return PolygonDocument::make("off", std::move(file_));
  }

 private:
  bool fail(const std::string& message) {
    failure_ = text::malformedLine(words_.line(), message);
    return false;
  }
  bool failNumber() { return fail("expected a number, not " + text::inQuotes(words_.word())); }

  bool takeHeader() {
    text::WordReader start = words_;
    std::string keyword(words_.next());
    const auto takePrefix = [&](const char* prefix) {
      const std::string p(prefix);
      if (keyword.compare(0, p.size(), p) != 0) return false;
      keyword.erase(0, p.size());
      return true;
    };
    hasUv_ = takePrefix("ST");
    hasColor_ = takePrefix("C");
    hasNormal_ = takePrefix("N");
    isHomogeneous_ = keyword == "4OFF" && takePrefix("4");
    if (keyword == "OFF") return true;
    std::int64_t count = 0;
    text::WordReader counts = start;
    if (hasUv_ || hasColor_ || hasNormal_ || isHomogeneous_ || !counts.nextInt(count)) {
      return fail("not an OFF file (the first word must be OFF)");
    }
    words_ = start;
    file_.notes.push_back(Note("read-keyword-missing"));
    return true;
  }

  bool takeCounts() {
    if (!words_.nextInt(vertices_)) {
      return words_.word() == "BINARY" ? fail("binary OFF files are not supported; save it as text")
                                       : failNumber();
    }
    if (!words_.nextInt(faces_)) return failNumber();
    takeEdgeCount();
    // Every row takes at least two bytes, so a count above the file's size must be wrong.
    const std::int64_t most = static_cast<std::int64_t>(size_);
    if (vertices_ < 0 || faces_ < 0 || vertices_ > most || faces_ > most) {
      return fail(
          formatText("the counts, %lld vertices and %lld faces, do not fit a file of %zu bytes",
                     static_cast<long long>(vertices_), static_cast<long long>(faces_), size_));
    }
    return true;
  }

  /// Skips the number of edges, which follows the other two counts, is on a separate line, or is missing.
  void takeEdgeCount() {
    std::int64_t ignored = 0;
    text::WordReader rest(words_.restOfLine());
    if (!rest.isAtEnd()) return;
    text::WordReader ahead = words_;
    if (!ahead.nextInt(ignored)) return;
    text::WordReader behind(ahead.restOfLine());
    if (behind.isAtEnd()) words_ = ahead;
  }

  bool takeVertices() {
    for (std::int64_t i = 0; i < vertices_; ++i) {
      Vec3 p{};
      for (double& x : p) {
        if (!words_.nextAnyDouble(x)) return failNumber();
      }
      double w = 1;
      if (isHomogeneous_ && !words_.nextAnyDouble(w)) return failNumber();
      if (w == 0) return fail("a vertex at infinity (the fourth coordinate is 0)");
      if (isHomogeneous_) p = {p[0] / w, p[1] / w, p[2] / w};
      if (!isFinite(p)) notFinite_.push_back({static_cast<int>(i), words_.line()});
      file_.polygons.positions.push_back(p);
      if (!takeExtras()) return false;
    }
    return true;
  }

  /// Skips what follows a position: normal, colour (three or four numbers), texture coordinates. It extends to the
  /// end of the line, or, if the line is too short, over as many numbers as the keyword implies.
  bool takeExtras() {
    text::WordReader line(words_.restOfLine());
    if (!hasUv_) {
      const bool isCut = (hasColor_ || hasNormal_) && line.isAtEnd();
      double ignored = 0;
      for (int k = 0; isCut && k < (hasColor_ ? 4 : 0) + (hasNormal_ ? 3 : 0); ++k) {
        if (!words_.nextDouble(ignored)) return failNumber();
      }
      return true;
    }
    std::vector<double> numbers;
    double x = 0;
    while (line.nextDouble(x)) numbers.push_back(x);
    const std::size_t announced = (hasColor_ ? 4 : 0) + (hasNormal_ ? 3 : 0) + 2;
    const bool isWhole = numbers.size() >= announced - (hasColor_ ? 1 : 0);
    while (!isWhole && numbers.size() < announced) {
      if (!words_.nextDouble(x)) return failNumber();
      numbers.push_back(x);
    }
    file_.uv.push_back({numbers[numbers.size() - 2], numbers.back()});
    return true;
  }

  bool takeFaces() {
    std::uint64_t triangles = 0;
    for (std::int64_t f = 0; f < faces_; ++f) {
      std::int64_t corners = 0;
      if (!words_.nextInt(corners)) return failNumber();
      if (corners < 0 || corners > kMaxPolygonCorners) {
        return fail(
            formatText("a face of %lld corners; at most %d are supported: triangulate it "
                       "first",
                       static_cast<long long>(corners), kMaxPolygonCorners));
      }
      if (corners < 3) {
        words_.restOfLine();
        ++skippedFaces_;
        continue;
      }
      for (std::int64_t c = 0; c < corners; ++c) {
        std::int64_t v = 0;
        if (!words_.nextInt(v)) return failNumber();
        if (v < 0 || v >= vertices_) {
          return fail(formatText("vertex %lld is out of range (there are %lld, counted from 0)",
                                 static_cast<long long>(v), static_cast<long long>(vertices_)));
        }
        file_.polygons.cornerVertex.push_back(static_cast<int>(v));
        if (hasUv_) file_.cornerUv.push_back(static_cast<int>(v));
      }
      words_.restOfLine();
      file_.polygons.start.push_back(
          static_cast<std::uint32_t>(file_.polygons.cornerVertex.size()));
      triangles += static_cast<std::uint64_t>(corners) - 2;
      if (triangles > maxTriangles_) {
        failure_ = tooManyTriangles(maxTriangles_);
        return false;
      }
    }
    if (file_.polygons.polygonCount() == 0) return fail("there are no faces: not a surface");
    return true;
  }

  text::WordReader words_;
  std::size_t size_;
  std::uint64_t maxTriangles_;
  PolygonFile file_;
  Failure failure_;
  std::vector<NotFiniteVertex> notFinite_;
  std::int64_t vertices_ = 0, faces_ = 0;
  std::int64_t skippedFaces_ = 0;
  bool hasUv_ = false, hasColor_ = false, hasNormal_ = false, isHomogeneous_ = false;
};

}  // namespace

Result<DocumentPtr> readOff(FileSet files, const Limits& limits) {
  return OffReader(withoutByteOrderMark(asText(files.main)), limits.maxTriangles).read();
}

}  // namespace hgp::io
