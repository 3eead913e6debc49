#include "hgp/parametrize/along/given_values.h"

#include <algorithm>
#include <optional>

namespace hgp {

void holdOrigin(const TriMesh& mesh, const StraightSetup& setup, const std::vector<int>& variables,
                GivenValues& given) {
  const SeamlessSetup& seamless = setup.seamless;
  for (const auto& chain : seamless.cut.chains)
    if (seamless.seams.rotation[chain.left.front()] != 0) return;
  std::vector<char> isVertex(at(seamless.unknowns.count), 0);
  for (VertexId v : mesh.vertices())
    if (seamless.unknowns.vertexUnknown[v] >= 0)
      isVertex[at(seamless.unknowns.vertexUnknown[v])] = 1;
  const auto isOf = [&](int unknown, int part) {
    const int variable = setup.unknowns.variable[at(unknown)];
    return variable % 2 == part && isVertex[at(variable / 2)];
  };
  for (const int part : {0, 1}) {
    bool isHeld = std::any_of(variables.begin(), variables.end(),
                              [&](int unknown) { return isOf(unknown, part); });
    for (int i = 0; !isHeld && i < setup.unknowns.count; ++i) {
      isHeld = isOf(i, part);
      if (isHeld) given.push_back({i, 0.0});
    }
  }
}

std::vector<FaceId> reversedByGiven(const TriMesh& mesh, const StraightSetup& setup,
                                    const GivenValues& given) {
  const RealUnknowns& unknowns = setup.unknowns;
  std::vector<std::optional<double>> value(at(unknowns.count));
  for (const auto& [unknown, x] : given) value[at(unknown)] = x;
  const auto part = [&](int row) -> std::optional<double> {
    double sum = 0.0;
    for (RealUnknowns::Rows::InnerIterator it(unknowns.rows, row); it; ++it) {
      const std::optional<double>& x = value[at(it.col())];
      if (!x) return {};
      sum += it.value() * *x;
    }
    return sum;
  };
  const CutMesh& cut = setup.seamless.cut;
  std::vector<std::optional<Complex>> place(at(cut.vertexCount()));
  for (std::size_t c = 0; c < place.size(); ++c) {
    const std::optional<double> u = part(2 * static_cast<int>(c));
    if (!u) continue;
    if (const std::optional<double> v = part(2 * static_cast<int>(c) + 1)) place[c].emplace(*u, *v);
  }
  std::vector<FaceId> reversed;
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    const auto& a = place[at(cut.copy[h].i)];
    const auto& b = place[at(cut.copy[TriMesh::next(h)].i)];
    const auto& c = place[at(cut.copy[TriMesh::previous(h)].i)];
    if (a && b && c && !(std::imag(std::conj(*b - *a) * (*c - *a)) > 0.0)) reversed.push_back(f);
  }
  return reversed;
}

}  // namespace hgp
