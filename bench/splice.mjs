// node bench/splice.mjs FILE.md HEADING < TEXT: the text becomes what stands under that heading. Role: bench/all.
import { readFileSync, writeFileSync } from 'node:fs';

const [file, heading] = process.argv.slice(2);
const lines = readFileSync(file, 'utf8').split('\n');
const start = lines.indexOf(heading);
if (start < 0) throw new Error(`${file} has no line '${heading}'`);
const level = heading.match(/^#+/)[0].length;
const isNext = (line) => /^#+ /.test(line) && line.match(/^#+/)[0].length <= level;
const after = lines.findIndex((line, i) => i > start && isNext(line));
const end = after < 0 ? lines.length : after;
const text = readFileSync(0, 'utf8').trim();
if (text === '') throw new Error('no text');
const rest = lines.slice(end);
const all = [...lines.slice(0, start + 1), '', ...text.split('\n'), '', ...rest];
writeFileSync(file, all.join('\n').trimEnd() + '\n');
