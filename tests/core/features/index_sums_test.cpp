// Cones that are prescribed on features.  Laws: a field has them, with all its other laws, exactly where a flow between
// patches and vertices exists; otherwise the field has other cones that are possible.
#include "hgp/features/index_sums.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "hgp/base/disjoint_sets.h"
#include "hgp/features/field_along.h"
#include "hgp/features/index_flow.h"
#include "support/creases.h"

namespace hgp {
namespace {

using Cones = std::map<VertexId, int>;

HolonomySpec specWith(const Cones& cones) {
  HolonomySpec spec;
  for (const auto& [v, k] : cones) spec.cones.push_back({v, k});
  return spec;
}

/// Sectors as edges between patches and vertices on Γ, and what both have to distribute.
class Transport {
 public:
  Transport(const TriMesh& mesh, const AlignedField& free, const Cones& cones) {
    const Sectors& sectors = free.sectors;
    DisjointSets patches(mesh.faceCount());
    for (HalfedgeId h : mesh.halfedges())
      if (!mesh.isBoundary(h) && !sectors.isFeature[mesh.edge(h)])
        patches.join(TriMesh::face(h).i, TriMesh::face(mesh.twin(h)).i);
    const auto patchAt = [&](HalfedgeId h) { return patches.root(TriMesh::face(h).i); };
    const auto kOf = [&](VertexId v) { return cones.contains(v) ? cones.at(v) : 4; };
    // Gauss–Bonnet: Σ k + Σ a of a patch is the same for all fields.
    for (VertexId v : mesh.vertices()) {
      if (sectors.isOnFeature[v])
        toVertex_[v.i] += kOf(v);
      else
        fromPatch_[patchAt(mesh.outgoing(v))] += free.index[at(v.i)] - kOf(v);
    }
    for (const Sector& s : sectors.list) {
      const int node = sectors.node(mesh, s.first), low = 1;
      const int patch = patchAt(s.first), v = mesh.tail(s.first).i;
      fromPatch_[patch] += free.index[at(node)] - low;
      toVertex_[v] -= low;
      links_.push_back({patch, v, largestIndex(mesh, sectors, node) - low, 0});
    }
  }

  bool isPossible() {
    const auto isNegative = [](const auto& entry) { return entry.second < 0; };
    if (std::any_of(fromPatch_.begin(), fromPatch_.end(), isNegative) ||
        std::any_of(toVertex_.begin(), toVertex_.end(), isNegative))
      return false;
    for (auto& [patch, left] : fromPatch_)
      for (; left > 0; --left) {
        seen_.clear();
        if (!sendFrom(patch)) return false;
      }
    return std::all_of(toVertex_.begin(), toVertex_.end(),
                       [](const auto& entry) { return entry.second == 0; });
  }

 private:
  struct Link {
    int patch, vertex, capacity, flow;
  };

  /// One more unit from a patch, by an augmenting path.
  bool sendFrom(int patch) {
    if (!seen_.insert(patch).second) return false;
    for (Link& link : links_) {
      if (link.patch != patch || link.flow == link.capacity) continue;
      if (toVertex_[link.vertex] > 0) {
        --toVertex_[link.vertex];
        ++link.flow;
        return true;
      }
      for (Link& other : links_)
        if (other.vertex == link.vertex && other.flow > 0 && sendFrom(other.patch)) {
          --other.flow;
          ++link.flow;
          return true;
        }
    }
    return false;
  }

