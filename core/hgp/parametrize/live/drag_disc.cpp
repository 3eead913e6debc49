#include "hgp/parametrize/live/drag_disc.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/frames.h"

namespace hgp::live {
namespace {

/// Whether the soft triangles include a further ring: as in a run, where the root stays small.
int cheapRoot(const TriMesh& mesh) {
  return static_cast<int>(2.0 * std::sqrt(static_cast<double>(mesh.vertexCount())));
}

/// With more kept unknowns outside the disc, a sparse factor of all is faster than a dense root.
int largestRoot(const TriMesh& mesh) { return std::min(2 * cheapRoot(mesh), 1800); }

/// Finer meshes have more rings, so that as much of the hand's way is in reach; with ten, the disc's dense factor is still
/// a small part of a frame.
int ringCount(const TriMesh& mesh) {
  constexpr int kFewest = 6, kMost = 10;
  constexpr double kVertices = 15000.0;  // with which six are enough
  const double finer = std::sqrt(static_cast<double>(mesh.vertexCount()) / kVertices);
  return std::clamp(static_cast<int>(kFewest * finer), kFewest, kMost);
}

int cornerCount(const TriMesh& mesh, const std::vector<FaceId>& faces) {
  PerVertex<char> isCorner(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (FaceId f : faces)
    for (VertexId v : mesh.corners(f)) isCorner[v] = 1;
  return static_cast<int>(std::count(isCorner.begin(), isCorner.end(), 1));
}

}  // namespace

DragDisc::DragDisc(const TriMesh& mesh, const SeamlessSetup& setup, VertexId cone,
                   Eigen::VectorXcd x)
    : mesh_(mesh),
      setup_(setup),
      cone_(cone),
      rings_(ringCount(mesh)),
      x_(std::move(x)),
      still_(mesh, setup.cut, setup.seams, setup.unknowns, cone),
      isFixed_(static_cast<std::size_t>(mesh.vertexCount()), 0),
      isSoft_(isFixed_),
      ring_(static_cast<std::size_t>(mesh.vertexCount()), -1) {}

std::unique_ptr<DragDisc> DragDisc::make(const TriMesh& mesh, const SeamlessSetup& setup,
                                         VertexId cone, Eigen::VectorXcd x) {
  std::unique_ptr<DragDisc> disc(new DragDisc(mesh, setup, cone, std::move(x)));
  if (!disc->build()) return nullptr;
  return disc;
}

bool DragDisc::build() {
  for (VertexId v : mesh_.vertices()) isFixed_[v] = mesh_.isBoundary(v);
  for (VertexId v : setup_.cones) isFixed_[v] = v != cone_;
  chooseDisc();
  chooseFaces();
  chooseKept();
  if (held_ < 0) return false;
  isSparse_ = rootSize() - unknownCount() > largestRoot(mesh_);
  return readFaces() && (isSparse_ ? buildSparse() : buildDense());
}

void DragDisc::chooseDisc() {
  near_.assign(1, cone_);
  ring_[cone_] = 0;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const VertexId v = near_[i];
    if (ring_[v] == rings_) break;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v))
      for (const VertexId w : {mesh_.head(h), mesh_.tail(TriMesh::previous(h))}) {
        if (ring_[w] >= 0) continue;
        ring_[w] = ring_[v] + 1;
        near_.push_back(w);
      }
  }
  for (FaceId f : mesh_.faces()) {
    const auto corners = mesh_.corners(f);
    if (std::any_of(corners.begin(), corners.end(),
                    [&](VertexId v) { return ring_[v] >= 0 && ring_[v] < rings_; }))
      inside_.push_back(f);
  }
}

