#include "hgp/base/check.h"
#include "hgp/io/polygon/polygon_document.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// "[ST][C][N]OFF", the counts, the vertices, the faces; numbers are free-form.
class OffReader {
 public:
  OffReader(std::string_view text, std::uint64_t maxTriangles)
      : words_(text), size_(text.size()), maxTriangles_(maxTriangles) {}

  Result<DocumentPtr> read() {
    if (takeHeader() && takeVertices() && takeFaces()) {
      return PolygonDocument::make("off", std::move(file_));
    }
    return std::move(failure_);
  }

 private:
  bool fail(const std::string& message) {
    failure_ = malformedLine(words_.line(), message);
    return false;
  }
  bool failNumber() { return fail("expected a number, not " + inQuotes(words_.word())); }

  bool takeHeader() {
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
    if (keyword != "OFF") return fail("not an OFF file (the first word must be OFF)");
    std::int64_t edges = 0;
    if (!words_.nextInt(vertices_)) {
      return words_.word() == "BINARY" ? fail("binary OFF files are not read") : failNumber();
    }
    if (!words_.nextInt(faces_) || !words_.nextInt(edges)) return failNumber();
    // Every row takes at least a few bytes, so a count above the file's size is a lie.
    const std::int64_t most = static_cast<std::int64_t>(size_);
    if (vertices_ < 0 || faces_ < 0 || vertices_ > most || faces_ > most) {
      return fail("the counts do not fit the size of the file");
    }
    return true;
  }

  bool takeVertices() {
    for (std::int64_t i = 0; i < vertices_; ++i) {
      Vec3 p{};
      for (double& x : p) {
        if (!words_.nextDouble(x)) return failNumber();
      }
      file_.polygons.positions.push_back(p);
      double ignored = 0;
      for (int k = 0; k < (hasColor_ ? 4 : 0) + (hasNormal_ ? 3 : 0); ++k) {
        if (!words_.nextDouble(ignored)) return failNumber();
      }
      Vec2 uv{};
      if (hasUv_ && (!words_.nextDouble(uv[0]) || !words_.nextDouble(uv[1]))) return failNumber();
      if (hasUv_)
        file_.uv.push_back(uv);
      else
        words_.restOfLine();  // colours and the like
    }
    return true;
  }

  bool takeFaces() {
    std::uint64_t triangles = 0;
    for (std::int64_t f = 0; f < faces_; ++f) {
      std::int64_t corners = 0;
      if (!words_.nextInt(corners)) return failNumber();
      if (corners < 3 || corners > kMaxPolygonCorners) {
        return fail(formatText("a face of %lld corners", static_cast<long long>(corners)));
      }
      for (std::int64_t c = 0; c < corners; ++c) {
        std::int64_t v = 0;
        if (!words_.nextInt(v)) return failNumber();
        if (v < 0 || v >= vertices_) {
          return fail(formatText("vertex %lld is out of range (there are %lld)",
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
        failure_ = {ErrorCode::kLimit,
                    "read",
                    formatText("more than %llu triangles (the limit)",
                               static_cast<unsigned long long>(maxTriangles_)),
                    {}};
        return false;
      }
    }
    if (faces_ == 0) return fail("there are no faces");
    return true;
  }

  WordReader words_;
  std::size_t size_;
  std::uint64_t maxTriangles_;
  PolygonFile file_;
  Failure failure_;
  std::int64_t vertices_ = 0, faces_ = 0;
  bool hasUv_ = false, hasColor_ = false, hasNormal_ = false;
};

}  // namespace

Result<DocumentPtr> readOff(FileSet files, const Limits& limits) {
  return OffReader(asText(files.main), limits.maxTriangles).read();
}

}  // namespace hgp::io
