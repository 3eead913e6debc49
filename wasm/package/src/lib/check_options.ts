// The options of every call, checked before anything is sent to the worker: an unknown name or a value of
// the wrong type is an error and never silently ignored.

import { usage } from './error.js';

/** @internal */
export const describe = (value: unknown): string => {
  if (typeof value === 'string') return `'${value.slice(0, 40)}'`;
  if (typeof value === 'number' || typeof value === 'boolean') return String(value);
  if (typeof value === 'bigint') return `${value}n (a BigInt)`;
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  if (typeof value !== 'object') return typeof value;
  const { constructor } = value as { constructor?: { name?: string } };
  return `a ${constructor?.name ?? 'object'}`;
};

/** A type of values: its name in messages, and a test for values. */
interface Kind {
  name: string;
  test: (value: unknown) => boolean;
  /** The members of a record. */
  fields?: Fields;
}
type Fields = Record<string, Kind>;

const kind = (name: string, test: Kind['test']): Kind => ({ name, test });

const isFinite = (value: unknown): value is number =>
  typeof value === 'number' && Number.isFinite(value);
const boolean = kind('true or false', (value) => typeof value === 'boolean');
const string = kind('a string', (value) => typeof value === 'string');
const positive = kind('a positive number', (value) => isFinite(value) && value > 0);
const number = kind('a number of at least 0', (value) => isFinite(value) && value >= 0);
const integer = (low: number, high = Number.MAX_SAFE_INTEGER): Kind =>
  kind(
    high === Number.MAX_SAFE_INTEGER
      ? `an integer of at least ${low}`
      : `an integer from ${low} to ${high}`,
    (value) => isFinite(value) && Number.isInteger(value) && value >= low && value <= high,
  );
const oneOf = (...words: string[]): Kind =>
  kind(words.map((word) => `'${word}'`).join(' or '), (value) => words.includes(value as string));
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' &&
  value !== null &&
  !Array.isArray(value) &&
  !ArrayBuffer.isView(value);
const cones = kind(
  '{ q, cones: [{ vertex, k }, …] }',
  (value) => isRecord(value) && Array.isArray(value.cones),
);
const coneFile = kind(
  '{ name, text }',
  (value) => isRecord(value) && typeof value.text === 'string',
);
const record = (fields: Fields): Kind => ({ name: 'an object', test: isRecord, fields });
const callback = kind('a function', (value) => typeof value === 'function');
const signal = kind(
  'an AbortSignal',
  (value) => typeof value === 'object' && value !== null && 'aborted' in value,
);
const anything = kind('anything', () => true);

const improve = kind(
  "'isometric', 'conformal', 'area' or a number from -1 to 1",
  (value) =>
    ['isometric', 'conformal', 'area'].includes(value as string) ||
    (isFinite(value) && value >= -1 && value <= 1),
);
const order = integer(1, 64);

const load: Fields = {
  name: string,
  surface: integer(0),
  weld: number,
  limits: record({ bytes: positive, triangles: positive }),
  fix: record({ orient: boolean, split: boolean, degenerate: boolean }),
  strict: boolean,
  writeRepairs: boolean,
  target: oneOf('obj', 'glb', 'gltf', 'ply'),
};
const suggestCones: Fields = {
  q: order,
  count: integer(0),
  conesFor: oneOf('balanced', 'few', 'low-distortion'),
  alignToCurvature: boolean,
};
const parametrize: Fields = {
  ...suggestCones,
  cones,
  field: coneFile,
  frames: oneOf('auto', 'file'),
  boundary: oneOf('free', 'convex'),
  maxRounds: integer(1),
  method: oneOf('auto', 'harmonic', 'soft', 'printed', 'all-frames'),
  improve,
  quality: boolean,
  keepGoing: boolean,
  scale: oneOf('solved', 'unit', 'fit'),
  refine: boolean,
  convexPolygons: boolean,
  grid: record({ cells: number, spacing: number, mode: oneOf('tile', 'quad') }),
};
const write: Fields = {
  format: oneOf('same', 'glb', 'gltf', 'obj', 'flat-obj', 'svg'),
  gridMaterial: kind(
    'true or a positive number',
    (value) => typeof value === 'boolean' || positive.test(value),
  ),
  uvSet: integer(-1),
  name: string,
  embedCones: boolean,
  allowUncertified: boolean,
  use: boolean,
};
const { surface: _surface, ...loadFile } = load;
const {
  cones: _cones,
  field: _field,
  frames: _frames,
  refine: _refine,
  ...solveFile
} = parametrize;
const { format: _format, ...writeFile } = write;
const { limits, fix, strict } = load;

