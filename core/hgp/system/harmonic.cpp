#include "hgp/system/harmonic.h"

#include <algorithm>

#include "hgp/base/parallel.h"
#include "hgp/system/row_builder.h"

namespace hgp {
namespace {

/// The two terms of a translation cancel along its chain; smaller sums are rounding errors.
constexpr double kMinWeight = 1e-14;
/// The rows of fewer vertices are not shared.
constexpr int kFewVertices = 2000;

/// The rows of all, one below the other.
SparseRows joined(const std::vector<HarmonicSystem>& pieces) {
  Eigen::Index rows = 0, entries = 0;
  for (const HarmonicSystem& piece : pieces) {
    rows += piece.rows.rows();
    entries += piece.rows.nonZeros();
  }
  SparseRows out(rows, pieces.front().rows.cols());
  out.resizeNonZeros(entries);
  Eigen::Index row = 0, entry = 0;
  for (const HarmonicSystem& piece : pieces) {
    const SparseRows& from = piece.rows;
    for (Eigen::Index r = 0; r < from.rows(); ++r)
      out.outerIndexPtr()[row + r] = static_cast<int>(entry) + from.outerIndexPtr()[r];
    std::copy_n(from.innerIndexPtr(), from.nonZeros(), out.innerIndexPtr() + entry);
    std::copy_n(from.valuePtr(), from.nonZeros(), out.valuePtr() + entry);
    row += from.rows();
    entry += from.nonZeros();
  }
  out.outerIndexPtr()[row] = static_cast<int>(entry);
  return out;
}

struct RowSource {
  const TriMesh& mesh;
  const Geometry& geometry;
  const CutMesh& cut;
  const ReducedUnknowns& unknowns;
  int q;
  WeightKind kind;
  PerVertex<char> isCone;

  bool hasRow(VertexId v) const { return !mesh.isIsolated(v) && !mesh.isBoundary(v) && !isCone[v]; }

  /// The rows of vertices begin … end − 1.
  HarmonicSystem rows(int begin, int end) const {
    HarmonicSystem system;
    RowBuilder builder(unknowns.count, end - begin, 7 * at(end - begin));
    std::vector<CornerWeights> weights;
    for (VertexId v(begin); v.i < end; ++v.i) {
      if (!hasRow(v)) continue;
      system.rowVertex.push_back(v);
      addRow(v, weights, builder);
      builder.endRow(kMinWeight);
    }
    system.rows = builder.take();
    return system;
  }

  void addRow(VertexId v, std::vector<CornerWeights>& weights, RowBuilder& builder) const {
    const auto addCopy = [&](HalfedgeId h, const Complex& factor) {
      for (SparseRows::InnerIterator it(unknowns.copies, cut.copy[h].i); it; ++it)
        builder.add(static_cast<int>(it.col()), factor * it.value());
    };
    weights.clear();
    double total = 0.0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      weights.push_back(cornerWeights(kind, mesh, geometry, h));
      total += weights.back().toHead + weights.back().toThird;
    }
    auto w = weights.begin();
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const Complex back = rotation(-unknowns.turn[cut.copy[h]], q) / total;
      addCopy(h, back * (w->toHead + w->toThird));
      addCopy(TriMesh::next(h), -back * w->toHead);
      addCopy(TriMesh::previous(h), -back * w->toThird);
      ++w;
    }
  }
};

}  // namespace

HarmonicSystem harmonicSystem(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                              const ReducedUnknowns& unknowns, int q,
                              const std::vector<VertexId>& cones, WeightKind kind) {
  RowSource source{
      mesh, geometry, cut, unknowns, q, kind, PerVertex<char>(at(mesh.vertexCount()), 0)};
  for (VertexId v : cones) source.isCone[v] = 1;
  // Few pieces, as each has an index of all unknowns.
  const int count = threadCount() == 1 ? 1 : 2 * threadCount();
  if (count == 1 || mesh.vertexCount() < kFewVertices) return source.rows(0, mesh.vertexCount());
  const int block = mesh.vertexCount() / count + 1;
  std::vector<HarmonicSystem> pieces(at((mesh.vertexCount() - 1) / block + 1));
  parallelBlocks(mesh.vertexCount(), block,
                 [&](int begin, int end) { pieces[at(begin / block)] = source.rows(begin, end); });
  HarmonicSystem system;
  system.rows = joined(pieces);
  for (const HarmonicSystem& piece : pieces)
    system.rowVertex.insert(system.rowVertex.end(), piece.rowVertex.begin(), piece.rowVertex.end());
  return system;
}

}  // namespace hgp
