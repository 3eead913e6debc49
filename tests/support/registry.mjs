// A local npm registry with the packages installed here, for tests that run `npm install` as documented: versions
// are those of package-lock.json, and no network is used.

import { spawn } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';

/** Every package installed below a node_modules folder, including nested ones: name → version → folder. */
function installedBelow(folder, found = new Map()) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const place = path.join(folder, entry.name);
    if (entry.name.startsWith('.') || !entry.isDirectory()) continue;
    if (entry.name.startsWith('@')) {
      installedBelow(place, found);
      continue;
    }
    if (existsSync(path.join(place, 'package.json'))) {
      const manifest = JSON.parse(readFileSync(path.join(place, 'package.json'), 'utf8'));
      const versions = found.get(manifest.name) ?? new Map();
      found.set(manifest.name, versions.set(manifest.version, { place, manifest }));
    }
    const nested = path.join(place, 'node_modules');
    if (existsSync(nested)) installedBelow(nested, found);
  }
  return found;
}

const newest = (versions) =>
  [...versions].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).at(-1);

/** Resolves to { origin, close }. */
export function startRegistry(nodeModules) {
  const installed = installedBelow(nodeModules);
  const server = createServer((request, response) => {
    const [name, version] = decodeURIComponent(request.url.slice(1)).split('/-/');
    const versions = installed.get(name);
    if (!versions) return response.writeHead(404).end('{}');
    if (version) {
      const { place } = versions.get(version);
      const [folder, base] = [path.dirname(place), path.basename(place)];
      const options = ['--exclude=node_modules', `--transform=s,^${base},package,`];
      response.writeHead(200, { 'Content-Type': 'application/octet-stream' });
      return spawn('tar', ['-c', ...options, '-C', folder, base]).stdout.pipe(response);
    }
    const { origin } = registry;
    const described = [...versions].map(([number, { manifest }]) => [
      number,
      { ...manifest, dist: { tarball: `${origin}/${name}/-/${number}` } },
    ]);
    response.writeHead(200, { 'Content-Type': 'application/json' });
    response.end(
      JSON.stringify({
        name,
        'dist-tags': { latest: newest(versions.keys()) },
        versions: Object.fromEntries(described),
      }),
    );
  });
  const registry = { close: () => server.close() };
  return new Promise((resolve) =>
    server.listen(0, 'localhost', () => {
      registry.origin = `http://localhost:${server.address().port}`;
      resolve(registry);
    }),
  );
}
