// Surfaces with a prescription, cut open.  Role: one line from a shape to S_c and its rotations.
#pragma once

#include <string>
#include <vector>

#include "hgp/cut/seam_rotation.h"
#include "hgp/field/prescribed_field.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp::test {

struct CutSurface {
  std::string name;
  TriMesh mesh;
  FieldContext context;
  PrescribedField field;
  std::vector<VertexId> cones;
  CutMesh cut;
  SeamRotations seams;

  int k(VertexId v) const {
    for (const ConePoint& cone : field.spec.cones)
      if (cone.vertex == v) return cone.k;
    return field.spec.q;
  }
  bool isCone(VertexId v) const { return k(v) != field.spec.q; }
  /// Degree of v in G_s.
  int seamDegree(VertexId v) const {
    int degree = 0;
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      degree += cut.isSeam[e] && (mesh.tail(h) == v || mesh.head(h) == v);
    }
    return degree;
  }
};

/// Nothing when the turning cannot be completed.
inline std::optional<CutSurface> cutSurface(const std::string& name, const TriMesh& mesh,
                                            const HolonomySpec& spec) {
  CutSurface s;
  s.name = name;
  s.mesh = mesh;
  Result<FieldContext> context = prepareFields(s.mesh);
  if (!context) return {};
  s.context = std::move(*context);
  Result<PrescribedField> field = prescribedField(s.mesh, s.context, spec);
  if (!field) return {};
  s.field = std::move(*field);
  for (const ConePoint& cone : s.field.spec.cones) s.cones.push_back(cone.vertex);
  s.cut =
      cutToDisk(s.mesh, seamGraph(s.mesh, s.context.geometry, s.context.surface, s.cones), s.cones);
  s.seams = seamRotations(s.mesh, s.cut, s.field.field);
  return s;
}

/// Small shapes of every topology with random prescriptions, among them cones with k ≡ 0 (mod q),
/// no cones at all, and branched seams.
inline std::vector<CutSurface> makeCutSurfaces(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<CutSurface> surfaces;
  for (const Shape& shape : all()) {
    const TriMesh mesh = shape.mesh();
    const Topology topology = computeTopology(mesh);
    for (const auto& [q, cones] : {std::pair{1, 3}, {2, 4}, {3, 3}, {4, 6}, {5, 0}, {6, 9}}) {
      const auto spec = randomSpec(mesh, topology, {q, cones, true, false}, random);
      if (!spec) continue;
      auto s = cutSurface(shape.name + " q=" + std::to_string(q) + " n=" + std::to_string(cones),
                          mesh, *spec);
      if (s) surfaces.push_back(std::move(*s));
    }
  }
  return surfaces;
}

/// Those of most tests, made once in a program.
inline const std::vector<CutSurface>& cutSurfaces() {
  static const std::vector<CutSurface> surfaces = makeCutSurfaces(43);
  return surfaces;
}

}  // namespace hgp::test
