// Stores the last cones of every file, by the file's hash, in this browser; never the mesh.

import type { Prescription } from '../model/prescription';

const format = 2;

interface SavedCones {
  sha256: string;
  time: number;
  /** Version of the record's format; records of other versions are ignored. */
  version: typeof format;
  prescription: Prescription;
}

const most = 200;

const isCount = (x: unknown): boolean => Number.isSafeInteger(x) && (x as number) >= 0;
const isIndex = (x: unknown): boolean => x === null || Number.isSafeInteger(x);

/** Checks a stored record, which another version of the page, or someone by hand, may have changed. */
function isSavedCones(value: unknown): value is SavedCones {
  const { version, prescription, time } = (value ?? {}) as Partial<SavedCones>;
  if (version !== format || typeof time !== 'number' || !prescription) return false;
  const { q, cones, turnings, handles } = prescription;
  return (
    isCount(q) &&
    q >= 1 &&
    [cones, turnings, handles].every(Array.isArray) &&
    cones.every((cone) => isCount(cone?.vertex) && Number.isSafeInteger(cone.k)) &&
    [...turnings, ...handles].every(isIndex)
  );
}

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

/** The stored cones of a file, if any; undefined as well if storage is not allowed. */
export async function restorable(sha256: string): Promise<SavedCones | undefined> {
  try {
    const found: unknown = await answer((await openStore('readonly')).get(sha256));
    return isSavedCones(found) ? found : undefined;
  } catch {
    return undefined;
  }
}

export async function saveCones(sha256: string, prescription: Prescription): Promise<void> {
  try {
    const store = await openStore('readwrite');
    store.put({ sha256, time: Date.now(), version: format, prescription } satisfies SavedCones);
    const count = await answer(store.count());
    if (count <= most) return;
    const oldest = store.index('time').openKeyCursor();
    oldest.onsuccess = () => {
      if (oldest.result) store.delete(oldest.result.primaryKey);
    };
  } catch {
    // The page works without storage.
  }
}
