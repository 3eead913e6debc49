// The options of every call, checked before anything is sent to the worker: an unknown name or a value of
// the wrong type is an error and never silently ignored. Names, types and bounds are those of the core's table.

import { usage } from './error.js';
import { optionTable, type OptionRow } from './option_table.js';

/** @internal */
export const describe = (value: unknown): string => {
  if (typeof value === 'string') return `'${Array.from(value.slice(0, 80)).slice(0, 40).join('')}'`;
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

const kind = (name: string, test: Kind['test'], fields?: Fields): Kind => ({
  name,
  test,
  ...(fields && { fields }),
});

const isFinite = (value: unknown): value is number =>
  typeof value === 'number' && Number.isFinite(value);
const boolean = kind('true or false', (value) => typeof value === 'boolean');
const string = kind('a string', (value) => typeof value === 'string');
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
const features = kind(
  '{ rims, creases, marked, lines } or { name, text }',
  (value) =>
    isRecord(value) &&
    (typeof value.text === 'string' ||
      Object.keys(value).every((name) => ['rims', 'creases', 'marked', 'lines'].includes(name))),
);
const record = (fields: Fields): Kind => ({ name: 'an object', test: isRecord, fields });
const callback = kind('a function', (value) => typeof value === 'function');
const signal = kind(
  'an AbortSignal',
  (value) => typeof value === 'object' && value !== null && 'aborted' in value,
);
const anything = kind('anything', () => true);

const bounded = ({ low = -Infinity, high = Infinity, isOpen }: OptionRow, value: number) =>
  (isOpen ? value > low : value >= low) && value <= high;

/** "a number from -1 to 1" */
function numberName({ low, high, isOpen }: OptionRow): string {
  if (high !== undefined)
    return `a number from ${low} to ${high < 1e6 ? high : high.toExponential()}`;
  if (low === undefined) return 'a number';
  return isOpen
    ? low === 0
      ? 'a positive number'
      : `a number above ${low}`
    : `a number of at least ${low}`;
}

/** The values of a row of the core's table. */
function kindOf(row: OptionRow): Kind {
  const { words = [], low = 0, high } = row;
  const isNumber = (value: unknown): boolean => isFinite(value) && bounded(row, value);
  switch (row.kind) {
    case 'flag':
      return boolean;
    case 'integer':
      return integer(low, high);
    case 'number':
      return kind(numberName(row), isNumber);
    case 'text':
      return string;
    case 'word':
      return oneOf(...words);
    case 'wordOrNumber':
      return kind(
        `${words.map((word) => `'${word}'`).join(', ')} or ${numberName(row)}`,
        (value) => words.includes(value as string) || isNumber(value),
      );
    case 'flagOrNumber':
      return kind(
        `true, false or ${numberName(row)}`,
        (value) => typeof value === 'boolean' || isNumber(value),
      );
    case 'words':
      return record(Object.fromEntries(words.map((word) => [word, boolean])));
  }
}

/** The rows of the core's table as fields; "grid.cells" is a member of the record `grid`. */
function fieldsOf(rows: OptionRow[]): Fields {
  const fields: Fields = {};
  for (const row of rows) {
    const [name, member] = row.name.split('.');
    if (!member) fields[name] = kindOf(row);
    else ((fields[name] ??= record({})).fields ?? {})[member] = kindOf(row);
  }
  return fields;
}

const load: Fields = { name: string, ...fieldsOf(optionTable.load) };
const solve = fieldsOf(optionTable.solve);
const { cells, ...gridFields } = solve.grid.fields ?? {};
const grid = kind("'auto' or an object", (value) => value === 'auto' || isRecord(value), {
  ...gridFields,
  cells: kind(`${cells.name} or 'auto'`, (value) => value === 'auto' || cells.test(value)),
});
const parametrize: Fields = { ...solve, grid, cones, field: coneFile, features };
const { q, count, conesFor, alignToCurvature } = parametrize;
const write = fieldsOf(optionTable.write);
const { surface: _surface, ...loadFile } = load;
const {
  cones: _cones,
  field: _field,
  frames: _frames,
  refine: _refine,
  ...solveFile
} = parametrize;
const { format: _format, ...writeFile } = write;
const { limits, fix, strict, weld } = load;

/**
 * The options of each call. The declarations in ./options.ts and ./client.ts have the same names; a test compares them.
 * @internal
 */
export const optionsOf = {
  load,
  loadMesh: {
    weld: kind(`${weld.name} or false`, (value) => value === false || weld.test(value)),
    limits,
    fix,
    strict,
  },
  suggestCones: { q, count, conesFor, alignToCurvature },
  parametrize,
  verify: { cones, field: coneFile, features, ...fieldsOf(optionTable.verify) },
  write,
  quads: { name: string },
  listFeatures: { name: string },
  parametrizeFile: { ...loadFile, ...solveFile, write: record(writeFile) },
  combine: {
    name: string,
    uvSet: write.uvSet,
    embedCones: boolean,
    allowUncertified: boolean,
    use: boolean,
    gridMaterial: write.gridMaterial,
  },
  createClient: {
    wasmUrl: anything,
    wasmBinary: anything,
    wasmModule: anything,
    workerUrl: anything,
    createWorker: callback,
    warmUp: boolean,
  },
  call: { signal, onProgress: callback, keepWorker: boolean },
  'lite.parametrizeMesh': {
    q,
    count,
    conesFor,
    cones,
    improve: parametrize.improve,
    weld: boolean,
    precision: oneOf('double', 'single'),
  },
  'lite.call': { signal, onProgress: callback },
  'lite.verifyMesh': { q, cones, weld: boolean, tolerance: fieldsOf(optionTable.verify).tolerance },
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
    if (inner && isRecord(value)) checkFields(call, value, inner, `${path}${name}.`);
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
export function checkFeatures(call: string, value: unknown): void {
  if (!features.test(value))
    throw usage(`${call}: features are ${features.name}, not ${describe(value)}`);
}

/** @internal */
export function checkVertex(call: string, value: unknown): void {
  const vertex = integer(0, 2 ** 31 - 1);
  if (!vertex.test(value))
    throw usage(`${call}: a vertex is ${vertex.name}, not ${describe(value)}`);
}
