// Recordings of what page and package do, in texts that are read like a diff. A test that differs from its recording says
// where; if the difference is wanted, HGP_RECORD=1 writes the recordings anew:
//
//   HGP_RECORD=1 node --import ./tests/support/typescript.mjs --test \
//     tests/web/units/recorded_*.test.mjs tests/wasm/recorded.test.mjs

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const around = 8; // lines shown
const remake = 'the command in CONTRIBUTING.md writes all of them anew.';

/** Numbers as written in a recording: what differs between engines in the last bits does not show. */
export function numberText(x, digits = 3) {
  if (Number.isInteger(x) && Math.abs(x) < 2 ** 31) return String(x + 0);
  if (!Number.isFinite(x)) return String(x);
  if (Math.abs(x) < 1e-6) return '0';
  return String(Number(x.toPrecision(digits)));
}

const isTyped = (value) => ArrayBuffer.isView(value) && !(value instanceof DataView);

/** A long list by its length, its sum, and a sum with weights, by which places are told apart. */
function listText(list) {
  if (list.length <= 9) return `[${Array.from(list, (x) => numberText(Number(x))).join(' ')}]`;
  let [sum, weighted, size, total] = [0, 0, 0, 0];
  for (let i = 0; i < list.length; i++) {
    const x = Number(list[i]);
    if (!Number.isFinite(x)) continue;
    const weight = 1 + ((i * 7919) % 13);
    sum += x;
    weighted += weight * x;
    size += Math.abs(x);
    total += weight * Math.abs(x);
  }
  const part = (a, b) => numberText(Math.round((1000 * a) / (b || 1)) / 1000);
  // Ids are exact; what was computed may differ in the last bits, and bytes of it by one.
  const isExact = list instanceof Uint32Array || list instanceof Int32Array || Array.isArray(list);
  const about = isExact ? size : Number(size.toPrecision(4));
  return `[${list.length}: ${numberText(about)} ${part(sum, size)} ${part(weighted, total)}]`;
}

const hashOf = (text) => createHash('sha256').update(text).digest('hex').slice(0, 6);

/** A value in one line. */
export function valueText(value, depth = 4) {
  if (typeof value === 'number') return numberText(value);
  if (typeof value === 'string') return JSON.stringify(value.length > 400 ? `${value.slice(0, 60)}… ${value.length}, ${hashOf(value)}` : value); // prettier-ignore
  if (typeof value === 'function') return 'ƒ';
  if (value === null || typeof value !== 'object') return String(value);
  if (isTyped(value)) return listText(value);
  if (Array.isArray(value) && value.length > 0 && value.every((x) => typeof x === 'number')) return listText(value); // prettier-ignore
  if (value instanceof ArrayBuffer) return `${value.byteLength} bytes`;
  if (value instanceof Blob) return `${value.size} bytes`;
  if (value instanceof Error) return `${value.name} ${value.code ?? ''} ${value.message}`;
  if (depth === 0) return '…';
  const inner = (one) => valueText(one, depth - 1);
  if (value instanceof Set) return `{${[...value].map(inner).join(' ')}}`;
  if (value instanceof Map) return `{${[...value].map(([key, one]) => `${key}: ${inner(one)}`).join(', ')}}`; // prettier-ignore
  if (Array.isArray(value)) {
    const more = value.length > 12 ? [`… ${value.length}`] : [];
    return `[${[...value.slice(0, 12).map(inner), ...more].join(', ')}]`;
  }
  const entries = Object.entries(value).filter(([, one]) => one !== undefined && typeof one !== 'function'); // prettier-ignore
  return `{${entries.map(([key, one]) => `${key}: ${inner(one)}`).join(', ')}}`;
}

const keyOf = (line) => line.match(/^\S+(?: [\w.]+)?/)?.[0] ?? '';

/** A changed line: what it is now, between its parts that stay. What it was is further up. */
function changedText(was, is) {
  const [a, b] = [was, is].map((line) => line.split(/(?<=\s)/));
  let head = 0;
  while (head < Math.min(a.length, b.length) && a[head] === b[head]) head++;
  let tail = 0;
  while (tail < Math.min(a.length, b.length) - head && a.at(-1 - tail) === b.at(-1 - tail)) tail++;
  const part = (words) =>
    words
      .slice(head, words.length - tail)
      .join('')
      .trim();
  const key = keyOf(is);
  const label = head === 0 ? '' : `${key.slice(0, 30)}${a.slice(0, head).join('').length > key.length + 1 ? ' …' : ''} `; // prettier-ignore
  return `~${label}${part(b) || `without ${part(a)}`}`;
}

