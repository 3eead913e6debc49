#include "hgp/api/session/map_notes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
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

std::optional<std::string> crushedNote(const ModelComponent& component, const UvMap& map) {
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
  std::vector<Where> place{{Where::Kind::kFace, worst.i}};
  toSurfaceIds(component, place);
  const Vec3& p = mesh.position(mesh.corners(worst)[0]);
  return formatText(
      "%d of %s crushed: area scale below %g of the median, the smallest %.1e of it "
      "(triangle %lld, at %.4g %.4g %.4g). Place a cone there, or more cones.",
      count, (counted(mesh.faceCount(), "triangle") + (count == 1 ? " is" : " are")).c_str(),
      kCrushedScale, scale[worst] / median, static_cast<long long>(place[0].id), p[0], p[1], p[2]);
}

std::optional<std::string> countNote(int asked, const CompleteSpec& chosen) {
  const int have = static_cast<int>(chosen.cones.size());
  if (asked == 0 || have == asked) return {};
  return formatText("%s asked for, %d placed: %s.", counted(asked, "cone").c_str(), have,
                    have > asked
                        ? "fewer would break Gauss–Bonnet or be too strong for the triangles"
                        : "the mesh has no vertices for more");
}

std::vector<std::string> mismatchNotes(const Model& model, const io::Prescription& cones) {
  std::vector<std::string> notes;
  const auto compare = [&](int asked, std::size_t have, const char* one, const char* many) {
    if (asked < 0 || static_cast<std::size_t>(asked) == have) return;
    notes.push_back("the cones are for a mesh of " + counted(asked, one, many) + "; this one has " +
                    std::to_string(have));
  };
  compare(cones.triangleCount, model.source().mesh.triangles.size(), "triangle", "triangles");
  compare(cones.vertexCount, model.source().mesh.positions.size(), "vertex", "vertices");
  const std::size_t loops = model.topology.loops.size();
  if (cones.hasCones && !cones.field && loops > cones.boundaries.size())
    notes.push_back(
        counted(loops - cones.boundaries.size(), "boundary loop has", "boundary loops have") +
        " no turning among the cones: measured, and compared with nothing. If the cones "
        "are for a closed surface, faces are missing here");
  return notes;
}

}  // namespace hgp::api