/// Soft triangles of the other cones and of boundaries; those with a corner that may change are assembled in every frame.
void DragDisc::chooseFaces() {
  std::vector<VertexId> others;
  for (VertexId v : setup_.cones)
    if (v != cone_) others.push_back(v);
  std::vector<FaceId> soft;
  for (FaceId f : mesh_.faces()) {
    const auto corners = mesh_.corners(f);
    if (std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return isFixed(v); }))
      soft.push_back(f);
  }
  std::vector<FaceId> grown = growFaces(mesh_, soft, 1);
  isGrown_ = cornerCount(mesh_, grown) <= cheapRoot(mesh_);
  if (isGrown_) soft = std::move(grown);
  for (FaceId f : soft) {
    const auto corners = mesh_.corners(f);
    for (VertexId v : corners) isSoft_[v] = 1;
    const bool isClose = std::any_of(corners.begin(), corners.end(), [&](VertexId v) {
      return ring_[v] >= 0 && ring_[v] <= reach();
    });
    (isClose ? close_ : far_).push_back(f);
  }
}

void DragDisc::chooseKept() {
  const auto count = static_cast<std::size_t>(setup_.unknowns.count);
  std::vector<char> isKept(count, 1);
  for (VertexId v : setup_.harmonic.rowVertex) isKept[at(setup_.unknowns.vertexUnknown[v])] = 0;
  const auto mark = [&](HalfedgeId corner, auto&& use) {
    for (const Term& t : still_.termsOf(corner)) use(t.unknown);
  };
  discAt_.assign(count, -1);
  const auto toDisc = [&](int unknown) {
    if (discAt_[at(unknown)] >= 0) return;
    discAt_[at(unknown)] = static_cast<int>(disc_.size());
    disc_.push_back(unknown);
  };
  for (VertexId v : near_) {
    if (ring_[v] == rings_) continue;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v))
      for (const HalfedgeId corner : {h, TriMesh::next(h), TriMesh::previous(h)})
        mark(corner, toDisc);
  }
  for (FaceId f : far_)
    for (int k = 0; k < 3; ++k)
      mark(TriMesh::halfedge(f, k), [&](int unknown) { isKept[at(unknown)] = 1; });
  holdOne();
  for (int unknown : disc_) isKept[at(unknown)] = 1;
  index_.assign(count, -1);
  int outside = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isKept[i]) continue;
    kept_.push_back(static_cast<int>(i));
    if (discAt_[i] < 0 && static_cast<int>(i) != held_) index_[i] = outside++;
  }
  for (int unknown : disc_) index_[at(unknown)] = outside++;
}

/// A translation of the whole map is free, so the unknown of one vertex keeps its value: a corner of a soft triangle out of
/// reach, or else of the last ring.
void DragDisc::holdOne() {
  const auto mayHold = [&](VertexId v) {
    const int unknown = setup_.unknowns.vertexUnknown[v];
    return unknown >= 0 && (ring_[v] < 0 || ring_[v] == rings_);
  };
  for (FaceId f : far_)
    for (VertexId v : mesh_.corners(f))
      if (held_ < 0 && mayHold(v)) held_ = setup_.unknowns.vertexUnknown[v];
  for (VertexId v : near_)
    if (held_ < 0 && mayHold(v) && ring_[v] == rings_) held_ = setup_.unknowns.vertexUnknown[v];
  if (held_ < 0 || discAt_[at(held_)] < 0) return;
  disc_.erase(disc_.begin() + discAt_[at(held_)]);
  discAt_[at(held_)] = -1;
  for (std::size_t i = 0; i < disc_.size(); ++i) discAt_[at(disc_[i])] = static_cast<int>(i);
}

/// Soft triangles of a cone at v.
std::vector<FaceId> DragDisc::facesNear(VertexId v) const {
  std::vector<VertexId> around{v};
  if (isGrown_)
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) around.push_back(mesh_.head(h));
  std::vector<FaceId> faces;
  for (VertexId w : around)
    for (HalfedgeId h : outgoingHalfedges(mesh_, w)) faces.push_back(TriMesh::face(h));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace hgp::live
