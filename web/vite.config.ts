import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { examples } from './examples.mjs';
import { firstScreen } from './first_screen.mjs';
import { guidePage } from './guide.mjs';
import { heroModel } from './hero.mjs';
import { licences } from './licences.mjs';
import { serviceWorker } from './offline.mjs';
import { hashed, headers, isolation } from './serve.mjs';

const built = path.resolve(import.meta.dirname, '../build/package');

/** The example models as files beside the page, and what the page says about them as a module. */
function exampleModels(): Plugin {
  const id = 'virtual:examples';
  const made = examples();
  return {
    name: 'hgp-examples',
    resolveId: (source) => (source === id ? `\0${id}` : undefined),
    transformIndexHtml: (page) =>
      page.replace('<div id="page"></div>', () => `<div id="page">${firstScreen(made)}</div>`),
    load(source) {
      if (source !== `\0${id}`) return undefined;
      const about = made.map(({ bytes: _, ...rest }) => rest);
      return `export const examples = ${JSON.stringify(about)};`;
    },
    async generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'hero.bin', source: await heroModel() });
      for (const { file, bytes } of made) {
        this.emitFile({ type: 'asset', fileName: `examples/${file}`, source: bytes });
      }
    },
  };
}

/** docs/guide.md as a page beside this one, in the same style. */
function guide(): Plugin {
  const docs = path.resolve(import.meta.dirname, '../docs');
  return {
    name: 'hgp-guide',
    generateBundle(_, bundle) {
      const stylesheet = Object.keys(bundle).find((name) => name.endsWith('.css')) ?? '';
      const markdown = readFileSync(path.join(docs, 'guide.md'), 'utf8');
      const source = guidePage(markdown, stylesheet);
      this.emitFile({ type: 'asset', fileName: 'guide.html', source });
      const images = path.join(docs, 'images');
      for (const name of existsSync(images) ? readdirSync(images) : []) {
        if (!name.startsWith('guide-')) continue;
        const bytes = readFileSync(path.join(images, name));
        this.emitFile({ type: 'asset', fileName: `images/${name}`, source: bytes });
      }
    },
  };
}

/** The service worker with the names of all files, and the headers for hosts that read `_headers`. */
function offline(): Plugin {
  return {
    name: 'hgp-offline',
    enforce: 'post',
    generateBundle(_, bundle) {
      const files = new Map<string, string | Uint8Array>();
      for (const [name, part] of Object.entries(bundle)) {
        if (name.startsWith('images/')) continue; // pictures of the guide
        files.set(name, part.type === 'chunk' ? part.code : part.source);
      }
      const thumbnails = readdirSync(path.join(import.meta.dirname, 'public/thumbnails'));
      const fixed = ['icon.svg', 'hgp.webmanifest'];
      for (const name of [...fixed, ...thumbnails.map((one) => `thumbnails/${one}`)]) {
        files.set(name, readFileSync(path.join(import.meta.dirname, 'public', name)));
      }
      this.emitFile({ type: 'asset', fileName: 'sw.js', source: serviceWorker(files) });
      // Not the rule on caching: some hosts would join it with that of the names that never change.
      const { 'Cache-Control': again, ...always } = { ...headers, ...isolation };
      const rule = (place: string, values: Record<string, string>): string =>
        [place, ...Object.entries(values).map(([name, value]) => `  ${name}: ${value}`), ''].join(
          '\n',
        );
      const source = [
        rule('/*', always),
        ...['/', '/index.html', '/sw.js'].map((place) => rule(place, { 'Cache-Control': again })),
        rule(`/${hashed.folder}/*`, { 'Cache-Control': hashed.cacheControl }),
      ].join('');
      this.emitFile({ type: 'asset', fileName: '_headers', source });
    },
  };
}

export default defineConfig({
  root: import.meta.dirname,
  base: './', // any path on any static host
  plugins: [exampleModels(), guide(), licences({ isPage: true }), offline()],
  resolve: {
    alias: [
      { find: /^hgp$/, replacement: path.join(built, 'index.js') },
      { find: /^hgp\/(?=worker|gzip)/, replacement: `${built}/` },
    ],
  },
  build: {
    outDir: path.resolve(import.meta.dirname, '../build/page'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
  },
  worker: { format: 'es', plugins: () => [licences({ isPage: false })] },
});
