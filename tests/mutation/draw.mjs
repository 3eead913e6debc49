// Faults of one line drawn at random from a seed: signs, off-by-one, swapped arguments, dropped terms, removed
// statements, constants times ten, weakened comparisons, options ignored. Unlike those of faults.mjs nobody has chosen
// them, so that the share that is caught says how much the tests see.

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';

/** Numbers in [0, 1) that depend on the seed only (mulberry32). */
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** The text with comments, strings and preprocessor lines blanked, every other character in its place. */
export function codeOf(text) {
  const blank = (part) => part.replace(/[^\n]/g, ' ');
  return text.replace(
    /\/\/[^\n]*|\/\*[\s\S]*?\*\/|R"\([\s\S]*?\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|^[ \t]*#[^\n]*/gm,
    blank,
  );
}

const swapped = { '<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==', '&&': '||', '||': '&&', '+': '-', '-': '+', min: 'max', max: 'min', true: 'false', false: 'true' }; // prettier-ignore
const swap = (match, word) => match.replace(word, swapped[word]);
const word = String.raw`[\w.]+(?:\[\w+\])?`;
const notAStatement = String.raw`(?!return|const|auto|using|case|break|continue|else|if|for|while|do|switch|default|throw|static|struct|class|enum|public|private|template|HGP_CHECK)`; // prettier-ignore

/** Functions whose arguments may be swapped, which is no fault. */
export const isSymmetric = (name) => /^(?:min|max|hypot|gcd|swap|same[A-Z]\w*)$/.test(name);

/** Each kind: where it applies, in code without comments and strings, and what stands there afterwards. */
const kinds = {
  sign: [/ ([+-]) (?=[\w(])/g, swap],
  compound: [/ ([+-])= /g, swap],
  strictness: [/(?<=[\w)\]]) (<=|>=|<|>) (?=[\w(!*-])/g, swap],
  equality: [/ (==|!=) /g, swap],
  logic: [/ (&&|\|\|) /g, swap],
  negation: [/!(?=[a-zA-Z_(])/g, () => ''],
  arguments: [new RegExp(String.raw`\b(\w+)\((${word}), (${word})\)`, 'g'), (call, f, a, b) => (isSymmetric(f) ? call : `${f}(${b}, ${a})`)], // prettier-ignore
  term: [/ [+-] [\w.]+(?:\([^()]*\)|\[[^[\]]*\])*(?=[;,)])/g, () => ''],
  statement: [new RegExp(String.raw`(?<=[;{})]\n)( +)${notAStatement}[\w:.>[\]()*&-]+(?:\(.*\)| [+*/-]?= .*);(?=\n)`, 'g'), (line, space) => (/\.reserve\(/.test(line) ? line : `${space};`)], // prettier-ignore
  constant: [/(?<=constexpr double \w+ = )([^;,]+)(?=;)/g, (value) => `10.0 * (${value})`],
  number: [/(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.])/g, (value) => (Number(value) === 0 ? '1.0' : `(10.0 * ${value})`)], // prettier-ignore
  one: [/ [+-] 1(?=[;,)\] ])/g, () => ''],
  zero: [/(?<=[[( ])0(?=[;)\]])/g, () => '1'],
  boolean: [/(?<=return )(true|false)(?=;)/g, swap],
  jump: [/(?<=\n +)(break|continue)(?=;)/g, () => ''],
  extreme: [/std::(min|max)(?=[({])/g, swap],
};

/** All places of a text where a kind of fault can be planted. */
export function sitesOf(text, kind) {
  const [pattern, replace] = kinds[kind];
  const sites = [];
  for (const match of codeOf(text).matchAll(pattern)) {
    const original = text.slice(match.index, match.index + match[0].length);
    if (original !== match[0]) continue; // has a string or a comment in it
    const put = replace(match[0], ...match.slice(1));
    if (put !== match[0]) sites.push({ at: match.index, find: match[0], put });
  }
  return sites;
}

const sourcesIn = (root, folder, accepts) =>
  readdirSync(path.join(root, folder), { recursive: true })
    .filter(accepts)
    .map((name) => path.posix.join(folder, name.split(path.sep).join('/')))
    .sort();

/** The files that faults are drawn from: sources that are compiled by themselves (a header is in many). */
export function filesToDrawFrom(root, words) {
  const isSource = (name) => name.endsWith('.cpp') && !/kernels[/\\]|third_party/.test(name);
  const files = [...sourcesIn(root, 'core/hgp', isSource), ...sourcesIn(root, 'examples/cli', isSource)]; // prettier-ignore
  return files.filter((file) => words.length === 0 || words.some((part) => file.includes(part)));
}

/** The modules in the order of the build, lowest first, and whether they have tests of their own. */
export function modulesOf(root) {
  const text = readFileSync(path.join(root, 'CMakeLists.txt'), 'utf8');
  const names = text.match(/set\(HGP_MODULES ([^)]*)\)/)[1].split(/\s+/);
  return names.map((name) => ({ name, hasTests: existsSync(path.join(root, 'tests/core', name)) }));
}

/** The tests that may see a fault in a file, the quickest first: recorded results, its module's, those of the modules
 *  above, and at last those that run the program. Names with "node:" are folders of tests of the program. */
export function programsFor(file, modules) {
  if (!file.startsWith('core/')) return ['node:cli'];
  const own = file.split('/')[2];
  const from = modules.findIndex(({ name }) => name === own);
  const tested = modules.slice(from).filter(({ hasTests }) => hasTests);
  const above = tested.map(({ name }) => name).filter((name) => name !== own);
  const near = ['api', 'parametrize', 'paper'].filter((name) => name === 'paper' || above.includes(name)); // prettier-ignore
  const first = ['recorded', ...(modules[from].hasTests ? [own] : ['io'])];
  return [
    ...new Set([...first, ...above.filter((name) => !near.includes(name)), ...near, 'node:cli']),
  ];
}

/**
 * `count` different faults, each file as likely as it has lines.
 * @returns {{file: string, line: number, kind: string, name: string, find: string, put: string, text: string}[]}
 */
export function drawFaults(root, seed, count, words = []) {
  const random = randomFrom(seed);
  const files = filesToDrawFrom(root, words).map((file) => {
    const text = readFileSync(path.join(root, file), 'utf8');
    return { file, text, lines: text.split('\n').length };
  });
  const total = files.reduce((sum, { lines }) => sum + lines, 0);
  const seen = new Set();
  const drawn = [];
  for (let tries = 0; drawn.length < count && tries < 200 * count; tries++) {
    let rest = random() * total;
    const { file, text } = files.find(({ lines }) => (rest -= lines) < 0) ?? files.at(-1);
    const names = Object.keys(kinds);
    const kind = names[Math.floor(random() * names.length)];
    const sites = sitesOf(text, kind);
    const site = sites[Math.floor(random() * sites.length)];
    if (!site || seen.has(`${file}:${site.at}`)) continue;
    seen.add(`${file}:${site.at}`);
    const line = text.slice(0, site.at).split('\n').length + (site.find.startsWith('\n') ? 1 : 0);
    drawn.push({
      ...site,
      file,
      line,
      kind,
      name: `${file}:${line} ${kind}: ${text.split('\n')[line - 1].trim()}`,
      text: text.slice(0, site.at) + site.put + text.slice(site.at + site.find.length),
    });
  }
  return drawn;
}
