#include "hgp/quads/unfold.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"
#include "hgp/quads/quad_shapes.h"
#include "hgp/quads/surface_walk.h"

namespace hgp {
namespace {

constexpr int kPasses = 12;
/// Quads whose scaled Jacobian is above this are not improved further.
constexpr double kGood = 0.15;
/// Lengths of the walks that are tried, as fractions of the mean edge at the vertex.
constexpr double kSteps[] = {0.08, 0.2, 0.4, 0.7};
constexpr double kHalf = 0.5, kSlant = 0.86602540378443864676;
constexpr std::array<double, 2> kDirections[] = {
    {1, 0},  {kSlant, kHalf},   {kHalf, kSlant},   {0, 1},  {-kHalf, kSlant}, {-kSlant, kHalf},
    {-1, 0}, {-kSlant, -kHalf}, {-kHalf, -kSlant}, {0, -1}, {kHalf, -kSlant}, {kSlant, -kHalf}};

class Unfolding {
 public:
  Unfolding(const TriMesh& mesh, QuadMesh& quads) : mesh_(mesh), quads_(quads) {
    quadsAt_.resize(quads.positions.size());
    for (std::size_t n = 0; n < quads.quads.size(); ++n)
      for (const int v : quads.quads[n]) quadsAt_[at(v)].push_back(static_cast<int>(n));
  }

  void run() {
    for (int pass = 0; pass < kPasses; ++pass) {
      std::vector<int> near;
      for (std::size_t n = 0; n < quads_.quads.size(); ++n) {
        if (!(scaledJacobian(quads_, static_cast<int>(n)) > 0.0))
          near.insert(near.end(), quads_.quads[n].begin(), quads_.quads[n].end());
      }
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      bool isChanged = false;
      for (const int v : near)
        if (mayMove(v)) isChanged = move(v) || isChanged;
      if (!isChanged) return;
    }
  }

 private:
  /// Of the quads at one vertex.
  struct Score {
    int folded = 0, inverted = 0;
    double penalty = 0.0;
  };

  Score scoreAt(int v) const {
    Score out;
    for (const int n : quadsAt_[at(v)]) {
      const double shape = scaledJacobian(quads_, n);
      out.folded += !(shape > 0.0);
      out.inverted += isAgainstSurface(n);
      const double lack = std::max(0.0, kGood - shape);
      out.penalty += lack * lack;
    }
    return out;
  }
  bool isAgainstSurface(int n) const {
    const auto& q = quads_.quads[at(n)];
    const auto& p = quads_.positions;
    const Vec3 normal =
        cross(subtract(p[at(q[2])], p[at(q[0])]), subtract(p[at(q[3])], p[at(q[1])]));
    Vec3 sum{};
    for (const int v : q) sum = add(sum, quads_.normals[at(v)]);
    return !(dot(normal, sum) > 0.0);
  }

  /// Inside, no cone, and on no feature: every neighbour is one of two quads at the vertex.
  bool mayMove(int v) const {
    if (quads_.coneVertex[at(v)] >= 0 || quads_.isOnFeature[at(v)] != 0) return false;
    std::map<int, int> uses;
    for (const int n : quadsAt_[at(v)]) {
      const auto& q = quads_.quads[at(n)];
      const auto k = static_cast<std::size_t>(std::find(q.begin(), q.end(), v) - q.begin());
      ++uses[q[(k + 1) % 4]];
      ++uses[q[(k + 3) % 4]];
    }
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
  }
  double meanEdge(int v) const {
    double sum = 0.0;
    for (const int n : quadsAt_[at(v)]) {
      const auto& q = quads_.quads[at(n)];
      const auto k = static_cast<std::size_t>(std::find(q.begin(), q.end(), v) - q.begin());
      sum += distance(quads_.positions[at(v)], quads_.positions[at(q[(k + 1) % 4])]);
    }
    return sum / static_cast<double>(quadsAt_[at(v)].size());
  }

  void put(int v, const SurfacePoint& p) {
    quads_.positions[at(v)] = p.position;
    quads_.normals[at(v)] = p.normal;
    quads_.face[at(v)] = p.face;
  }

  /// To the best place around it, if one is better.
  bool move(int v) {
    const SurfacePoint start{quads_.face[at(v)], quads_.positions[at(v)], quads_.normals[at(v)]};
    const Score before = scoreAt(v);
    Score best = before;
    SurfacePoint place = start;
    const double edge = meanEdge(v);
    for (const double step : kSteps)
      for (const auto& direction : kDirections) {
        const auto p = walkStraight(mesh_, start, direction, step * edge);
        if (!p) continue;
        put(v, *p);
        const Score score = scoreAt(v);
        if (score.inverted > before.inverted || score.folded > best.folded) continue;
        if (score.folded == best.folded && !(score.penalty < best.penalty)) continue;
        best = score;
        place = *p;
      }
    put(v, place);
    return best.folded < before.folded || best.penalty < 0.999 * before.penalty;
  }

  const TriMesh& mesh_;
  QuadMesh& quads_;
  std::vector<std::vector<int>> quadsAt_;
};

}  // namespace

int unfoldInSpace(const TriMesh& mesh, QuadMesh& quads) {
  const int before = countFoldedInSpace(quads);
  if (before == 0) return 0;
  Unfolding(mesh, quads).run();
  return before - countFoldedInSpace(quads);
}

}  // namespace hgp
