#include "hgp/optimize/lone_cones.h"

#include <deque>
#include <utility>

#include "hgp/base/turns.h"
#include "hgp/features/step_repair.h"

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

/// The charts of a patch's faces in that of the first one: z_first = i^turn z + Σ terms.
class Unfolding {
 public:
  Unfolding(const SeamlessSystem& system, const Sectors& sectors)
      : s_(system), sectors_(sectors), of_(at(system.mesh.faceCount()), -1) {}

  void unfold(FaceId first) {
    charts_.assign(1, {});
    sums_.assign(1, {});
    of_[first] = 0;
    for (std::deque<FaceId> queue{first}; !queue.empty(); queue.pop_front())
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(queue.front(), k);
        if (sectors_.isFeature[s_.mesh.edge(h)]) continue;
        const FaceId g = TriMesh::face(s_.mesh.twin(h));
        if (of_[g] >= 0) continue;
        of_[g] = static_cast<int>(charts_.size());
        charts_.push_back(across(h));
        queue.push_back(g);
      }
  }
  int turnOf(FaceId f) const { return charts_[at(of_[f])].turn; }
  const std::vector<TurnedSum::Term>& termsOf(FaceId f) const {
    return sums_[at(charts_[at(of_[f])].sum)];
  }

 private:
  struct Chart {
    int turn = 0;
    int sum = 0;  ///< index
  };

  Chart across(HalfedgeId h) {
    const HalfedgeId twin = s_.mesh.twin(h);
    Chart chart = charts_[at(of_[TriMesh::face(h)])];
    const int here = s_.cut.copy[h].i, there = s_.cut.copy[TriMesh::next(twin)].i;
    const int rotation = s_.seams.rotation[h];
    const bool isSeam =
        here != there || s_.cut.copy[TriMesh::next(h)].i != s_.cut.copy[twin].i || rotation != 0;
    if (!isSeam) return chart;
    std::vector<TurnedSum::Term> terms = sums_[at(chart.sum)];
    terms.push_back({here, chart.turn, 1.0});
    chart.turn -= rotation;
    terms.push_back({there, chart.turn, -1.0});
    chart.sum = static_cast<int>(sums_.size());
    sums_.push_back(std::move(terms));
    return chart;
  }

  const SeamlessSystem& s_;
  const Sectors& sectors_;
  PerFace<int> of_;
  std::vector<Chart> charts_;
  std::vector<std::vector<TurnedSum::Term>> sums_;
};

}  // namespace

std::vector<TurnedSum> distancesOfLoneCones(const SeamlessSystem& system,
                                            const std::vector<StraightEdge>& edges,
                                            const AlignedField& aligned) {
  const TriMesh& mesh = system.mesh;
  const CutMesh& cut = system.cut;
  std::vector<TurnedSum> distances;
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
      const int turn = unfolding.turnOf(TriMesh::face(h));
      // To the left of the side, in the first face's chart.
      const int normal = edge.heading + across + turn + 1;
      double length = 0.0;
      for (const HalfedgeId e : straightRun(mesh, aligned, h)) length += system.geometry.length[e];
      const double scale = 2.0 / length;
      TurnedSum& sum = distances.emplace_back();
      sum.side = h;
      sum.terms.push_back({cut.copy[patch.atCone].i, -normal, scale});
      sum.terms.push_back({cut.copy[h].i, turn - normal, -scale});
      for (const TurnedSum::Term& t : unfolding.termsOf(TriMesh::face(h)))
        sum.terms.push_back({t.copy, t.turn - normal, -scale * t.factor});
    }
  }
  return distances;
}

}  // namespace hgp
