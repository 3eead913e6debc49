// The discrete conformal metric with given cone angles.  Role: the conformal method with which maps are compared;
// it shares only geometry and the numbering of nodes with our fields.
#pragma once

#include "hgp/field/filled_surface.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp::bench {

struct ConformalOptions {
  int maxSteps = 200;
  double tolerance = 1e-11;  ///< of the largest angle sum's error, radians
  double maxSeconds = 0.0;   ///< of processor time; 0 = no limit
};

struct ConformalMetric {
  PerHalfedge<double> length;  ///< of the halfedge's edge
  int steps = 0;
  int broken = 0;         ///< triangles whose final lengths violate the triangle inequality
  double residual = 0.0;  ///< largest error of an angle sum, radians
  bool isLate = false;
  bool isFound = false;  ///< within the tolerance, and no triangle is broken
};

/// Springborn, Schröder and Pinkall 2008 on the given triangulation: l̃_ij = e^{(u_i + u_j)/2} l_ij such that
/// angles sum to 2πk/q at the vertices, and to π n − 2πl/q over the n vertices of a loop, which share one u
/// (a free boundary, scaled as a whole). With Θ̂ the prescribed sums and α̃ the angles, Newton's method on the convex
/// E(u) with ∂E/∂u_i = Θ̂_i − Σ α̃, whose Hessian is the cotangent Laplacian of l̃. Broken triangles have angles π, 0,
/// 0, which keeps E convex on all u: a minimum with broken triangles means that no such metric exists. Steps
/// are halved while they pass the minimum along their direction by far.
/// Rotations along loops and handles are not prescribed: above genus 0 such a metric is seamless only by chance.
ConformalMetric conformalMetric(const TriMesh& mesh, const Geometry& geometry,
                                const Topology& topology, const FilledSurface& surface,
                                const CompleteSpec& spec, const ConformalOptions& options);

}  // namespace hgp::bench
