#include "hgp/features/rectangle_corners.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace hgp {
namespace {

/// Radians for which corners are spaced unevenly; see the header.
constexpr double kUneven = 0.25;
/// Share of the loop's length to either side within which its turning counts, less with the distance.
constexpr double kReach = 1.0 / 48.0;
/// Stretches of equal length, each with one candidate.
constexpr int kStretches = 96;

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

/// Of every stretch the vertex with the largest turning, in the order of the loop.
std::vector<Candidate> candidatesOf(const TriMesh& mesh, const Geometry& geometry,
                                    const BoundaryLoop& loop) {
  const PerVertex<double> turning = turningsOf(mesh, geometry);
  const std::size_t n = loop.halfedges.size();
  std::vector<double> place(n, 0.0);
  double length = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = length;
    length += geometry.length[loop.halfedges[i]];
  }
  for (double& p : place) p /= length;
  std::vector<Candidate> best(at(kStretches));
  for (std::size_t i = 0; i < n; ++i) {
    const VertexId v = mesh.tail(loop.halfedges[i]);
    double around = turning[v];
    for (const std::size_t step : {std::size_t{1}, n - 1}) {
      double walked = 0.0;
      for (std::size_t j = i, k = 1; k < n; ++k) {
        const std::size_t next = (j + step) % n;
        const double gap = std::abs(place[next] - place[j]);
        walked += std::min(gap, 1.0 - gap);
        if (walked > kReach) break;
        around += (1.0 - walked / kReach) * turning[mesh.tail(loop.halfedges[next])];
        j = next;
      }
    }
    Candidate& stretch =
        best[std::min(at(kStretches - 1), static_cast<std::size_t>(place[i] * kStretches))];
    if (!stretch.vertex.isValid() || around > stretch.turning) stretch = {v, place[i], around};
  }
  std::erase_if(best, [](const Candidate& c) { return !c.vertex.isValid(); });
  return best;
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
