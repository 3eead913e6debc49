// Files that belong to a written one.

import { bytesOf, relativeName } from '../formats/glb';
import type { Model, OutputFile } from '../model/types';
import type { App } from './app';

/** The files to which a written .gltf refers without including them: existing buffers and images. */
export async function sideFiles(
  app: App,
  { files }: Model,
  written: OutputFile[],
): Promise<OutputFile[]> {
  const [main] = written;
  if (!/\.gltf$/i.test(main.name)) return [];
  const answer = await app.geometry.call('urisOf', [main]);
  const found = new Map<string, Uint8Array>();
  for (const uri of answer.uris) {
    const name = relativeName(uri);
    const file = name === undefined ? undefined : files.get(name);
    if (!name || !file || written.some((one) => one.name === name)) continue;
    // A copy, because it is transferred to the worker that reads it back.
    found.set(name, (await bytesOf(file)).slice());
  }
  return [...found].map(([name, bytes]) => ({ name, bytes }));
}
