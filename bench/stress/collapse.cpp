#include "collapse.h"

#include <algorithm>
#include <set>
#include <vector>

#include "vectors.h"

namespace hgp::stress {
namespace {

using namespace hgp::models;

/// Triangles, and the triangles around each vertex; removed triangles have corners −1.
class Collapser {
 public:
  explicit Collapser(const MeshData& mesh) : mesh_(mesh), around_(mesh.positions.size()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int v : mesh.triangles[t]) around_[at(v)].push_back(static_cast<int>(t));
  }

  int triangleCount() const { return static_cast<int>(mesh_.triangles.size()) - removed_; }

  /// Collapses the edge from corner `corner` of triangle t to the next corner into its midpoint.
  bool collapse(int t, int corner) {
    const auto& triangle = mesh_.triangles[at(t)];
    const int a = triangle[at(corner)], b = triangle[at((corner + 1) % 3)];
    if (a < 0 || !isAllowed(a, b)) return false;
    mesh_.positions[at(a)] = 0.5 * (mesh_.positions[at(a)] + mesh_.positions[at(b)]);
    for (int f : std::vector<int>(around_[at(b)])) {
      auto& corners = mesh_.triangles[at(f)];
      if (std::find(corners.begin(), corners.end(), a) != corners.end()) {
        remove(f);
        continue;
      }
      std::replace(corners.begin(), corners.end(), b, a);
      around_[at(a)].push_back(f);
    }
    around_[at(b)].clear();
    return true;
  }

  MeshData compact() const {
    MeshData out;
    std::vector<int> image(mesh_.positions.size(), -1);
    for (const auto& t : mesh_.triangles) {
      if (t[0] < 0) continue;
      std::array<int, 3> kept{};
      for (std::size_t i = 0; i < 3; ++i) {
        int& v = image[at(t[i])];
        if (v < 0) {
          v = static_cast<int>(out.positions.size());
          out.positions.push_back(mesh_.positions[at(t[i])]);
        }
        kept[i] = v;
      }
      out.triangles.push_back(kept);
    }
    return out;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::set<int> neighbours(int v) const {
    std::set<int> found;
    for (int t : around_[at(v)])
      for (int w : mesh_.triangles[at(t)])
        if (w != v) found.insert(w);
    return found;
  }
  /// Whether v is interior: it has as many neighbours as triangles.
  bool isInterior(int v, const std::set<int>& ring) const {
    return ring.size() == around_[at(v)].size();
  }
  bool isAllowed(int a, int b) const {
    const std::set<int> ringA = neighbours(a), ringB = neighbours(b);
    if (!isInterior(a, ringA) || !isInterior(b, ringB)) return false;
    std::vector<int> common;
    std::set_intersection(ringA.begin(), ringA.end(), ringB.begin(), ringB.end(),
                          std::back_inserter(common));
    if (common.size() != 2 || ringA.size() + ringB.size() < 7) return false;
    return std::all_of(common.begin(), common.end(),
                       [&](int v) { return around_[at(v)].size() > 3; });
  }
  void remove(int f) {
    for (int v : mesh_.triangles[at(f)]) std::erase(around_[at(v)], f);
    mesh_.triangles[at(f)] = {-1, -1, -1};
    ++removed_;
  }

  MeshData mesh_;
  std::vector<std::vector<int>> around_;
  int removed_ = 0;
};

}  // namespace

MeshData decimated(const MeshData& mesh, int triangles, Random& random) {
  Collapser collapser(mesh);
  const int all = static_cast<int>(mesh.triangles.size());
  for (int fails = 0; collapser.triangleCount() > triangles && fails < 20 * all;) {
    const int t = random.below(all), corner = random.below(3);
    fails = collapser.collapse(t, corner) ? 0 : fails + 1;
  }
  return collapser.compact();
}

}  // namespace hgp::stress
