#include "hgp/io/polygon/obj_refine.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/stable_order.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// The numbers on v, vt and vn lines, where those lines end, and whether indices are relative.
class DataLines {
 public:
  explicit DataLines(std::string_view text) : text_(text) {
    const char eol = text::lineEndOf(text);
    std::size_t at = text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
    while (at < text.size()) {
      const std::size_t begin = at;
      std::string joined;
      for (bool isOpen = true; isOpen && at < text.size();) {
        const std::size_t found = text.find(eol, at);
        const std::size_t stop = found == std::string_view::npos ? text.size() : found;
        std::string_view line = text.substr(at, stop - at);
        at = stop < text.size() ? stop + 1 : stop;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        isOpen = !line.empty() && line.back() == '\\' && line.find('#') == std::string_view::npos;
        if (isOpen) line.remove_suffix(1);
        joined += line;
        joined += ' ';
      }
      take(joined, begin, at);
    }
  }

  std::vector<std::vector<double>> vertices, uvs, normals;
  std::vector<std::size_t> normalEnds;  ///< where each vn line ends, ascending
  std::size_t end = 0;                  ///< of the last v, vt or vn line
  bool isRelative = false;              ///< some f, l or p line has a negative index

 private:
  void take(const std::string& line, std::size_t, std::size_t lineEnd) {
    const char* p = line.data();
    const char* stop = p + line.size();
    text::skipBlanks(p, stop);
    const char* word = p;
    while (p != stop && !text::isBlank(*p)) ++p;
    const std::string_view name(word, static_cast<std::size_t>(p - word));
    if (name == "f" || name == "fo" || name == "l" || name == "p") {
      isRelative = isRelative || std::find(p, stop, '-') != stop;
      return;
    }
    auto* list = name == "v" ? &vertices : name == "vt" ? &uvs : name == "vn" ? &normals : nullptr;
    if (list == nullptr) return;
    std::vector<double> numbers;
    double x = 0.0;
    for (text::skipBlanks(p, stop); text::readDouble(p, stop, x); text::skipBlanks(p, stop))
      numbers.push_back(x);
    list->push_back(std::move(numbers));
    if (list == &normals) normalEnds.push_back(lineEnd);
    end = lineEnd;
  }

  std::string_view text_;
};

std::vector<double> meanOf(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> mean(std::min(a.size(), b.size()));
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * a[i] + 0.5 * b[i];
  return mean;
}

void normalise(std::vector<double>& v) {
  double sum = 0.0;
  for (double x : v) sum += x * x;
  if (sum > 0.0)
    for (double& x : v) x /= std::sqrt(sum);
}

void appendLine(std::string& out, const char* word, const std::vector<double>& numbers,
                std::string_view lineEnd) {
  out += word;
  for (double x : numbers) {
    out += ' ';
    text::appendDouble(out, x);
  }
  out += lineEnd;
}

class ObjRefinement {
 public:
  ObjRefinement(std::string_view text, const ObjText& places, const std::vector<int>& cornerUv,
                const PolygonMesh& before, RefinedPolygons refined)
      : text_(text),
        places_(places),
        cornerUv_(cornerUv),
        before_(before),
        refined_(std::move(refined)),
        data_(text),
        uv_(static_cast<int>(data_.uvs.size())),
        normal_(static_cast<int>(data_.normals.size())) {
    const std::size_t first = text.find('\n');
    if (first != std::string_view::npos && first > 0 && text[first - 1] == '\r') {
      lineEnd_ = "\r\n";
    } else if (text::lineEndOf(text) == '\r') {
      lineEnd_ = "\r";
    }
  }

  std::string make() {
    const std::vector<std::string> faces = dividedFaces();
    std::vector<TextSpan> dropped = places_.coneLines;
    if (places_.embedded.end > 0) dropped.push_back(places_.embedded);
    sortStably(dropped, [](const TextSpan& a, const TextSpan& b) { return a.begin < b.begin; });
    const std::size_t insertion = data_.isRelative ? text_.size() : data_.end;
    bool isInserted = false;
    std::size_t line = 0, drop = 0, position = 0;
    const auto copyUntil = [&](std::size_t end) {
      if (!isInserted && end >= insertion) {
        out_.append(text_.substr(position, insertion - position));
        position = insertion;
        isInserted = true;
        insert();
      }
      out_.append(text_.substr(position, end - position));
      position = end;
    };
    while (line < faces.size() || drop < dropped.size()) {
      const bool isFace =
          drop == dropped.size() ||
          (line < faces.size() && places_.faceLines[line].begin < dropped[drop].begin);
      const TextSpan span = isFace ? places_.faceLines[line] : dropped[drop];
      const bool isKept = isFace && faces[line].empty();
      copyUntil(isKept ? span.end : span.begin);
      if (isFace && !isKept) out_ += faces[line];
      position = span.end;
      isFace ? ++line : ++drop;
    }
    copyUntil(text_.size());
    return std::move(out_);
  }

