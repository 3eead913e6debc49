#include "hgp/base/phrase.h"

namespace hgp {

namespace {

// An entry begins on a line of its own: wasm/phrases.mjs reads the catalogue.
constexpr Phrase kOthers[] = {
    // Reading.
    {"read-gzip-longer", "ignored: {bytes|byte} after the gzip data"},
    {"read-stl-longer", "ignored: {bytes|byte} after the last triangle"},
    {"read-glb-followed", "ignored: {bytes|byte} after the end of the GLB"},
    {"read-glb-longer", "the length in the GLB header leaves out {bytes|byte}, which are read"},
    {"read-glb-unpadded", "a chunk's length is not a multiple of 4"},
    {"read-stl-count", "the count in the header is 0; the file holds {triangles|triangle}"},
    {"read-joined-equal", "vertices at equal positions were joined (STL has no connectivity)"},
    {"read-polygons",
     "{polygons|polygon is|polygons are} solved as triangles and kept whole in the file"},
    {"read-commands-skipped", "call and csh lines are not executed"},
    {"read-small-faces-skipped", "skipped: {faces|face} with fewer than three corners"},
    {"read-small-lines-skipped", "skipped: {lines|f line} with fewer than three corners"},
    {"read-uv-missing", "{corners|corner} without a vt, because no vt line has their index"},
    {"read-uv-incomplete", "some corners have no texture coordinates; the set cannot be verified"},
    {"read-line-ends", "the lines end in CR alone"},
    {"read-keyword-missing", "the keyword OFF is missing"},
    {"read-strips", "triangle strips are read as triangles"},
    {"read-unknown-lines",
     "{lines|line|lines} of the header {lines#has an unknown keyword|have unknown keywords} and "
     "{lines#is|are} skipped"},
    {"read-extra-values",
     "{lines|line has|lines have} more values than the header declares; what follows those is "
     "left out"},
    {"read-manifold-used", "welded as EXT_mesh_manifold states"},
    {"read-manifold-vertices",
     "EXT_mesh_manifold is not used: it does not share the primitives' vertices"},
    {"read-manifold-types", "EXT_mesh_manifold is not used: its indices are not unsigned integers"},
    {"read-manifold-indices",
     "EXT_mesh_manifold is not used: its indices are not those of the primitives"},
    {"read-manifold-apart",
     "EXT_mesh_manifold is not used: it merges vertices that are not at the same position"},
    {"read-manifold-corners",
     "EXT_mesh_manifold is not used: it merges a vertex differently at different corners"},
    {"read-primitives-kept",
     "{primitives|primitive} ({kind}) {primitives#is kept as it is|are kept as they are}"},
    {"read-strips-unrolled",
     "{strips|triangle strip}[fans: and {fans|triangle fan}] {all#is|are} read as "
     "{triangles|triangle}"
     "[degenerate: ({degenerate|degenerate one is|degenerate ones are} skipped)]"},
    {"read-fans-unrolled",
     "{fans|triangle fan is|triangle fans are} read as {triangles|triangle}"
     "[degenerate: ({degenerate|degenerate one is|degenerate ones are} skipped)]"},
    {"read-incomplete-triangles",
     "{primitives|primitive ends|primitives end} in an incomplete triangle"},
    {"read-morph-targets", "morph targets: the base shape is used"},
    {"read-skinned", "skinned: the bind pose is used"},
    {"read-mesh-chosen", "the file has {meshes} meshes; mesh {mesh} is used"},
    {"read-not-finite",
     "{vertices|vertex|vertices} that no face uses {vertices#has|have} no finite position "
     "([several:first: ]{@vertex}); kept as in the file"},
    {"read-file-refused", "{why}; the reference to it is kept"},
    {"read-cones-unused", "the cones stored in the file are not used: {why}"},
    {"convert-materials-lost", "from {from} to {to}: of the materials only their names are kept"},
    {"convert-rest-pose",
     "from {from} to {to}: skins and animations are not kept: the model is in its rest pose"},
    {"convert-morphs-lost", "from {from} to {to}: morph targets are not kept"},
    {"convert-polygons-cut", "from {from} to {to}: polygons become triangles"},
    {"convert-uv-lost", "from {from} to {to}: the old texture coordinates are not kept"},
    {"convert-unused-placed",
     "from {from} to {to}: {vertices|unused vertex without a finite position is|unused vertices "
     "without finite positions are} put at the origin"},
    {"convert-uncoloured",
     "from {from} to {to}: {vertices|vertex without a colour is white|vertices without a colour "
     "are white}"},
    {"convert-lines-lost",
     "from {from} to {to}: {lines|line of lines or points (l, p) is|lines of lines or points "
     "(l, p) are} left out"},
    {"convert-others-lost", "from {from} to {to}: left out: {names}"},
    {"convert-groups-joined", "from {from} to {to}: groups (o, g) become one mesh"},
    // Defects, welds and repairs.
    {"repair-none", "nothing was repaired: a face names a vertex that does not exist"},
    {"repair-turned", "orient: {faces|face} turned over"},
    {"repair-one-sided-left",
     "orient: {components|one-sided component} cannot be oriented without a cut (split)"},
    {"repair-one-sided-cut", "orient: {components|one-sided component} cut along {edges|edge}"},
    {"repair-split",
     "split: {vertices|vertex|vertices} duplicated[edges: ({edges|edge} had more than two faces)]"},
    {"repair-no-surface",
     "{triangles|triangle} left out as no surface (a vertex named twice, or a component without "
     "area)"},
    {"repair-copies",
     "{triangles|triangle} left out as {triangles#a copy of another one, with its uv|copies of "
     "others, with the uv of those}"},
    {"repair-lengths",
     "{triangles|triangle has|triangles have} no area: all edge lengths are slightly increased "
     "so that every triangle has one"},
    {"repairs-written",
     "THE REPAIRS ARE WRITTEN:[turned: {turned|face} with the corners in the other order]"
     "[comma:,][copies: {copies|copy|copies} of vertices follow behind vertex {last}]"},
    {"weld", "weld: {before} vertices became {after}"},
    {"weld-soup",
     "every face was a component of its own: vertices at equal positions were joined, and "
     "{before} components became {after} (--weld none keeps them apart)"},
    {"weld-would-join",
     "{vertices|vertex has|vertices have} the position of another one; --weld exact would join "
     "{before} components into {after}"},
    {"crack",
     "a crack: [partial:at least ]{vertices} boundary vertices lie within {gap:.3g} of another "
     "one[weld:; --weld {weld:.2g} closes it][spoiled:; a weld of that length would not close it: "
     "{spoiled|triangle|triangles} would collapse, repeat others or meet several at one side]"},
    {"t-junctions",
     "T-junctions: [partial:at least ]{vertices|boundary vertex lies|boundary vertices lie} on "
     "the boundary edge of another face (within {gap:.3g}); a weld cannot close them: the edge "
     "needs a vertex there"},
    // Prescriptions.
    {"cones-from-list", "{cones|singularity|singularities} with k = {q} − index"},
    {"cones-from-curvatures", "{cones|cone} from curvatures in radians"},
    {"cones-from-angles", "{cones|cone} from total angles"},
    {"cones-from-file",
     "{cones|cone}[rotations: and seam rotations] from the file's own c and sm lines"},
    {"cones-rims-reduced",
     "the angles of boundary vertices were reduced to the turning index of each loop ({loops})"},
    {"cones-of-input", "the cones stored in the input are used"},
    {"cones-added",
     "component {component} has no cones in the list; they are chosen automatically"},
    {"moved-cone-removed", "the cone at vertex {vertex} is left out: a repair removed the vertex"},
    {"moved-cone-gone",
     "the cone at vertex {vertex} is left out: no vertex is at its position now"},
    {"moved-cone-several",
     "the cone at vertex {vertex} is left out: {count|vertex is|vertices are} at its position now"},
    {"moved-cone-boundary",
     "the cone at vertex {vertex} is left out: its vertex is on the boundary now"},
    {"moved-cone-joined",
     "the cone at vertex {vertex} is left out: its vertex is now one with that of the cone at "
     "vertex {other}"},
    {"moved-turning-gone",
     "the turning of boundary loop {loop} is left out: there is no such loop now"},
    {"moved-handle-gone",
     "the rotation along handle generator {generator} is left out: the triangles have changed"},
    {"cones-other-number",
     "{asked|cone} asked for, {placed} placed: [more:fewer would break Gauss–Bonnet or be too "
     "strong for the triangles][!more:the mesh has no vertices for more]."},
    {"cones-other-triangles", "the cones are for a mesh of {asked|triangle}; this one has {found}"},
    {"cones-other-vertices",
     "the cones are for a mesh of {asked|vertex|vertices}; this one has {found}"},
    {"cones-without-turning",
     "{loops|boundary loop has|boundary loops have} no turning among the cones: measured, and "
     "compared with nothing. If the cones are for a closed surface, faces are missing here"},
    {"features-other-file",
     "the features are of another file; found by [placed:positions][!placed:vertex numbers]"},
    {"creases-none",
     "no edge has a dihedral angle above {degrees:g}°, so that lines follow none"
     "[rims:; --rims makes the rims straight]"},
    {"marks-no-edges",
     "left out: {pairs|marked pair|marked pairs} of vertices without an edge between them"},
    {"features-own-cones",
     "the cones of a surface with features are those of a field along them: their number, purpose "
     "and alignment cannot be chosen"},
    {"field-frames", "the frames are the directions of the field"},
    {"budget-two-cones",
     "A closed torus with exactly two cones, k={low} and k={high}[divisor: (reduced by the "
     "common divisor {divisor} to q={q})], has no map with all rotations multiples of 2π/{q} "
     "unless a handle rotation is not a multiple of {divisor}."},
    {"budget-empty-stratum",
     "Closed surfaces of genus 2 have no flat metric with q=2 and cones k=3 and k=5, or k=6"
     "[divisor: (reduced by the common divisor {divisor} to q={q})][unless:, unless a handle "
     "rotation is not a multiple of that divisor]: expect no map."},
    {"budget-one-cone",
     "One cone on a closed surface of genus 2 (reduced by the common divisor {divisor} to "
     "q={q}) needs handle rotations that are all 0, or that are not all half turns."},
    {"budget-few-triangles",
     "{cones|cone} with few triangles for the angle (more than {angle:.3g} rad each on "
     "average): vertex {@vertex}. Refine the mesh there."},
    {"angle-shortage",
     "No locally injective map on this mesh has these angles: [cones:{cones|cone} with k = {k}]"
     "[afterCones: and ][regular:{regular|vertex|vertices} without a cone][vertices: (vertex "
     "{@vertex})][afterVertices: and ][rims:the {rims#rim|rims} {@loop} (turning {turning})] "
     "{asking#asks|ask} for {pi:g}π[together: together], and the {triangles|triangle} around "
     "{asking#it|them} cannot give that much: each has π for all its corners, and those "
     "elsewhere need some of it. [rims:Give another turning, move cones away from the rim]"
     "[!rims:Lower k there, move these cones apart], or split edges there (--refine)."},
    // Grids.
    {"grid-other-cones",
     "the cones for cells of this size leave them no room; those for cells {factor:g} times as "
     "long are used instead"},
    {"grid-few-advised", "fewer cones leave more room for a grid: try --cones-for few"},
    {"grid-few-used",
     "the default cones have no map on this grid; those of --cones-for few are used instead"},
    {"grid-cells-far",
     "{cells:.0f} cells instead of {asked:.0f}: [cones:with {perCone:.1f} cells per cone ]no "
     "number "
     "nearer to it was found[cones:; ask for more cells, or for fewer cones (--cones-for few)]"},
    {"grid-smaller-cells",
     "component {component} is small for cells of this size: its own are 1/{parts} as long"},
    {"grid-order", "a grid of squares needs q = 2 or 4, not {q}"},
    {"grid-seams", "the map's seams could not be read, or its strain is singular"},
    {"grid-no-integers",
     "no choice of integers kept all triangles positive and all angles as asked at {cells:.0f} "
     "cells ({perCone:.1f} per cone)[cutShort:; further attempts would have taken longer than "
     "the map itself][near:: cones {@edge} are {near} cells apart][working:; {working:.0f} cells "
     "would work][these: with the cones of this run (--cones)]"},
    // Writing.
    {"write-as-obj",
     "written as OBJ[normals:, with its normals][onlyColours:, with its colours][andColours: "
     "and colours]"},
    {"write-uv-replaced", "the old texture coordinates were replaced"},
    {"write-vt-replaced", "the old vt lines were replaced"},
    {"write-lines-without-vt",
     "polylines (l) and skipped faces lost their references to the old vt lines"},
    {"write-cones-ply", "cones are not embedded: PLY has no place for them"},
    {"write-cones-extras", "cones are not embedded: the mesh's extras are not an object"},
    {"write-set-used", "wrote TEXCOORD_{set}; the materials use it"},
    {"write-set-unseen",
     "wrote TEXCOORD_{set}; textures that used {others} use it, since {others} is missing there or "
     "has "
     "no area"},
    {"write-set-unused", "wrote TEXCOORD_{set}; the materials still use {others}"},
    {"write-set-replaced",
     "TEXCOORD_{set} was replaced: the materials' pictures were made for the old one and no "
     "longer fit"},
    {"write-set-unread",
     "TEXCOORD_{set}, which no material uses, was replaced: viewers read the first four sets"},
    {"write-set-high",
     "wrote TEXCOORD_{set}; many viewers read TEXCOORD_0 to TEXCOORD_3 only: --uv-set N "
     "replaces one of those"},
    {"write-set-filled",
     "primitive {primitive} had no TEXCOORD_{set}; it has the new uv there too"},
    {"write-vertices-copied", "{before} vertices became {after} along seams"},
    {"write-tangents-dropped",
     "primitive {primitive}: TANGENT dropped, it belonged to the replaced TEXCOORD_{set}"},
    {"write-list", "primitive {primitive} is now a list of triangles"},
    {"write-draco-unpacked",
     "primitive {primitive} was compressed with Draco and is stored uncompressed"},
    {"write-unpacked",
     "what was compressed is stored uncompressed: {bytes} bytes, {ratio:.2g} times the input"},
    {"write-packed",
     "compressed with meshopt, lossless: {bytes} bytes; {views} views, {before} bytes as they "
     "are, take {after}"},
    {"write-not-shorter", "nothing is shorter compressed: {bytes} bytes as they are"},
    {"write-chunk-dropped",
     "a .gltf has no chunks: one of {bytes} bytes and type {type} is not kept"},
    {"write-manifold-repaired",
     "EXT_mesh_manifold dropped: it describes the mesh before the repairs"},
    {"write-manifold-other",
     "EXT_mesh_manifold dropped: its indices are not those of the primitives, or contradict each "
     "other"},
    {"write-keep-beside", "keep {name} next to the new file"},
    {"write-file-refused", "{why}; it is not copied, and the reference to it is kept"},
    {"quads-across-seams",
     "{quads|quad crosses|quads cross} a seam of the input's texture coordinates or the border of "
     "a material: their corners have what the surface has there, but not what is between"},
    {"quads-nearest",
     "{corners|corner of these lies|corners of these lie} on triangles of other primitives only, "
     "and {corners#has|have} what the quad's own primitive has nearest to {corners#it|them}"},
    {"quads-mesh-alone", "the rest of the file is not kept: {why}"},
    {"quads-uv-missing",
     "{corners|corner of quads has|corners of quads have} no texture coordinates[zero: (0 in the "
     "file)], as the input has none there"},
    {"quads-no-materials", "materials are not kept: PLY has no place for them"},
    // What to do about an error: its message has the rule and the number.
    {"repair-with", "Repair with --fix {fixes}[more: as well]"},
    {"repair-by-hand", "No repair removes this; edit the mesh there"},
    {"find-creases", "Find creases by angle: --creases (features.creases)"},
    {"raise-bytes", "Raise it by --max-bytes (limits.bytes)"},
    {"raise-triangles", "Raise it by --max-triangles (limits.triangles)"},
    {"use-cones", "Leave out --boundary to use cones"},
    {"write-obj", "Write an OBJ (-o x.obj)"},
};

}  // namespace

std::span<const Phrase> otherPhrases() { return kOthers; }

}  // namespace hgp
