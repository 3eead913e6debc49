#include "hgp/mesh/defects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "hgp/base/disjoint_sets.h"
#include "hgp/base/ids.h"
#include "hgp/base/phrase.h"
#include "hgp/base/stable_order.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/finite.h"

namespace hgp {
namespace {

using Triangles = std::vector<std::array<int, 3>>;
using Places = std::map<DefectKind, std::vector<Where>>;

Where faceAt(int f) { return {Where::Kind::kFace, f}; }
Where vertexAt(int v) { return {Where::Kind::kVertex, v}; }

/// Finds faces with invalid indices or positions, to which no other rule can be applied; returns 1 for each of them.
std::vector<char> findBrokenFaces(const MeshData& data, Places& places) {
  const auto vertexCount = static_cast<int>(data.positions.size());
  std::vector<char> isBroken(data.triangles.size(), 0);
  for (std::size_t f = 0; f < data.triangles.size(); ++f) {
    const auto& t = data.triangles[f];
    const bool isInRange =
        std::all_of(t.begin(), t.end(), [&](int v) { return v >= 0 && v < vertexCount; });
    const bool isRepeated = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (!isInRange) {
      places[DefectKind::kIndexOutOfRange].push_back(faceAt(static_cast<int>(f)));
    } else if (isRepeated) {
      places[DefectKind::kRepeatedVertex].push_back(faceAt(static_cast<int>(f)));
    }
    isBroken[f] = !isInRange || isRepeated;
  }
  return isBroken;
}

/// Finds the two vertices that are farthest apart along an axis if that distance is outside the limits. If all
/// positions are equal, the defect is faces without area instead.
void findExtent(const MeshData& data, const std::vector<char>& isUsed, Places& places) {
  double extent = 0.0;
  std::size_t ends[2] = {0, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t low = data.positions.size(), high = low;
    for (std::size_t v = 0; v < data.positions.size(); ++v) {
      const double x = data.positions[v][axis];
      if (!isUsed[v] || !std::isfinite(x)) continue;
      if (low == data.positions.size() || x < data.positions[low][axis]) low = v;
      if (high == data.positions.size() || x > data.positions[high][axis]) high = v;
    }
    if (low == data.positions.size()) continue;
    const double side = data.positions[high][axis] - data.positions[low][axis];
    if (side <= extent) continue;
    extent = side;
    ends[0] = low;
    ends[1] = high;
  }
  if (extent == 0.0 || (extent >= kSmallestExtent && extent <= kLargestExtent)) return;
  for (std::size_t v : ends) places[DefectKind::kExtent].push_back(vertexAt(static_cast<int>(v)));
}

void findVertexDefects(const MeshData& data, Places& places) {
  std::vector<char> isUsed(data.positions.size(), 0);
  for (const auto& t : data.triangles)
    for (int v : t)
      if (v >= 0 && v < static_cast<int>(data.positions.size())) isUsed[at(v)] = 1;
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    const Vec3& p = data.positions[v];
    if (!isUsed[v]) {
      places[DefectKind::kIsolatedVertex].push_back(vertexAt(static_cast<int>(v)));
    } else if (!isFinite(p)) {
      places[DefectKind::kNotFinite].push_back(vertexAt(static_cast<int>(v)));
    }
  }
  findExtent(data, isUsed, places);
}

void findDuplicates(const Triangles& triangles, const std::vector<char>& isBroken, int vertexCount,
                    Places& places) {
  // Bucketed by smallest vertex; within a bucket, faces with the same other two are equal.
  std::vector<int> bucket(at(vertexCount) + 1, 0);
  const auto smallest = [&](std::size_t f) {
    return *std::min_element(triangles[f].begin(), triangles[f].end());
  };
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (!isBroken[f]) ++bucket[at(smallest(f)) + 1];
  for (std::size_t v = 1; v < bucket.size(); ++v) bucket[v] += bucket[v - 1];
  struct Entry {
    int mid, high, face;
  };
  std::vector<Entry> entries(at(bucket.back()));
  std::vector<int> fill(bucket.begin(), bucket.end() - 1);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (isBroken[f]) continue;
    auto t = triangles[f];
    std::sort(t.begin(), t.end());
    entries[at(fill[at(t[0])]++)] = {t[1], t[2], static_cast<int>(f)};
  }
  auto& found = places[DefectKind::kDuplicateFace];
  for (int v = 0; v < vertexCount; ++v) {
    const auto first = entries.begin() + bucket[at(v)], last = entries.begin() + bucket[at(v) + 1];
    std::sort(first, last, [](const Entry& a, const Entry& b) {
      if (a.mid != b.mid) return a.mid < b.mid;
      return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    for (auto e = first; e != last; ++e)
      if (e != first && e->mid == (e - 1)->mid && e->high == (e - 1)->high)
        found.push_back(faceAt(e->face));
  }
  sortStably(found, [](const Where& a, const Where& b) { return a.id < b.id; });
}

/// Edges with the wrong number or direction of faces, and vertices with more than one fan. Faces
/// that meet along an edge belong to one fan however many they are, so that a bad edge is not
/// reported a second time as two bad vertices.
void findEdgeDefects(const Triangles& triangles, const std::vector<char>& isBroken, int vertexCount,
                     Places& places) {
  const EdgeTable table(triangles, isBroken, vertexCount);
  DisjointSets fans(static_cast<int>(3 * triangles.size()));
  std::vector<int> fanCount(at(vertexCount), 0);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int v : triangles[f])
      if (!isBroken[f]) ++fanCount[at(v)];

  const auto cornerAt = [&](int side, int v) {
    return sideTail(triangles, side) == v ? side : nextSide(side);
  };
  for (int e = 0; e < table.edgeCount(); ++e) {
    const auto [a, b] = table.vertices(e);
    const int* sides = table.begin(e);
    const int count = table.faceCount(e);
    for (int n = 1; n < count; ++n) {
      fanCount[at(a)] -= fans.join(cornerAt(sides[n - 1], a), cornerAt(sides[n], a));
      fanCount[at(b)] -= fans.join(cornerAt(sides[n - 1], b), cornerAt(sides[n], b));
    }
    const Where where{Where::Kind::kEdge, a, b};
    if (count > 2) {
      places[DefectKind::kNonManifoldEdge].push_back(where);
    } else if (count == 2 && sideTail(triangles, sides[0]) == sideTail(triangles, sides[1])) {
      places[DefectKind::kInconsistentEdge].push_back(where);
    }
  }
  for (int v = 0; v < vertexCount; ++v)
    if (fanCount[at(v)] > 1) places[DefectKind::kNonManifoldVertex].push_back(vertexAt(v));
}

const char* remedy(DefectKind kind) {
  switch (kind) {
    case DefectKind::kRepeatedVertex:
    case DefectKind::kZeroArea:
    case DefectKind::kDuplicateFace:
      return "degenerate";
    case DefectKind::kNonManifoldEdge:
    case DefectKind::kNonManifoldVertex:
      return "split";
    case DefectKind::kInconsistentEdge:
      return "orient";
    default:
      return nullptr;
  }
}

}  // namespace