const most = 48; // characters of a line that goes

/** Lines that went and came in one place: those of the same kind are written as one. */
function* hunkLines(gone, come) {
  const rest = [...gone];
  const written = come.map((line) => {
    const at = rest.findIndex((one) => keyOf(one) === keyOf(line));
    return at < 0 ? `+${line}` : changedText(rest.splice(at, 1)[0], line);
  });
  if (rest.length > 3)
    yield `-${rest[0].slice(0, most)} … ${rest.length} lines … ${rest.at(-1).slice(0, most)}`; // prettier-ignore
  else yield* rest.map((line) => `-${line.slice(0, most)}`);
  yield* written;
}

/** What has changed from one list of lines to another, in order: + came, - went, ~ is another than before. */
export function changes(before, after) {
  let head = 0;
  while (head < before.length && before[head] === after[head]) head++;
  let tail = 0;
  while (tail < Math.min(before.length, after.length) - head && before.at(-1 - tail) === after.at(-1 - tail)) tail++; // prettier-ignore
  const a = before.slice(head, before.length - tail);
  const b = after.slice(head, after.length - tail);
  const common = Array.from({ length: a.length + 1 }, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; i--)
    for (let j = b.length - 1; j >= 0; j--)
      common[i][j] = a[i] === b[j] ? common[i + 1][j + 1] + 1 : Math.max(common[i + 1][j], common[i][j + 1]); // prettier-ignore
  const found = [];
  let [gone, come] = [[], []];
  const flush = () => {
    found.push(...hunkLines(gone, come));
    [gone, come] = [[], []];
  };
  for (let i = 0, j = 0; i < a.length || j < b.length;) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      flush();
      [i, j] = [i + 1, j + 1];
    } else if (i < a.length && (j === b.length || common[i + 1][j] >= common[i][j + 1]))
      gone.push(a[i++]);
    else come.push(b[j++]);
  }
  flush();
  return found;
}

const long = 64; // characters of a line that was written out before

/**
 * Lines that were written out before, in a few words: how many, the beginning of the first, and their hash, so that none
 * can differ.
 */
export function shortened(lines, known) {
  const found = [];
  let run = [];
  const flush = () => {
    const [first = ''] = run;
    const beginning = `${first.slice(0, most)} …`;
    if (run.length > 2) found.push(`${beginning} ${run.length} lines as before, ${hashOf(run.join('\n'))}`); // prettier-ignore
    else for (const one of run) found.push(one.length > long ? `${one.slice(0, most)} … as before, ${hashOf(one)}` : one); // prettier-ignore
    run = [];
  };
  for (const line of lines) {
    if (/^[+~]/.test(line) && known.has(line)) run.push(line);
    else {
      flush();
      found.push(line);
      known.add(line);
    }
  }
  flush();
  return found;
}

/** Lines that are compared with the recording of a name as they come, or that make it anew. */
export class Recording {
  #file;
  #lines = [];
  #known;
  #checked = 0;

  /** @param {string} folder  of the test */
  constructor(name, folder) {
    this.#file = path.join(folder, 'recorded', `${name}.txt`);
    const isThere = existsSync(this.#file) && !process.env.HGP_RECORD;
    this.#known = isThere ? readFileSync(this.#file, 'utf8').split('\n') : [''];
  }

  /** @param {string[]} lines */
  add(...lines) {
    this.#lines.push(...lines);
    if (process.env.HGP_RECORD) return;
    for (; this.#checked < this.#lines.length; this.#checked++)
      if (this.#known[this.#checked] !== this.#lines[this.#checked]) this.#fail();
  }

  /** Nothing more comes. */
  end() {
    if (process.env.HGP_RECORD) {
      mkdirSync(path.dirname(this.#file), { recursive: true });
      writeFileSync(this.#file, `${this.#lines.join('\n')}\n`);
    } else if (this.#known.length !== this.#lines.length + 1) this.#fail();
  }

  #fail() {
    const at = this.#checked;
    const step = this.#lines.slice(0, at + 1).findLast((line) => line.startsWith('# ')) ?? '';
    const part = (list, sign) => list.slice(at, at + around).map((line) => `${sign} ${line}`);
    assert.fail(
      [
        `recorded/${path.basename(this.#file)}, line ${at + 1}, ${step}`,
        ...part(this.#known, 'recorded:'),
        ...part(this.#lines, 'now:     '),
        `If this is wanted, ${remake}`,
      ].join('\n'),
    );
  }
}
