// The map of all components on the file's own triangles, as it will be stored, and its certificates.
// Role: what is certified is what is stored.
#pragma once

#include "hgp/api/model.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// A map per component (on component faces) with its prescription.
struct ComponentMap {
  UvMap map;
  std::vector<VertexId> copyOf;  ///< uv → component vertex
  CompleteSpec spec;
  Certificate certificate;  ///< of `map`, in double precision
  double shiftUnit = 0;     ///< 0, or a power of two that every shift must be a multiple of
  bool isKept = false;      ///< uv of the input file: neither moved nor scaled
  std::string whyNone;      ///< of a stand-in (stand_in.h): why there is no map; never certified
};

/// Adds the reason that this is not the prescribed map.
void denyCertificate(const std::string& whyNone, Certificate& certificate);

struct StoredMap {
  UvMap map;                              ///< on the surface's triangles, as stored
  std::vector<std::uint32_t> uvToVertex;  ///< uv → surface vertex
  std::vector<Certificate> certificates;  ///< per component, of the stored values
  std::vector<std::string> notes;
  bool isCertified = false;
};

/// The document whose numbers a map is rounded to: triangle by triangle that of the model.
struct StorePlace {
  const io::Document& document;
  int surface = 0;
};

/// Packs the components beside each other, scales, rounds as the format does and verifies. Components
/// are independent: one that was certified and that rounding breaks is tried around the origin, then
/// with other factors; the others stay as they are. Shifts are multiples of powers of two.
StoredMap storeMap(const Model& model, const std::vector<ComponentMap>& components, Scale scale);
StoredMap storeMap(const Model& model, const StorePlace& place,
                   const std::vector<ComponentMap>& components, Scale scale);

/// No packing, scaling or snapping: the map as `place` rounds it, verified; nothing changes where it has such
/// numbers already.
StoredMap certifyAsItIs(const Model& model, const StorePlace& place,
                        const std::vector<ComponentMap>& components, const UvMap& map);

/// The distance between neighbouring float32 around the largest |u|, |v| or |1 − v| of a component: glTF
/// stores u and 1 − v, and its writer rounds each component to one grid.
double gridStep(const UvMap& map);

/// A map on the surface's triangles as one component sees it, with uv numbers of its own.
UvMap mapOfComponent(const ModelComponent& component, const UvMap& surfaceMap);

/// The uv indices of both sides of a seam edge, corresponding ends first.
struct SeamEnds {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
};
SeamEnds seamEnds(const ModelComponent& component, const UvMap& surfaceMap, EdgeId edge);

}  // namespace hgp::api
