// What the tests of the package share: the package as it was built, clients that end, scratch space.

import { existsSync, mkdirSync, rmSync } from 'node:fs';
import path from 'node:path';

export const root = path.resolve(import.meta.dirname, '../..');
export const built = path.join(root, 'build/package');
export const native = process.env.HGP_BIN ?? path.join(root, 'build/native-release/bin/hgp');
export const shared = process.env.HGP_SHARED_MESHES ?? path.join(root, '../shared/meshes');
export const hasShared = existsSync(shared);

export const { createClient, HgpError } = await import(path.join(built, 'node/index.js'));
export const { compile, createCore } = await import(path.join(built, 'node/core.js'));

export const bytesOf = (text) => new TextEncoder().encode(text);
export const asFiles = (name, bytes) => ({ main: name, files: new Map([[name, bytes]]) });

/** Runs with a client of its own, which is ended whatever happens. */
export async function withClient(use, options) {
  const client = await createClient(options);
  try {
    return await use(client);
  } finally {
    client.terminate();
  }
}

/** An empty folder below build. */
export function scratch(name) {
  const folder = path.join(root, 'build/package-tests', name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}
