// The note that says why a mesh has no map with some angles.  Role: for checks, reports and the page.
#pragma once

#include "hgp/base/note.h"
#include "hgp/mesh/angle_shortage.h"

namespace hgp {

/// The code "angle-shortage": which cones, vertices and rims ask for how much, and how many triangles cannot give it.
/// Its places and names are vertices of the mesh and loops of its topology.
Note noteOn(const AngleQuestion& question, const AngleShortage& shortage);

}  // namespace hgp
