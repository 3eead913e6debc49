// Frames that follow the triangles of another metric.  Role: where those of the connection on S contradict each
// other or give a map with wrong angles [BCW17 §7.1 generalised].
#pragma once

#include <memory>

#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

/// The prescription's trivial connection on triangles of the given shapes, its direction in each carried back to S by
/// the similarity nearest to the map from S's triangle to the other. All edges weigh alike. Null where its seams would
/// rotate otherwise, or a triangle is too thin for float64.
/// @param length  per halfedge, as geometryOfShapes
std::shared_ptr<const SeamRotations> framesOfShapes(const TriMesh& mesh, const SeamlessSetup& setup,
                                                    const PerHalfedge<double>& length);

/// Triangles with the angles of the prescription's angleStructure: at cones that metric is flat already, so that only
/// handles and boundaries turn. Null where there is no structure.
std::shared_ptr<const SeamRotations> framesOfAngles(const TriMesh& mesh,
                                                    const SeamlessSetup& setup);

/// framesOfAngles, found when first asked for.
class AngleFrames {
 public:
  /// Null where the prescription has no angle structure.
  std::shared_ptr<const SeamRotations> get(const TriMesh& mesh, const SeamlessSetup& setup);

 private:
  bool isKnown_ = false;
  std::shared_ptr<const SeamRotations> frames_;
};

/// Triangles of a map, which may have other cones than asked: frames turn as the map does, but for the difference,
/// which is spread as evenly as the surface allows.
/// @param z  per copy
std::shared_ptr<const SeamRotations> framesOfMap(const TriMesh& mesh, const SeamlessSetup& setup,
                                                 const std::vector<Complex>& z);

}  // namespace hgp
