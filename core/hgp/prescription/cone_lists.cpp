#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/turns.h"
#include "hgp/prescription/cones.h"
#include "hgp/text/text.h"

namespace hgp::prescription {
namespace {

/// Reads words and records the first line with an error.
class ListReader {
 public:
  explicit ListReader(std::string_view text) : words_(text) {}

  int integer(const char* what) {
    std::int64_t value = 0;
    if (!isFine()) return 0;
    if (!words_.nextInt(value) || value < INT32_MIN || value > INT32_MAX) {
      wrong(
          formatText("%s must be an integer, not %s", what, text::inQuotes(words_.word()).c_str()));
      return 0;
    }
    return static_cast<int>(value);
  }
  double number(const char* what) {
    double value = 0;
    if (isFine() && !words_.nextDouble(value)) {
      wrong(formatText("%s must be a number, not %s", what, text::inQuotes(words_.word()).c_str()));
    }
    return value;
  }
  void keyword(const char* word) {
    if (isFine() && words_.next() != word) {
      wrong(formatText("expected '%s', not %s", word, text::inQuotes(words_.word()).c_str()));
    }
  }
  int count(const char* what) {
    const int n = integer(what);
    if (isFine() && (n < 0 || n > kMaxCones)) wrong(formatText("%s is %d", what, n));
    return isFine() ? n : 0;
  }
  void atEnd() {
    if (isFine() && !words_.isAtEnd()) wrong("more rows than announced");
  }
  bool hasMore() { return isFine() && !words_.isAtEnd(); }
  bool isFine() const { return message_.empty(); }
  int line() const { return words_.line(); }
  Failure failure() const {
    Failure f = text::malformedLine(line_, message_);
    f.stage = "cones";
    return f;
  }
  void wrong(const std::string& message) {
    message_ = message;
    line_ = words_.line();
  }