bool hasNoArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 u, v;
  double scale = 0.0;
  for (std::size_t n = 0; n < 3; ++n) {
    u[n] = b[n] - a[n];
    v[n] = c[n] - a[n];
    scale = std::max(scale, std::max(std::abs(u[n]), std::abs(v[n])));
  }
  if (!(scale > 0.0) || !std::isfinite(scale)) return scale == 0.0;
  // Scaled by a power of two, which is exact, if fourth powers would be out of range.
  const int exponent = scale > 1e-60 && scale < 1e60 ? 0 : std::ilogb(scale);
  for (std::size_t n = 0; exponent != 0 && n < 3; ++n) {
    u[n] = std::scalbn(u[n], -exponent);
    v[n] = std::scalbn(v[n], -exponent);
  }
  const Vec3 cross{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const auto dot = [](const Vec3& p, const Vec3& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const double uu = dot(u, u), vv = dot(v, v);
  const double longest = std::max(std::max(uu, vv), uu + vv - 2 * dot(u, v));
  return std::sqrt(dot(cross, cross)) <= kZeroHeight * longest;
}

const char* defectName(DefectKind kind) {
  switch (kind) {
    case DefectKind::kIndexOutOfRange:
      return "index-out-of-range";
    case DefectKind::kNotFinite:
      return "not-finite";
    case DefectKind::kExtent:
      return "extent";
    case DefectKind::kRepeatedVertex:
      return "repeated-vertex";
    case DefectKind::kZeroArea:
      return "zero-area";
    case DefectKind::kDuplicateFace:
      return "duplicate-face";
    case DefectKind::kNonManifoldEdge:
      return "non-manifold-edge";
    case DefectKind::kInconsistentEdge:
      return "inconsistent-edge";
    case DefectKind::kNonManifoldVertex:
      return "non-manifold-vertex";
    case DefectKind::kIsolatedVertex:
      return "isolated-vertex";
  }
  return "unknown";
}

bool isFatal(DefectKind kind, bool allowsZeroArea) {
  if (kind == DefectKind::kZeroArea) return !allowsZeroArea;
  return kind != DefectKind::kIsolatedVertex;
}

std::vector<Defect> findDefects(const MeshData& data) {
  const auto vertexCount = static_cast<int>(data.positions.size());
  Places places;
  const std::vector<char> isBroken = findBrokenFaces(data, places);
  findVertexDefects(data, places);
  for (std::size_t f = 0; f < data.triangles.size(); ++f) {
    const auto& t = data.triangles[f];
    if (!isBroken[f] &&
        hasNoArea(data.positions[at(t[0])], data.positions[at(t[1])], data.positions[at(t[2])]))
      places[DefectKind::kZeroArea].push_back(faceAt(static_cast<int>(f)));
  }
  findDuplicates(data.triangles, isBroken, vertexCount, places);
  findEdgeDefects(data.triangles, isBroken, vertexCount, places);
  std::vector<Defect> defects;
  for (auto& [kind, where] : places)
    if (!where.empty()) defects.push_back({kind, std::move(where)});
  return defects;
}

Note noteOn(const Defect& defect, bool wasRepaired) {
  constexpr std::size_t kShown = 5;
  const std::size_t count = defect.where.size();
  Note note(std::string("defect-") + defectName(defect.kind), {{"count", count}});
  note.values.push_back({count == 1 ? "only" : "first", 1});
  if (count > kShown) note.values.push_back({"more", 1});
  if (wasRepaired) note.values.push_back({"repaired", 1});
  note.where.assign(defect.where.begin(),
                    defect.where.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, count)));
  return note;
}

Status requireUsable(const std::vector<Defect>& defects, bool allowsZeroArea) {
  Failure failure{ErrorCode::kUnsupported, "topology", "", {}};
  Notes found;
  std::string fixes;
  for (const Defect& defect : defects) {
    if (!isFatal(defect.kind, allowsZeroArea)) continue;
    found.push_back(noteOn(defect));
    failure.where.insert(failure.where.end(), defect.where.begin(), defect.where.end());
    const char* fix = remedy(defect.kind);
    if (!fix || fixes.find(fix) != std::string::npos) continue;
    if (!fixes.empty()) fixes.append(",");
    fixes.append(fix);
  }
  if (found.empty()) return Done{};
  failure.message = phraseDefects(found) + ".";
  if (!fixes.empty()) failure.advice.push_back(Note("repair-with", {{"fixes", fixes}}));
  return failure;
}

}  // namespace hgp
