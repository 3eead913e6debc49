// Faults drawn at random in the TypeScript of the page and the package, of the same kinds as those in the core.

import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import ts from 'typescript';
import { isSymmetric, randomFrom } from './draw.mjs';

const swapped = { '<': '<=', '<=': '<', '>': '>=', '>=': '>', '===': '!==', '!==': '===', '&&': '||', '||': '&&', '+': '-', '-': '+', min: 'max', max: 'min', true: 'false', false: 'true', some: 'every', every: 'some' }; // prettier-ignore
const swap = (match, word) => match.replace(word, swapped[word]);
const word = String.raw`[\w.]+(?:\[\w+\])?`;
const notAStatement = String.raw`(?!return|const|let|case|break|continue|else|if|for|while|do|switch|default|throw|export|import|type|interface|class|super|readonly|private)`; // prettier-ignore

/** Each kind: where it applies, in code without comments and texts, and what stands there afterwards. */
const kinds = {
  sign: [/ ([+-]) (?=[\w(])/g, swap],
  compound: [/ ([+-])= /g, swap],
  strictness: [/(?<=[\w)\]]) (<=|>=|<|>) (?=[\w(!*-])/g, swap],
  equality: [/ (===|!==) /g, swap],
  logic: [/ (&&|\|\|) /g, swap],
  negation: [/!(?=[a-zA-Z_(])/g, () => ''],
  arguments: [new RegExp(String.raw`\b(\w+)\((${word}), (${word})\)`, 'g'), (call, f, a, b) => (isSymmetric(f) ? call : `${f}(${b}, ${a})`)], // prettier-ignore
  term: [/ [+-] [\w.]+(?:\([^()]*\)|\[[^[\]]*\])*(?=[;,)])/g, () => ''],
  statement: [new RegExp(String.raw`(?<=[;{})]\n)( +)${notAStatement}[#\w:.[\]()!?&-]+(?:\(.*\)| [+*/?|&-]*= .*);(?=\n)`, 'g'), (_, space) => `${space};`], // prettier-ignore
  constant: [/(?<=const \w+ = )(\d[\d_.e]*)(?=;)/g, (value) => `10 * ${value}`],
  number: [/(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.])/g, (value) => (Number(value) === 0 ? '1.0' : `(10 * ${value})`)], // prettier-ignore
  one: [/ [+-] 1(?=[;,)\] ])/g, () => ''],
  zero: [/(?<=[[( ])0(?=[;)\]])/g, () => '1'],
  boolean: [/(?<=return |: )(true|false)(?=[;,])/g, swap],
  jump: [/(?<=\n +|\) )(break|continue)(?=;)/g, () => ''],
  extreme: [/(?<=Math\.)(min|max)(?=\()/g, swap],
  all: [/(?<=\.)(some|every)(?=\()/g, swap],
  left: [/(?<=\n +)if \(.*\) return;(?=\n)/g, () => ''],
};

/** The text with comments, strings, the fixed parts of templates and regular expressions blanked in place. */
export function codeOfScript(text) {
  const Kind = ts.SyntaxKind;
  const texts = new Set([Kind.StringLiteral, Kind.NoSubstitutionTemplateLiteral, Kind.TemplateHead, Kind.TemplateMiddle, Kind.TemplateTail, Kind.RegularExpressionLiteral]); // prettier-ignore
  const source = ts.createSourceFile('a.ts', text, ts.ScriptTarget.ES2022, true);
  const code = text.split('');
  const blank = (from, to) => {
    for (let at = from; at < to; at++) if (code[at] !== '\n') code[at] = ' ';
  };
  const visit = (node) => {
    const start = node.getStart(source);
    for (const range of ts.getLeadingCommentRanges(text, node.getFullStart()) ?? [])
      blank(range.pos, range.end);
    if (texts.has(node.kind)) blank(start, node.end);
    else if (ts.isTypeNode(node) || ts.isInterfaceDeclaration(node)) blank(start, node.end);
    node.getChildren(source).forEach(visit);
  };
  visit(source);
  return code.join('');
}

function sitesOf(code, kind) {
  const [pattern, replace] = kinds[kind];
  return [...code.matchAll(pattern)]
    .map((match) => ({
      at: match.index,
      find: match[0],
      put: replace(match[0], ...match.slice(1)),
    }))
    .filter(({ find, put }) => find !== put);
}

/** The sources of the page and the package; not what is generated. */
export function pageFiles(root, words) {
  const generated = /lib\/(documents|options|core_phrases)\.ts$|\.d\.ts$/;
  return ['web/src', 'wasm/package/src']
    .flatMap((folder) =>
      readdirSync(path.join(root, folder), { recursive: true })
        .map((name) => path.posix.join(folder, name))
        .filter((name) => name.endsWith('.ts') && !generated.test(name))
        .sort(),
    )
    .filter((file) => words.length === 0 || words.some((part) => file.includes(part)));
}

/**
 * `count` different faults, each file as likely as it has lines.
 * @returns {{file: string, line: number, name: string, text: string}[]}
 */
export function drawPageFaults(root, seed, count, words = []) {
  const random = randomFrom(seed);
  const files = pageFiles(root, words).map((file) => {
    const text = readFileSync(path.join(root, file), 'utf8');
    return { file, text, lines: text.split('\n').length };
  });
  const total = files.reduce((sum, { lines }) => sum + lines, 0);
  const seen = new Set();
  const drawn = [];
  for (let tries = 0; drawn.length < count && tries < 400 * count; tries++) {
    let rest = random() * total;
    const one = files.find(({ lines }) => (rest -= lines) < 0) ?? files.at(-1);
    const { file, text } = one;
    const names = Object.keys(kinds);
    const kind = names[Math.floor(random() * names.length)];
    const sites = sitesOf((one.code ??= codeOfScript(text)), kind);
    const site = sites[Math.floor(random() * sites.length)];
    if (!site || seen.has(`${file}:${site.at}`)) continue;
    seen.add(`${file}:${site.at}`);
    const line = text.slice(0, site.at).split('\n').length;
    const was = text.split('\n')[line - 1].trim();
    const changed = text.slice(0, site.at) + site.put + text.slice(site.at + site.find.length);
    const is = changed.split('\n')[line - 1].trim();
    drawn.push({ file, line, kind, text: changed, name: `${file}:${line} ${kind}: ${was}  →  ${is}` }); // prettier-ignore
  }
  return drawn;
}
