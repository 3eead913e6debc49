#include "hgp/api/stored/polygon_facts.h"

#include <algorithm>

#include "hgp/api/stored/component_map.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/verify/orientation.h"

namespace hgp::api {
namespace {

class PolygonReader {
 public:
  PolygonReader(const Model& model, io::PolygonsView polygons, const UvMap& map)
      : polygons_(polygons), map_(map), componentOf_(componentOfTriangle(model)) {
    const auto& corner = model.cornerOrigin.raw();
    isTurned_.assign(map.cornerUv.size(), 0);
    for (std::size_t f = 0; 3 * f + 1 < corner.size(); ++f)
      isTurned_[at(corner[3 * f] / 3)] = (corner[3 * f + 1] - corner[3 * f] + 3) % 3 == 2;
    for (const LeftOutFace& left : model.leftOut)
      if (left.why == LeftOut::kDuplicate) copies_.push_back(left.face);
    isCopy_.assign(map.cornerUv.size(), 0);
    for (const int f : copies_) isCopy_[at(f)] = 1;
  }

  int size(int p) const { return static_cast<int>(mesh().start[at(p + 1)] - mesh().start[at(p)]); }
  int first(int p) const { return mesh().firstTriangle(p); }
  int component(int t) const { return componentOf_[at(t)]; }
  bool isCopy(int t) const { return isCopy_[at(t)] != 0; }
  bool hasCopies() const { return !copies_.empty(); }

  /// Whether all triangles are verified with the same winding.
  bool isWhole(int p) const {
    for (int t = first(p); t < first(p + 1); ++t)
      if (component(t) < 0 || isTurned_[at(t)] != isTurned_[at(first(p))]) return false;
    return true;
  }

  bool isConvex(int p) const {
    std::vector<Vec2> ring(at(size(p)));
    const int begin = static_cast<int>(mesh().start[at(p)]);
    for (int t = first(p); t < first(p + 1); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        ring[at((*polygons_.corners)[at(t)][k] - begin)] = uv(t, k);
    const int sign = isTurned_[at(first(p))] ? -1 : 1;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (sign *
              orientationSign(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <=
          0)
        return false;
    return true;
  }

  /// The sign of a triangle as it is stored.
  int signOf(int t) const { return orientationSign(uv(t, 0), uv(t, 1), uv(t, 2)); }

 private:
  const io::PolygonMesh& mesh() const { return *polygons_.mesh; }
  Vec2 uv(int t, std::size_t k) const { return map_.uv[at(map_.cornerUv[at(t)][k])]; }

  io::PolygonsView polygons_;
  const UvMap& map_;
  std::vector<int> componentOf_, copies_;
  std::vector<char> isTurned_, isCopy_;
};

/// Whether the map has a uv at every corner.
bool isComplete(io::PolygonsView polygons, const UvMap& map) {
  if (!polygons.mesh || map.cornerUv.size() != at(polygons.mesh->triangleCount())) return false;
  for (const auto& corners : map.cornerUv)
    for (const int i : corners)
      if (i < 0 || at(i) >= map.uv.size()) return false;
  return true;
}

/// Collects, per component, polygons that break a rule of their own.
class Denials {
 public:
  Denials(const Model& model, std::vector<Certificate>& certificates)
      : model_(model), certificates_(certificates), reasons_(certificates.size()) {}

  /// @param triangle  a verified one of the polygon
  void add(int component, int triangle) {
    Reason& reason = reasons_[at(component)];
    if (reason.count++ > 0) return;
    const std::vector<int>& faces = model_.components[at(component)].face.raw();
    const auto found = std::find(faces.begin(), faces.end(), triangle);
    reason.where.push_back({Where::Kind::kFace, found - faces.begin()});
  }

  void apply(const char* one, const char* many, const std::string& text) {
    for (std::size_t p = 0; p < reasons_.size(); ++p) {
      Reason& reason = reasons_[p];
      if (reason.count == 0) continue;
      reason.rule = Rule::kOrientation;
      reason.message = counted(reason.count, one, many) + text;
      certificates_[p].reasons.insert(certificates_[p].reasons.begin(), reason);
      certificates_[p].isCertified = false;
    }
  }

 private:
  const Model& model_;
  std::vector<Certificate>& certificates_;
  std::vector<Reason> reasons_;
};

}  // namespace

PolygonFacts measurePolygons(const Model& model, io::PolygonsView polygons,
                             const UvMap& surfaceMap) {
  PolygonFacts facts;
  if (!isComplete(polygons, surfaceMap)) return facts;
  const PolygonReader reader(model, polygons, surfaceMap);
  for (int p = 0; p < polygons.mesh->polygonCount(); ++p) {
    if (reader.size(p) == 3) continue;
    ++facts.polygons;
    facts.notConvex += reader.isWhole(p) && !reader.isConvex(p);
  }
  return facts;
}

void denyFoldedPolygons(const Model& model, io::PolygonsView polygons, const UvMap& surfaceMap,
                        std::vector<Certificate>& certificates) {
  if (!isComplete(polygons, surfaceMap)) return;
  const PolygonReader reader(model, polygons, surfaceMap);
  if (!reader.hasCopies()) return;
  Denials denials(model, certificates);
  for (int p = 0; p < polygons.mesh->polygonCount(); ++p) {
    int verified = -1;
    for (int t = reader.first(p); t < reader.first(p + 1); ++t)
      if (reader.component(t) >= 0) verified = t;
    bool isFolded = false;
    for (int t = reader.first(p); verified >= 0 && t < reader.first(p + 1); ++t)
      isFolded = isFolded || (reader.isCopy(t) && reader.signOf(t) != reader.signOf(verified));
    if (isFolded) denials.add(reader.component(verified), verified);
  }
  denials.apply("polygon has", "polygons have",
                " a part that repeats a face and is folded over in the map; remove the repeated "
                "face, or triangulate the polygons");
}

void denyNotConvex(const Model& model, io::PolygonsView polygons, const UvMap& surfaceMap,
                   std::vector<Certificate>& certificates) {
  if (!isComplete(polygons, surfaceMap)) return;
  const PolygonReader reader(model, polygons, surfaceMap);
  Denials denials(model, certificates);
  for (int p = 0; p < polygons.mesh->polygonCount(); ++p)
    if (reader.size(p) > 3 && reader.isWhole(p) && !reader.isConvex(p))
      denials.add(reader.component(reader.first(p)), reader.first(p));
  denials.apply(
      "polygon is", "polygons are",
      " not convex in the map, and convex polygons were asked for; try cones elsewhere, or "
      "triangulate the file and do not ask for them");
}

}  // namespace hgp::api
