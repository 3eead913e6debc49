#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "hgp/base/check.h"
#include "hgp/base/ids.h"
#include "hgp/mesh/repair/repair_steps.h"
#include "hgp/mesh/repair/surface_editor.h"

namespace hgp {
namespace {

struct Counts {
  int repeated = 0, duplicate = 0, merged = 0, flipped = 0, removed = 0, nudged = 0, left = 0;
};

double squaredLength(const MeshData& mesh, int a, int b) {
  const Vec3 &p = mesh.positions[at(a)], &q = mesh.positions[at(b)];
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
         (p[2] - q[2]) * (p[2] - q[2]);
}

bool isFlat(const MeshData& mesh, int a, int b, int c) {
  return hasNoArea(mesh.positions[at(a)], mesh.positions[at(b)], mesh.positions[at(c)]);
}

/// Of faces with the same corners one stays, unless the others on its edges fill them already (a fin
/// folded back on itself): then all go. The one that stays fits its neighbours' direction best.
int removeDuplicates(SurfaceEditor& surface) {
  std::map<std::array<int, 3>, std::vector<int>> groups;
  const auto sorted = [&](int f) {
    auto t = surface.triangle(f);
    std::sort(t.begin(), t.end());
    return t;
  };
  const std::vector<int> alive = surface.aliveFaces();
  for (const Defect& defect : findDefects(surface.compact()))
    if (defect.kind == DefectKind::kDuplicateFace)
      for (const Where& w : defect.where) groups[sorted(alive[static_cast<std::size_t>(w.id)])];
  int removed = 0;
  for (auto& [corners, faces] : groups) {
    for (int f : surface.facesAt(corners[0]))
      if (sorted(f) == corners) faces.push_back(f);
    std::sort(faces.begin(), faces.end());
    bool isFilled = false;
    std::map<int, int> fit;  // face of this group → neighbours that run the other way
    for (int f : faces)
      for (int k = 0; k < 3; ++k) {
        const auto t = surface.triangle(f);
        const int a = t[at(k)], b = t[at((k + 1) % 3)];
        std::set<std::array<int, 3>> others;
        for (int g : surface.facesOn(a, b)) {
          if (sorted(g) == corners) continue;
          others.insert(sorted(g));
          fit[f] += surface.hasSide(g, b, a) ? 1 : -1;
        }
        isFilled = isFilled || others.size() >= 2;
      }
    const auto best =
        std::max_element(faces.begin(), faces.end(), [&](int f, int g) { return fit[f] < fit[g]; });
    for (auto f = faces.begin(); f != faces.end(); ++f) {
      if (f == best && !isFilled) continue;
      surface.remove(*f);
      ++removed;
    }
  }
  return removed;
}

/// Merges the two closest corners when they are in one place.
bool closeNeedle(SurfaceEditor& surface, int f) {
  const auto t = surface.triangle(f);
  const MeshData& mesh = surface.mesh();
  int shortest = 0;
  double longest = 0.0, least = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const double length = squaredLength(mesh, t[at(k)], t[at((k + 1) % 3)]);
    longest = std::max(longest, length);
    if (length < least) {
      least = length;
      shortest = k;
    }
  }
  if (least > kZeroHeight * kZeroHeight * longest) return false;
  const int a = t[at(shortest)], b = t[at((shortest + 1) % 3)];
  // A boundary vertex stays, so that the boundary does not move inwards.
  const bool keepsB = surface.isBoundary(b) && !surface.isBoundary(a);
  return surface.merge(keepsB ? b : a, keepsB ? a : b);
}

enum class CapResult { kFlipped, kRemoved, kStuck };

/// Flips the longest side into the neighbour; on the boundary the face simply goes.
CapResult flattenCap(SurfaceEditor& surface, int f) {
  const auto t = surface.triangle(f);
  const MeshData& mesh = surface.mesh();
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (squaredLength(mesh, t[at(k)], t[at((k + 1) % 3)]) >
        squaredLength(mesh, t[at(longest)], t[at((longest + 1) % 3)]))
      longest = k;
  const int a = t[at(longest)], c = t[at((longest + 1) % 3)], b = t[at((longest + 2) % 3)];
  const std::vector<int> both = surface.facesOn(a, c);
  if (both.size() == 1) {
    if (surface.isBoundary(b)) return CapResult::kStuck;  // would pinch the surface at b
    surface.remove(f);
    return CapResult::kRemoved;
  }
  if (both.size() != 2) return CapResult::kStuck;
  const int g = both[0] == f ? both[1] : both[0];
  if (!surface.hasSide(g, c, a)) return CapResult::kStuck;
  const int d = surface.apex(g, a, c);
  if (d == b || !surface.facesOn(b, d).empty()) return CapResult::kStuck;
  // Between flat triangles only flips that shorten the side: they come to an end.
  const bool isCured = !isFlat(mesh, a, d, b) && !isFlat(mesh, d, c, b);
  if (!isCured && squaredLength(mesh, b, d) >= squaredLength(mesh, a, c)) return CapResult::kStuck;
  surface.replace(f, {a, d, b}, surface.origin(g));
  surface.replace(g, {d, c, b}, surface.origin(g));
  return CapResult::kFlipped;
}

/// Last resort: moves one corner sideways so that all faces around it have area and none turns over.
bool nudge(SurfaceEditor& surface, int f) {
  const auto t = surface.triangle(f);
  for (int k = 0; k < 3; ++k) {
    const int v = t[at(k)];
    double reach = 0.0;
    for (int g : surface.facesAt(v))
      for (int w : surface.triangle(g))
        reach = std::max(reach, squaredLength(surface.mesh(), v, w));
    const Vec3 start = surface.mesh().positions[at(v)];
    for (int direction = 0; direction < 6; ++direction) {
      Vec3 moved = start;
      moved[at(direction / 2)] += (direction % 2 ? -1 : 1) * kNudge * std::sqrt(reach);
      if (surface.tryMove(v, moved)) return true;
    }
  }
  return false;
}

/// Works off all faces without area; those that come up again wait for their neighbours.
void removeFlat(SurfaceEditor& surface, Counts& counts) {
  std::vector<int> flat;
  for (int f = 0; f < surface.faceCount(); ++f)
    if (surface.isAlive(f) && surface.isFlat(f)) flat.push_back(f);
  // Merges lose a vertex, flips cure a face or shorten a side: this ends by itself. The bound is for
  // sides whose lengths differ by rounding only.
  std::size_t stepsLeft = 1000 + 100 * flat.size();
  bool isProgress = true;
  while (isProgress && !flat.empty()) {
    isProgress = false;
    std::vector<int> next;
    for (std::size_t n = 0; n < flat.size(); ++n) {
      const int f = flat[n];
      if (!surface.isAlive(f) || !surface.isFlat(f) || stepsLeft == 0) continue;
      --stepsLeft;
      surface.takeTouched();
      if (closeNeedle(surface, f)) {
        ++counts.merged;
      } else {
        const CapResult result = flattenCap(surface, f);
        counts.flipped += result == CapResult::kFlipped;
        counts.removed += result == CapResult::kRemoved;
        if (result == CapResult::kStuck) {
          next.push_back(f);
          continue;
        }
      }
      isProgress = true;
      for (int g : surface.takeTouched()) next.push_back(g);
    }
    flat = std::move(next);
  }
  for (int f : flat) {
    if (!surface.isAlive(f) || !surface.isFlat(f)) continue;
    if (nudge(surface, f))
      ++counts.nudged;
    else
      ++counts.left;
  }
}

void note(FixResult& result, int count, const char* text) {
  if (count > 0) result.notes.push_back(formatText("degenerate: %d %s", count, text));
}

}  // namespace

