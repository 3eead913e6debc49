#include "hgp/optimize/frame_fixing.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// A one-ring to be embedded in the plane: halfedges leaving the centre, counterclockwise, each with its length and
/// the angle of the corner after it.
struct Ring {
  std::vector<HalfedgeId> spokes;
  std::vector<double> angles, lengths;
};

/// Bounds of an angle relative to the mean one, and the largest: the triangle over it has an area, and its edges'
/// lengths are those of the wrong map, which a sharper or flatter corner would make a needle.
constexpr double kMinOfMean = 0.05, kMaxOfMean = 20.0, kMaxAngle = 0.98 * kPi;
/// Every pass moves what the bounds took to the angles that are not at theirs; the sum is exact to rounding after few.
constexpr int kFitPasses = 50;
constexpr double kFitted = 1e-14;

/// Changes all angles by the same amount to the prescribed sum, within (0, π): the least-squares projection
/// when no bound is active.
void fitAngles(std::vector<double>& angles, double sum) {
  const double n = static_cast<double>(angles.size());
  const double least = kMinOfMean * sum / n, most = std::min(kMaxAngle, kMaxOfMean * sum / n);
  for (int pass = 0; pass < kFitPasses; ++pass) {
    double have = 0.0;
    for (double a : angles) have += a;
    const double step = (sum - have) / n;
    if (std::abs(step) < kFitted) break;
    for (double& a : angles) a = std::clamp(a + step, least, most);
  }
}

/// Frame angle of each face of the ring if the first spoke of the first face has uv angle
/// `heading`; uv are rotated by the seam rotation from one face to the next.
std::vector<double> ringFrames(const TriMesh& mesh, const Geometry& geometry,
                               const SeamRotations& seams, const Ring& ring, double heading) {
  std::vector<double> frames;
  int turn = 0;
  for (std::size_t n = 0; n < ring.spokes.size(); ++n) {
    const HalfedgeId h = ring.spokes[n];
    if (n > 0) turn += seams.rotation[mesh.twin(h)];
    const double own = heading + turnAngle(turn, seams.q);
    std::array<Complex, 3> corner;
    const auto slot = static_cast<std::size_t>(h.i % 3);
    corner[slot] = 0.0;
    corner[(slot + 1) % 3] = portable::polar(ring.lengths[n], own);
    corner[(slot + 2) % 3] =
        portable::polar(ring.lengths[(n + 1) % ring.spokes.size()], own + ring.angles[n]);
    const LinearParts parts = linearParts(geometry, TriMesh::face(h));
    Complex similarity = 0.0;
    for (std::size_t c = 0; c < 3; ++c) similarity += parts.similarity[c] * corner[c];
    frames.push_back(-portable::arg(similarity));
    heading += ring.angles[n];
  }
  return frames;
}

double& frameOf(Frames& frames, FaceId f) {
  const auto found = std::lower_bound(frames.faces.begin(), frames.faces.end(), f);
  HGP_CHECK(found != frames.faces.end() && *found == f, "the ring of a cone is constrained");
  return frames.angles[static_cast<std::size_t>(found - frames.faces.begin())];
}

}  // namespace

bool holdsRing(const TriMesh& mesh, const Frames& frames, VertexId cone) {
  for (HalfedgeId h : outgoingHalfedges(mesh, cone))
    if (!std::binary_search(frames.faces.begin(), frames.faces.end(), TriMesh::face(h)))
      return false;
  return true;
}

void embedConeRing(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                   const SeamRotations& seams, const std::vector<Complex>& z, VertexId cone, int k,
                   Frames& frames) {
  Ring ring;
  const auto at = [&](HalfedgeId h) { return z[static_cast<std::size_t>(cut.copy[h].i)]; };
  for (HalfedgeId h : outgoingHalfedges(mesh, cone)) {
    const Complex a = at(TriMesh::next(h)) - at(h), b = at(TriMesh::previous(h)) - at(h);
    ring.spokes.push_back(h);
    ring.angles.push_back(std::abs(portable::arg(std::conj(a) * b)));
    ring.lengths.push_back(portable::abs(a));
  }
  fitAngles(ring.angles, turnAngle(k, seams.q));
  const HalfedgeId first = ring.spokes[0];
  const double heading = portable::arg(at(TriMesh::next(first)) - at(first));
  const std::vector<double> laid = ringFrames(mesh, geometry, seams, ring, heading);
  for (std::size_t n = 0; n < laid.size(); ++n)
    frameOf(frames, TriMesh::face(ring.spokes[n])) = laid[n];
}

}  // namespace hgp
