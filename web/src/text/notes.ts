// Notes of the solver as the page phrases them: it has buttons where the package has options.

import { phrase, type Note, type Phrases } from 'hgp';

/** Templates of the codes whose sentences name something to do, or places, which the page outlines. */
const pagePhrases: Phrases = {
  'weld-soup':
    'every face was a component of its own: vertices at equal positions were joined, and {before} components ' +
    'became {after}',
  'weld-would-join':
    '{vertices|vertex has|vertices have} the position of another one; joining would make {before} parts into ' +
    '{after}',
  crack:
    'a crack: [partial:at least ]{vertices} boundary vertices lie within {gap:.3g} of another one[weld:; joining ' +
    'vertices closer than {weld:.2g} closes it][spoiled:; joining vertices that close would not close it: ' +
    '{spoiled|triangle|triangles} would collapse, repeat others or meet several at one side]',
  'angle-shortage':
    'No locally injective map on this mesh has these angles: [cones:{cones|cone} with k = {k}][afterCones: and ]' +
    '[regular:{regular|vertex|vertices} without a cone][vertices: (vertex {@vertex})][afterVertices: and ]' +
    '[rims:the {rims#rim|rims} {@loop} (turning {turning})] {asking#asks|ask} for {pi:g}π[together: together], and ' +
    'the {triangles|triangle} around {asking#it|them} cannot give that much: each has π for all its corners, and ' +
    'those elsewhere need some of it. [rims:Give another turning, move cones away from the rim]' +
    '[!rims:Lower k there, move these cones apart], or split edges there (on the command line: --refine).',
  'map-evened-lengths':
    "Many triangles are very thin, and the surface's own edge lengths gave no map. This one is harmonic with evened " +
    'lengths instead: as seamless and as free of folds, with more distortion. “Less distortion” under Solve lowers it.',
  'map-small-improved':
    'the map as solved has triangles too small for the numbers of the format; it is improved, as by “Less distortion”',
  'refine-offered':
    'no map on this mesh: it may be too coarse for the prescription. On the command line, --refine splits edges, ' +
    'tries again, and writes the refined mesh',
  'creases-none':
    'no edge has a dihedral angle above {degrees:g}°, so that lines follow none[rims:; “Lines follow rims” makes the rims straight]',
  'method-offered': 'no map on this mesh by the method “{method}” alone',
  'grid-few-advised': 'fewer cones leave more room for a grid: move the slider to Fewer',
  'grid-cells-far':
    '{cells:.0f} cells instead of {asked:.0f}: [cones:with {perCone:.1f} cells per cone ]no number nearer to it was ' +
    'found[cones:; ask for more cells, or move the slider to Fewer]',
  'grid-few-used': 'the default cones have no map on this grid; fewer cones are used instead',
  'write-set-high':
    'Wrote TEXCOORD_{set}; many viewers read TEXCOORD_0 to TEXCOORD_3 only: choose one of those under UV set',
  'repair-with': '',
  'repair-by-hand': 'No repair removes this; edit the mesh there',
  'find-creases': 'Lines follow creases finds them by angle',
  'raise-bytes': '',
  'raise-triangles': '',
  'use-cones': '',
  'write-obj': 'Download it as OBJ',
};

/** A defect without its first places, which the page outlines. */
const defectPhrases: Phrases = Object.fromEntries(
  Object.entries({
    'index-out-of-range': '{count|face names|faces name} a vertex that does not exist',
    'not-finite': '{count|vertex has|vertices have} a position that is not finite',
    extent: 'The mesh is too large or too small to compute with (1e-100 to 1e18)',
    'repeated-vertex': '{count|face names|faces name} one vertex twice',
    'zero-area': '{count|face has|faces have} no area',
    'duplicate-face': '{count|face repeats|faces repeat} another one',
    'non-manifold-edge': '{count|edge has|edges have} more than two faces',
    'inconsistent-edge': '{count|edge has|edges have} two faces of opposite orientation',
    'non-manifold-vertex': '{count|vertex joins|vertices join} several fans of faces',
  }).map(([kind, template]) => [`defect-${kind}`, template]),
);

const phrases: Phrases = { ...pagePhrases, ...defectPhrases };

/** @param others  templates that replace those of the page */
export const noteForPage = (note: Note, others: Phrases = {}): string =>
  phrase(note, { ...phrases, ...others });

/** What is wrong with the mesh, in one sentence without ids. */
export function defectsInWords(
  defects: readonly { kind: string; fatal: boolean; count: number }[],
): string {
  const fatal = defects.filter((one) => one.fatal);
  const sentences = fatal.map(({ kind, count }) =>
    noteForPage({ code: `defect-${kind}`, numbers: { count }, words: {}, where: [] }),
  );
  return sentences.length > 0 ? `${sentences.join('; ')}.` : '';
}

/** How close vertices are to be joined according to notes: 0 for equal positions; undefined where none says so. */
export function weldIn(notes: readonly Note[]): number | undefined {
  const found = notes.flatMap(({ code, numbers }) =>
    code === 'weld-would-join' ? [0] : code === 'crack' && numbers.weld ? [numbers.weld] : [],
  );
  return found.length > 0 ? Math.max(...found) : undefined;
}

/** Bytes after gzip data, which the page itself unpacks. */
export const gzipNote = (bytes: number): Note => ({
  code: 'read-gzip-longer',
  numbers: { bytes },
  words: {},
  where: [],
});
