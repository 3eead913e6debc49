// Runs the gltf_probe of the build under test: natively, or as WebAssembly under Node.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const probe = process.env.HGP_GLTF_PROBE ?? path.join(root, 'build/native-release/bin/gltf_probe');
export const isWasm = probe.endsWith('.js');
export const scratch = path.join(process.env.HGP_BUILD ?? path.join(root, 'build'), 'gltf-files');
mkdirSync(scratch, { recursive: true });
export const meshes = process.env.HGP_SHARED_MESHES ?? path.join(root, '../shared/meshes');
export const hasMeshes = existsSync(path.join(meshes, 'gltf'));

/** One object per file. A crash or a hang is a failure of its own: { crashed: … }. */
export function runProbe(args, { seconds = 120 } = {}) {
  const command = isWasm
    ? [process.execPath, ['--no-experimental-fetch', probe, ...args]]
    : [probe, args];
  const ended = spawnSync(...command, {
    encoding: 'utf8',
    timeout: seconds * 1000,
    maxBuffer: 1 << 28,
    env: {
      ...process.env,
      ASAN_OPTIONS: 'max_allocation_size_mb=4096:allocator_may_return_null=0',
    },
  });
  const lines = ended.stdout
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
  if (ended.status !== 0) {
    lines.push({ crashed: `${ended.signal ?? ended.status} ${ended.stderr.slice(0, 3000)}` });
  }
  return lines;
}
