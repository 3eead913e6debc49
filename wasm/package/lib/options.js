// The options of every call, checked before anything is sent to the worker: an unknown name or a value of
// the wrong type is an error and never silently ignored.

import { usage } from './error.js';

const describe = (value) => {
  if (typeof value === 'string') return `'${value.slice(0, 40)}'`;
  if (typeof value === 'number' || typeof value === 'boolean') return String(value);
  if (typeof value === 'bigint') return `${value}n (a BigInt)`;
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' ? `a ${value.constructor?.name ?? 'object'}` : typeof value;
};

/** A type of values: its name in messages, and a test for values. */
const kind = (name, test) => ({ name, test });

export const boolean = kind('true or false', (value) => typeof value === 'boolean');
export const string = kind('a string', (value) => typeof value === 'string');
export const positive = kind(
  'a positive number',
  (value) => typeof value === 'number' && Number.isFinite(value) && value > 0,
);
export const number = kind(
  'a number of at least 0',
  (value) => typeof value === 'number' && Number.isFinite(value) && value >= 0,
);
export const integer = (low, high = Number.MAX_SAFE_INTEGER) =>
  kind(
    high === Number.MAX_SAFE_INTEGER
      ? `an integer of at least ${low}`
      : `an integer from ${low} to ${high}`,
    (value) => Number.isInteger(value) && value >= low && value <= high,
  );
export const oneOf = (...words) =>
  kind(words.map((word) => `'${word}'`).join(' or '), (value) => words.includes(value));
const isRecord = (value) =>
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
const record = (fields) => ({ name: 'an object', test: isRecord, fields });

const improve = kind(
  "'isometric', 'conformal', 'area' or a number from -1 to 1",
  (value) =>
    ['isometric', 'conformal', 'area'].includes(value) ||
    (typeof value === 'number' && value >= -1 && value <= 1),
);
const order = integer(1, 64);

/** The options of each call. The declarations in options.d.ts have the same names; a test compares them. */
export const optionsOf = {
  load: {
    name: string,
    surface: integer(0),
    weld: number,
    limits: record({ bytes: positive, triangles: positive }),
    fix: record({ orient: boolean, split: boolean, degenerate: boolean }),
    strict: boolean,
    writeRepairs: boolean,
    target: oneOf('obj', 'glb', 'gltf'),
  },
  suggestCones: {
    q: order,
    count: integer(0),
    conesFor: oneOf('balanced', 'few', 'low-distortion'),
    alignToCurvature: boolean,
  },
  verify: { cones, field: coneFile, q: integer(0, 64), uvSet: integer(-1), tolerance: number },
  write: {
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
  },
  quads: { name: string },
};
optionsOf.parametrize = {
  ...optionsOf.suggestCones,
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
  grid: record({ cells: number, spacing: number, mode: oneOf('tile', 'quad') }),
};

const without = (fields, ...names) =>
  Object.fromEntries(Object.entries(fields).filter(([name]) => !names.includes(name)));
optionsOf.parametrizeFile = {
  ...without(optionsOf.load, 'surface'),
  ...without(optionsOf.parametrize, 'cones', 'field', 'frames', 'refine'),
  write: record(without(optionsOf.write, 'format')),
};

/** The known name that was probably meant: equal up to case, or different in one letter. */
function nearest(name, known) {
  const plain = (word) => word.toLowerCase().replace(/s$/, '');
  return known.find((other) => plain(other) === plain(name));
}

/** Throws a usage error with the call, the option and the expected type. */
export function checkOptions(call, options, fields = optionsOf[call], path = '') {
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
    if (inner) checkOptions(call, value, inner, `${path}${name}.`);
  }
  if (options.frames === 'file' && !options.field) {
    throw usage("parametrize: frames: 'file' needs the field that they come from (field)");
  }
}

export function checkCones(call, value) {
  if (!cones.test(value)) throw usage(`${call}: cones are ${cones.name}, not ${describe(value)}`);
}

export function checkConeFile(call, value) {
  if (!coneFile.test(value)) {
    throw usage(`${call}: a file of cones is ${coneFile.name}, not ${describe(value)}`);
  }
}

export { describe };
