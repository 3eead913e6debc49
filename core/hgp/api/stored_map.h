// The map of all components on the file's own triangles, as it will be stored, and its certificates.
// Role: certify what is shipped.
#pragma once

#include "hgp/api/model.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// A map per component (on component faces) with what was asked of it.
struct ComponentMap {
  UvMap map;
  std::vector<VertexId> copyOf;  ///< uv → component vertex
  CompleteSpec spec;
  Certificate certificate;  ///< of `map`, in double precision
};

struct StoredMap {
  UvMap map;                              ///< on the surface's triangles, as stored
  std::vector<std::uint32_t> uvToVertex;  ///< uv → surface vertex
  std::vector<Certificate> certificates;  ///< per component, of the stored values
  std::vector<std::string> notes;
  bool isCertified = false;
};

/// Sets the components side by side, scales, rounds as the format does and judges. When rounding breaks
/// a component that was certified, other scales and origins are tried before the verdict stands.
/// @param wasCertified  the components were certified before rounding: worth trying again
StoredMap storeMap(const Model& model, const std::vector<ComponentMap>& components, Scale scale,
                   bool wasCertified);

/// The distance between neighbouring float32 around the largest |u|, |v| or |1 − v| of a map: glTF
/// stores u and 1 − v, and its writer rounds all of a map to one grid.
double gridStep(const UvMap& map);

/// A map on the surface's triangles as component `p` sees it. A face made by a repair takes, at each
/// corner, a uv of that vertex from the faces beside it.
UvMap mapOfComponent(const Model& model, const ModelComponent& component, const UvMap& surfaceMap);

/// The uv indices of both sides of a seam edge, corresponding ends first.
struct SeamEnds {
  int a[2] = {-1, -1};
  int b[2] = {-1, -1};
};
SeamEnds seamEnds(const Model& model, const ModelComponent& component, const UvMap& surfaceMap,
                  EdgeId edge);

}  // namespace hgp::api
