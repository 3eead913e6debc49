#include "hgp/api/session/map_notes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

double surfaceArea(const TriMesh& mesh, FaceId f) {
  const auto [a, b, c] = mesh.corners(f);
  return triangleArea(mesh.position(a), mesh.position(b), mesh.position(c));
}

double uvArea(const UvMap& map, FaceId f) {
  const auto& t = map.cornerUv[static_cast<std::size_t>(f.i)];
  const auto at = [&](std::size_t k) { return map.uv[static_cast<std::size_t>(t[k])]; };
  return 0.5 * ((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]));
}

}  // namespace

std::optional<Note> crushedNote(const ModelComponent& component, const UvMap& map) {
  const TriMesh& mesh = component.mesh;
  if (map.cornerUv.size() != static_cast<std::size_t>(mesh.faceCount())) return {};
  PerFace<double> scale(static_cast<std::size_t>(mesh.faceCount()), -1.0);
  std::vector<double> sorted;
  for (FaceId f : mesh.faces()) {
    const double area = surfaceArea(mesh, f);
    if (area <= 0.0) continue;
    scale[f] = uvArea(map, f) / area;
    sorted.push_back(scale[f]);
  }
  if (sorted.empty()) return {};
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double median = *middle;
  int count = 0;
  FaceId worst;
  for (FaceId f : mesh.faces()) {
    if (scale[f] <= 0.0 || scale[f] >= kCrushedScale * median) continue;
    ++count;
    if (!worst.isValid() || scale[f] < scale[worst]) worst = f;
  }
  if (count == 0) return {};
  const Vec3& p = mesh.position(mesh.corners(worst)[0]);
  return Note("map-crushed",
              {{"crushed", count},
               {"triangles", mesh.faceCount()},
               {"scale", kCrushedScale},
               {"smallest", scale[worst] / median},
               {"x", p[0]},
               {"y", p[1]},
               {"z", p[2]}},
              {{Where::Kind::kFace, worst.i}});
}

std::optional<Note> countNote(int asked, const CompleteSpec& chosen) {
  const int have = static_cast<int>(chosen.cones.size());
  if (asked == 0 || have == asked) return {};
  return Note("cones-other-number",
              {{"asked", asked}, {"placed", have}, {"more", have > asked ? 1 : 0}});
}

Notes mismatchNotes(const Model& model, const prescription::Prescription& cones) {
  Notes notes;
  const auto compare = [&](int asked, std::size_t have, const char* code) {
    if (asked < 0 || static_cast<std::size_t>(asked) == have) return;
    notes.push_back(Note(code, {{"asked", asked}, {"found", have}}));
  };
  compare(cones.triangleCount, model.source().mesh.triangles.size(), "cones-other-triangles");
  compare(cones.vertexCount, model.source().mesh.positions.size(), "cones-other-vertices");
  const std::size_t loops = model.topology.loops.size();
  if (cones.hasCones && !cones.field && loops > cones.boundaries.size())
    notes.push_back(Note("cones-without-turning", {{"loops", loops - cones.boundaries.size()}}));
  return notes;
}

}  // namespace hgp::api
