#include "hgp/features/field_along.h"

#include <array>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/features/fitted_field.h"
#include "hgp/features/index_flow.h"
#include "hgp/features/index_sums.h"
#include "hgp/field/smooth_field.h"

namespace hgp {
namespace {

constexpr double kQuarter = kPi / 2.0;

/// Directions of the triangles along features, and the axes of their feature edges.
Status holdFaces(const TriMesh& mesh, const Geometry& geometry, AlignedField& out,
                 std::vector<HeldDirection>& held) {
  std::vector<Where> crowded;
  for (FaceId f : mesh.faces()) {
    std::array<char, 3> isFeature{};
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      isFeature[at(k)] = out.sectors.isFeature[mesh.edge(TriMesh::halfedge(f, k))];
      count += isFeature[at(k)];
    }
    if (count == 0) continue;
    if (count == 3) {
      crowded.push_back({Where::Kind::kFace, f.i});
      continue;
    }
    int k = 0;  // the feature edge, or the first of two consecutive ones
    while (!isFeature[at(k)] || (count == 2 && !isFeature[at((k + 1) % 3)])) ++k;
    const HalfedgeId h = TriMesh::halfedge(f, k), after = TriMesh::next(h);
    double angle = geometry.direction[h];
    if (count == 2) {  // a quarter turn between them, both tilted by the same angle
      out.axis[after] = 1;
      angle += 0.5 * (kQuarter - geometry.cornerAngle[after]);
    }
    held.push_back({f, angle});
  }
  if (crowded.empty()) return Done{};
  return Failure{ErrorCode::kPrescription, "features",
                 counted(crowded.size(), "triangle") +
                     " with three feature edges: no triangle has three sides along two axes. "
                     "Leave out one of the edges or split the triangle.",
                 std::move(crowded)};
}

/// Matchings across features from the axes on both sides, elsewhere principal; turns and tilts of the whole field.
void readTurns(const TriMesh& mesh, const Geometry& geometry, AlignedField& out) {
  FrameField& field = out.field;
  matchPrincipally(mesh, geometry, field);
  for (HalfedgeId h : mesh.halfedges()) {
    const FaceId f = TriMesh::face(h);
    const HalfedgeId twin = mesh.twin(h);
    const bool isFeature = out.sectors.isFeature[mesh.edge(h)] != 0;
    if (isFeature)
      out.tilt[h] = principalAngle(out.axis[h] * kQuarter - geometry.direction[h] + field.angle[f]);
    if (!twin.isValid() || twin < h) continue;
    if (isFeature) {
      field.matching[h] = out.axis[twin] + 2 - out.axis[h];
      field.matching[twin] = -field.matching[h];
    }
    const double rest = field.angle[TriMesh::face(twin)] + field.matching[h] * kQuarter -
                        field.angle[f] - transport(mesh, geometry, h);
    out.turn[h] = principalAngle(rest);
    out.turn[twin] = -out.turn[h];
  }
}

/// Indices of all nodes from turns and tilts.
void readIndices(const TriMesh& mesh, const Geometry& geometry, AlignedField& out) {
  const Sectors& sectors = out.sectors;
  std::vector<double> sum(at(mesh.vertexCount()) + sectors.list.size(), 0.0);
  for (HalfedgeId h : mesh.halfedges()) {
    double& node = sum[at(sectors.node(mesh, h))];
    node += geometry.cornerAngle[h];
    const HalfedgeId into = TriMesh::previous(h);  // crossed next, counterclockwise
    if (!sectors.isFeature[mesh.edge(into)]) node -= out.turn[into];
  }
  for (std::size_t s = 0; s < sectors.list.size(); ++s)
    sum[at(mesh.vertexCount()) + s] +=
        out.tilt[sectors.list[s].last] - out.tilt[sectors.list[s].first];
  out.index.assign(sum.size(), 0);
  for (std::size_t n = 0; n < sum.size(); ++n) {
    out.index[n] = static_cast<int>(std::lround(sum[n] / kQuarter));
    HGP_CHECK(std::abs(sum[n] / kQuarter - out.index[n]) < 1e-6,
              "an aligned field has integer indices, not %g", sum[n] / kQuarter);
  }
}

}  // namespace

Result<AlignedField> alignedField(const TriMesh& mesh, const FieldContext& context,
                                  const std::vector<EdgeId>& features, const HolonomySpec& asked) {
  const Geometry& geometry = context.geometry;
  AlignedField out;
  out.sectors = findSectors(mesh, features);
  out.axis = PerHalfedge<int>(at(mesh.halfedgeCount()), 0);
  out.turn = out.tilt = PerHalfedge<double>(at(mesh.halfedgeCount()), 0.0);
  SmoothFieldOptions options;
  options.alignToBoundary = false;
  if (Status done = holdFaces(mesh, geometry, out, options.held); !done)
    return std::move(done).error();
  Result<FrameField> field = smoothField(mesh, context, options);
  if (!field) return std::move(field).error();
  out.field = std::move(*field);
  readTurns(mesh, geometry, out);
  readIndices(mesh, geometry, out);
  out.corners = asked.corners;
  out.given = givenIndices(mesh, context.topology, out.sectors, asked);
  if (Status done = makeIndicesPossible(mesh, geometry, out); !done) return std::move(done).error();
  if (Status done = makeSumsPossible(mesh, geometry, out); !done) return std::move(done).error();
  if (out.moved > 0) fitField(mesh, geometry, out);
  return out;
}

}  // namespace hgp
