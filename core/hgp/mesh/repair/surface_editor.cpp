#include "hgp/mesh/repair/surface_editor.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "hgp/base/ids.h"
#include "hgp/mesh/defects.h"

namespace hgp {
namespace {

Vec3 normal(const MeshData& mesh, const std::array<int, 3>& t) {
  const Vec3 &a = mesh.positions[at(t[0])], &b = mesh.positions[at(t[1])],
             &c = mesh.positions[at(t[2])];
  Vec3 u, v;
  for (std::size_t n = 0; n < 3; ++n) {
    u[n] = b[n] - a[n];
    v[n] = c[n] - a[n];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

}  // namespace

SurfaceEditor::SurfaceEditor(MeshData mesh, std::vector<int> origins)
    : mesh_(std::move(mesh)),
      origins_(std::move(origins)),
      isAlive_(mesh_.triangles.size(), 1),
      facesAt_(mesh_.positions.size()) {
  for (int f = 0; f < faceCount(); ++f)
    for (int v : triangle(f)) {
      auto& list = facesAt_[at(v)];
      if (list.empty() || list.back() != f) list.push_back(f);
    }
}

std::vector<int> SurfaceEditor::facesOn(int a, int b) const {
  std::vector<int> faces;
  for (int f : facesAt(a)) {
    const auto& t = triangle(f);
    if (std::find(t.begin(), t.end(), b) != t.end()) faces.push_back(f);
  }
  return faces;
}

bool SurfaceEditor::hasSide(int f, int a, int b) const {
  const auto& t = triangle(f);
  for (int k = 0; k < 3; ++k)
    if (t[at(k)] == a && t[at((k + 1) % 3)] == b) return true;
  return false;
}

int SurfaceEditor::apex(int f, int a, int b) const {
  const auto& t = triangle(f);
  return *std::find_if(t.begin(), t.end(), [&](int v) { return v != a && v != b; });
}

bool SurfaceEditor::isFlat(int f) const {
  const auto& t = triangle(f);
  return hasNoArea(mesh_.positions[at(t[0])], mesh_.positions[at(t[1])], mesh_.positions[at(t[2])]);
}

std::vector<int> SurfaceEditor::neighbours(int v) const {
  std::vector<int> list;
  for (int f : facesAt(v))
    for (int w : triangle(f))
      if (w != v) list.push_back(w);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

bool SurfaceEditor::isBoundary(int v) const {
  for (int w : neighbours(v))
    if (facesOn(v, w).size() == 1) return true;
  return false;
}

void SurfaceEditor::detach(int f) {
  for (int v : triangle(f)) {
    auto& list = facesAt_[at(v)];
    list.erase(std::remove(list.begin(), list.end(), f), list.end());
  }
}

void SurfaceEditor::remove(int f) {
  detach(f);
  isAlive_[at(f)] = 0;
}

void SurfaceEditor::replace(int f, const std::array<int, 3>& corners, int origin) {
  detach(f);
  mesh_.triangles[at(f)] = corners;
  origins_[at(f)] = origin;
  for (int v : corners) facesAt_[at(v)].push_back(f);
  touched_.push_back(f);
}

bool SurfaceEditor::merge(int kept, int gone) {
  const std::vector<int> shared = facesOn(kept, gone);
  if (shared.empty() || shared.size() > 2) return false;
  if (shared.size() == 2 && isBoundary(kept) && isBoundary(gone)) return false;
  std::vector<int> opposite;
  opposite.reserve(shared.size());
  for (int f : shared) opposite.push_back(apex(f, kept, gone));
  std::sort(opposite.begin(), opposite.end());
  if (opposite.size() == 2 && opposite[0] == opposite[1]) return false;
  const std::vector<int> a = neighbours(kept), b = neighbours(gone);
  std::vector<int> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  if (common != opposite) return false;
  // On a tetrahedron the condition holds and two faces would fall together.
  for (int f : facesAt(gone)) {
    const auto& t = triangle(f);
    if (std::find(t.begin(), t.end(), kept) != t.end()) continue;
    const int x = t[0] == gone ? t[1] : t[0], y = apex(f, gone, x);
    for (int g : facesOn(x, y))
      if (apex(g, x, y) == kept) return false;
  }
  for (int f : shared) remove(f);
  const std::vector<int> moved = facesAt(gone);
  for (int f : moved) {
    auto t = triangle(f);
    std::replace(t.begin(), t.end(), gone, kept);
    replace(f, t, origin(f));
  }
  return true;
}

bool SurfaceEditor::tryMove(int v, const Vec3& position) {
  std::vector<std::pair<bool, Vec3>> before;
  for (int f : facesAt(v)) before.emplace_back(isFlat(f), normal(mesh_, triangle(f)));
  const Vec3 old = std::exchange(mesh_.positions[at(v)], position);
  for (std::size_t n = 0; n < before.size(); ++n) {
    const int f = facesAt(v)[n];
    const Vec3 m = normal(mesh_, triangle(f)), &b = before[n].second;
    if (isFlat(f) || (!before[n].first && m[0] * b[0] + m[1] * b[1] + m[2] * b[2] <= 0.0)) {
      mesh_.positions[at(v)] = old;
      return false;
    }
  }
  return true;
}

std::vector<int> SurfaceEditor::takeTouched() {
  std::vector<int> faces = std::exchange(touched_, {});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  faces.erase(
      std::remove_if(faces.begin(), faces.end(), [&](int f) { return !isAlive(f) || !isFlat(f); }),
      faces.end());
  return faces;
}

MeshData SurfaceEditor::compact() const {
  MeshData out;
  out.positions = mesh_.positions;
  for (int f = 0; f < faceCount(); ++f)
    if (isAlive(f)) out.triangles.push_back(triangle(f));
  return out;
}

std::vector<int> SurfaceEditor::compactOrigins() const {
  std::vector<int> out;
  for (int f = 0; f < faceCount(); ++f)
    if (isAlive(f)) out.push_back(origin(f));
  return out;
}

std::vector<int> SurfaceEditor::aliveFaces() const {
  std::vector<int> out;
  for (int f = 0; f < faceCount(); ++f)
    if (isAlive(f)) out.push_back(f);
  return out;
}

}  // namespace hgp
