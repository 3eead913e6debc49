// The address of the page: look, camera, cones, features and the settings of Run. Numbers and known words only.

import type { Edge, FeatureChoice } from '../model/features';
import { plainRounds } from '../model/request';
import type { Cone, Prescription } from '../model/prescription';
import {
  overlays,
  patterns,
  type GridSettings,
  type Look,
  type Overlay,
  type Pattern,
  type SolveSettings,
} from '../model/types';

const maxText = 8192;

export interface HashState {
  example?: string;
  q?: number;
  pattern?: Pattern;
  overlay?: Overlay;
  tiles?: number;
  camera?: string;
  /** The settings of Run that differ from those of a new page. */
  grid?: GridSettings;
  improve?: number;
  rounds?: number;
  /** In seconds. */
  timeLimit?: number;
  /** Edges that lines follow, of the model. */
  features?: Omit<FeatureChoice, 'rims'>;
  /** The model to which cones, turnings and handles belong, as `modelTag` gives it. */
  model?: string;
  cones?: Cone[];
  /** Pairs of a loop and its l, and of a generator and its r. */
  turnings?: [number, number][];
  handles?: [number, number][];
}

/** Identifies one mesh of one file: the start of its SHA-256, and the mesh's number. */
export const modelTag = ({ file, surface }: { file: { sha256: string }; surface: number }) =>
  `${file.sha256.slice(0, 8)}.${surface}`;

const integer = (text: string | null, low: number, high: number): number | undefined => {
  const n = text === null ? NaN : Number(text);
  return Number.isInteger(n) && n >= low && n <= high ? n : undefined;
};

/** Lists of two integers, or of up to `most`; undefined if the text has anything else. */
function tuplesOf(text: string | null, most: number): number[][] | undefined {
  if (!text || text.length > maxText || !/^[\w-]+$/.test(text)) return undefined;
  try {
    const list: unknown = JSON.parse(atob(text.replaceAll('-', '+').replaceAll('_', '/')));
    const isTuple = (one: unknown): boolean =>
      Array.isArray(one) &&
      one.length >= 2 &&
      one.length <= most &&
      one.every((n) => Number.isSafeInteger(n));
    return Array.isArray(list) && list.every(isTuple) ? (list as number[][]) : undefined;
  } catch {
    return undefined;
  }
}

const pairsOf = (text: string | null) => tuplesOf(text, 2) as [number, number][] | undefined;

/** A vertex and its k; of a copy of a vertex, its triangle as well. */
const tupleOf = ({ vertex, k, triangle }: Cone): number[] =>
  triangle === undefined ? [vertex, k] : [vertex, k, triangle];

function conesOf(text: string | null): Cone[] | undefined {
  const tuples = tuplesOf(text, 3);
  // There need not be a triangle.
  const isCone = ([vertex, k, triangle]: number[]): boolean =>
    vertex >= 0 && k >= 1 && !(triangle < 0);
  if (!tuples?.every(isCone)) return undefined;
  return tuples.map(([vertex, k, triangle]) => ({
    vertex,
    k,
    ...(triangle === undefined ? {} : { triangle }),
  }));
}

function gridOf(words: URLSearchParams): GridSettings | undefined {
  const word = words.get('grid');
  const cells = integer(words.get('cells'), 1, 1_000_000);
  if (word === 'off') return { isOn: false, mode: 'tile', cells };
  return word === 'tile' || word === 'quad' ? { isOn: true, mode: word, cells } : undefined;
}

function featuresOf(words: URLSearchParams): HashState['features'] {
  const edges: Edge[] | undefined = pairsOf(words.get('edges'));
  const hasRims = words.get('rims') === '1';
  const isGood = (edges ?? []).every(([v, w]) => v >= 0 && w >= 0);
  const isSymmetric = words.get('symmetric') === '1';
  if (!isGood || (!edges && !hasRims && !isSymmetric)) return undefined;
  const hasCreases = words.get('creases') === '1';
  const marks = {
    ...(isSymmetric ? { isSymmetric } : {}),
    ...(words.get('own') === '1' ? { keepsCones: true } : {}),
  };
  return { hasCreases, hasRims, edges: edges ?? [], ...marks };
}

