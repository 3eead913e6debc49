// Keeps the last cones of every file, by its hash, in this browser. Never the mesh.

import type { Prescription } from './prescription';

interface Saved {
  sha256: string;
  time: number;
  asked: Prescription;
}

const most = 200;

function openStore(mode: IDBTransactionMode): Promise<IDBObjectStore> {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('hgp', 1);
    opening.onupgradeneeded = () =>
      opening.result.createObjectStore('cones', { keyPath: 'sha256' }).createIndex('time', 'time');
    opening.onerror = () => reject(opening.error ?? new Error('no storage'));
    opening.onsuccess = () => {
      const transaction = opening.result.transaction('cones', mode);
      transaction.oncomplete = () => opening.result.close();
      resolve(transaction.objectStore('cones'));
    };
  });
}

const answer = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('storage failed'));
  });

/** Storage may be forbidden: then there is nothing to restore, and that is all. */
export async function restorable(sha256: string): Promise<Saved | undefined> {
  try {
    return (await answer((await openStore('readonly')).get(sha256))) as Saved | undefined;
  } catch {
    return undefined;
  }
}

export async function save(sha256: string, asked: Prescription): Promise<void> {
  try {
    const store = await openStore('readwrite');
    store.put({ sha256, time: Date.now(), asked } satisfies Saved);
    const count = await answer(store.count());
    if (count <= most) return;
    const oldest = store.index('time').openKeyCursor();
    oldest.onsuccess = () => {
      if (oldest.result) store.delete(oldest.result.primaryKey);
    };
  } catch {
    // Nothing to do: the page works without storage.
  }
}
