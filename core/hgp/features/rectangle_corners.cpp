#include "hgp/features/rectangle_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hgp/base/stable_order.h"

namespace hgp {
namespace {

/// Radians for which corners are spaced unevenly; see the header.
constexpr double kUneven = 0.25;
/// Share of the loop's length to either side within which its turning counts, less with the distance.
constexpr double kReach = 1.0 / 48.0;
/// Stretches of equal length, each with one candidate. As many vertices again, those that turn most, are candidates: a
/// narrow strip has two corners in one stretch.
constexpr int kStretches = 64;

/// A vertex that may become a corner.
struct Candidate {
  VertexId vertex;
  double place = 0.0;    ///< along the loop, from 0 to 1
  double turning = 0.0;  ///< T
};

PerVertex<double> turningsOf(const TriMesh& mesh, const Geometry& geometry) {
  PerVertex<double> turning(at(mesh.vertexCount()), kPi);
  for (HalfedgeId h : mesh.halfedges()) turning[mesh.tail(h)] -= geometry.cornerAngle[h];
  return turning;
}

/// The vertices of the loop. The window for T slides along; the loop is laid out three times.
std::vector<Candidate> verticesOf(const TriMesh& mesh, const Geometry& geometry,
                                  const BoundaryLoop& loop, const PerVertex<double>& turning) {
  const std::size_t n = loop.halfedges.size();
  std::vector<Candidate> all(n);
  double length = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    all[i] = {mesh.tail(loop.halfedges[i]), length, 0.0};
    length += geometry.length[loop.halfedges[i]];
  }
  for (Candidate& c : all) c.place /= length;
  const auto placeOf = [&](std::size_t j) {
    const std::size_t rounds = j / n;
    return all[j % n].place + static_cast<double>(rounds) - 1.0;
  };
  std::vector<double> sum(3 * n + 1, 0.0), moment(3 * n + 1, 0.0);  // of the turnings before j
  for (std::size_t j = 0; j < 3 * n; ++j) {
    const double turn = turning[all[j % n].vertex];
    sum[j + 1] = sum[j] + turn;
    moment[j + 1] = moment[j] + turn * placeOf(j);
  }
  for (std::size_t i = 0, low = 0, high = 0; i < n; ++i) {
    const double here = all[i].place;
    while (here - placeOf(low) > kReach) ++low;
    while (high < 3 * n && placeOf(high) - here <= kReach) ++high;
    const std::size_t self = i + n;
    const double before = sum[self] - sum[low], after = sum[high] - sum[self];
    const double weighed =
        (moment[self] - moment[low]) - here * before - (moment[high] - moment[self]) + here * after;
    all[i].turning = before + after + weighed / kReach;
  }
  return all;
}

std::vector<Candidate> candidatesOf(const TriMesh& mesh, const Geometry& geometry,
                                    const BoundaryLoop& loop) {
  const PerVertex<double> turning = turningsOf(mesh, geometry);
  const std::vector<Candidate> all = verticesOf(mesh, geometry, loop, turning);
  const std::vector<std::size_t> order = stableOrder(all.size(), [&](std::size_t a, std::size_t b) {
    return turning[all[a].vertex] > turning[all[b].vertex];
  });
  std::vector<char> isCandidate(all.size(), 0);
  for (std::size_t i = 0; i < order.size() && i < std::size_t{kStretches}; ++i)
    isCandidate[order[i]] = 1;
  for (std::size_t i = 0; i < all.size();) {
    const auto stretchOf = [&](std::size_t j) { return std::floor(all[j].place * kStretches); };
    std::size_t best = i, end = i + 1;
    for (; end < all.size() && stretchOf(end) == stretchOf(i); ++end)
      if (all[end].turning > all[best].turning) best = end;
    isCandidate[best] = 1;
    i = end;
  }
  std::vector<Candidate> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (isCandidate[i]) chosen.push_back(all[i]);
  return chosen;
}

double unevenness(double gap) {
  const double miss = 4.0 * gap - 1.0;
  return kUneven * miss * miss;
}

/// Ways through the candidates from a first one: value[c] is that of the best choice of so many corners that ends at c.
class Choice {
 public:
  explicit Choice(const std::vector<Candidate>& candidates) : all_(candidates) {}

  /// The best four corners of which `first` comes first.
  void tryFirst(std::size_t first) {
    const std::size_t n = all_.size();
    std::array<std::vector<double>, 4> value;
    std::array<std::vector<std::size_t>, 4> before;
    for (int i = 0; i < 4; ++i) {
      value[at(i)].assign(n, -std::numeric_limits<double>::infinity());
      before[at(i)].assign(n, first);
    }
    value[0][first] = all_[first].turning;
    for (std::size_t i = 1; i < 4; ++i)
      for (std::size_t c = first + i; c < n; ++c)
        for (std::size_t b = first + i - 1; b < c; ++b) {
          const double here =
              value[i - 1][b] + all_[c].turning - unevenness(all_[c].place - all_[b].place);
          if (here <= value[i][c]) continue;
          value[i][c] = here;
          before[i][c] = b;
        }
    for (std::size_t c = first + 3; c < n; ++c) {
      const double all = value[3][c] - unevenness(1.0 + all_[first].place - all_[c].place);
      if (all <= best_) continue;
      best_ = all;
      std::size_t corner = c;
      for (std::size_t i = 4; i-- > 0; corner = before[i][corner])
        corners_[i] = all_[corner].vertex;
    }
  }

  const std::array<VertexId, 4>& corners() const { return corners_; }

 private:
  const std::vector<Candidate>& all_;
  double best_ = -std::numeric_limits<double>::infinity();
  std::array<VertexId, 4> corners_{};
};

}  // namespace

std::optional<std::array<VertexId, 4>> rectangleCorners(const TriMesh& mesh,
                                                        const Geometry& geometry,
                                                        const BoundaryLoop& loop) {
  const std::vector<Candidate> candidates = candidatesOf(mesh, geometry, loop);
  if (candidates.size() < 4) return {};
  Choice choice(candidates);
  for (std::size_t first = 0; first + 3 < candidates.size(); ++first) choice.tryFirst(first);
  return choice.corners();
}

}  // namespace hgp
