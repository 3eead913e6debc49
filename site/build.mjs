// Builds the site into build/site: the page, the documentation, a gallery and, unless --without-references, the API
// references. scripts/site makes first what this needs.
//   node site/build.mjs [--without-references] [--out FOLDER] [--repository ADDRESS]

import * as esbuild from 'esbuild';
import {
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { serviceWorker } from '../web/offline.mjs';
import { brokenLinks } from './check.mjs';
import { parts, relative, render } from './markdown.mjs';
import { galleryModels } from './models.mjs';
import { markdownPages } from './pages.mjs';
import { frame } from './template.mjs';

const root = path.resolve(import.meta.dirname, '..');
const { values: asked } = parseArgs({
  options: {
    'without-references': { type: 'boolean', default: false },
    out: { type: 'string', default: path.join(root, 'build/site') },
    repository: { type: 'string', default: '' },
  },
});
const out = path.resolve(asked.out);
const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** Files of the sources that pages link to and the site copies: source → file of the site. */
const copied = new Map();

function copyOf(source) {
  const isPicture = /\.(png|svg|jpg)$/.test(source);
  const isSchema = source.startsWith('docs/schema/') && source.endsWith('.json');
  if (!isPicture && !isSchema) return undefined;
  const to = `${isPicture ? 'images' : 'schema'}/${path.basename(source)}`;
  copied.set(source, to);
  return to;
}

/** How a link of a Markdown file is written on its page. */
const resolver = (source, file) => (href) => {
  if (/^(https?:|mailto:|#)/.test(href)) return href;
  const [place, id] = href.split('#');
  const target = path.posix.normalize(path.posix.join(path.posix.dirname(source), place));
  const page = markdownPages.find((one) => one.source === target);
  const to = page?.file ?? copyOf(target);
  if (to) return relative(file, to) + (id ? `#${id}` : '');
  if (!existsSync(path.join(root, target))) throw new Error(`${source}: ${href} leads nowhere`);
  return asked.repository ? `${asked.repository}/blob/main/${target}` : undefined;
};

const documentation = () =>
  markdownPages.map(({ source, file, title }) => {
    const markdown = readFileSync(path.join(root, source), 'utf8');
    return { file, title, ...pick(render(markdown, resolver(source, file))) };
  });
const pick = ({ html, headings }) => ({ html, headings });

const patterns = ['checker', 'grid', 'plaid', 'brick', 'wood', 'hex', 'cross', 'circles'];
/** Those that fit a map whose seams turn by multiples of 360°/q. */
const fitting = (q) =>
  ({ 2: patterns, 4: ['checker', 'grid', 'cross', 'plaid', 'circles'] })[q] ?? ['hex', 'circles'];

const dataOf = ({ id, q, scale, isAligned, pattern }) =>
  escaped(JSON.stringify({ file: `gallery/${id}.bin`, q, scale, isAligned, pattern }));

function figure(model) {
  const choices = [...new Set([model.pattern, ...fitting(model.q)])];
  return `<figure data-model="${dataOf(model)}" id="${model.id}">
<canvas class="model" tabindex="0" role="img" aria-label="${escaped(model.title)}: arrow keys turn it"></canvas>
<canvas class="map" role="img" aria-label="${escaped(model.title)}: the map"></canvas>
<h2>${escaped(model.title)}</h2><p>${escaped(model.look)}</p><p><small>${escaped(model.facts)}</small></p>
<label>Pattern <select>${choices.map((name) => `<option>${name}</option>`).join('')}</select></label>
</figure>`;
}

async function ownPages() {
  const models = await galleryModels();
  mkdirSync(path.join(out, 'gallery'), { recursive: true });
  for (const { id, bytes } of models) writeFileSync(path.join(out, `gallery/${id}.bin`), bytes);
  const start = readFileSync(path.join(root, 'site/start.html'), 'utf8');
  const gallery = `<h1>Gallery</h1>
<p>Every model was mapped while this site was built, and every map is certified. Drag a model to turn it, or use the arrow keys.
Below each is its map: what is drawn there once is what you see on the surface.</p>
<div class="cards">${models.map(figure).join('\n')}</div>`;
  const scripts = ['gallery.js'];
  return [
    {
      file: 'index.html',
      title: 'hgp',
      kind: 'start',
      scripts,
      html: start.replace('{{hero}}', dataOf(models[0])),
    },
    { file: 'gallery.html', title: 'Gallery', kind: 'gallery', scripts, html: gallery },
  ];
}

/** The list of all parts of all pages; of references, what a name is, without the prose below it. */
function searchIndex(pages) {
  const list = pages.flatMap(({ file, title, html, headings = [] }) => {
    if (file.startsWith('api/'))
      return [
        { file, title, heading: '', id: '', text: parts(html)[0]?.text.slice(0, 200) ?? '' },
        ...headings.slice(1).map(({ id, text }) => ({ file, title, heading: text, id, text: '' })),
      ];
    return parts(html).map(({ id, heading, text }) => ({ file, title, heading, id, text }));
  });
  const script = readFileSync(path.join(root, 'site/src/search.js'), 'utf8');
  return `${script}\nglobalThis.hgpSearch.parts = ${JSON.stringify(list)};\n`;
}

const write = (name, content) => {
  mkdirSync(path.dirname(path.join(out, name)), { recursive: true });
  writeFileSync(path.join(out, name), content);
};

function allFiles(folder) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => statSync(path.join(folder, name)).isFile())
    .sort();
}

async function main() {
  const page = path.join(root, 'build/page');
  if (!existsSync(page)) throw new Error('build/page is not there: scripts/site builds it');
  rmSync(out, { recursive: true, force: true });
  cpSync(page, path.join(out, 'app'), { recursive: true });
  const pages = [...(await ownPages()), ...documentation()];
  if (!asked['without-references'])
    pages.push(...(await import('./references.mjs')).referencePages());
  const has = new Set([...pages.map(({ file }) => file), 'app/index.html']);
  for (const one of pages)
    write(
      one.file,
      frame(one, (file) => has.has(file)),
    );
  for (const [source, file] of copied) write(file, readFileSync(path.join(root, source)));
  const tokens = readFileSync(path.join(root, 'web/src/styles/tokens.css'), 'utf8');
  write('site.css', tokens + readFileSync(path.join(root, 'site/src/site.css'), 'utf8'));
  write('site.js', readFileSync(path.join(root, 'site/src/site.js')));
  write('search-index.js', searchIndex(pages));
  write('icon.svg', readFileSync(path.join(root, 'web/public/icon.svg')));
  write('THIRD_PARTY_LICENSES.txt', readFileSync(path.join(root, 'THIRD_PARTY_LICENSES.txt')));
  await esbuild.build({
    entryPoints: [path.join(root, 'site/src/gallery.mjs')],
    outfile: path.join(out, 'gallery.js'),
    ...{ bundle: true, minify: true, format: 'iife', target: 'es2022', logLevel: 'warning' },
  });
  const files = new Map(allFiles(out).map((name) => [name, readFileSync(path.join(out, name))]));
  write('sw.js', serviceWorker(files, 'site-hgp-'));
  const wrong = brokenLinks(out);
  if (wrong.length > 0) throw new Error(`broken links:\n${wrong.join('\n')}`);
  const size = allFiles(out).reduce((sum, name) => sum + statSync(path.join(out, name)).size, 0);
  console.log(
    `${out}: ${pages.length} pages, ${(size / 1e6).toFixed(1)} MB, all links lead somewhere`,
  );
}

await main();
