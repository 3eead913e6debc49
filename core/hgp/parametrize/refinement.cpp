#include "hgp/parametrize/refinement.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/turns.h"
#include "hgp/mesh/geometry.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

/// Longest edge over height: above it a triangle is thin.
constexpr double kThin = 8.0;
/// Rings around wrong triangles in which thin triangles are searched, and rings that attempt 1 divides.
constexpr int kThinRings = 3;
constexpr int kDividedRings = 2;

class Splits {
 public:
  explicit Splits(const TriMesh& mesh)
      : mesh_(mesh), isSplit_(static_cast<std::size_t>(mesh.edgeCount()), 0) {}

  void begin(const char* reason) { places_.push_back({reason, {}}); }
  void add(EdgeId e) {
    if (isSplit_[e]) return;
    isSplit_[e] = 1;
    places_.back().edges.push_back(e);
  }
  void addFace(FaceId f) {
    for (int k = 0; k < 3; ++k) add(mesh_.edge(TriMesh::halfedge(f, k)));
  }

  std::vector<SplitPlace> take() {
    std::erase_if(places_, [](const SplitPlace& place) { return place.edges.empty(); });
    int triangles = mesh_.faceCount();
    for (const SplitPlace& place : places_)
      for (EdgeId e : place.edges) triangles += mesh_.twin(mesh_.halfedge(e)).isValid() ? 2 : 1;
    if (triangles > kLargestRefinement) return {};
    return std::move(places_);
  }

 private:
  const TriMesh& mesh_;
  PerEdge<char> isSplit_;
  std::vector<SplitPlace> places_;
};

/// Triangles that are not positive, at which the program was strained most, or that lie around a wrong angle.
std::vector<FaceId> wrongFaces(const TriMesh& mesh, const Parametrization& failed) {
  const Certificate& c = failed.certificate;
  std::vector<FaceId> faces = c.orientation.notPositive;
  faces.insert(faces.end(), failed.strained.begin(), failed.strained.end());
  for (const MeasuredCone& cone : c.angles.wrong)
    for (HalfedgeId h : outgoingHalfedges(mesh, cone.vertex)) faces.push_back(TriMesh::face(h));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void splitConeRings(const TriMesh& mesh, const CompleteSpec& spec, Splits& splits) {
  splits.begin("cone rings");
  for (const ConePoint& cone : spec.cones) {
    const double angle = 2 * kPi * cone.k / spec.q;
    if (angle <= kPoorCornerAngle * mesh.valence(cone.vertex)) continue;
    for (HalfedgeId h : outgoingHalfedges(mesh, cone.vertex))
      splits.add(mesh.edge(TriMesh::next(h)));
  }
}

/// Splits edges that join two cones, whose angles would otherwise have to be met by the same triangles.
void splitBetween(const TriMesh& mesh, const CompleteSpec& spec, Splits& splits) {
  PerVertex<char> isCone(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (const ConePoint& cone : spec.cones) isCone[cone.vertex] = 1;
  splits.begin("between cones");
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (isCone[mesh.tail(h)] && isCone[mesh.head(h)]) splits.add(e);
  }
  splits.begin("across the boundary");
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (!mesh.twin(h).isValid()) continue;
    if (mesh.isBoundary(mesh.tail(h)) && mesh.isBoundary(mesh.head(h))) splits.add(e);
  }
}

void splitThin(const TriMesh& mesh, const std::vector<FaceId>& near, Splits& splits) {
  const Geometry geometry = computeGeometry(mesh);
  splits.begin("thin triangles");
  for (FaceId f : near) {
    HalfedgeId longest = TriMesh::halfedge(f, 0);
    for (int k = 1; k < 3; ++k)
      if (geometry.length[TriMesh::halfedge(f, k)] > geometry.length[longest])
        longest = TriMesh::halfedge(f, k);
    const double length = geometry.length[longest];
    if (length * length > kThin * 2 * geometry.area[f]) splits.add(mesh.edge(longest));
  }
}

}  // namespace

std::vector<SplitPlace> placesToSplit(const TriMesh& mesh, const Parametrization& failed,
                                      int attempt) {
  Splits splits(mesh);
  const std::vector<FaceId> wrong = wrongFaces(mesh, failed);
  splitConeRings(mesh, failed.spec, splits);
  splitBetween(mesh, failed.spec, splits);
  splitThin(mesh, growFaces(mesh, wrong, kThinRings), splits);
  splits.begin("around what is wrong");
  for (FaceId f : wrong) splits.addFace(f);
  if (attempt >= 1) {
    std::vector<FaceId> seeds = wrong;
    for (const ConePoint& cone : failed.spec.cones)
      for (HalfedgeId h : outgoingHalfedges(mesh, cone.vertex)) seeds.push_back(TriMesh::face(h));
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    for (FaceId f : growFaces(mesh, seeds, kDividedRings)) splits.addFace(f);
  }
  if (attempt >= 2) {
    splits.begin("everywhere");
    for (FaceId f : mesh.faces()) splits.addFace(f);
  }
  return splits.take();
}

}  // namespace hgp