/**
 * The options of each call. The declarations in ./options.ts and ./client.ts have the same names; a test compares them.
 * @internal
 */
export const optionsOf = {
  load,
  loadMesh: {
    weld: kind('a number of at least 0 or false', (value) => value === false || number.test(value)),
    ...{ limits, fix, strict },
  },
  suggestCones,
  parametrize,
  verify: { cones, field: coneFile, q: integer(0, 64), uvSet: integer(-1), tolerance: number },
  write,
  quads: { name: string },
  parametrizeFile: { ...loadFile, ...solveFile, write: record(writeFile) },
  combine: {
    ...{ name: string, uvSet: integer(-1), embedCones: boolean },
    ...{ allowUncertified: boolean, use: boolean, gridMaterial: write.gridMaterial },
  },
  createClient: {
    ...{ wasmUrl: anything, wasmBinary: anything, wasmModule: anything, workerUrl: anything },
    ...{ createWorker: callback, warmUp: boolean },
  },
  call: { signal, onProgress: callback },
} satisfies Record<string, Fields>;

/** @internal */
export type CallName = keyof typeof optionsOf;

/** The known name that was probably meant: equal up to case, or different in one letter. */
function nearest(name: string, known: string[]): string | undefined {
  const plain = (word: string): string => word.toLowerCase().replace(/s$/, '');
  return known.find((other) => plain(other) === plain(name));
}

function checkFields(call: string, options: unknown, fields: Fields, path: string): void {
  if (!isRecord(options)) throw usage(`${call}: options are an object, not ${describe(options)}`);
  for (const [name, value] of Object.entries(options)) {
    if (!Object.hasOwn(fields, name)) {
      const known = Object.keys(fields);
      const meant = nearest(name, known);
      const hint = meant ? `did you mean '${meant}'?` : `there are: ${known.join(', ')}`;
      throw usage(`${call}: there is no option '${path}${name}'; ${hint}`);
    }
    if (value === undefined) continue;
    const { name: wanted, test, fields: inner } = fields[name];
    if (!test(value)) {
      throw usage(`${call}: ${path}${name} is ${wanted}, not ${describe(value)}`);
    }
    if (inner) checkFields(call, value, inner, `${path}${name}.`);
  }
  if (options.frames === 'file' && !options.field) {
    throw usage("parametrize: frames: 'file' needs the field that they come from (field)");
  }
}

/**
 * Throws a usage error with the call, the option and the expected type.
 * @internal
 */
export function checkOptions(call: CallName, options: unknown): void {
  checkFields(call, options, optionsOf[call], '');
}

/** @internal */
export function checkCones(call: string, value: unknown): void {
  if (!cones.test(value)) throw usage(`${call}: cones are ${cones.name}, not ${describe(value)}`);
}

/** @internal */
export function checkConeFile(call: string, value: unknown): void {
  if (!coneFile.test(value)) {
    throw usage(`${call}: a file of cones is ${coneFile.name}, not ${describe(value)}`);
  }
}

/** @internal */
export function checkVertex(call: string, value: unknown): void {
  const vertex = integer(0);
  if (!vertex.test(value))
    throw usage(`${call}: a vertex is ${vertex.name}, not ${describe(value)}`);
}
