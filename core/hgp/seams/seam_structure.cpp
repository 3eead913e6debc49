#include "hgp/seams/seam_structure.h"

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

Complex valueOf(const std::vector<Vec2>& uv, int copy) {
  return {uv[at(copy)][0], uv[at(copy)][1]};
}

template <class Ring>
class SeamReader {
 public:
  SeamReader(const TriMesh& mesh, const UvMap& map, int q) : mesh_(mesh), map_(map), q_(q) {}

  bool run(const std::vector<VertexId>& cones) {
    if (!gatherCopies()) return false;
    findSeams();
    static_cast<SeamChains&>(out_) = traceChains(mesh_, isSeam_, seamNodes(mesh_, isSeam_, cones));
    for (const SeamChain& chain : out_.chains)
      out_.chainTurn.push_back(longestTurn(chain) * (Ring::kOrder / q_));
    out_.firstCopy = PerVertex<int>(at(mesh_.vertexCount()), -1);
    out_.placeIndex.assign(map_.uv.size(), -1);
    for (VertexId v : mesh_.vertices())
      if (!mesh_.isIsolated(v) && !walk(v)) return false;
    return true;
  }

  SeamStructureOver<Ring> take() { return std::move(out_); }

 private:
  bool gatherCopies() {
    if (map_.cornerUv.size() != at(mesh_.faceCount())) return false;
    out_.copy = PerHalfedge<int>(at(mesh_.halfedgeCount()), -1);
    out_.vertexOf.assign(map_.uv.size(), VertexId());
    for (HalfedgeId h : mesh_.halfedges()) {
      const int c = map_.cornerUv[at(h.i / 3)][at(h.i % 3)];
      if (c < 0 || at(c) >= map_.uv.size()) return false;
      VertexId& owner = out_.vertexOf[at(c)];
      if (owner.isValid() && owner != mesh_.tail(h)) return false;
      owner = mesh_.tail(h);
      out_.copy[h] = c;
    }
    return true;
  }

  void findSeams() {
    isSeam_ = PerEdge<char>(at(mesh_.edgeCount()), 0);
    for (EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      if (mesh_.isBoundary(h)) continue;
      const HalfedgeId twin = mesh_.twin(h);
      isSeam_[e] = out_.copy[h] != out_.copy[TriMesh::next(twin)] ||
                   out_.copy[TriMesh::next(h)] != out_.copy[twin];
    }
  }

  int longestTurn(const SeamChain& chain) const {
    double longest = -1.0;
    int turn = 0;
    for (HalfedgeId h : chain.left) {
      const HalfedgeId twin = mesh_.twin(h);
      const Complex left =
          valueOf(map_.uv, out_.copy[TriMesh::next(h)]) - valueOf(map_.uv, out_.copy[h]);
      const Complex right =
          valueOf(map_.uv, out_.copy[twin]) - valueOf(map_.uv, out_.copy[TriMesh::next(twin)]);
      const double size = portable::abs(right * std::conj(left));
      if (size <= longest) continue;
      longest = size;
      turn = measuredTurn(left, right, q_);
    }
    return turn;
  }

  /// False where two sectors share a copy or a sector has two.
  bool walk(VertexId v) {
    const TurnedChains seams{mesh_, isSeam_, out_, out_.chainTurn, Ring::kOrder};
    const bool isSeamVertex = isOnSeam(v);
    bool isRegular = true;
    int copy = -1;
    const std::optional<CopyPlace<Ring>> closure =
        walkSectors<Ring>(seams, v, [&](HalfedgeId h, bool isFirst, const CopyPlace<Ring>& place) {
          if (copy < 0) out_.firstCopy[v] = out_.copy[h];
          if (!isFirst) {
            isRegular = isRegular && out_.copy[h] == copy;
            return;
          }
          copy = out_.copy[h];
          if (isSeamVertex) isRegular = isRegular && setPlace(copy, place);
        });
    if (closure && out_.isSeamNode[v]) out_.closures.push_back({v, *closure});
    return isRegular;
  }

  bool isOnSeam(VertexId v) const {
    for (HalfedgeId h : outgoingHalfedges(mesh_, v))
      if (isSeam_[mesh_.edge(h)]) return true;
    return false;
  }

  bool setPlace(int copy, const CopyPlace<Ring>& place) {
    int& index = out_.placeIndex[at(copy)];
    if (index >= 0) return false;
    index = static_cast<int>(out_.places.size());
    out_.places.push_back(place);
    return true;
  }

  const TriMesh& mesh_;
  SeamStructureOver<Ring> out_;
  const UvMap& map_;
  const int q_;
  PerEdge<char> isSeam_;
};

}  // namespace

template <class Ring>
std::optional<SeamStructureOver<Ring>> readSeamsOver(const TriMesh& mesh, const UvMap& map, int q,
                                                     const std::vector<VertexId>& cones) {
  if (q < 1 || Ring::kOrder % q != 0) return {};
  SeamReader<Ring> reader(mesh, map, q);
  if (!reader.run(cones)) return {};
  return reader.take();
}

template <class Ring>
std::vector<Complex> chainTranslations(const SeamStructureOver<Ring>& seams, const TriMesh& mesh,
                                       const std::vector<Vec2>& uv) {
  std::vector<Complex> translation;
  for (int c = 0; c < seams.chainCount(); ++c) {
    const std::vector<HalfedgeId>& left = seams.chains[at(c)].left;
    const HalfedgeId h = left[left.size() / 2];
    const Complex right = valueOf(uv, seams.copy[TriMesh::next(mesh.twin(h))]);
    translation.push_back(right - toComplex(Ring::turned(seams.chainTurn[at(c)])) *
                                      valueOf(uv, seams.copy[h]));
  }
  return translation;
}

int measuredTurn(const Complex& a, const Complex& b, int q) {
  const Complex ratio = b * std::conj(a);
  int turn = 0;
  double best = ratio.real();
  for (int r = 1; r < q; ++r) {
    const Complex R = rotation(r, q);
    const double fit = R.real() * ratio.real() + R.imag() * ratio.imag();
    if (fit <= best) continue;
    best = fit;
    turn = r;
  }
  return turn;
}

template std::optional<SeamStructureOver<Gaussian>> readSeamsOver(const TriMesh&, const UvMap&, int,
                                                                  const std::vector<VertexId>&);
template std::optional<SeamStructureOver<Eisenstein>> readSeamsOver(const TriMesh&, const UvMap&,
                                                                    int,
                                                                    const std::vector<VertexId>&);
template std::vector<Complex> chainTranslations(const SeamStructureOver<Gaussian>&, const TriMesh&,
                                                const std::vector<Vec2>&);
template std::vector<Complex> chainTranslations(const SeamStructureOver<Eisenstein>&,
                                                const TriMesh&, const std::vector<Vec2>&);

}  // namespace hgp
