// Made from the catalogue in core/hgp/base by wasm/phrases.mjs: the templates of notes that suit every user.

/** @internal */
export const corePhrases = {
  'defect-index-out-of-range':
    '[repaired:repaired: ]{count|face names|faces name} a vertex that does not exist[first: (first: {@})][only: ({@})]',
  'defect-not-finite':
    '[repaired:repaired: ]{count|vertex has|vertices have} a position that is not finite[first: (first: {@})][only: ({@})]',
  'defect-extent':
    '[repaired:repaired: ]the mesh is too large or too small to compute with (1e-100 to 1e18)[first: (first: {@})][only: ({@})]',
  'defect-repeated-vertex':
    '[repaired:repaired: ]{count|face names|faces name} one vertex twice[first: (first: {@})][only: ({@})]',
  'defect-zero-area':
    '[repaired:repaired: ]{count|face has|faces have} no area[first: (first: {@})][only: ({@})]',
  'defect-duplicate-face':
    '[repaired:repaired: ]{count|face repeats|faces repeat} another one[first: (first: {@})][only: ({@})]',
  'defect-non-manifold-edge':
    '[repaired:repaired: ]{count|edge has|edges have} more than two faces[first: (first: {@})][only: ({@})]',
  'defect-inconsistent-edge':
    '[repaired:repaired: ]{count|edge has|edges have} two faces of opposite orientation[first: (first: {@})][only: ({@})]',
  'defect-non-manifold-vertex':
    '[repaired:repaired: ]{count|vertex joins|vertices join} several fans of faces[first: (first: {@})][only: ({@})]',
  'read-gzip-longer': 'ignored: {bytes|byte} after the gzip data',
  'read-stl-longer': 'ignored: {bytes|byte} after the last triangle',
  'read-glb-followed': 'ignored: {bytes|byte} after the end of the GLB',
  'read-glb-longer': 'the length in the GLB header leaves out {bytes|byte}, which are read',
  'read-glb-unpadded': "a chunk's length is not a multiple of 4",
  'read-stl-count': 'the count in the header is 0; the file holds {triangles|triangle}',
  'read-joined-equal': 'vertices at equal positions were joined (STL has no connectivity)',
  'read-polygons':
    '{polygons|polygon is|polygons are} solved as triangles and kept whole in the file',
  'read-commands-skipped': 'call and csh lines are not executed',
  'read-small-faces-skipped': 'skipped: {faces|face} with fewer than three corners',
  'read-small-lines-skipped': 'skipped: {lines|f line} with fewer than three corners',
  'read-uv-missing': '{corners|corner} without a vt, because no vt line has their index',
  'read-uv-incomplete': 'some corners have no texture coordinates; the set cannot be verified',
  'read-line-ends': 'the lines end in CR alone',
  'read-keyword-missing': 'the keyword OFF is missing',
  'read-strips': 'triangle strips are read as triangles',
  'read-unknown-lines':
    '{lines|line|lines} of the header {lines#has an unknown keyword|have unknown keywords} and {lines#is|are} skipped',
  'read-extra-values':
    '{lines|line has|lines have} more values than the header declares; what follows those is left out',
  'read-manifold-used': 'welded as EXT_mesh_manifold states',
  'read-manifold-vertices':
    "EXT_mesh_manifold is not used: it does not share the primitives' vertices",
  'read-manifold-types': 'EXT_mesh_manifold is not used: its indices are not unsigned integers',
  'read-manifold-indices':
    'EXT_mesh_manifold is not used: its indices are not those of the primitives',
  'read-manifold-apart':
    'EXT_mesh_manifold is not used: it merges vertices that are not at the same position',
  'read-manifold-corners':
    'EXT_mesh_manifold is not used: it merges a vertex differently at different corners',
  'read-primitives-kept':
    '{primitives|primitive} ({kind}) {primitives#is kept as it is|are kept as they are}',
  'read-strips-unrolled':
    '{strips|triangle strip}[fans: and {fans|triangle fan}] {all#is|are} read as {triangles|triangle}[degenerate: ({degenerate|degenerate one is|degenerate ones are} skipped)]',
  'read-fans-unrolled':
    '{fans|triangle fan is|triangle fans are} read as {triangles|triangle}[degenerate: ({degenerate|degenerate one is|degenerate ones are} skipped)]',
  'read-incomplete-triangles':
    '{primitives|primitive ends|primitives end} in an incomplete triangle',
  'read-morph-targets': 'morph targets: the base shape is used',
  'read-skinned': 'skinned: the bind pose is used',
  'read-mesh-chosen': 'the file has {meshes} meshes; mesh {mesh} is used',
  'read-not-finite':
    '{vertices|vertex|vertices} that no face uses {vertices#has|have} no finite position ([several:first: ]{@vertex}); kept as in the file',
  'read-file-refused': '{why}; the reference to it is kept',
  'read-cones-unused': 'the cones stored in the file are not used: {why}',
  'convert-materials-lost': 'from {from} to {to}: of the materials only their names are kept',
  'convert-rest-pose':
    'from {from} to {to}: skins and animations are not kept: the model is in its rest pose',
  'convert-morphs-lost': 'from {from} to {to}: morph targets are not kept',
  'convert-polygons-cut': 'from {from} to {to}: polygons become triangles',
  'convert-uv-lost': 'from {from} to {to}: the old texture coordinates are not kept',
  'convert-unused-placed':
    'from {from} to {to}: {vertices|unused vertex without a finite position is|unused vertices without finite positions are} put at the origin',
  'convert-uncoloured':
    'from {from} to {to}: {vertices|vertex without a colour is white|vertices without a colour are white}',
  'convert-lines-lost':
    'from {from} to {to}: {lines|line of lines or points (l, p) is|lines of lines or points (l, p) are} left out',
  'convert-others-lost': 'from {from} to {to}: left out: {names}',
  'convert-groups-joined': 'from {from} to {to}: groups (o, g) become one mesh',
  'repair-none': 'nothing was repaired: a face names a vertex that does not exist',
  'repair-turned': 'orient: {faces|face} turned over',
  'repair-one-sided-left':
    'orient: {components|one-sided component} cannot be oriented without a cut (split)',
  'repair-one-sided-cut': 'orient: {components|one-sided component} cut along {edges|edge}',
  'repair-split':
    'split: {vertices|vertex|vertices} duplicated[edges: ({edges|edge} had more than two faces)]',
  'repair-no-surface':
    '{triangles|triangle} left out as no surface (a vertex named twice, or a component without area)',
  'repair-copies':
    '{triangles|triangle} left out as {triangles#a copy of another one, with its uv|copies of others, with the uv of those}',
  'repair-lengths':
    '{triangles|triangle has|triangles have} no area: all edge lengths are slightly increased so that every triangle has one',
  'repairs-written':
    'THE REPAIRS ARE WRITTEN:[turned: {turned|face} with the corners in the other order][comma:,][copies: {copies|copy|copies} of vertices follow behind vertex {last}]',
  weld: 'weld: {before} vertices became {after}',
  't-junctions':
    'T-junctions: [partial:at least ]{vertices|boundary vertex lies|boundary vertices lie} on the boundary edge of another face (within {gap:.3g}); a weld cannot close them: the edge needs a vertex there',
  'cones-from-list': '{cones|singularity|singularities} with k = {q} − index',
  'cones-from-curvatures': '{cones|cone} from curvatures in radians',
  'cones-from-angles': '{cones|cone} from total angles',
  'cones-from-file':
    "{cones|cone}[rotations: and seam rotations] from the file's own c and sm lines",
  'cones-rims-reduced':
    'the angles of boundary vertices were reduced to the turning index of each loop ({loops})',
  'cones-of-input': 'the cones stored in the input are used',
  'cones-added': 'component {component} has no cones in the list; they are chosen automatically',
  'moved-cone-removed': 'the cone at vertex {vertex} is left out: a repair removed the vertex',
  'moved-cone-gone': 'the cone at vertex {vertex} is left out: no vertex is at its position now',
  'moved-cone-several':
    'the cone at vertex {vertex} is left out: {count|vertex is|vertices are} at its position now',
  'moved-cone-boundary':
    'the cone at vertex {vertex} is left out: its vertex is on the boundary now',
  'moved-cone-joined':
    'the cone at vertex {vertex} is left out: its vertex is now one with that of the cone at vertex {other}',
  'moved-turning-gone':
    'the turning of boundary loop {loop} is left out: there is no such loop now',
  'moved-handle-gone':
    'the rotation along handle generator {generator} is left out: the triangles have changed',
  'cones-other-number':
    '{asked|cone} asked for, {placed} placed: [more:fewer would break Gauss–Bonnet or be too strong for the triangles][!more:the mesh has no vertices for more].',
  'cones-other-triangles': 'the cones are for a mesh of {asked|triangle}; this one has {found}',
  'cones-other-vertices':
    'the cones are for a mesh of {asked|vertex|vertices}; this one has {found}',
  'cones-without-turning':
    '{loops|boundary loop has|boundary loops have} no turning among the cones: measured, and compared with nothing. If the cones are for a closed surface, faces are missing here',
  'features-other-file':
    'the features are of another file; found by [placed:positions][!placed:vertex numbers]',
  'marks-no-edges':
    'left out: {pairs|marked pair|marked pairs} of vertices without an edge between them',
  'features-own-cones':
    'the cones of a surface with features are those of a field along them: their number, purpose and alignment cannot be chosen',
  'field-frames': 'the frames are the directions of the field',
  'budget-two-cones':
    'A closed torus with exactly two cones, k={low} and k={high}[divisor: (reduced by the common divisor {divisor} to q={q})], has no map with all rotations multiples of 2π/{q} unless a handle rotation is not a multiple of {divisor}.',
  'budget-empty-stratum':
    'Closed surfaces of genus 2 have no flat metric with q=2 and cones k=3 and k=5, or k=6[divisor: (reduced by the common divisor {divisor} to q={q})][unless:, unless a handle rotation is not a multiple of that divisor]: expect no map.',
  'budget-one-cone':
    'One cone on a closed surface of genus 2 (reduced by the common divisor {divisor} to q={q}) needs handle rotations that are all 0, or that are not all half turns.',
  'budget-few-triangles':
    '{cones|cone} with few triangles for the angle (more than {angle:.3g} rad each on average): vertex {@vertex}. Refine the mesh there.',
  'grid-other-cones':
    'the cones for cells of this size leave them no room; those for cells {factor:g} times as long are used instead',
  'grid-smaller-cells':
    'component {component} is small for cells of this size: its own are 1/{parts} as long',
  'grid-order': 'a grid of squares needs q = 2 or 4, not {q}',
  'grid-seams': "the map's seams could not be read, or its strain is singular",
  'write-as-obj':
    'written as OBJ[normals:, with its normals][onlyColours:, with its colours][andColours: and colours]',
  'write-uv-replaced': 'the old texture coordinates were replaced',
  'write-vt-replaced': 'the old vt lines were replaced',
  'write-lines-without-vt':
    'polylines (l) and skipped faces lost their references to the old vt lines',
  'write-cones-ply': 'cones are not embedded: PLY has no place for them',
  'write-cones-extras': "cones are not embedded: the mesh's extras are not an object",
  'write-set-used': 'wrote TEXCOORD_{set}; the materials use it',
  'write-set-unseen':
    'wrote TEXCOORD_{set}; textures that used {others} use it, since {others} is missing there or has no area',
  'write-set-unused': 'wrote TEXCOORD_{set}; the materials still use {others}',
  'write-set-replaced':
    "TEXCOORD_{set} was replaced: the materials' pictures were made for the old one and no longer fit",
  'write-set-unread':
    'TEXCOORD_{set}, which no material uses, was replaced: viewers read the first four sets',
  'write-set-filled': 'primitive {primitive} had no TEXCOORD_{set}; it has the new uv there too',
  'write-vertices-copied': '{before} vertices became {after} along seams',
  'write-tangents-dropped':
    'primitive {primitive}: TANGENT dropped, it belonged to the replaced TEXCOORD_{set}',
  'write-list': 'primitive {primitive} is now a list of triangles',
  'write-draco-unpacked':
    'primitive {primitive} was compressed with Draco and is stored uncompressed',
  'write-unpacked':
    'what was compressed is stored uncompressed: {bytes} bytes, {ratio:.2g} times the input',
  'write-packed':
    'compressed with meshopt, lossless: {bytes} bytes; {views} views, {before} bytes as they are, take {after}',
  'write-not-shorter': 'nothing is shorter compressed: {bytes} bytes as they are',
  'write-chunk-dropped': 'a .gltf has no chunks: one of {bytes} bytes and type {type} is not kept',
  'write-manifold-repaired': 'EXT_mesh_manifold dropped: it describes the mesh before the repairs',
  'write-manifold-other':
    'EXT_mesh_manifold dropped: its indices are not those of the primitives, or contradict each other',
  'write-keep-beside': 'keep {name} next to the new file',
  'write-file-refused': '{why}; it is not copied, and the reference to it is kept',
  'quads-across-seams':
    "{quads|quad crosses|quads cross} a seam of the input's texture coordinates or the border of a material: their corners have what the surface has there, but not what is between",
  'quads-nearest':
    "{corners|corner of these lies|corners of these lie} on triangles of other primitives only, and {corners#has|have} what the quad's own primitive has nearest to {corners#it|them}",
  'quads-mesh-alone': 'the rest of the file is not kept: {why}',
  'quads-uv-missing':
    '{corners|corner of quads has|corners of quads have} no texture coordinates[zero: (0 in the file)], as the input has none there',
  'quads-no-materials': 'materials are not kept: PLY has no place for them',
  'repair-by-hand': 'No repair removes this; edit the mesh there',
  'map-crushed':
    '{crushed} of {triangles|triangle} {crushed#is|are} crushed: area scale below {scale:g} of the median, the smallest {smallest:.1e} of it (triangle {@triangle}, at {x:.4g} {y:.4g} {z:.4g}). Place a cone there, or more cones.',
  'map-stretched':
    'These cones stretch the surface by e^{range}; expect strong area distortion. More cones lower it.',
  'map-unresolved':
    'These cones stretch the surface by e^{range} where angles are kept: double precision cannot resolve such areas. Add cones in the regions that shrink.',
  'map-frames-contradict':
    'The frames of the best program contradict each other, as a Farkas certificate shows to 8 digits: of {frames|constrained triangle}, {strained|of them is|of them are} strained most (see conflict).',
  'map-frames-unmet':
    'The best program found no map that turns all frames as asked: of {frames|constrained triangle}, {strained|of them is|of them are} strained most (see conflict).',
  'map-given-frames':
    'The frames were those of the field file. Automatic frames have the same cones, turning and handles but turn evenly: a map with them may be certified.',
  'map-own-cones':
    'No map without folds has the cones that were chosen first. This one has others at {vertices|vertex|vertices}, which are part of the prescription now.',
  'map-not-improved':
    'The map is not improved, as the verifier did not accept the improved map: [rule:it breaks the rule {rule} at {places|place}, by {worst} at worst ({@}).][!rule:it is no better on the surface itself.]',
  'map-areas-lowered':
    'Areas of the map spanned more than double precision resolves: its distortion was lowered.',
  symmetric:
    'the map is its own mirror image across the plane {plane}; vertices of the mesh are off theirs by at most {off:.2g} of the diagonal. Lines follow the plane, and the rims of what it cuts.[pairs: {pairs|component is the image of another|components are images of others}.]',
  'symmetric-split':
    'THE MESH HAS MORE TRIANGLES: {edges|edge was|edges were} split at the midpoint, so that the plane of symmetry has edges in it. The written mesh has {vertices} vertices and {triangles} triangles instead of {verticesBefore} and {trianglesBefore}; vertices keep their ids.',
  'features-contradict':
    'The lengths of features contradict each other, or leave a cone no place between them: {edges|feature edge} would have no length, whatever the map (see conflict). Leave out one of these.',
  'features-straightened':
    '{steps|step} of features would have no length, because the lines around allow none; the map goes straight on there.',
  'features-moved':
    '{units|cone or corner was|cones and corners were} moved, because no map was found with those of the smoothest field',
  'features-split':
    'THE MESH HAS MORE TRIANGLES: {edges|edge was|edges were} split at the midpoint, because a map along all features[grid:, on the lines of a grid,] has no room otherwise. The certified and written mesh has {vertices} vertices and {triangles} triangles instead of {verticesBefore} and {trianglesBefore}; vertices keep their ids, new ones follow, and halves of features are features.',
  'features-split-in-vain':
    'no map along these features[grid: on the lines of a grid] on the mesh with split edges ({triangles} triangles) either',
  'split-as-polygons':
    'this file cannot store split edges: only positions and triangles are kept, no materials, normals or other attributes',
  'features-no-grid': 'the lines of these features and the seams have no common grid',
  'features-many-integers':
    'the lines of these features have {integers} integers to choose, and at most {most} are chosen; with fewer features there are fewer',
  'features-grid-work':
    'the {integers} integers of the lines of these features were not chosen within the work allowed at {cells:.0f} cells; with fewer features, or more cells, there is less to choose',
  'features-no-integers':
    'no choice of integers kept lines apart and all triangles positive at {cells:.0f} cells[working:; {working:.0f} cells would work][these: with the cones of this run]',
  'map-dragged':
    'The cone at vertex {@vertex} was dragged there. This map follows from the one before and from the path of the drag; the bytes of a run with the same cones depend on nothing else.',
  'component-without-map':
    'component {component} has no map of its own; it keeps its uv or is cut to a disk: {message}',
  'cones-other':
    'the cones chosen first have no map on this mesh; those chosen for “{purpose}” are used instead',
  refined:
    'THE MESH WAS REFINED: {edges|edge is|edges are} split ({places}), because {programs|program} gave no map of the original mesh. The certified and written mesh has {vertices} vertices and {triangles} triangles instead of {verticesBefore} and {trianglesBefore}; vertices keep their ids, new ones follow.',
  'refine-nowhere': 'nothing was refined: the places where this map is wrong are not known',
  'refine-in-vain': 'no map on the mesh refined to {triangles} triangles either',
  'stored-moved':
    '{moved} of {components|component} moved or scaled to survive the rounding of the format',
  'stored-broken':
    '{broken} of {components|component} certified before the rounding of the format, but not after it',
} as const;
