#include "hgp/api/request/file_marks.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/io/plain_surface.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

using Pair = std::array<int, 2>;

/// Cosine of the angle between normals that are the same but for rounding: one degree.
constexpr double kSameNormal = 0.99985;

/// One side of an edge: `a` and `b` are its vertices, a < b, with the corners of the triangle at them.
struct Side {
  int a = -1, b = -1, triangle = -1, cornerA = 0, cornerB = 0;
  Pair ends() const { return {a, b}; }
};

std::vector<Side> sidesOf(const MeshData& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, a = mesh.triangles[t][at(k)], b = mesh.triangles[t][at(next)];
      if (a < b)
        sides.push_back({a, b, static_cast<int>(t), k, next});
      else
        sides.push_back({b, a, static_cast<int>(t), next, k});
    }
  sortStably(sides, [](const Side& s, const Side& t) {
    return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
  });
  return sides;
}

class MarkFinder {
 public:
  explicit MarkFinder(const io::PlainSurface& surface)
      : surface_(surface), sides_(sidesOf(surface.mesh)) {}

  Status add(prescription::FeatureMark mark, bool isAsked) {
    switch (mark) {
      case prescription::FeatureMark::kLines:
        for (const auto& [a, b] : surface_.lines)
          found_.push_back({std::min(a, b), std::max(a, b)});
        return Done{};
      case prescription::FeatureMark::kSmoothing:
        return addBetween(surface_.triangleSmoothing);
      case prescription::FeatureMark::kMaterials:
        return addBetween(surface_.triangleMaterial);
      case prescription::FeatureMark::kNormals:
        return addNormals(isAsked);
    }
    return Done{};
  }

  std::vector<Pair> take() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  /// Calls use(one, other) for both sides of every edge between two triangles.
  template <class Use>
  void forEdges(const Use& use) const {
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      const bool isPair = sides_[i].ends() == sides_[i + 1].ends();
      const bool isThird = (i > 0 && sides_[i - 1].ends() == sides_[i].ends()) ||
                           (i + 2 < sides_.size() && sides_[i + 2].ends() == sides_[i].ends());
      if (isPair && !isThird) use(sides_[i], sides_[i + 1]);
    }
  }

  Status addBetween(const std::vector<int>& values) {
    if (values.empty()) return Done{};
    forEdges([&](const Side& s, const Side& t) {
      if (values[at(s.triangle)] != values[at(t.triangle)]) found_.push_back(s.ends());
    });
    return Done{};
  }

  bool isSame(const Side& s, int cornerS, const Side& t, int cornerT) const {
    const int i = surface_.cornerNormal[at(s.triangle)][at(cornerS)];
    const int j = surface_.cornerNormal[at(t.triangle)][at(cornerT)];
    if (i == j || i < 0 || j < 0) return true;
    const Vec3 &n = surface_.normals[at(i)], &m = surface_.normals[at(j)];
    const double lengths = norm(n) * norm(m);
    return !(lengths > 0.0) || dot(n, m) >= kSameNormal * lengths;
  }

  Status addNormals(bool isAsked) {
    if (surface_.cornerNormal.empty()) return Done{};
    std::vector<Pair> split;
    std::size_t edges = 0;
    forEdges([&](const Side& s, const Side& t) {
      ++edges;
      if (!isSame(s, s.cornerA, t, t.cornerA) || !isSame(s, s.cornerB, t, t.cornerB))
        split.push_back(s.ends());
    });
    const bool isFlat = 2 * split.size() > edges;
    if (isFlat && isAsked)
      return Failure{
          ErrorCode::kPrescription,
          "features",
          formatText("normals differ at %zu of %zu edges: the file is shaded flat, so that "
                     "its normals mark no creases",
                     split.size(), edges),
          {},
          {Note("find-creases")}};
    if (!isFlat) found_.insert(found_.end(), split.begin(), split.end());
    return Done{};
  }

  const io::PlainSurface& surface_;
  std::vector<Side> sides_;
  std::vector<Pair> found_;
};

}  // namespace

Result<std::vector<Pair>> markedEdges(const Model& model,
                                      std::vector<prescription::FeatureMark> marks) {
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  if (marks.empty()) return std::vector<Pair>();
  Result<io::PlainFile> plain = model.document->plain(model.surface);
  if (!plain) return plain.error();
  MarkFinder finder(plain->surfaces.front());
  std::string names;
  for (const prescription::FeatureMark mark : marks) {
    if (Status done = finder.add(mark, marks.size() == 1); !done) return done.error();
    names += (names.empty() ? "" : ", ") +
             std::string(prescription::kFeatureMarks[static_cast<int>(mark)]);
  }
  std::vector<Pair> found = finder.take();
  if (!found.empty()) return found;
  return Failure{
      ErrorCode::kPrescription,
      "features",
      "the file marks no edges (" + names + ")" +
          (model.hasOwnVertexIds ? ""
                                 : "; lines and smoothing groups are lost where it is converted: "
                                   "list them before with hgp features"),
      {},
      model.hasOwnVertexIds ? Notes{Note("find-creases")} : Notes()};
}

}  // namespace hgp::api
