// Frames that follow the triangles of another metric.  Role: used where the connection's frames contradict each
// other or give a map with wrong angles [BCW17 §7.1 generalised to all triangles].
#pragma once

#include <memory>

#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

/// The prescription's trivial connection on triangles of the given shapes (all edges have the same weight); the
/// direction in each is carried back to S by the similarity that is nearest to the affine map of the triangles. Null
/// where the seam rotations would differ, or a triangle is too thin for float64.
/// @param length  per halfedge, as geometryOfShapes
std::shared_ptr<const SeamRotations> framesOfShapes(const TriMesh& mesh, const SeamlessSetup& setup,
                                                    const PerHalfedge<double>& length);

/// framesOfShapes for triangles with the angles of the prescription's angleStructure. That metric already has the
/// prescribed cone angles, so that only handles and boundaries need adjustment. Null where there is no structure.
std::shared_ptr<const SeamRotations> framesOfAngles(const TriMesh& mesh,
                                                    const SeamlessSetup& setup);

/// framesOfAngles, computed on the first call of get().
class AngleFrames {
 public:
  /// Null where the prescription has no angle structure.
  std::shared_ptr<const SeamRotations> get(const TriMesh& mesh, const SeamlessSetup& setup);

 private:
  bool isKnown_ = false;
  std::shared_ptr<const SeamRotations> frames_;
};

/// framesOfShapes for the triangles of a map, whose cone angles may differ from the prescribed ones: frames turn as the
/// map does; the difference of the angles is spread as evenly as possible.
/// @param z  per copy
std::shared_ptr<const SeamRotations> framesOfMap(const TriMesh& mesh, const SeamlessSetup& setup,
                                                 const std::vector<Complex>& z);

}  // namespace hgp
