#include <algorithm>
#include <numeric>
#include <queue>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/ids.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/repair/repair_steps.h"

namespace hgp {
namespace {

/// If fewer than one face in this many disagrees with the others, it is those faces that are wrong.
constexpr int kClearMajority = 4;

/// Edge of every side, for tables that are walked from face to face.
std::vector<int> edgeOfSide(const EdgeTable& table, std::size_t sideCount) {
  std::vector<int> edge(sideCount, -1);
  for (int e = 0; e < table.edgeCount(); ++e)
    for (const int* s = table.begin(e); s != table.end(e); ++s) edge[at(*s)] = e;
  return edge;
}

/// A set of faces connected over edges with exactly two faces.
struct OrientedComponent {
  std::vector<int> faces;
  bool isClosed = true;
  bool isOneSided = false;
};

/// Traverses one component; isFlipped[f] says which faces to flip so that all agree with the first.
OrientedComponent walkComponent(const MeshData& mesh, const EdgeTable& table,
                                const std::vector<int>& edge, int seed, std::vector<char>& isSeen,
                                std::vector<char>& isFlipped) {
  OrientedComponent component;
  std::queue<int> queue;
  queue.push(seed);
  isSeen[at(seed)] = 1;
  while (!queue.empty()) {
    const int f = queue.front();
    queue.pop();
    component.faces.push_back(f);
    for (int s = 3 * f; s < 3 * f + 3; ++s) {
      const int e = edge[at(s)];
      if (e < 0 || table.faceCount(e) != 2) {
        component.isClosed = false;
        continue;
      }
      const int other = table.begin(e)[0] == s ? table.begin(e)[1] : table.begin(e)[0];
      const bool isSameWay = sideTail(mesh.triangles, s) == sideTail(mesh.triangles, other);
      const int g = other / 3;
      const char wanted = static_cast<char>(isFlipped[at(f)] != isSameWay);
      if (isSeen[at(g)]) {
        if (isFlipped[at(g)] != wanted) component.isOneSided = true;
        continue;
      }
      isSeen[at(g)] = 1;
      isFlipped[at(g)] = wanted;
      queue.push(g);
    }
  }
  return component;
}

double signedVolume(const MeshData& mesh, const std::vector<int>& faces,
                    const std::vector<char>& isFlipped) {
  // Relative to one of the component's vertices, to avoid cancellation far from the origin.
  const Vec3 o = mesh.positions[at(mesh.triangles[at(faces[0])][0])];
  double volume = 0.0;
  for (int f : faces) {
    Vec3 p[3];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t n = 0; n < 3; ++n)
        p[k][n] = mesh.positions[at(mesh.triangles[at(f)][k])][n] - o[n];
    const double six = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                       p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                       p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    volume += isFlipped[at(f)] ? -six : six;
  }
  return volume;
}

bool hasIndexOutOfRange(const MeshData& mesh) {
  const auto vertexCount = static_cast<int>(mesh.positions.size());
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return v < 0 || v >= vertexCount; });
  });
}

}  // namespace

int orientFaces(FixResult& result, bool isCutLater) {
  MeshData& mesh = result.mesh;
  std::vector<char> isSkipped(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    const auto& t = mesh.triangles[f];
    isSkipped[f] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  const EdgeTable table(mesh.triangles, isSkipped, static_cast<int>(mesh.positions.size()));
  const std::vector<int> edge = edgeOfSide(table, 3 * mesh.triangles.size());
  std::vector<char> isSeen = isSkipped, isFlipped(mesh.triangles.size(), 0);
  int flippedCount = 0, oneSidedCount = 0;
  for (std::size_t seed = 0; seed < isSeen.size(); ++seed) {
    if (isSeen[seed]) continue;
    const OrientedComponent component =
        walkComponent(mesh, table, edge, static_cast<int>(seed), isSeen, isFlipped);
    if (component.isOneSided) {
      ++oneSidedCount;
      if (!isCutLater) continue;
    }
    const auto turned = std::count_if(component.faces.begin(), component.faces.end(),
                                      [&](int f) { return isFlipped[at(f)] != 0; });
    const auto count = static_cast<std::ptrdiff_t>(component.faces.size());
    const bool isMixed = kClearMajority * std::min(turned, count - turned) > count;
    const bool isInsideOut = component.isClosed && isMixed
                                 ? signedVolume(mesh, component.faces, isFlipped) < 0.0
                                 : 2 * turned > count;
    for (int f : component.faces) {
      if ((isFlipped[at(f)] != 0) == isInsideOut) continue;
      std::swap(mesh.triangles[at(f)][1], mesh.triangles[at(f)][2]);
      ++flippedCount;
    }
  }
  if (flippedCount > 0) result.notes.push_back(Note("repair-turned", {{"faces", flippedCount}}));
  if (oneSidedCount > 0 && !isCutLater)
    result.notes.push_back(Note("repair-one-sided-left", {{"components", oneSidedCount}}));
  return oneSidedCount;
}

FixResult fixDefects(const MeshData& data, const FixOptions& options) {
  FixResult result;
  result.mesh = data;
  result.faceOrigin.resize(data.triangles.size());
  result.vertexOrigin.resize(data.positions.size());
  std::iota(result.faceOrigin.begin(), result.faceOrigin.end(), 0);
  std::iota(result.vertexOrigin.begin(), result.vertexOrigin.end(), 0);
  if (hasIndexOutOfRange(data)) {
    result.notes.push_back(Note("repair-none"));
    return result;
  }
  if (options.degenerate) leaveOut(result);
  int oneSided = 0;
  if (options.orient) oneSided = orientFaces(result, options.split);
  if (options.split) splitNonManifold(result, oneSided);
  return result;
}

}  // namespace hgp
