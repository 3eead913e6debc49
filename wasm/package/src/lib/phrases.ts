// Notes as sentences for users of this package. The solver says what happened as a code with numbers; other programs may
// phrase them in their own way, with templates of their own.

import { corePhrases } from './core_phrases.js';
import type { Note } from './documents.js';

/** Templates by code: see {@link phrase}. */
export type Phrases = Readonly<Partial<Record<string, string>>>;

/** Templates of the codes that name options of this package, where the command line has options of its own. */
const optionPhrases: Phrases = {
  'weld-soup':
    'every face was a component of its own: vertices at equal positions were joined, and {before} components ' +
    'became {after} (weld: false keeps them apart)',
  'weld-would-join':
    '{vertices|vertex has|vertices have} the position of another one; weld: 0 would join {before} components into ' +
    '{after}',
  crack:
    'a crack: [partial:at least ]{vertices} boundary vertices lie within {gap:.3g} of another one[weld:; weld: ' +
    '{weld:.2g} closes it][spoiled:; a weld of that length would not close it: {spoiled|triangle|triangles} would ' +
    'collapse, repeat others or meet several at one side]',
  'angle-shortage':
    'No locally injective map on this mesh has these angles: [cones:{cones|cone} with k = {k}][afterCones: and ]' +
    '[regular:{regular|vertex|vertices} without a cone][vertices: (vertex {@vertex})][afterVertices: and ]' +
    '[rims:the {rims#rim|rims} {@loop} (turning {turning})] {asking#asks|ask} for {pi:g}π[together: together], and ' +
    'the {triangles|triangle} around {asking#it|them} cannot give that much: each has π for all its corners, and ' +
    'those elsewhere need some of it. [rims:Give another turning, move cones away from the rim]' +
    '[!rims:Lower k there, move these cones apart], or split edges there (refine: true).',
  'map-evened-lengths':
    "Many triangles are very thin, and the surface's own edge lengths gave no map. This one is harmonic with evened " +
    "lengths instead: as seamless and as free of folds, with more distortion. improve: 'isometric' lowers it.",
  'map-small-improved':
    'the map as solved has triangles too small for the numbers of the format; it is improved, as by ' +
    "improve: 'isometric'",
  'refine-offered':
    'no map on this mesh: it may be too coarse for the prescription. refine: true splits edges, tries again, and ' +
    'writes the refined mesh',
  'creases-none':
    'no edge has a dihedral angle above {degrees:g}°, so that lines follow none[rims:; rims: true in features ' +
    'makes the rims straight]',
  'method-offered':
    "no map on this mesh by the method “{method}” alone; with method: 'auto' others are tried after it",
  'grid-few-advised': "fewer cones leave more room for a grid: try conesFor: 'few'",
  'grid-few-used':
    "the default cones have no map on this grid; those of conesFor: 'few' are used instead",
  'grid-cells-far':
    '{cells:.0f} cells instead of {asked:.0f}: [cones:with {perCone:.1f} cells per cone ]no number nearer to it was ' +
    "found[cones:; ask for more cells, or for fewer cones (conesFor: 'few')]",
  'grid-no-integers':
    'no choice of integers kept all triangles positive and all angles as asked at {cells:.0f} cells ({perCone:.1f} ' +
    'per cone)[cutShort:; further attempts would have taken longer than the map itself][near:: cones {@edge} are ' +
    '{near} cells apart][working:; {working:.0f} cells would work][these: with the cones of this run]',
  'write-set-high':
    'wrote TEXCOORD_{set}; many viewers read TEXCOORD_0 to TEXCOORD_3 only: uvSet replaces one of those',
  'repair-with': 'Repair with fix: {fixes}[more: as well]',
  'find-creases': 'Find creases by angle: features.creases',
  'raise-bytes': 'Raise it by limits.bytes',
  'raise-triangles': 'Raise it by limits.triangles',
  'use-cones': 'Leave out boundary to use cones',
  'write-obj': "Ask for format: 'obj'",
};

/** All templates of the package. */
export const packagePhrases: Phrases = { ...corePhrases, ...optionPhrases };

type Value = number | string | null | undefined;

const valueOf = ({ numbers, words }: Note, name: string): Value =>
  name in numbers ? numbers[name] : words[name];

/**
 * A number with so many digits, by `write`. Of two that are equally near, printf takes the one with an even last digit,
 * and JavaScript the larger one.
 */
