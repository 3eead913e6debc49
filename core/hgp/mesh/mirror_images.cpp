#include <algorithm>
#include <array>

#include "hgp/base/stable_order.h"
#include "hgp/mesh/reflection.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// A triangle at the place of its centre along a direction that no grid is aligned with.
struct Centre {
  double place;
  FaceId face;
  bool operator<(double other) const { return place < other; }
};

double placeOf(const std::array<Vec3, 3>& corners) {
  static constexpr Vec3 kDirection{0.3713906763541037, 0.5570860145311556, 0.7427813527082074};
  return dot(kDirection, add(add(corners[0], corners[1]), corners[2])) / 3.0;
}

std::array<Vec3, 3> cornersOf(const TriMesh& mesh, FaceId f) {
  const auto [a, b, c] = mesh.corners(f);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

/// Whether b, the other way round, has its corners at those of a.
bool isTurnedOver(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, double tolerance) {
  for (std::size_t first = 0; first < 3; ++first)
    if (distance(a[0], b[first]) <= tolerance && distance(a[1], b[(first + 2) % 3]) <= tolerance &&
        distance(a[2], b[(first + 1) % 3]) <= tolerance)
      return true;
  return false;
}

}  // namespace

MirrorImages mirrorImages(const TriMesh& mesh, const MirrorPlane& plane, double tolerance) {
  std::vector<Centre> centres;
  centres.reserve(at(mesh.faceCount()));
  for (FaceId f : mesh.faces()) centres.push_back({placeOf(cornersOf(mesh, f)), f});
  sortStably(centres, [](const Centre& a, const Centre& b) { return a.place < b.place; });
  MirrorImages out;
  for (FaceId f : mesh.faces()) {
    std::array<Vec3, 3> there = cornersOf(mesh, f);
    for (Vec3& p : there) p = mirrored(plane, p);
    const double place = placeOf(there);
    auto other = std::lower_bound(centres.begin(), centres.end(), place - tolerance);
    const auto isImage = [&] {
      return isTurnedOver(there, cornersOf(mesh, other->face), tolerance);
    };
    while (other != centres.end() && other->place <= place + tolerance && !isImage()) ++other;
    if (other != centres.end() && other->place <= place + tolerance)
      ++out.count;
    else if (!out.without.isValid())
      out.without = f;
  }
  return out;
}

}  // namespace hgp
