import path from 'node:path';
import { defineConfig } from 'vite';

const built = path.resolve(import.meta.dirname, '../build/package');

export default defineConfig({
  root: import.meta.dirname,
  base: './', // any path on any static host
  resolve: {
    alias: [
      { find: /^hgp$/, replacement: path.join(built, 'index.js') },
      { find: /^hgp\/(?=worker)/, replacement: `${built}/` },
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
  worker: { format: 'es' },
});