 private:
  text::WordReader words_;
  std::string message_;
  int line_ = 0;
};

Failure notAnInteger(std::int64_t line, const char* letter, double value, int q) {
  return {ErrorCode::kPrescription,
          "cones",
          formatText("line %lld: the angle is %.9g · 2π/%d; %s must be an integer",
                     static_cast<long long>(line), value, q, letter),
          {{Where::Kind::kLine, line}}};
}

}  // namespace

Result<Prescription> readConesText(std::string_view text) {
  ListReader in(text);
  Prescription out;
  in.keyword("q");
  out.q = in.integer("q");
  in.keyword("cones");
  const int cones = in.count("the number of cones");
  out.hasCones = true;
  for (int i = 0; i < cones && in.isFine(); ++i) {
    PrescribedCone cone;
    cone.vertex = in.integer("a vertex");
    cone.k = in.integer("k");
    out.cones.push_back(cone);
  }
  if (in.hasMore()) {
    in.keyword("matchings");
    const int matchings = in.count("the number of matchings");
    out.field.emplace();
    out.field->order = out.q;
    out.field->hasMatchings = true;
    for (int i = 0; i < matchings && in.isFine(); ++i) {
      Matching m;
      m.to = in.integer("a face");
      m.from = in.integer("a face");
      m.tail = in.integer("a vertex");
      m.head = in.integer("a vertex");
      m.turn = in.integer("a rotation");
      out.field->matchings.push_back(m);
    }
  }
  in.atEnd();
  if (!in.isFine()) return in.failure();
  return out;
}

Result<Prescription> readSings(std::string_view text) {
  ListReader in(text);
  Prescription out;
  out.q = in.integer("the order N");
  const int rows = in.count("the number of singularities");
  out.hasCones = true;
  for (int i = 0; i < rows && in.isFine(); ++i) {
    PrescribedCone cone;
    cone.vertex = in.integer("a vertex");
    const int index = in.integer("a singularity index");
    const std::int64_t k = std::int64_t{out.q} - index;
    if (k < INT32_MIN || k > INT32_MAX) {
      in.wrong(formatText("a singularity index of %d is out of range", index));
      break;
    }
    cone.k = static_cast<int>(k);
    if (index != 0) out.cones.push_back(cone);
  }
  in.atEnd();
  if (!in.isFine()) return in.failure();
  out.notes.push_back(Note("cones-from-list", {{"cones", out.cones.size()}, {"q", out.q}}));
  return out;
}

Result<Prescription> readCurvatures(std::string_view text, int q) {
  ListReader in(text);
  Prescription out;
  out.q = q;
  out.hasCones = true;
  while (in.hasMore()) {
    PrescribedCone cone;
    cone.vertex = in.integer("a vertex");
    const double curvature = in.number("a curvature");
    if (!in.isFine()) break;
    const double k = q * (1 - curvature / (2 * kPi));
    if (!(std::abs(k - std::round(k)) <= kAngleIndexTolerance) || std::abs(k) > 1e6) {
      return notAnInteger(in.line(), "k", k, q);
    }
    cone.k = static_cast<int>(std::lround(k));
    if (cone.k != q) out.cones.push_back(cone);
  }
  if (!in.isFine()) return in.failure();
  out.notes.push_back(Note("cones-from-curvatures", {{"cones", out.cones.size()}}));
  return out;
}

Result<Prescription> readTotalAngles(std::string_view text, int q) {
  ListReader in(text);
  Prescription out;
  out.q = q;
  out.totalAngles.reserve(text.size() / 18);
  while (in.hasMore()) out.totalAngles.push_back(in.number("a total angle"));
  if (!in.isFine()) return in.failure();
  if (out.totalAngles.empty()) {
    return Failure{ErrorCode::kMalformed, "cones", "there are no angles in this file", {}};
  }
  return out;
}

Result<Prescription> reduceTotalAngles(const Prescription& angles, const TriMesh& mesh,
                                       const Topology& topology,
                                       const std::vector<int>& vertexOrigin) {
  Prescription out;
  out.q = angles.q;
  out.hasCones = true;
  const auto lineOf = [&](VertexId v) {
    return vertexOrigin.empty() ? v.i : vertexOrigin[static_cast<std::size_t>(v.i)];
  };
  const double unit = 2 * kPi / angles.q;
  for (VertexId v : mesh.vertices()) {
    if (static_cast<std::size_t>(lineOf(v)) >= angles.totalAngles.size()) {
      return Failure{
          ErrorCode::kPrescription,
          "cones",
          formatText("%s for a mesh of %d vertices",
                     counted(angles.totalAngles.size(), "total angle").c_str(), mesh.vertexCount()),
          {}};
    }
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    const double k = angles.totalAngles[static_cast<std::size_t>(lineOf(v))] / unit;
    if (!(std::abs(k - std::round(k)) <= kAngleIndexTolerance) || std::abs(k) > 1e6) {
      return notAnInteger(lineOf(v) + 1, "k", k, angles.q);
    }
    const int index = static_cast<int>(std::lround(k));
    if (index != angles.q) out.cones.push_back({lineOf(v), index, std::nullopt});
  }
  for (std::size_t j = 0; j < topology.loops.size(); ++j) {
    double l = 0;
    for (HalfedgeId h : topology.loops[j].halfedges) {
      l += (kPi - angles.totalAngles[static_cast<std::size_t>(lineOf(mesh.tail(h)))]) / unit;
    }
    const int anchor = lineOf(mesh.tail(topology.loops[j].halfedges.front()));
    if (!(std::abs(l - std::round(l)) <= kAngleIndexTolerance) || std::abs(l) > 1e9) {
      return notAnInteger(anchor + 1, "a boundary's turning index l", l, angles.q);
    }
    out.boundaries.push_back({static_cast<int>(j), static_cast<int>(std::lround(l)), anchor});
  }
  out.notes.push_back(Note("cones-from-angles", {{"cones", out.cones.size()}}));
  if (!topology.loops.empty())
    out.notes.push_back(Note("cones-rims-reduced", {{"loops", topology.loops.size()}}));
  return out;
}

}  // namespace hgp::prescription
