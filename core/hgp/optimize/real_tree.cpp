#include "hgp/optimize/real_tree.h"

#include <algorithm>
#include <array>

namespace hgp {
namespace {

constexpr int kNobody = -1, kSeveral = -2;

void sortUnique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Dissection {
 public:
  Dissection(const SeamlessSystem& system, const RealUnknowns& unknowns,
             const PerVertex<char>& hasRow)
      : s_(system), unknowns_(unknowns), hasRow_(hasRow) {
    nameUnknowns();
  }

  linalg::SeparatorTree run() const {
    linalg::DissectionOptions options;
    options.separatorWidth = 2;
    const linalg::SeparatorTree own = linalg::nestedDissection(edgeGraph(), options);
    linalg::SeparatorTree tree = linalg::appendVertices(own, sharedGraph());
    std::vector<int> unknownOf(name_.size());
    for (std::size_t i = 0; i < name_.size(); ++i) unknownOf[at(name_[i])] = static_cast<int>(i);
    for (int& v : tree.order) v = unknownOf[at(v)];
    return tree;
  }

 private:
  template <class Use>
  void forEachUnknown(int copy, int part, const Use& use) const {
    for (RealUnknowns::Rows::InnerIterator it(unknowns_.rows, 2 * copy + part); it; ++it)
      use(static_cast<int>(it.col()));
  }

  /// First those on which the copies of one vertex depend, then the others.
  void nameUnknowns() {
    std::vector<int> owner(at(unknowns_.count), kNobody);
    for (int copy = 0; copy < s_.cut.vertexCount(); ++copy)
      for (const int part : {0, 1})
        forEachUnknown(copy, part, [&](int i) {
          const int vertex = s_.cut.parent[CutVertexId(copy)].i;
          owner[at(i)] = owner[at(i)] == kNobody || owner[at(i)] == vertex ? vertex : kSeveral;
        });
    name_.resize(owner.size());
    for (std::size_t i = 0; i < owner.size(); ++i)
      if (owner[i] != kSeveral) name_[i] = own_++;
    int next = own_;
    for (std::size_t i = 0; i < owner.size(); ++i)
      if (owner[i] == kSeveral) name_[i] = next++;
  }

  /// Ends of an edge are coupled part by part, in the chart of either side.
  linalg::Graph edgeGraph() const {
    std::vector<std::array<int, 2>> pairs;
    pairs.reserve(2 * at(s_.mesh.edgeCount()));
    std::vector<int> coupled;
    const auto couple = [&](int tail, int head, int part) {
      coupled.clear();
      for (const int copy : {tail, head})
        forEachUnknown(copy, part, [&](int i) {
          if (name_[at(i)] < own_) coupled.push_back(name_[at(i)]);
        });
      for (std::size_t i = 0; i < coupled.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (coupled[i] != coupled[j]) pairs.push_back({coupled[j], coupled[i]});
    };
    for (EdgeId e : s_.mesh.edges())
      for (HalfedgeId h : {s_.mesh.halfedge(e), s_.mesh.twin(s_.mesh.halfedge(e))}) {
        if (!h.isValid()) continue;
        const int tail = s_.cut.copy[h].i, head = s_.cut.copy[TriMesh::next(h)].i;
        for (const int part : {0, 1}) couple(tail, head, part);
        if (!s_.cut.isSeam[e]) break;  // the other side has the same copies
      }
    return linalg::graphOf(own_, pairs);
  }

  /// Triangles with a corner that depends on a shared unknown. Most have none.
  PerFace<char> facesWithShared() const {
    std::vector<char> isShared(at(s_.cut.vertexCount()), 0);
    for (int copy = 0; copy < s_.cut.vertexCount(); ++copy)
      for (const int part : {0, 1})
        forEachUnknown(copy, part, [&](int i) {
          if (name_[at(i)] >= own_) isShared[at(copy)] = 1;
        });
    PerFace<char> out(at(s_.mesh.faceCount()), 0);
    for (FaceId f : s_.mesh.faces())
      for (int k = 0; k < 3; ++k)
        if (isShared[at(s_.cut.copy[TriMesh::halfedge(f, k)].i)]) out[f] = 1;
    return out;
  }

  /// What shared unknowns may be coupled with, by the triangles and by the rows around vertices: with either part, as a seam
  /// may turn one into the other.
  linalg::Graph sharedGraph() const {
    std::vector<std::vector<int>> neighbours(name_.size());
    std::vector<int> group;
    const auto addFace = [&](FaceId f) {
      for (int k = 0; k < 3; ++k)
        for (const int part : {0, 1})
          forEachUnknown(s_.cut.copy[TriMesh::halfedge(f, k)].i, part,
                         [&](int i) { group.push_back(name_[at(i)]); });
    };
    const auto couple = [&] {
      sortUnique(group);
      for (auto shared = group.rbegin(); shared != group.rend() && *shared >= own_; ++shared)
        neighbours[at(*shared)].insert(neighbours[at(*shared)].end(), group.begin(), group.end());
      group.clear();
    };
    const PerFace<char> isShared = facesWithShared();
    for (VertexId v : s_.mesh.vertices()) {
      if (!hasRow_[v]) continue;
      bool isAny = false;
      for (HalfedgeId h : outgoingHalfedges(s_.mesh, v))
        isAny = isAny || isShared[TriMesh::face(h)];
      if (!isAny) continue;
      for (HalfedgeId h : outgoingHalfedges(s_.mesh, v)) addFace(TriMesh::face(h));
      couple();
    }
    for (FaceId f : s_.mesh.faces()) {
      if (!isShared[f]) continue;
      addFace(f);
      couple();
    }
    linalg::Graph graph;
    for (std::vector<int>& list : neighbours) {
      sortUnique(list);
      graph.neighbours.insert(graph.neighbours.end(), list.begin(), list.end());
      graph.start.push_back(static_cast<int>(graph.neighbours.size()));
    }
    return graph;
  }

  const SeamlessSystem& s_;
  const RealUnknowns& unknowns_;
  const PerVertex<char>& hasRow_;
  std::vector<int> name_;
  int own_ = 0;
};

}  // namespace

linalg::SeparatorTree RealTree::get(const SeamlessSystem& system, const RealUnknowns& unknowns,
                                    const PerVertex<char>& hasRow, const std::vector<int>& number) {
  if (!tree_) tree_ = Dissection(system, unknowns, hasRow).run();
  return linalg::restrictTree(*tree_, number);
}

}  // namespace hgp