void removeDegenerate(FixResult& result) {
  const std::vector<Defect> defects = findDefects(result.mesh);
  const bool isClean = std::none_of(defects.begin(), defects.end(), [](const Defect& d) {
    return d.kind == DefectKind::kRepeatedVertex || d.kind == DefectKind::kZeroArea ||
           d.kind == DefectKind::kDuplicateFace;
  });
  if (isClean) return;
  Counts counts;
  SurfaceEditor surface(result.mesh, result.faceOrigin);
  // The two other sides of such a face run along one edge in opposite directions: dropping it glues
  // its neighbours.
  for (int f = 0; f < surface.faceCount(); ++f) {
    const auto t = surface.triangle(f);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) continue;
    surface.remove(f);
    ++counts.repeated;
  }
  counts.duplicate = removeDuplicates(surface);
  removeFlat(surface, counts);
  result.mesh = surface.compact();
  result.faceOrigin = surface.compactOrigins();
  note(result, counts.repeated, "faces that named a vertex twice removed");
  note(result, counts.duplicate, "copies of other faces removed");
  note(result, counts.merged, "pairs of vertices in one place merged");
  note(result, counts.flipped, "sides flipped under a corner that lay on them");
  note(result, counts.removed, "faces without area removed from the boundary");
  note(result, counts.nudged, "vertices moved slightly to give their faces area");
  note(result, counts.left, "faces without area could not be repaired");
}

}  // namespace hgp
