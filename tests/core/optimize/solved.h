// A cut surface with its harmonic system, and the verifier's view of a map of it.
#pragma once

#include "hgp/optimize/program.h"
#include "hgp/verify/certificate.h"
#include "support/seamless.h"

namespace hgp::test {

struct SeamlessProblem {
  CutSurface surface;
  ReducedUnknowns unknowns;
  HarmonicSystem harmonic;

  ProgramOptions plainOptions() const {
    ProgramOptions options;
    options.u = PerVertex<double>(static_cast<std::size_t>(surface.mesh.vertexCount()), 0.0);
    return options;
  }
  ProgramOptions weightedOptions() const {
    ProgramOptions options;
    options.u = surface.field.u;
    return options;
  }
  Frames frames() const {
    return fieldFrames(surface.seams, coneAndBoundaryFaces(surface.mesh, surface.cones));
  }
  ProgramResult solve(const Frames& frames, const ProgramOptions& options) const {
    return solveProgram(system(), frames, options);
  }
  SeamlessSystem system() const {
    return {surface.mesh, surface.context.geometry, surface.cut, surface.seams, unknowns, harmonic};
  }
  UvMap map(const std::vector<Complex>& z) const {
    UvMap map;
    for (const Complex& p : z) map.uv.push_back({p.real(), p.imag()});
    for (FaceId f : surface.mesh.faces()) {
      std::array<int, 3> corners{};
      for (int k = 0; k < 3; ++k)
        corners[static_cast<std::size_t>(k)] = surface.cut.copy[TriMesh::halfedge(f, k)].i;
      map.cornerUv.push_back(corners);
    }
    return map;
  }
  Certificate certify(const std::vector<Complex>& z) const {
    return hgp::certify(surface.mesh, surface.field.spec, map(z));
  }
  /// f_z and f_z̄ of a face.
  std::pair<Complex, Complex> partsOf(FaceId f, const std::vector<Complex>& z) const {
    const LinearParts parts = linearParts(surface.context.geometry, f);
    Complex similarity = 0.0, antisimilarity = 0.0;
    for (int k = 0; k < 3; ++k) {
      const Complex value =
          z[static_cast<std::size_t>(surface.cut.copy[TriMesh::halfedge(f, k)].i)];
      similarity += parts.similarity[static_cast<std::size_t>(k)] * value;
      antisimilarity += parts.antisimilarity[static_cast<std::size_t>(k)] * value;
    }
    return {similarity, antisimilarity};
  }
};

inline SeamlessProblem problemOf(CutSurface surface) {
  SeamlessProblem p{std::move(surface), {}, {}};
  const CutSurface& s = p.surface;
  p.unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
  p.harmonic = harmonicSystem(s.mesh, s.context.geometry, s.cut, p.unknowns, s.seams.q, s.cones);
  return p;
}

/// The icosphere with the given cones at well spread vertices.
inline SeamlessProblem sphereProblem(int n, int q, const std::vector<int>& k) {
  const TriMesh mesh = icosphere(n).mesh();
  HolonomySpec spec;
  spec.q = q;
  const std::vector<VertexId> places = spreadVertices(mesh, static_cast<int>(k.size()));
  for (std::size_t i = 0; i < k.size(); ++i) spec.cones.push_back({places[i], k[i]});
  return problemOf(*cutSurface("sphere", mesh, spec));
}

}  // namespace hgp::test
