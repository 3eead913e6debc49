#include "hgp/parametrize/after/real_pairs.h"

namespace hgp {
namespace {

constexpr int kNowhere = -1, kAtSeveral = -2;

}  // namespace

RealPairs::RealPairs(const TriMesh& mesh, const CutMesh& cut, const ReducedUnknowns& unknowns,
                     const RealUnknowns& real, const std::vector<char>& isHeld)
    : parts_(real.variable), isHeld_(at(4 * unknowns.count), 1) {
  pairs_.count = 2 * unknowns.count;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    int& part = parts_[i];
    if (!isHeld.empty() && isHeld[i] != 0)
      part += pairs_.count;
    else
      isHeld_[at(part / 2)] = isHeld_[at(part / 2 + pairs_.count)] = 0;
  }
  std::vector<int> place(at(pairs_.count), kNowhere);
  RowBuilder builder(2 * pairs_.count, cut.vertexCount(), 2 * at(cut.vertexCount()));
  for (int c = 0; c < cut.vertexCount(); ++c) {
    const int vertex = cut.parent[CutVertexId(c)].i;
    for (const int part : {0, 1})
      for (RealUnknowns::Rows::InnerIterator it(real.rows, 2 * c + part); it; ++it) {
        const int own = parts_[at(it.col())], pair = own / 2;
        const Complex half(part == 0 ? 0.5 * it.value() : 0.0, part == 1 ? 0.5 * it.value() : 0.0);
        const Complex turned(half.imag(), -half.real());
        builder.add(pair, own % 2 == 0 ? half : turned);
        builder.add(pairs_.count + pair, own % 2 == 0 ? half : -turned);
        int& only = place[at(pair)];
        only = only == kNowhere || only == vertex ? vertex : kAtSeveral;
      }
    builder.endRow(0.0);
  }
  pairs_.copies = builder.take();
  pairs_.vertexUnknown = unknowns.vertexUnknown;
  for (VertexId v : mesh.vertices()) {
    int& unknown = pairs_.vertexUnknown[v];
    if (unknown >= 0 && place[at(unknown)] != v.i) unknown = -1;
  }
}

Eigen::VectorXcd RealPairs::pairsOf(const Eigen::VectorXd& values) const {
  Eigen::VectorXcd x = Eigen::VectorXcd::Zero(2 * pairs_.count);
  setParts(values, parts_, x);
  for (int i = 0; i < pairs_.count; ++i) x[pairs_.count + i] = std::conj(x[i]);
  return x;
}

}  // namespace hgp
