// The models of the figures, each given by a formula.  Role: data without third-party copyright.
#pragma once

#include <string>
#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp::models {

/// The icosahedron with every triangle divided into 4^levels, projected to the unit sphere.
MeshData sphere(int levels);
/// A sphere with twelve holes.
MeshData colander(int levels);
/// A torus of revolution, radii 1 and 0.4.
MeshData torus(int around, int along);
/// A tube along the trefoil.
MeshData knot(int around, int along);
/// A fluted vase without a bottom: two boundary loops.
MeshData vase(int around, int along);
/// A rounded cube.
MeshData cube(int cells);
/// A slab with three holes.
MeshData pretzel(int cells);
/// Body, legs, horns and a tail, blended together.
MeshData creature(int cells);
/// A twisted cubic lattice of rods, genus 28.
MeshData lattice(int cells);
/// A gear wheel with a bore, `steps` edges along each side of a tooth: creases of 90° and at its teeth, genus 1.
MeshData gear(int teeth, int steps);
/// Five rings blended together in a row, genus 5.
MeshData rings(int cells);
/// About 10⁶ triangles of genus 0 and 5.
MeshData creatureOfAMillion();
MeshData ringsOfAMillion();

/// All of the above in a size for pictures, and `million`, a creature of about 10⁶ triangles.
const std::vector<std::string>& names();
/// A model by name, including `small-pretzel`, which is examples/meshes/pretzel.obj. Empty for unknown names.
MeshData byName(const std::string& name);

}  // namespace hgp::models
