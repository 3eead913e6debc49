// A cut surface with the parametrization of its seamless maps.  Role: common input of the conic program, of
// improve() and of untangle().
#pragma once

#include "hgp/cut/cut_mesh.h"
#include "hgp/cut/seam_rotation.h"
#include "hgp/mesh/geometry.h"
#include "hgp/mesh/tri_mesh.h"
#include "hgp/system/harmonic.h"

namespace hgp {

/// References only; the objects must outlive it.
struct SeamlessSystem {
  const TriMesh& mesh;
  const Geometry& geometry;
  const CutMesh& cut;
  const SeamRotations& seams;       ///< with the direction of every triangle's frame
  const ReducedUnknowns& unknowns;  ///< z = copies · x: whatever x, all seams are met
  const HarmonicSystem& harmonic;   ///< L, in the same unknowns
};

}  // namespace hgp
