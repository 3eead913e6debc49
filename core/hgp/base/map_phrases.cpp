#include "hgp/base/phrase.h"

namespace hgp {

namespace {

// An entry begins on a line of its own: wasm/phrases.mjs reads the catalogue.
constexpr Phrase kMaps[] = {
    {"map-crushed",
     "{crushed} of {triangles|triangle} {crushed#is|are} crushed: area scale below {scale:g} of "
     "the median, the smallest {smallest:.1e} of it (triangle {@triangle}, at {x:.4g} {y:.4g} "
     "{z:.4g}). Place a cone there, or more cones."},
    {"map-stretched",
     "These cones stretch the surface by e^{range}; expect strong area distortion. More cones "
     "lower it."},
    {"map-unresolved",
     "These cones stretch the surface by e^{range} where angles are kept: double precision "
     "cannot resolve such areas. Add cones in the regions that shrink."},
    {"map-frames-contradict",
     "The frames of the best program contradict each other, as a Farkas certificate shows to 8 "
     "digits: of {frames|constrained triangle}, {strained|of them is|of them are} strained most "
     "(see conflict)."},
    {"map-frames-unmet",
     "The best program found no map that turns all frames as asked: of {frames|constrained "
     "triangle}, {strained|of them is|of them are} strained most (see conflict)."},
    {"map-given-frames",
     "The frames were those of the field file. Automatic frames have the same cones, turning and "
     "handles but turn evenly: a map with them may be certified."},
    {"map-evened-lengths",
     "Many triangles are very thin, and the surface's own edge lengths gave no map. This one is "
     "harmonic with evened lengths instead: as seamless and as free of folds, with more "
     "distortion. --improve isometric (improve) lowers it."},
    {"map-own-cones",
     "No map without folds has the cones that were chosen first. This one has others at "
     "{vertices|vertex|vertices}, which are part of the prescription now."},
    {"map-not-improved",
     "The map is not improved, as the verifier did not accept the improved map: "
     "[rule:it breaks the rule {rule} at {places|place}, by {worst} at worst ({@}).]"
     "[!rule:it is no better on the surface itself.]"},
    {"map-areas-lowered",
     "Areas of the map spanned more than double precision resolves: its distortion was lowered."},
    {"map-small-improved",
     "the map as solved has triangles too small for the numbers of the format; it is improved, "
     "as by --improve isometric"},
    {"symmetric",
     "the map is its own mirror image across the plane {plane}; vertices of the mesh are off "
     "theirs by at most {off:.2g} of the diagonal. Lines follow the plane, and the rims of what it "
     "cuts.[pairs: {pairs|component is the image of another|components are images of others}.]"},
    {"symmetric-split",
     "THE MESH HAS MORE TRIANGLES: {edges|edge was|edges were} split at the midpoint, so that the "
     "plane of symmetry has edges in it. The written mesh has {vertices} vertices and {triangles} "
     "triangles instead of {verticesBefore} and {trianglesBefore}; vertices keep their ids."},
    {"features-contradict",
     "The lengths of features contradict each other, or leave a cone no place between them: "
     "{edges|feature edge} would have no length, whatever the map (see conflict). Leave out one of "
     "these."},
    {"features-straightened",
     "{steps|step} of features would have no length, because the lines around allow none; the "
     "map goes straight on there."},
    {"features-moved",
     "{units|cone or corner was|cones and corners were} moved, because no map was found with those "
     "of the smoothest field"},
    {"features-split",
     "THE MESH HAS MORE TRIANGLES: {edges|edge was|edges were} split at the midpoint, because a "
     "map along all features[grid:, on the lines of a grid,] has no room otherwise. The certified "
     "and written mesh has {vertices} "
     "vertices and {triangles} triangles instead of {verticesBefore} and {trianglesBefore}; "
     "vertices keep their ids, new ones follow, and halves of features are features."},
    {"features-split-in-vain",
     "no map along these features[grid: on the lines of a grid] on the mesh with split edges "
     "({triangles} triangles) either"},
    {"split-as-polygons",
     "this file cannot store split edges: only positions and triangles are kept, no materials, "
     "normals or other attributes"},
    {"features-no-grid", "the lines of these features and the seams have no common grid"},
    {"features-many-integers",
     "the lines of these features have {integers} integers to choose, and at most {most} are "
     "chosen; with fewer features there are fewer"},
    {"features-grid-work",
     "the {integers} integers of the lines of these features were not chosen within the work "
     "allowed at {cells:.0f} cells; with fewer features, or more cells, there is less to choose"},
    {"features-no-integers",
     "no choice of integers kept lines apart and all triangles positive at {cells:.0f} "
     "cells[working:; {working:.0f} cells would work][these: with the cones of this run]"},
    {"map-dragged",
     "The cone at vertex {@vertex} was dragged there. This map follows from the one before and "
     "from the path of the drag; the bytes of a run with the same cones depend on nothing else."},
    {"component-without-map",
     "component {component} has no map of its own; it keeps its uv or is cut to a disk: {message}"},
    {"cones-other",
     "the cones chosen first have no map on this mesh; those chosen for “{purpose}” are used "
     "instead"},
    {"refine-offered",
     "no map on this mesh: it may be too coarse for the prescription. --refine (refine: true) "
     "splits edges, tries again, and writes the refined mesh"},
    {"method-offered",
     "no map on this mesh by the method “{method}” alone; without --method (method: auto) others "
     "are tried after it"},
    {"refined",
     "THE MESH WAS REFINED: {edges|edge is|edges are} split ({places}), because "
     "{programs|program} gave no map of the original mesh. The certified and written mesh has "
     "{vertices} vertices and {triangles} triangles instead of {verticesBefore} and "
     "{trianglesBefore}; vertices keep their ids, new ones follow."},
    {"refine-nowhere", "nothing was refined: the places where this map is wrong are not known"},
    {"refine-in-vain", "no map on the mesh refined to {triangles} triangles either"},
    {"stored-moved",
     "{moved} of {components|component} moved or scaled to survive the rounding of the format"},
    {"stored-broken",
     "{broken} of {components|component} certified before the rounding of the format, but not "
     "after it"},
};

}  // namespace

std::span<const Phrase> mapPhrases() { return kMaps; }

}  // namespace hgp
