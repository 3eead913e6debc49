#include "hgp/io/cone_files.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/stable_order.h"
#include "hgp/io/polygon/obj_scan.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

bool endsWith(std::string_view name, std::string_view end) {
  return name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
}

/// Converts "c V A" and "sm F V R" lines to cones and matchings.
class HgpLines {
 public:
  explicit HgpLines(const PolygonMesh& polygons) : polygons_(polygons) { out_.q = 4; }

  bool take(std::string_view line) {
    const char* p = line.data();
    const char* end = p + line.size();
    text::skipBlanks(p, end);
    const bool isCone = *p == 'c';
    p += isCone ? 1 : 2;
    std::int64_t first = 0;
    text::skipBlanks(p, end);
    if (!text::readInt(p, end, first)) return fail("the first number is not an index");
    text::skipBlanks(p, end);
    return isCone ? takeCone(p, end, first) : takeSeam(p, end, first);
  }

  const std::string& message() const { return message_; }
  Result<prescription::Prescription> finish() {
    if (out_.field) {
      std::vector<Matching>& list = out_.field->matchings;
      // The file lists every edge once per side, with opposite rotations.
      sortStably(list, [](const Matching& a, const Matching& b) {
        return std::pair(std::min(a.tail, a.head), std::max(a.tail, a.head)) <
               std::pair(std::min(b.tail, b.head), std::max(b.tail, b.head));
      });
      for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        const Matching &a = list[i], &b = list[i + 1];
        if (a.tail == b.head && a.head == b.tail && (a.turn + b.turn) % 4 != 0) {
          return Failure{ErrorCode::kMalformed,
                         "cones",
                         formatText("the two sm lines of edge %d–%d contradict each other",
                                    a.tail + 1, a.head + 1),
                         {{Where::Kind::kEdge, a.tail, a.head}}};
        }
      }
      list.erase(std::unique(list.begin(), list.end(),
                             [](const Matching& a, const Matching& b) {
                               return a.tail == b.head && a.head == b.tail;
                             }),
                 list.end());
    }
    return std::move(out_);
  }

 private:
  bool fail(const std::string& message) {
    message_ = message;
    return false;
  }

  bool takeCone(const char* p, const char* end, std::int64_t vertex) {
    double angle = 0;
    if (!text::readDouble(p, end, angle)) return fail("a cone's angle is not a number");
    const double k = 2 * angle;
    if (std::abs(k - std::round(k)) > prescription::kAngleIndexTolerance || std::abs(k) > 1e6) {
      return fail(formatText("the cone angle %.9g π is no multiple of π/2", angle));
    }
    if (vertex < 1 || vertex > static_cast<std::int64_t>(polygons_.positions.size())) {
      return fail("the vertex is out of range");
    }
    out_.hasCones = true;
    out_.cones.push_back({static_cast<int>(vertex - 1), static_cast<int>(std::lround(k)), {}});
    return true;
  }

  /// The halfedge of polygon F whose target is V; the next column is its rotation in quarter turns.
  bool takeSeam(const char* p, const char* end, std::int64_t face) {
    std::int64_t vertex = 0, turn = 0;
    if (!text::readInt(p, end, vertex)) return fail("the vertex is not an index");
    text::skipBlanks(p, end);
    if (!text::readInt(p, end, turn) || std::abs(turn) > 1'000'000) {
      return fail("the rotation is not an integer");
    }
    if (face < 1 || face > polygons_.polygonCount()) return fail("the face is out of range");
    const std::size_t first = polygons_.start[static_cast<std::size_t>(face - 1)];
    const std::size_t last = polygons_.start[static_cast<std::size_t>(face)];
    for (std::size_t c = first; c < last; ++c) {
      if (polygons_.cornerVertex[c] != vertex - 1) continue;
      Matching m;
      m.tail = polygons_.cornerVertex[c == first ? last - 1 : c - 1];
      m.head = static_cast<int>(vertex - 1);
      m.turn = static_cast<int>(turn);
      if (!out_.field) out_.field.emplace();
      out_.field->hasMatchings = true;
      out_.field->matchings.push_back(m);
      return true;
    }
    return fail("the vertex is not a corner of that face");
  }

  const PolygonMesh& polygons_;
  prescription::Prescription out_;
  std::string message_;
};

