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
  gatherFaceRows(
      linearParts(in.geometry, f), CornerCopies{in.cut, in.unknowns, f},
      [&](int unknown) { return held.isHeld[at(unknown)] ? -1 : unknown; }, held.value, rows);
  std::sort(rows.terms.begin(), rows.terms.end(),
            [](const auto& a, const auto& b) { return a.unknown < b.unknown; });
}

socp::ConeConstraint frameCondition(const ProgramInput& in, const FaceRows& rows, std::size_t j) {
  const double scale = portable::exp(-faceScale(in, in.frames.faces[j]));
  return coneCondition(rows, portable::polar(scale, in.frames.angles[j]), scale, in.options.margin);
}

void scaleToDistortion(const ProgramInput& in, FaceId f, double delta, FaceRows& rows) {
  const double target = std::sqrt(delta * in.geometry.area[f]);  // weight · e^u
  const double weight = target * portable::exp(-faceScale(in, f));
  rows.scale(portable::polar(weight, in.seams.frameAngle[f]), weight);
  rows.heldSimilar -= target;
}

}  // namespace hgp