 private:
  /// Indices of vn lines, 0-based, by corner of the polygon before refinement; −1: none.
  std::vector<int> normalsOf(std::size_t polygon) const {
    std::vector<int> out;
    const TextSpan& span = places_.faceLines[polygon];
    std::string line(text_.substr(span.begin, span.end - span.begin));
    std::replace(line.begin(), line.end(), '\\', ' ');
    std::replace(line.begin(), line.end(), '\n', ' ');
    const char* p = line.data();
    const char* end = p + line.size();
    text::skipBlanks(p, end);
    while (p != end && !text::isBlank(*p)) ++p;
    const auto known = static_cast<std::int64_t>(
        std::upper_bound(data_.normalEnds.begin(), data_.normalEnds.end(), span.begin) -
        data_.normalEnds.begin());
    ObjCorner corner;
    for (text::skipBlanks(p, end); p != end && takeObjCorner(p, end, corner);
         text::skipBlanks(p, end)) {
      const char* n = corner.normal.data();
      std::int64_t index = 0;
      if (corner.normal.empty() || !text::readInt(n, n + corner.normal.size(), index)) index = 0;
      index += index < 0 ? known : -1;
      const bool isThere = index >= 0 && index < static_cast<std::int64_t>(data_.normals.size());
      out.push_back(isThere ? static_cast<int>(index) : -1);
    }
    return out;
  }

  /// The lines that replace each f line; "" where it stays.
  std::vector<std::string> dividedFaces() {
    std::vector<std::string> faces(places_.faceLines.size());
    std::vector<int> normals;
    int last = -1;
    for (std::size_t p = 0; p < refined_.polygonOrigin.size(); ++p) {
      if (refined_.isSame[p]) continue;
      const int origin = refined_.polygonOrigin[p];
      if (origin != last) normals = normalsOf(static_cast<std::size_t>(origin));
      last = origin;
      std::string& out = faces[static_cast<std::size_t>(origin)];
      out += 'f';
      for (auto c = refined_.polygons.start[p]; c < refined_.polygons.start[p + 1]; ++c)
        appendCorner(out, c, static_cast<int>(before_.start[static_cast<std::size_t>(origin)]),
                     normals);
      out += lineEnd_;
    }
    return faces;
  }

  void appendCorner(std::string& out, std::size_t c, int first, const std::vector<int>& normals) {
    const VertexPair& pair = refined_.corners[c];
    const auto normalAt = [&](int corner) {
      const auto i = static_cast<std::size_t>(corner - first);
      return i < normals.size() ? normals[i] : -1;
    };
    const auto uvAt = [&](int corner) {
      return cornerUv_.empty() ? -1 : cornerUv_[static_cast<std::size_t>(corner)];
    };
    const int uv = uv_.of(uvAt(pair[0]), uvAt(pair[1]));
    const int normal = normal_.of(normalAt(pair[0]), normalAt(pair[1]));
    out += ' ';
    text::appendInt(out, refined_.polygons.cornerVertex[c] + 1);
    if (uv >= 0 || normal >= 0) out += '/';
    if (uv >= 0) text::appendInt(out, uv + 1);
    if (normal < 0) return;
    out += '/';
    text::appendInt(out, normal + 1);
  }

  void insert() {
    if (!out_.empty() && out_.back() != '\n' && out_.back() != '\r') out_ += lineEnd_;
    const auto mean = [](const std::vector<std::vector<double>>& lines, const VertexPair& pair) {
      return meanOf(lines[static_cast<std::size_t>(pair[0])],
                    lines[static_cast<std::size_t>(pair[1])]);
    };
    for (const VertexPair& pair : refined_.parents)
      appendLine(out_, "v", mean(data_.vertices, pair), lineEnd_);
    for (const VertexPair& pair : uv_.pairs())
      appendLine(out_, "vt", mean(data_.uvs, pair), lineEnd_);
    for (const VertexPair& pair : normal_.pairs()) {
      std::vector<double> normal = mean(data_.normals, pair);
      normalise(normal);
      appendLine(out_, "vn", normal, lineEnd_);
    }
  }

  std::string_view text_;
  const ObjText& places_;
  const std::vector<int>& cornerUv_;
  const PolygonMesh& before_;
  RefinedPolygons refined_;
  DataLines data_;
  MeanValues uv_, normal_;
  std::string out_;
  std::string_view lineEnd_ = "\n";
};

}  // namespace

std::string rewriteObjFaces(std::string_view text, const ObjText& places,
                            const PolygonMesh& polygons, const std::vector<int>& cornerUv,
                            RefinedPolygons refined) {
  return ObjRefinement(text, places, cornerUv, polygons, std::move(refined)).make();
}

}  // namespace hgp::io
