// Which npm packages a bundle contains, compared with packaging/components.json, and the licences beside the page.

import { readFileSync } from 'node:fs';
import path from 'node:path';

const root = path.resolve(import.meta.dirname, '..');

/** The names of the npm packages that the ids of modules are from; helpers of the bundler have ids like `\0vite/…`. */
export function packagesOf(ids) {
  const names = new Set();
  for (const id of ids) {
    const found =
      id.match(/^.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//) ?? id.match(/^\0(vite|rolldown)\//);
    if (found) names.add(found[1]);
  }
  return names;
}

/** Packages that are bundled and not listed as part of the page. */
export function unlisted(ids, components) {
  const listed = new Set(
    components
      .filter(({ parts }) => parts.includes('page'))
      .map(({ source }) => source.replace(/^npm:/, '')),
  );
  return [...packagesOf(ids)].filter((name) => !listed.has(name)).sort();
}

/** For Vite: ends the build if a package is not listed. `isPage`: writes the licences, too. */
export function licences({ isPage }) {
  const { components } = JSON.parse(
    readFileSync(path.join(root, 'packaging/components.json'), 'utf8'),
  );
  return {
    name: 'hgp-licences',
    generateBundle(_, bundle) {
      const ids = Object.values(bundle).flatMap((part) => part.moduleIds ?? []);
      const missing = unlisted(ids, components);
      if (missing.length > 0)
        this.error(`${missing.join(', ')}: bundled, but not in packaging/components.json`);
      if (!isPage) return;
      const source = readFileSync(path.join(root, 'THIRD_PARTY_LICENSES.txt'), 'utf8');
      this.emitFile({ type: 'asset', fileName: 'THIRD_PARTY_LICENSES.txt', source });
    },
  };
}
