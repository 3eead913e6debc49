#include "hgp/api/stored/stored_map.h"

#include <algorithm>
#include <cmath>

#include "hgp/api/stored/outside.h"
#include "hgp/api/stored/pack_components.h"
#include "hgp/api/stored/polygon_facts.h"
#include "hgp/api/stored/snap_components.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/portable_math.h"

namespace hgp::api {
namespace {

// Factors to try, in this order, if rounding to float32 breaks a component; each also moves it to the origin.
// 0 stands for the power of two that scales it to 64 to 128 units: v is stored as 1 − v, so a small component
// would lose digits.
constexpr double kRetryFactors[] = {1.0,    0.0,    1.1875, 1.375,  1.625,
                                    1.8125, 0.9375, 1.0625, 1.53125};

/// The transformation of a component before it is stored: uv ↦ factor · uv + shift.
struct Placement {
  double factor = 1;
  Vec2 shift{0, 0};
};

/// A map on the corners of Model::mesh with the mesh vertex of every uv.
struct MeshMap {
  std::vector<Vec2> uv;
  std::vector<int> cornerUv;  ///< 3 per face of Model::mesh
  std::vector<int> copyOf;    ///< uv → mesh vertex
};

std::vector<Placement> packed(const std::vector<ComponentMap>& components) {
  std::vector<UvBox> boxes;
  std::vector<std::size_t> movable;
  double unit = 0;
  for (std::size_t p = 0; p < components.size(); ++p) {
    if (components[p].isKept) continue;
    movable.push_back(p);
    boxes.push_back(boxOf(components[p].map.uv));
    unit = std::max(unit, components[p].shiftUnit);
  }
  const std::vector<Vec2> shifts = packBoxes(boxes, unit);
  std::vector<Placement> out(components.size());
  for (std::size_t i = 0; i < movable.size(); ++i) out[movable[i]] = {1, shifts[i]};
  return out;
}

/// Centres a component at the origin, where its coordinates are most precise. (Components may overlap.)
Placement centred(const ComponentMap& component, double factor) {
  UvBox box = boxOf(component.map.uv);
  if (component.shiftUnit > 0) factor = 1.0;  // aligned to a grid: one cell stays one unit
  if (factor == 0.0) factor = box.extent() > 0 ? std::scalbn(1.0, 6 - std::ilogb(box.extent())) : 1;
  for (Vec2* p : {&box.low, &box.high}) *p = {factor * (*p)[0], factor * (*p)[1]};
  return {factor, centringShift(box, component.shiftUnit)};
}

MeshMap joinComponents(const Model& model, const std::vector<ComponentMap>& components,
                       const std::vector<Placement>& placements) {
  MeshMap out;
  out.cornerUv.assign(3 * model.mesh.triangles.size(), -1);
  for (std::size_t p = 0; p < components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const auto& [factor, shift] = placements[p];
    const int first = static_cast<int>(out.uv.size());
    for (std::size_t i = 0; i < components[p].map.uv.size(); ++i) {
      const Vec2& q = components[p].map.uv[i];
      out.uv.push_back({factor * q[0] + shift[0], factor * q[1] + shift[1]});
      out.copyOf.push_back(component.meshVertex[VertexId{components[p].copyOf[i].i}].i);
    }
    for (std::size_t f = 0; f < components[p].map.cornerUv.size(); ++f) {
      const std::size_t at = 3 * hgp::at(component.meshFace[FaceId{static_cast<int>(f)}].i);
      for (std::size_t k = 0; k < 3; ++k)
        out.cornerUv[at + k] = first + components[p].map.cornerUv[f][k];
    }
  }
  return out;
}

double meanUvEdge(const MeshMap& map) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < map.cornerUv.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    if (map.cornerUv[c] < 0 || map.cornerUv[next] < 0) continue;
    const Vec2& a = map.uv[static_cast<std::size_t>(map.cornerUv[c])];
    const Vec2& b = map.uv[static_cast<std::size_t>(map.cornerUv[next])];
    sum += portable::hypot(b[0] - a[0], b[1] - a[1]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

void moveAndScale(std::vector<Vec2>& uv, const Vec2& origin, double factor) {
  for (Vec2& p : uv) p = {(p[0] - origin[0]) * factor, (p[1] - origin[1]) * factor};
}

void applyScale(MeshMap& map, Scale scale) {
  if (scale == Scale::kUnit) {
    const double mean = meanUvEdge(map);
    if (mean > 0) moveAndScale(map.uv, {0, 0}, 1 / mean);
  } else if (scale == Scale::kFit) {
    const UvBox box = boxOf(map.uv);
    const double size = box.extent();
    // The margin keeps rounding from exceeding 1.
    if (size > 0) moveAndScale(map.uv, box.low, (1 - 1e-7) / size);
  }
}

/// Restores the uv of components that keep those of the file.
void restoreKept(const std::vector<ComponentMap>& components, std::vector<Vec2>& uv) {
  auto at = uv.begin();
  for (const ComponentMap& component : components) {
    if (component.isKept) std::copy(component.map.uv.begin(), component.map.uv.end(), at);
    at += static_cast<std::ptrdiff_t>(component.map.uv.size());
  }
}

UvMap onSurface(const Model& model, const MeshMap& from) {
  UvMap out;
  out.uv = from.uv;
  out.cornerUv.assign(model.source().mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t c = 0; c < from.cornerUv.size(); ++c) {
    const SurfaceCornerId to = model.cornerOrigin[MeshCornerId{static_cast<int>(c)}];
    out.cornerUv[at(to.i / 3)][at(to.i % 3)] = from.cornerUv[c];
  }
  fillOutside(model, out);
  return out;
}

std::vector<std::uint32_t> verticesOfUv(const Model& model, const UvMap& map) {
  std::vector<std::uint32_t> out(map.uv.size(), 0);
  const auto& triangles = model.source().mesh.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      out[static_cast<std::size_t>(map.cornerUv[t][k])] =
          static_cast<std::uint32_t>(triangles[t][k]);
    }
  }
  return out;
}

/// Whether both maps have the same uv at every corner.
bool isSame(const UvMap& a, const UvMap& b) {
  if (a.cornerUv.size() != b.cornerUv.size()) return false;
  for (std::size_t f = 0; f < a.cornerUv.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = a.cornerUv[f][k], j = b.cornerUv[f][k];
      if (i < 0 || j < 0) return false;
      if (a.uv[static_cast<std::size_t>(i)] != b.uv[static_cast<std::size_t>(j)]) return false;
    }
  return true;
}

bool isFloat32(const StorePlace& place) {
  return place.document.uvPrecision() == io::UvPrecision::kFloat32;
}

CertifyOptions certifyOptions(const StorePlace& place) {
  CertifyOptions options;
  options.precision = isFloat32(place) ? Precision::kFloat32 : Precision::kFloat64;
  return options;
}

StoredNumbers numbersOf(const StorePlace& place) {
  return {isFloat32(place) ? 24 : 53, isFloat32(place)};
}

/// Verifies `out.map`. A component with exactly the numbers that were verified before storing or in `earlier` is not
/// verified again.
void check(const Model& model, const StorePlace& place, const std::vector<ComponentMap>& components,
           const StoredMap* earlier, StoredMap& out) {
  CertifyOptions options = certifyOptions(place);
  out.certificates.reserve(components.size());
  for (std::size_t p = 0; p < components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const UvMap stored = mapOfComponent(component, out.map);
    const bool isFloat = options.precision == Precision::kFloat32;
    options.gridStep = isFloat ? gridStep(stored) : 0.0;
    if (earlier && isSame(stored, mapOfComponent(component, earlier->map))) {
      out.certificates.push_back(earlier->certificates[p]);
    } else if (!isFloat && components[p].certificate.precision == options.precision &&
               isSame(stored, components[p].map)) {
      out.certificates.push_back(components[p].certificate);
    } else {
      out.certificates.push_back(certify(component.mesh, components[p].spec, stored, options));
      if (!components[p].whyNone.empty())
        denyCertificate(components[p].whyNone, out.certificates.back());
    }
  }
  out.isCertified = areCertified(out.certificates);
}

/// Joins the components, snaps them so that seams are exact, rounds them as the format does and verifies them.
StoredMap store(const Model& model, const StorePlace& place,
                const std::vector<ComponentMap>& components,
                const std::vector<Placement>& placements, Scale scale,
                const ComponentSnapper& snapper, const StoredMap* earlier) {
  MeshMap joined = joinComponents(model, components, placements);
  applyScale(joined, scale);
  snapper.snap(numbersOf(place), joined.uv);
  restoreKept(components, joined.uv);
  StoredMap out;
  out.map =
      place.document.asStored(place.surface, onSurface(model, joined), componentOfTriangle(model));
  check(model, place, components, earlier, out);
  return out;
}

/// Ascending; of a pair of images, both.
std::vector<std::size_t> brokenByStoring(const std::vector<ComponentMap>& components,
                                         const StoredMap& stored) {
  std::vector<char> isBroken(components.size(), 0);
  for (std::size_t p = 0; p < components.size(); ++p) {
    if (!components[p].certificate.isCertified || stored.certificates[p].isCertified) continue;
    isBroken[p] = 1;
    if (components[p].mirror && components[p].mirror->of >= 0)
      isBroken[at(components[p].mirror->of)] = 1;
  }
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < components.size(); ++p) {
    const Mirror* mirror = components[p].mirror.get();
    if (isBroken[p] || (mirror && mirror->of >= 0 && isBroken[at(mirror->of)])) out.push_back(p);
  }
  return out;
}

