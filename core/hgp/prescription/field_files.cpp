#include <cmath>
#include <limits>
#include <unordered_map>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"
#include "hgp/mesh/vectors.h"
#include "hgp/prescription/cones.h"
#include "hgp/text/text.h"

namespace hgp::prescription {
namespace {

// Tolerance of the directions of an N-RoSy, because files have few digits.
constexpr double kRosyTolerance = 1e-2;
constexpr std::int64_t kMaxFaces = 100'000'000;
constexpr std::int64_t kMaxOrder = 64;

Failure fieldFailure(const text::WordReader& words, const std::string& message) {
  Failure f = text::malformedLine(words.line(), message);
  f.stage = "field";
  return f;
}

Failure notANumber(const text::WordReader& words) {
  return fieldFailure(words, "expected a number, not " + text::inQuotes(words.word()));
}

/// Whether the directions are at the angles 2πj/N from direction `from`, each as often as in an N-RoSy.
bool isEvenFrom(const std::vector<Vec3>& directions, const Vec3& from, std::vector<int>& found) {
  const int N = static_cast<int>(directions.size());
  const double length = norm(from);
  found.assign(directions.size(), 0);
  for (const Vec3& d : directions) {
    const double other = norm(d);
    if (!(length > 0 && other > 0)) return false;
    const double c = std::max(-1.0, std::min(1.0, dot(d, from) / (length * other)));
    const double turns = portable::acos(c) * N / (2 * kPi);
    if (std::abs(turns - std::round(turns)) > kRosyTolerance * N) return false;
    ++found[static_cast<std::size_t>(std::lround(turns)) % directions.size()];
  }
  for (int j = 0; j <= N / 2; ++j) {
    const int want = j == 0 || 2 * j == N ? 1 : 2;
    if (found[static_cast<std::size_t>(j)] != want) return false;
  }
  return true;
}

/// Whether the directions are an N-RoSy: they are evenly spaced from each of them.
bool isRosy(const std::vector<Vec3>& directions) {
  std::vector<int> found;
  for (const Vec3& d : directions) {
    if (!isEvenFrom(directions, d, found)) return false;
  }
  return true;
}

bool readVector(text::WordReader& words, Vec3& out) {
  return words.nextDouble(out[0]) && words.nextDouble(out[1]) && words.nextDouble(out[2]);
}

/// Reads the blocks of a `.ffield` in order.
class FFieldReader {
 public:
  explicit FFieldReader(std::string_view text) : words_(text) {
    const std::size_t mark = text.find("version");
    if (mark != std::string_view::npos && mark < 200) {
      const char* p = text.data() + mark + 7;
      const char* end = text.data() + text.size();
      text::skipBlanks(p, end);
      double version = 0;
      // Files of versions below 2 have the opposite sign.
      if (text::readDouble(p, end, version) && version < 2) sign_ = 1;
    }
  }

  Result<Prescription> read() {
    Prescription out;
    out.q = 4;
    out.field.emplace();
    field_ = &*out.field;
    while (!words_.isAtEnd()) {
      const std::string block(words_.next());
      Status done = Done{};
      if (block == "target_frame" || block == "shape_operator") {
        done = readFrames();
      } else if (block == "crossfield_angles") {
        done = skipNumbers(static_cast<std::int64_t>(field_->directions.size()));
      } else if (block == "fixed" || block == "fixed_vertices") {
        std::int64_t n = 0;
        if (!words_.nextInt(n) || n < 0 || n > kMaxFaces) return notANumber(words_);
        done = skipNumbers(n);
      } else if (block.find("matchings") != std::string::npos) {
        done = readMatchings();
      } else {
        return fieldFailure(words_, "unknown block " + text::inQuotes(block));
      }
      if (!done) return done.error();
    }
    if (field_->directions.empty()) return fieldFailure(words_, "no target_frame block");
    return out;
  }

 private:
  Status skipNumbers(std::int64_t count) {
    double ignored = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      if (!words_.nextDouble(ignored)) return notANumber(words_);
    }
    return Done{};
  }

  Status readFrames() {
    std::int64_t faces = 0;
    if (!words_.nextInt(faces) || faces < 1 || faces > kMaxFaces) return notANumber(words_);
    words_.next();  // "k1", the first word of the header line
    words_.restOfLine();
    for (std::int64_t f = 0; f < faces; ++f) {
      double curvature = 0;
      Vec3 first{}, second{};
      if (!words_.nextDouble(curvature) || !words_.nextDouble(curvature) ||
          !readVector(words_, first) || !readVector(words_, second)) {
        return notANumber(words_);
      }
      field_->directions.push_back(first);
    }
    return Done{};
  }

