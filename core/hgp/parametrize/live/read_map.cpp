#include "hgp/parametrize/live/read_map.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/mesh/face_flood.h"

namespace hgp::live {
namespace {

/// Largest difference of a corner from the seam conditions, relative to the size of the map.
constexpr double kSeamTolerance = 1e-6;

/// z ↦ e^{i2π turn/q} z + shift
struct Motion {
  int turn = 0;
  Complex shift = 0.0;
};

class Development {
 public:
  Development(const TriMesh& mesh, const SeamlessSetup& setup, const UvMap& map)
      : mesh_(mesh), setup_(setup), map_(map) {}

  std::vector<Complex> run() const {
    PerFace<char> isSeen(static_cast<std::size_t>(mesh_.faceCount()), 0);
    PerFace<Motion> motion(static_cast<std::size_t>(mesh_.faceCount()));
    isSeen[FaceId(0)] = 1;
    floodFaces(mesh_, FaceId(0), [&](HalfedgeId h, FaceId g) {
      if (setup_.cut.isSeam[mesh_.edge(h)] || isSeen[g]) return false;
      isSeen[g] = 1;
      motion[g] = across(motion[TriMesh::face(h)], h);
      return true;
    });
    std::vector<Complex> z(static_cast<std::size_t>(setup_.cut.vertexCount()));
    for (HalfedgeId h : mesh_.halfedges())
      z[at(setup_.cut.copy[h].i)] = moved(motion[TriMesh::face(h)], uv(h));
    return z;
  }

 private:
  Complex uv(HalfedgeId corner) const {
    const Vec2& p = map_.uv[at(map_.cornerUv[at(corner.i / 3)][at(corner.i % 3)])];
    return {p[0], p[1]};
  }
  Complex moved(const Motion& m, const Complex& z) const {
    return rotation(m.turn, setup_.seams.q) * z + m.shift;
  }
  Motion across(const Motion& here, HalfedgeId h) const {
    const HalfedgeId twin = mesh_.twin(h);
    const Complex a = uv(h), b = uv(TriMesh::next(h));
    const Complex there0 = uv(TriMesh::next(twin)), there1 = uv(twin);
    if (a == there0 && b == there1) return here;
    const int q = setup_.seams.q;
    const double angle = portable::arg((b - a) * std::conj(there1 - there0));
    Motion out{reduceTurn(here.turn + std::lround(angle * q / (2.0 * kPi)), q), 0.0};
    out.shift = moved(here, 0.5 * (a + b)) - rotation(out.turn, q) * (0.5 * (there0 + there1));
    return out;
  }

  const TriMesh& mesh_;
  const SeamlessSetup& setup_;
  const UvMap& map_;
};

}  // namespace

Result<Eigen::VectorXcd> readMap(const TriMesh& mesh, const SeamlessSetup& setup,
                                 const UvMap& map) {
  const std::vector<Complex> z = Development(mesh, setup, map).run();
  Eigen::VectorXcd x = readUnknowns(mesh, setup.cut, setup.seams, setup.unknowns, z);
  const Eigen::VectorXcd back = setup.unknowns.copies * x;
  double size = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    size = std::max(size, portable::abs(z[i] - z[0]));
    worst = std::max(worst, portable::abs(z[i] - back[static_cast<Eigen::Index>(i)]));
  }
  if (worst <= kSeamTolerance * size) return x;
  return Failure{
      ErrorCode::kUsage,
      "live",
      formatText("This map does not have the seams of its cones: they differ by %.3g of its size. "
                 "Solve again, then drag.",
                 worst / size),
      {}};
}

}  // namespace hgp::live