/// Tries other positions and scales for the components that rounding broke; the others stay.
void redo(const Model& model, const StorePlace& place, const std::vector<ComponentMap>& components,
          const ComponentSnapper& snapper, std::vector<Placement> placements, StoredMap& stored) {
  std::vector<std::size_t> broken = brokenByStoring(components, stored);
  const std::size_t before = broken.size();
  const std::vector<Placement> packedThere = placements;
  for (double factor : kRetryFactors) {
    if (broken.empty()) break;
    for (std::size_t p : broken) placements[p] = centred(components[p], factor);
    stored = store(model, place, components, placements, Scale::kSolved, snapper, &stored);
    broken = brokenByStoring(components, stored);
  }
  if (!broken.empty()) {
    for (std::size_t p : broken) placements[p] = packedThere[p];
    stored = store(model, place, components, placements, Scale::kSolved, snapper, &stored);
  }
  if (broken.size() < before) {
    stored.notes.push_back(Note(
        "stored-moved", {{"moved", before - broken.size()}, {"components", components.size()}}));
  }
}

void denyFolded(const Model& model, const StorePlace& place, StoredMap& stored) {
  denyFoldedPolygons(model, place.document.polygons(place.surface), stored.map,
                     stored.certificates);
  stored.isCertified = areCertified(stored.certificates);
}

}  // namespace

