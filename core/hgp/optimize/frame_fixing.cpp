#include "hgp/optimize/frame_fixing.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"

namespace hgp {
namespace {

/// Angles at the cone, as the map has them, moved by one common step onto the asked sum and kept
/// inside (0, π): the closest point in the least-squares sense when no bound is active.
std::vector<double> fittedAngles(std::vector<double> angles, double sum) {
  const double n = static_cast<double>(angles.size());
  const double least = 0.05 * sum / n, most = std::min(0.98 * kPi, 20.0 * sum / n);
  for (int pass = 0; pass < 50; ++pass) {
    double have = 0.0;
    for (double a : angles) have += a;
    const double step = (sum - have) / n;
    if (std::abs(step) < 1e-14) break;
    for (double& a : angles) a = std::clamp(a + step, least, most);
  }
  return angles;
}

}  // namespace

void embedConeRing(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                   const SeamRotations& seams, const std::vector<Complex>& z, VertexId cone, int k,
                   Frames& frames) {
  std::vector<HalfedgeId> spokes;
  std::vector<double> angles, lengths;
  const auto at = [&](HalfedgeId h) { return z[static_cast<std::size_t>(cut.copy[h].i)]; };
  for (HalfedgeId h : outgoingHalfedges(mesh, cone)) {
    spokes.push_back(h);
    const Complex a = at(TriMesh::next(h)) - at(h), b = at(TriMesh::previous(h)) - at(h);
    angles.push_back(std::abs(std::arg(std::conj(a) * b)));
    lengths.push_back(std::abs(a));
  }
  angles = fittedAngles(angles, turnAngle(k, seams.q));

  // Lay the ring down from the first triangle as the map has it: `heading` is the angle of the
  // spoke in that triangle's uv; crossing to the next triangle the uv turns by the seam rotation.
  double heading = std::arg(at(TriMesh::next(spokes[0])) - at(spokes[0]));
  int turn = 0;
  for (std::size_t n = 0; n < spokes.size(); ++n) {
    const HalfedgeId h = spokes[n];
    if (n > 0) turn += seams.rotation[mesh.twin(h)];
    const FaceId f = TriMesh::face(h);
    const double own = heading + turnAngle(turn, seams.q);
    const double next = lengths[(n + 1) % spokes.size()];
    std::array<Complex, 3> corner;
    const auto slot = static_cast<std::size_t>(h.i % 3);
    corner[slot] = 0.0;
    corner[(slot + 1) % 3] = std::polar(lengths[n], own);
    corner[(slot + 2) % 3] = std::polar(next, own + angles[n]);
    const LinearParts parts = linearParts(geometry, f);
    Complex similarity = 0.0;
    for (std::size_t c = 0; c < 3; ++c) similarity += parts.similarity[c] * corner[c];
    const auto found = std::lower_bound(frames.faces.begin(), frames.faces.end(), f);
    HGP_CHECK(found != frames.faces.end() && *found == f, "the ring of a cone is constrained");
    frames.angles[static_cast<std::size_t>(found - frames.faces.begin())] = -std::arg(similarity);
    heading += angles[n];
  }
}

}  // namespace hgp