function rounded(value: number, digits: number, write: 'toFixed' | 'toExponential'): string {
  const beyond = 25; // digits, in which a double near the middle shows on which side of it it is
  const found = /^(.*?(\d)\.?)(\d{25})(e.*)?$/.exec(value[write](digits + beyond));
  if (!found) return value[write](digits); // not a finite number
  const [, down, last, rest, end = ''] = found;
  const isMiddle = rest === `5${'0'.repeat(beyond - 1)}`;
  if (!isMiddle || Number(last) % 2 !== 0) return value[write](digits);
  return down.replace(/\.$/, '') + end;
}

/** A number as printf's `.2e`, `.3g`, `.1f` or `g` prints it. */
function formatted(value: number, format: string): string {
  const kind = format.at(-1);
  const digits = format.startsWith('.') ? Number(format.slice(1, -1)) : 6;
  if (kind === 'f') return rounded(value, digits, 'toFixed');
  if (kind === 'e') return withExponent(rounded(value, digits, 'toExponential'));
  const scientific = rounded(value, digits - 1, 'toExponential');
  const exponent = value === 0 ? 0 : Number(/e(.*)/.exec(scientific)?.[1]);
  const isPlain = exponent >= -4 && exponent < digits;
  const text = isPlain ? rounded(value, digits - 1 - exponent, 'toFixed') : scientific;
  // Zeros at the end of the fraction, not those of an exponent.
  return withExponent(text.replace(/(\.\d*?)0+(?=e|$)/, '$1').replace(/\.(?=e|$)/, ''));
}

/** 1.1e-5 as 1.1e-05. */
const withExponent = (text: string): string =>
  text.replace(/e([+-])(\d)$/, (_, sign: string, digit: string) => `e${sign}0${digit}`);

function textOf(value: Value, format: string): string {
  if (value === null || value === undefined) return '?';
  if (typeof value === 'string') return value;
  if (format) return formatted(value, format);
  return Number.isInteger(value) ? String(value) : formatted(value, '.4g');
}

function placesOf({ where, numbers }: Note, kind: string): string {
  const some = where.filter((one) => kind === '' || one.kind === kind);
  const names = some.map(({ id, other }) => (other === undefined ? `${id}` : `${id}–${other}`));
  return names.join(', ') + (numbers.more ? ', …' : '');
}

/** What stands between braces: "n", "n:.2e", "n|edge|edges" or "n#lies|lie"; "@vertex" for places. */
function placeText(note: Note, place: string): string {
  if (place.startsWith('@')) return placesOf(note, place.slice(1));
  const end = place.search(/[:|#]/);
  const value = valueOf(note, end < 0 ? place : place.slice(0, end));
  const rest = end < 0 ? '' : place.slice(end + 1);
  if (end < 0 || place[end] === ':') return textOf(value, rest);
  const bar = rest.indexOf('|');
  const one = bar < 0 ? rest : rest.slice(0, bar);
  const many = bar < 0 ? `${rest}s` : rest.slice(bar + 1);
  const word = value === 1 ? one : many;
  return place[end] === '#' ? word : `${textOf(value, '')} ${word}`;
}

const filled = (note: Note, template: string): string =>
  template.replace(/\{([^}]*)\}/g, (_, place: string) => placeText(note, place));

/**
 * The sentence of a note. In a template, {n} is a value, {n:.2g} a number in that format of printf, {n|edge|edges} is
 * "1 edge" or "2 edges", {n#lies|lie} the word alone, {@vertex} the ids of places of that kind; [n:…] is there if the
 * value n is, and neither 0 nor empty, [!n:…] if not.
 * @param phrases  templates that replace those of the package
 */
export function phrase(note: Note, phrases: Phrases = {}): string {
  const template = phrases[note.code] ?? packagePhrases[note.code];
  if (template === undefined) return note.code;
  const parts = template.replace(
    /\[(!?)([^:\]]*):([^\]]*)\]/g,
    (_, not, name: string, text: string) =>
      Boolean(valueOf(note, name)) === (not === '') ? text : '',
  );
  return filled(note, parts);
}

/** A message with its advice as sentences. */
export function withAdvice(
  message: string,
  advice: readonly Note[] = [],
  phrases: Phrases = {},
): string {
  if (advice.length === 0) return message;
  const sentences = [message.replace(/\.$/, ''), ...advice.map((note) => phrase(note, phrases))];
  return `${sentences.join('. ')}.`;
}