  /// m_i belongs to the halfedge that points to v_i; the sum of m into v is k_v.
  Status readMatchings() {
    field_->hasMatchings = true;
    for (std::size_t f = 0; f < field_->directions.size(); ++f) {
      std::int64_t n[9] = {};
      for (std::int64_t& x : n) {
        if (!words_.nextInt(x) || x < INT32_MIN || x > INT32_MAX) return notANumber(words_);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        Matching m;
        m.from = static_cast<int>(f);
        m.tail = static_cast<int>(n[(i + 2) % 3]);
        m.head = static_cast<int>(n[i]);
        m.turn = reduceTurn(sign_ * n[3 + i], 4);
        // The twin has the same matching with opposite sign; one side suffices.
        if (m.turn != 0 && m.tail < m.head) field_->matchings.push_back(m);
        if (m.turn != 0 && m.tail > m.head) reversed_.push_back(m);
      }
    }
    addUnpaired();
    return Done{};
  }

  /// Adds edges that are listed only in the other direction (the file stores both, but one on the boundary).
  void addUnpaired() {
    std::unordered_map<std::int64_t, int> known;
    const auto key = [](int a, int b) { return (static_cast<std::int64_t>(a) << 32) ^ b; };
    for (const Matching& m : field_->matchings) known[key(m.tail, m.head)] = m.from;
    for (const Matching& m : reversed_) {
      if (known.count(key(m.head, m.tail)) == 0) field_->matchings.push_back(m);
    }
  }

  text::WordReader words_;
  FieldData* field_ = nullptr;
  std::vector<Matching> reversed_;
  int sign_ = -1;
};

}  // namespace

Result<Prescription> readRawField(std::string_view text) {
  text::WordReader words(text);
  std::int64_t N = 0, faces = 0;
  if (!words.nextInt(N) || !words.nextInt(faces)) return notANumber(words);
  if (N < 1 || N > kMaxOrder || faces < 1 || faces > kMaxFaces) {
    return fieldFailure(words, "the order must be 1 to 64 and the number of faces positive");
  }
  Prescription out;
  out.q = static_cast<int>(N);
  out.field.emplace();
  out.field->order = out.q;
  std::vector<Vec3> directions(static_cast<std::size_t>(N));
  for (std::int64_t f = 0; f < faces; ++f) {
    for (Vec3& d : directions) {
      if (!readVector(words, d)) return notANumber(words);
    }
    if (!isRosy(directions)) {
      return fieldFailure(words, formatText("face %lld: its %lld vectors are not rotations of one "
                                            "another by 2π/%lld",
                                            static_cast<long long>(f), static_cast<long long>(N),
                                            static_cast<long long>(N)));
    }
    out.field->directions.push_back(directions[0]);
  }
  if (!words.isAtEnd()) return fieldFailure(words, "more rows than announced");
  return out;
}

Result<Prescription> readRosy(std::string_view text) {
  text::WordReader words(text);
  std::int64_t faces = 0, N = 0;
  if (!words.nextInt(faces) || !words.nextInt(N)) return notANumber(words);
  if (N < 1 || N > kMaxOrder || faces < 1 || faces > kMaxFaces) {
    return fieldFailure(words, "the order must be 1 to 64 and the number of faces positive");
  }
  Prescription out;
  out.q = static_cast<int>(N);
  out.field.emplace();
  out.field->order = out.q;
  for (std::int64_t f = 0; f < faces; ++f) {
    Vec3 d{};
    if (!readVector(words, d)) return notANumber(words);
    out.field->directions.push_back(d);
  }
  if (!words.isAtEnd()) return fieldFailure(words, "more rows than announced");
  return out;
}

Result<Prescription> readFField(std::string_view text) { return FFieldReader(text).read(); }

Status completeMatchings(FieldData& field, const std::vector<std::array<int, 3>>& triangles) {
  std::unordered_map<std::int64_t, int> faceOf;
  const auto key = [](int a, int b) { return (static_cast<std::int64_t>(a) << 32) ^ b; };
  for (const Matching& m : field.matchings) {
    faceOf[key(m.tail, m.head)] = -1;
    faceOf[key(m.head, m.tail)] = -1;
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto it = faceOf.find(key(triangles[f][k], triangles[f][(k + 1) % 3]));
      if (it != faceOf.end()) it->second = static_cast<int>(f);
    }
  }
  std::vector<Matching> inner;
  for (Matching m : field.matchings) {
    const int from = faceOf[key(m.tail, m.head)], to = faceOf[key(m.head, m.tail)];
    if (from < 0 && to < 0) {
      return Failure{ErrorCode::kPrescription,
                     "field",
                     formatText("a matching names the edge %d–%d, which the mesh does not have",
                                m.tail, m.head),
                     {{Where::Kind::kEdge, m.tail, m.head}}};
    }
    if (from < 0 || to < 0) continue;  // a boundary edge has no matching
    if ((m.from >= 0 && m.from != from) || (m.to >= 0 && m.to != to)) {
      return Failure{ErrorCode::kPrescription,
                     "field",
                     formatText("a matching names faces %d and %d beside the edge %d→%d; the mesh "
                                "has %d and %d there",
                                m.from, m.to, m.tail, m.head, from, to),
                     {{Where::Kind::kEdge, m.tail, m.head}}};
    }
    m.from = from;
    m.to = to;
    inner.push_back(m);
  }
  field.matchings = std::move(inner);
  return Done{};
}

}  // namespace hgp::prescription