export function readHash(hash: string): HashState {
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const known = <T>(list: readonly T[], key: string): T | undefined =>
    list.find((word) => word === words.get(key));
  const tiles = Number(words.get('tiles'));
  const improve = Number(words.get('improve') ?? NaN);
  return {
    example: /^[a-z0-9-]{1,40}$/.exec(words.get('example') ?? '')?.[0],
    q: integer(words.get('q'), 1, 64),
    pattern: known(
      patterns.filter((name) => name !== 'image' && name !== 'material'),
      'pattern',
    ),
    overlay: known(overlays, 'overlay'),
    tiles: tiles >= 1 && tiles <= 1000 ? tiles : undefined,
    camera: words.get('camera') ?? undefined,
    grid: gridOf(words),
    improve: improve >= -1 && improve <= 1 ? improve : undefined,
    rounds: integer(words.get('rounds'), 1, 1000),
    timeLimit: integer(words.get('limit'), 1, 1_000_000),
    features: featuresOf(words),
    model: /^[0-9a-f]{8}\.\d{1,9}$/.exec(words.get('model') ?? '')?.[0],
    cones: conesOf(words.get('cones')),
    turnings: pairsOf(words.get('turnings')),
    handles: pairsOf(words.get('handles')),
  };
}

export interface HashSource {
  /** The open example, if any. */
  example?: string;
  look: Look;
  prescription: Prescription;
  solve: Pick<SolveSettings, 'grid' | 'improve' | 'rounds' | 'timeLimit'>;
  features?: FeatureChoice;
  camera?: string;
  model?: string;
}

export interface Written {
  hash: string;
  /** What is too long for an address. */
  omitted: string[];
}

/** The settings that differ from those of a new page. */
export function writeHash(source: HashSource): Written {
  const { example, look, prescription, camera, model, solve, features } = source;
  const omitted: string[] = [];
  const words = new URLSearchParams();
  if (example) words.set('example', example);
  words.set('q', String(prescription.q));
  words.set('pattern', look.pattern);
  if (look.overlay !== 'none') words.set('overlay', look.overlay);
  words.set('tiles', look.tiles.toFixed(0));
  if (camera) words.set('camera', camera);
  const { grid, improve, rounds, timeLimit } = solve;
  if (!grid.isOn || grid.mode !== 'tile' || grid.cells !== undefined)
    words.set('grid', grid.isOn ? grid.mode : 'off');
  if (grid.cells !== undefined) words.set('cells', String(grid.cells));
  if (improve !== undefined) words.set('improve', String(improve));
  if (rounds !== plainRounds) words.set('rounds', String(rounds));
  if (timeLimit !== undefined) words.set('limit', String(timeLimit));
  const set = (key: string, pairs: readonly (readonly number[])[], what: string): void => {
    const text = btoa(JSON.stringify(pairs));
    const safe = text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    if (pairs.length === 0) return;
    if (safe.length <= maxText) words.set(key, safe);
    else omitted.push(`${pairs.length} ${what}`);
  };
  const said = (list: readonly (number | null)[]): number[][] =>
    list.flatMap((n, i) => (n === null ? [] : [[i, n]]));
  set('cones', prescription.cones.map(tupleOf), 'cones');
  set('turnings', said(prescription.turnings), 'turnings');
  set('handles', said(prescription.handles), 'rotations around handles');
  set('edges', features?.edges ?? [], 'edges that lines follow');
  if (features?.hasRims) words.set('rims', '1');
  if (features?.isSymmetric) words.set('symmetric', '1');
  if (features?.hasCreases && words.has('edges')) words.set('creases', '1');
  if (features?.keepsCones && words.has('cones')) words.set('own', '1');
  const ofModel = ['cones', 'turnings', 'handles', 'edges', 'rims', 'symmetric'];
  if (model && ofModel.some((key) => words.has(key))) words.set('model', model);
  return { hash: `#${words}`, omitted };
}
