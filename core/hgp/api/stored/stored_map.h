// The map of all components on the triangles of the file, as it will be stored, and its certificates.
// Role: ensures that the stored numbers themselves are certified.
#pragma once

#include "hgp/api/stored/component_map.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/reflection.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// The map of one component, on the component's faces, with its prescription.
struct ComponentMap {
  UvMap map;
  std::vector<VertexId> copyOf;  ///< uv → component vertex
  CompleteSpec spec;
  Certificate certificate;  ///< of `map`, in double precision
  double shiftUnit = 0;     ///< 0, or a power of two of which every shift must be a multiple
  bool isKept = false;      ///< uv of the input file: neither moved nor scaled
  std::string whyNone;      ///< of a stand-in (stand_in.h): why there is no map; never certified
  std::shared_ptr<const Mirror> mirror = {};  ///< of which `map` is symmetric
};

/// Makes the certificate negative and adds the reason: this is not the prescribed map.
void denyCertificate(const std::string& whyNone, Certificate& certificate);

struct StoredMap {
  UvMap map;                              ///< on the surface's triangles, as stored
  std::vector<std::uint32_t> uvToVertex;  ///< uv → surface vertex
  std::vector<Certificate> certificates;  ///< per component, of the stored values
  Notes notes;
  bool isCertified = false;
};

/// The document to whose number format a map is rounded. It has the same triangles, in order, as the model.
struct StorePlace {
  const io::Document& document;
  int surface = 0;
};

/// Packs the components side by side, scales them, rounds them as the format does and verifies them. Components
/// are independent: if rounding breaks one that was certified, it is moved to the origin and then scaled by
/// other factors, while the others stay. Shifts are multiples of powers of two.
StoredMap storeMap(const Model& model, const std::vector<ComponentMap>& components, Scale scale);
StoredMap storeMap(const Model& model, const StorePlace& place,
                   const std::vector<ComponentMap>& components, Scale scale);

/// The map rounded to the numbers of `place` and verified, without packing, scaling or snapping; a map that already
/// has such numbers does not change.
StoredMap certifyAsItIs(const Model& model, const StorePlace& place,
                        const std::vector<ComponentMap>& components, const UvMap& map);

/// The uv indices of both sides of a seam edge, in corresponding order.
struct SeamEnds {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
};
SeamEnds seamEnds(const ModelComponent& component, const UvMap& surfaceMap, EdgeId edge);

}  // namespace hgp::api