  std::map<int, int> fromPatch_, toVertex_;
  std::vector<Link> links_;
  std::set<int> seen_;
};

Cones prescribedBy(const TriMesh& mesh, const AlignedField& field) {
  Cones cones;
  for (const ConePoint& cone : specOf(mesh, computeTopology(mesh), {}, field, {}).cones)
    cones[cone.vertex] = cone.k;
  return cones;
}

/// Moves units between random vertices, most of them on Γ.
void disturb(const TriMesh& mesh, const AlignedField& field, int units, std::mt19937& random,
             Cones& cones) {
  std::vector<VertexId> on;
  for (VertexId v : mesh.vertices())
    if (field.sectors.isOnFeature[v]) on.push_back(v);
  const auto anyOf = [&](std::size_t count) { return random() % count; };
  const auto any = [&] {
    return anyOf(4) == 0 ? VertexId(static_cast<int>(anyOf(at(mesh.vertexCount()))))
                         : on[anyOf(on.size())];
  };
  for (; units > 0; --units)
    for (const int sign : {1, -1}) cones.try_emplace(any(), 4).first->second += sign;
}

struct Tally {
  int possible = 0, impossible = 0, advised = 0;
};

/// Prescribes what is possible or not, as Transport says, and then what the field has instead.
void expectAsPossible(const std::string& name, const TriMesh& mesh, AlignedField field,
                      const Cones& cones, Tally& tally) {
  const Topology topology = computeTopology(mesh);
  const Geometry geometry = computeGeometry(mesh);
  const bool isPossible = Transport(mesh, field, cones).isPossible();
  field.given = givenIndices(mesh, topology, field.sectors, specWith(cones));
  const Status inside = makeIndicesPossible(mesh, geometry, field);
  const Status done = inside ? makeSumsPossible(mesh, geometry, field) : inside;
  ASSERT_EQ(static_cast<bool>(done), isPossible) << name;
  (isPossible ? tally.possible : tally.impossible)++;
  EXPECT_EQ(hasGivenIndices(mesh, field), isPossible) << name;
  if (isPossible) return;
  EXPECT_EQ(done.error().code, ErrorCode::kPrescription);
  EXPECT_FALSE(done.error().where.empty());
  if (!inside) return;
  EXPECT_TRUE(Transport(mesh, field, prescribedBy(mesh, field)).isPossible()) << name;
  ++tally.advised;
}

TEST(IndexSums, FieldsHavePrescribedConesWhereThatIsPossible) {
  std::mt19937 random(20261129);
  Tally tally;
  std::vector<test::CreasedShape> shapes = test::creasedShapes();
  for (const int n : {1, 2}) {
    TriMesh mesh = test::cube(n).mesh();
    std::vector<EdgeId> features = test::creasesOf(mesh);
    shapes.push_back({"cube of " + std::to_string(n), std::move(mesh), std::move(features)});
  }
  for (const test::CreasedShape& shape : shapes) {
    if (shape.mesh.vertexCount() == 0 || computeTopology(shape.mesh).loops.size() > 0) continue;
    const Result<AlignedField> free =
        alignedField(shape.mesh, prepareSurface(shape.mesh), shape.features);
    ASSERT_TRUE(free) << shape.name;
    for (int units = 0; units < 12; ++units) {
      Cones cones = prescribedBy(shape.mesh, *free);
      disturb(shape.mesh, *free, units / 2, random, cones);
      if (!cones.empty()) expectAsPossible(shape.name, shape.mesh, *free, cones, tally);
    }
  }
  EXPECT_GE(tally.possible, 20);
  EXPECT_GE(tally.impossible, 10);
  EXPECT_GE(tally.advised, 5);
}

TEST(IndexSums, MovesKeepPrescribedSums) {
  const TriMesh mesh = test::cube(4).mesh();
  const Geometry geometry = computeGeometry(mesh);
  const FieldContext context = prepareSurface(mesh);
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  const AlignedField free = *alignedField(mesh, context, features);
  AlignedField field = *alignedField(mesh, context, features, specWith(prescribedBy(mesh, free)));
  int without = 0;
  for (const Sector& s : field.sectors.list)
    for (const int sign : {1, -1}) {
      const int node = field.sectors.node(mesh, s.first);
      AlignedField open = free;
      without += cheapestMoves(mesh, geometry, open, node, sign, 4).empty() ? 0 : 1;
      for (const IndexMove& move : cheapestMoves(mesh, geometry, field, node, sign, 4)) {
        AlignedField next = field;
        applyMove(mesh, move, next);
        EXPECT_TRUE(hasGivenIndices(mesh, next));
      }
    }
  EXPECT_GT(without, 0);
}

TEST(IndexSums, SquaresOfTwoTrianglesHaveNoQuarterTurnToSpare) {
  // Each has four corners of a quarter turn, so that every corner of the cube has three.
  const TriMesh mesh = test::cube(1).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  const FieldContext context = prepareSurface(mesh);
  const Cones own = prescribedBy(mesh, *alignedField(mesh, context, features));
  ASSERT_EQ(own.size(), 8u);
  EXPECT_TRUE(alignedField(mesh, context, features, specWith(own)));
  for (const int k : {2, 4}) {
    Cones cones = own;
    cones.begin()->second = k;
    const Result<AlignedField> field = alignedField(mesh, context, features, specWith(cones));
    ASSERT_FALSE(field) << k;
    ASSERT_EQ(field.error().where.size(), 1u);
    EXPECT_EQ(field.error().where[0].id, own.begin()->first.i);
  }
}

}  // namespace
}  // namespace hgp
