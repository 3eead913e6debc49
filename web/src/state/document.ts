// What the page is about: one loaded model and, when there is one, its map.

import type { Client, ModelInfo, Progress, Result } from 'hgp';

export interface Document {
  name: string;
  info: ModelInfo;
  result: Result;
}

/** Loads a file and maps it: a disk onto a convex polygon, anything else with suggested cones. */
export async function openAndRun(
  client: Client,
  file: File,
  call: { signal: AbortSignal; onProgress(p: Progress): void },
): Promise<Document> {
  const info = await client.load(file, {}, call);
  if (info.error) throw new Error(info.error.message);
  const isDisk = info.genus === 0 && info.boundaryLoops === 1 && info.components?.length === 1;
  const result = isDisk
    ? await client.parametrize({ boundary: 'convex' }, call)
    : await client.parametrize({ q: 4 }, call);
  return { name: file.name, info, result };
}
