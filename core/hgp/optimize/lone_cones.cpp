#include "hgp/optimize/lone_cones.h"

#include <deque>
#include <utility>

#include "hgp/features/step_repair.h"
#include "hgp/features/ways.h"

namespace hgp {
namespace {

/// A part of the surface between features, as far as it decides whether distances are known.
struct PatchOfCone {
  int cones = 0;      ///< off features
  HalfedgeId atCone;  ///< that leaves one of them
  int k = 4;
  bool isConvex = true;           ///< no corner has a ≥ 3
  std::vector<HalfedgeId> sides;  ///< the first of each, after a corner with a = 1

  /// Gauss–Bonnet, Σ(2 − a) + (4 − k) = 4χ, makes it a disk.
  bool hasDistances() const {
    return cones == 1 && isConvex && static_cast<int>(sides.size()) == k;
  }
};

/// Per face, one number for each patch.
PerFace<int> patchOfFaces(const TriMesh& mesh, const Sectors& sectors, int& count) {
  PerFace<int> patch(at(mesh.faceCount()), -1);
  std::vector<FaceId> stack;
  for (FaceId start : mesh.faces()) {
    if (patch[start] >= 0) continue;
    patch[start] = count;
    for (stack.push_back(start); !stack.empty();) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        if (sectors.isFeature[mesh.edge(h)]) continue;
        int& other = patch[TriMesh::face(mesh.twin(h))];
        if (other >= 0) continue;
        other = count;
        stack.push_back(TriMesh::face(mesh.twin(h)));
      }
    }
    ++count;
  }
  return patch;
}

std::vector<PatchOfCone> findPatches(const TriMesh& mesh, const AlignedField& aligned) {
  const Sectors& sectors = aligned.sectors;
  int count = 0;
  const PerFace<int> of = patchOfFaces(mesh, sectors, count);
  std::vector<PatchOfCone> patches(at(count));
  for (const Sector& s : sectors.list) {
    PatchOfCone& patch = patches[at(of[TriMesh::face(s.first)])];
    const int a = aligned.index[at(sectors.node(mesh, s.first))];
    if (a == 1) patch.sides.push_back(s.first);
    patch.isConvex = patch.isConvex && a <= 2;
  }
  for (VertexId v : mesh.vertices()) {
    const int k = aligned.index[at(v.i)];
    if (mesh.isIsolated(v) || sectors.isOnFeature[v] || k == 4) continue;
    PatchOfCone& patch = patches[at(of[TriMesh::face(mesh.outgoing(v))])];
    ++patch.cones;
    patch.atCone = mesh.outgoing(v);
    patch.k = k;
  }
  return patches;
}

/// The ways from the first face of a patch to all others, with a direction that is 0 in the first face's chart.
class Unfolding {
 public:
  struct Way {
    std::vector<SeamStep> steps;
    int turn = 0;  ///< the direction at the end
  };

  Unfolding(const SeamlessSystem& system, const Sectors& sectors)
      : s_(system), sectors_(sectors), wayOf_(at(system.mesh.faceCount()), -1) {}

  void unfold(FaceId first) {
    ways_.assign(1, {});
    wayOf_[first] = 0;
    for (std::deque<FaceId> queue{first}; !queue.empty(); queue.pop_front())
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(queue.front(), k);
        if (sectors_.isFeature[s_.mesh.edge(h)]) continue;
        const FaceId g = TriMesh::face(s_.mesh.twin(h));
        if (wayOf_[g] >= 0) continue;
        wayOf_[g] = across(h);
        queue.push_back(g);
      }
  }
  const Way& to(FaceId f) const { return ways_[at(wayOf_[f])]; }

 private:
  /// Faces between which there is no seam share their way.
  int across(HalfedgeId h) {
    const int here = wayOf_[TriMesh::face(h)];
    if (!s_.cut.isSeam[s_.mesh.edge(h)]) return here;
    Way way = ways_[at(here)];
    const int before = way.turn;
    way.turn += s_.seams.rotation[h];
    way.steps.push_back(
        {s_.cut.copy[h].i, s_.cut.copy[TriMesh::next(s_.mesh.twin(h))].i, before, way.turn});
    ways_.push_back(std::move(way));
    return static_cast<int>(ways_.size()) - 1;
  }

  const SeamlessSystem& s_;
  const Sectors& sectors_;
  PerFace<int> wayOf_;
  std::vector<Way> ways_;
};

}  // namespace

std::vector<SideDistance> distancesOfLoneCones(const SeamlessSystem& system,
                                               const RealUnknowns& unknowns,
                                               const std::vector<StraightEdge>& edges,
                                               const AlignedField& aligned) {
  const TriMesh& mesh = system.mesh;
  const CutMesh& cut = system.cut;
  std::vector<SideDistance> distances;
  PerEdge<int> edgeOf(at(mesh.edgeCount()), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
    edgeOf[mesh.edge(edges[i].h)] = static_cast<int>(i);
  Unfolding unfolding(system, aligned.sectors);
  for (const PatchOfCone& patch : findPatches(mesh, aligned)) {
    if (!patch.hasDistances()) continue;
    unfolding.unfold(TriMesh::face(patch.atCone));
    for (const HalfedgeId h : patch.sides) {
      const StraightEdge& edge = edges[at(edgeOf[mesh.edge(h)])];
      const int across = edge.h == h ? 0 : 2 + system.seams.rotation[edge.h];
      const Unfolding::Way& way = unfolding.to(TriMesh::face(h));
      // From the cone to the right of the side, which has its patch to the left.
      const int direction = edge.heading + across - 1 - way.turn;
      std::vector<SeamStep> steps = way.steps;
      for (SeamStep& s : steps) {
        s.before += direction;
        s.after += direction;
      }
      SideDistance& d = distances.emplace_back();
      d.side = h;
      d.sum = wayAlong(unknowns, cut.copy[patch.atCone].i, direction, steps, cut.copy[h].i);
      d.length = 0.0;
      for (const HalfedgeId e : straightRun(mesh, aligned, h))
        d.length += 0.5 * system.geometry.length[e];
    }
  }
  return distances;
}

}  // namespace hgp
