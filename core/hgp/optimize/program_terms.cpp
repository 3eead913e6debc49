#include "hgp/optimize/program_terms.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {

int pinnedUnknown(const ProgramInput& in) {
  VertexId pinned;
  const auto consider = [&](VertexId v) {
    if (in.unknowns.vertexUnknown[v] < 0) return;
    if (!pinned.isValid() || in.options.u[v] < in.options.u[pinned]) pinned = v;
  };
  for (FaceId f : in.frames.faces)
    for (VertexId v : in.mesh.corners(f)) consider(v);
  // The exact form requires the pinned unknown to be one that its rows do not determine.
  if (!pinned.isValid())
    for (FaceId f : in.options.soft.faces)
      for (VertexId v : in.mesh.corners(f)) consider(v);
  if (!pinned.isValid())
    for (VertexId v : in.mesh.vertices()) consider(v);
  if (pinned.isValid()) return in.unknowns.vertexUnknown[pinned];
  // Every vertex is a cone determined by its chains: translating the map changes the translation of each
  // chain with a rotation, so one of these is held.
  for (std::size_t c = 0; c < in.cut.chains.size(); ++c)
    if (in.unknowns.chainUnknown[c] >= 0 && in.seams.rotation[in.cut.chains[c].left[0]] != 0)
      return in.unknowns.chainUnknown[c];
  return -1;
}

double faceScale(const ProgramInput& in, FaceId f) {
  double sum = 0.0;
  for (VertexId v : in.mesh.corners(f)) sum += in.options.u[v] / 3.0;
  return sum;
}

HeldUnknowns heldUnknowns(const ProgramInput& in) {
  const auto count = static_cast<std::size_t>(in.unknowns.count);
  if (const Patch* patch = in.options.patch()) {
    HeldUnknowns held{std::vector<char>(count), patch->x};
    for (std::size_t i = 0; i < count; ++i) held.isHeld[i] = !patch->isFree[i];
    return held;
  }
  HeldUnknowns held{std::vector<char>(count, 0), Eigen::VectorXcd::Zero(in.unknowns.count)};
  const int pinned = pinnedUnknown(in);
  if (pinned >= 0) held.isHeld[static_cast<std::size_t>(pinned)] = 1;
  return held;
}

void faceRows(const ProgramInput& in, const HeldUnknowns& held, FaceId f, FaceRows& rows) {
  rows.unknowns.clear();
  const SparseRows& copies = in.unknowns.copies;
  const auto isHeld = [&](Eigen::Index unknown) {
    return held.isHeld[static_cast<std::size_t>(unknown)] != 0;
  };
  for (int k = 0; k < 3; ++k)
    for (SparseRows::InnerIterator it(copies, in.cut.copy[TriMesh::halfedge(f, k)].i); it; ++it)
      if (!isHeld(it.col())) rows.unknowns.push_back(static_cast<int>(it.col()));
  std::sort(rows.unknowns.begin(), rows.unknowns.end());
  rows.unknowns.erase(std::unique(rows.unknowns.begin(), rows.unknowns.end()), rows.unknowns.end());
  rows.similar.assign(rows.unknowns.size(), 0.0);
  rows.anti.assign(rows.unknowns.size(), 0.0);
  rows.heldSimilar = rows.heldAnti = 0.0;
  const LinearParts parts = linearParts(in.geometry, f);
  for (int k = 0; k < 3; ++k)
    for (SparseRows::InnerIterator it(copies, in.cut.copy[TriMesh::halfedge(f, k)].i); it; ++it) {
      const Complex similar = parts.similarity[static_cast<std::size_t>(k)] * it.value();
      const Complex anti = parts.antisimilarity[static_cast<std::size_t>(k)] * it.value();
      if (isHeld(it.col())) {
        rows.heldSimilar += similar * held.value[it.col()];
        rows.heldAnti += anti * held.value[it.col()];
        continue;
      }
      const auto at = static_cast<std::size_t>(
          std::find(rows.unknowns.begin(), rows.unknowns.end(), static_cast<int>(it.col())) -
          rows.unknowns.begin());
      rows.similar[at] += similar;
      rows.anti[at] += anti;
    }
}

socp::ConeConstraint frameCondition(const ProgramInput& in, const FaceRows& rows, std::size_t j) {
  const double scale = portable::exp(-faceScale(in, in.frames.faces[j]));
  const Complex turn = portable::polar(scale, in.frames.angles[j]);
  socp::ConeConstraint constraint;
  constraint.F.resize(3, static_cast<Eigen::Index>(2 * rows.unknowns.size()));
  for (std::size_t i = 0; i < rows.unknowns.size(); ++i) {
    const Complex similar = turn * rows.similar[i], anti = scale * rows.anti[i];
    const auto column = static_cast<Eigen::Index>(2 * i);
    constraint.F.col(column) << similar.real(), anti.real(), anti.imag();
    constraint.F.col(column + 1) << -similar.imag(), -anti.imag(), anti.real();
  }
  const Complex anti = scale * rows.heldAnti;
  constraint.h << in.options.margin - (turn * rows.heldSimilar).real(), -anti.real(), -anti.imag();
  return constraint;
}

DistortionRows distortionRows(const ProgramInput& in, FaceId f, double delta) {
  const double target = std::sqrt(delta * in.geometry.area[f]);  // weight · e^u
  const double weight = target * portable::exp(-faceScale(in, f));
  return {portable::polar(weight, in.seams.frameAngle[f]), weight, target};
}

}  // namespace hgp