/// A list with one number per row gives angles; "N n" followed by n pairs gives singularities; any other list
/// gives curvatures.
Result<prescription::Prescription> readUnnamedList(std::string_view text, int q) {
  text::WordReader words(text);
  double first = 0, second = 0;
  if (!words.nextDouble(first)) {
    return Failure{
        ErrorCode::kMalformed,
        "cones",
        "not a file of cones or of a field that is known here: hgp-cones JSON, .cones, .sing, "
        "a list of angles or curvatures, .rawfield, .rosy or .ffield",
        {}};
  }
  const int firstLine = words.line();
  if (!words.nextDouble(second) || words.line() != firstLine)
    return prescription::readTotalAngles(text, q);
  std::int64_t rows = 0;
  while (!words.isAtEnd()) {
    words.next();
    words.restOfLine();
    ++rows;
  }
  const bool isHeader = std::floor(first) == first && static_cast<double>(rows) == second;
  return isHeader && first >= 1 && first <= 64 ? prescription::readSings(text)
                                               : prescription::readCurvatures(text, q);
}

}  // namespace

Result<prescription::Prescription> readHgpConeLines(std::string_view text,
                                                    const std::vector<TextSpan>& lines,
                                                    const PolygonMesh& polygons,
                                                    const TriangleCorners& corners) {
  HgpLines reader(polygons);
  for (const TextSpan& span : lines) {
    if (!reader.take(text.substr(span.begin, span.end - span.begin))) {
      return text::malformedLine(text::lineAt(text, span.begin), "c/sm: " + reader.message());
    }
  }
  Result<prescription::Prescription> finished = reader.finish();
  if (!finished) return finished.error();
  prescription::Prescription out = std::move(*finished);
  if (out.field) {
    const MeshData mesh = triangleMesh(polygons, corners);
    if (Status done = prescription::completeMatchings(*out.field, mesh.triangles); !done)
      return done.error();
  }
  out.notes.push_back(
      Note("cones-from-file", {{"cones", out.cones.size()}, {"rotations", out.field ? 1 : 0}}));
  return out;
}

Result<prescription::Prescription> readPrescription(std::string_view name, std::string_view text,
                                                    int q) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : char(c); });
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) {
    return Failure{ErrorCode::kMalformed, "cones", "the file is empty", {}};
  }
  if (text[start] == '{') return prescription::readConesJson(text);
  if (endsWith(lower, ".rawfield")) return prescription::readRawField(text);
  if (endsWith(lower, ".rosy")) return prescription::readRosy(text);
  if (endsWith(lower, ".ffield")) return prescription::readFField(text);
  if (endsWith(lower, ".sing") || endsWith(lower, ".sings")) return prescription::readSings(text);
  if (endsWith(lower, "th_hat")) return prescription::readTotalAngles(text, q);
  if (endsWith(lower, ".obj")) {
    Result<ObjText> obj = scanObj(text, Limits().maxTriangles);
    if (!obj) return obj.error();
    Result<TriangleCorners> corners = triangulate(obj->polygons);
    if (!corners) return corners.error();
    if (obj->coneLines.empty()) {
      return Failure{ErrorCode::kMalformed, "cones", "this OBJ has no c lines", {}};
    }
    return readHgpConeLines(text, obj->coneLines, obj->polygons, *corners);
  }
  text::WordReader words(text);
  const std::string_view first = words.next();
  if (endsWith(lower, ".cones") || first == "q") return prescription::readConesText(text);
  if (first == "target_frame" || first == "shape_operator") return prescription::readFField(text);
  return readUnnamedList(text, q);
}

}  // namespace hgp::io
