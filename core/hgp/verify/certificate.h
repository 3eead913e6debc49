// The verifier: measures a map and decides whether it is certified.  Role: hypotheses and conclusion of
// [BCW17 Thm 6.1], Def. C.1. Shares no code with the method; its input is a mesh, the prescription and uv. Threads may call it at once.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/topology.h"
#include "hgp/verify/angles.h"
#include "hgp/verify/distortion.h"
#include "hgp/verify/exact_seams.h"
#include "hgp/verify/features.h"
#include "hgp/verify/overlap.h"
#include "hgp/verify/reason.h"
#include "hgp/verify/seams.h"
#include "hgp/verify/thresholds.h"

namespace hgp {

/// Facts first, verdict last. Facts that could not be measured keep their defaults.
struct Certificate {
  int vertexCount = 0, edgeCount = 0, faceCount = 0;  ///< vertices that have faces
  int componentCount = 0, genus = 0, loopCount = 0, eulerCharacteristic = 0;
  int q = 0;
  Precision precision = Precision::kFloat64;
  Thresholds thresholds;
  OrientationFacts orientation;
  AngleFacts angles;
  SeamFacts seams;
  ExactSeamFacts exactSeams;  ///< reported; the verdict does not depend on it
  FeatureFacts features;      ///< of the prescribed features
  DistortionFacts distortion;
  OverlapFacts overlap;  ///< reported; certify() leaves it empty, the API fills it (measureOverlap)
  /// Gauss–Bonnet from measured integers: Σ(q − k) + Σl = q(2c − 2g − m).
  long long gaussBonnetHave = 0, gaussBonnetNeed = 0;

  bool isMeasured = false;   ///< uv were well formed and finite, so the facts above are there
  bool isCertified = false;  ///< every rule holds; then `reasons` is empty
  bool isUsable = false;     ///< areaSpan is above the machine epsilon of `precision`
  std::vector<Reason> reasons;
};

/// Certifies maps of one mesh. Never fails: for a map that cannot be measured, the certificate says so.
///
/// Certified means: there are triangles, and every one has positive signed area (exact sign); every interior
/// angle sum is 2πk/q with the prescribed k (k = q where no cone is listed); every given turning index and
/// handle rotation is as prescribed; the sides of every seam edge differ by a rotation by a multiple of 2π/q; all
/// within `Thresholds`; every prescribed feature edge is exactly straight; and the areas span no more than the number type resolves. Empty
/// optionals are measured and not compared; handles are measured on connected surfaces only.
class Verifier {
 public:
  /// Computes what depends only on the mesh. Keeps a reference to it.
  explicit Verifier(const TriMesh& mesh);
  Certificate certify(const HolonomySpec& asked, const UvMap& map,
                      const CertifyOptions& options = {}) const;

 private:
  const TriMesh& mesh_;
  Topology topology_;
  std::vector<DualLoop> generators_;  ///< none where they are not measured
};

/// Whether these certificates, one per component, certify a whole map: there is at least one, and all are certified.
/// Nothing else decides this.
bool areCertified(const std::vector<Certificate>& components);

/// One map, measured and certified.
Certificate certify(const TriMesh& mesh, const HolonomySpec& asked, const UvMap& map,
                    const CertifyOptions& options = {});
Certificate certify(const TriMesh& mesh, const CompleteSpec& asked, const UvMap& map,
                    const CertifyOptions& options = {});

}  // namespace hgp
