// The files that were opened last, in this browser only: they never leave it, and one click forgets them.

import type { Recent } from '../model/recent';
import { answer, openStore, type Store } from './storage';

const maxFiles = 6;
const maxBytes = 48 * 2 ** 20;
const place: Store = { database: 'hgp-recent', name: 'files', keyPath: 'id' };

const isRecent = (value: unknown): value is Recent => {
  const { id, main, time, files } = (value ?? {}) as Partial<Recent>;
  return (
    typeof id === 'string' &&
    typeof main === 'string' &&
    typeof time === 'number' &&
    Array.isArray(files) &&
    files.every((one) => Array.isArray(one) && one[1] instanceof Blob)
  );
};

/** The newest first; none where storage is not allowed. */
export async function recentFiles(): Promise<Recent[]> {
  try {
    const all: unknown[] = await answer((await openStore(place, 'readonly')).getAll());
    return all.filter(isRecent).sort((a, b) => b.time - a.time);
  } catch {
    return [];
  }
}

/** Stores files, unless they are large; the oldest give way. */
export async function keepRecent(
  id: string,
  main: string,
  files: ReadonlyMap<string, Blob | Uint8Array>,
): Promise<void> {
  const blobs = [...files].map(([name, content]): [string, Blob] => [
    name,
    content instanceof Blob ? content : new Blob([content as BlobPart]),
  ]);
  if (blobs.reduce((sum, [, blob]) => sum + blob.size, 0) > maxBytes) return;
  try {
    const store = await openStore(place, 'readwrite');
    store.put({ id, main, time: Date.now(), files: blobs } satisfies Recent);
    const all: unknown[] = await answer(store.getAll());
    const old = all.filter(isRecent).sort((a, b) => b.time - a.time);
    for (const one of old.slice(maxFiles)) store.delete(one.id);
  } catch {
    // The page works without storage.
  }
}

export async function forgetRecent(): Promise<void> {
  try {
    (await openStore(place, 'readwrite')).clear();
  } catch {
    // There is nothing to forget.
  }
}