void denyCertificate(const std::string& whyNone, Certificate& certificate) {
  certificate.reasons.insert(
      certificate.reasons.begin(),
      {Rule::kPrescription, 1, 0.0, "There is no map with this prescription: " + whyNone, {}});
  certificate.isCertified = false;
}

StoredMap certifyAsItIs(const Model& model, const StorePlace& place,
                        const std::vector<ComponentMap>& components, const UvMap& map) {
  StoredMap out;
  out.map = place.document.asStored(place.surface, map, componentOfTriangle(model));
  check(model, place, components, nullptr, out);
  denyFolded(model, place, out);
  out.uvToVertex = verticesOfUv(model, out.map);
  return out;
}

StoredMap storeMap(const Model& model, const std::vector<ComponentMap>& components, Scale scale) {
  return storeMap(model, {*model.document, model.surface}, components, scale);
}

StoredMap storeMap(const Model& model, const StorePlace& place,
                   const std::vector<ComponentMap>& components, Scale scale) {
  const std::vector<Placement> placements = packed(components);
  ComponentSnapper snapper(model, components);
  StoredMap out = store(model, place, components, placements, scale, snapper, nullptr);
  if (scale == Scale::kSolved) redo(model, place, components, snapper, placements, out);
  if (const auto broken = brokenByStoring(components, out); !broken.empty()) {
    for (std::size_t p : broken) snapper.leave(p);
    out = store(model, place, components, placements, scale, snapper, &out);
    if (scale == Scale::kSolved) redo(model, place, components, snapper, placements, out);
  }
  const std::size_t broken = brokenByStoring(components, out).size();
  if (broken > 0) {
    out.notes.push_back(
        Note("stored-broken", {{"broken", broken}, {"components", components.size()}}));
  }
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const UvMap map = mapOfComponent(model.components[p], out.map);
    out.certificates[p].overlap = measureOverlap(map, overlapCells(map));
  }
  denyFolded(model, place, out);
  out.uvToVertex = verticesOfUv(model, out.map);
  return out;
}

}  // namespace hgp::api
