// Stores the last cones of every file, by the file's hash, in this browser; never the mesh.

import type { Prescription } from '../model/prescription';
import { answer, openStore, type Store } from './storage';

const format = 2;
const cones: Store = { database: 'hgp', name: 'cones', keyPath: 'sha256', indices: ['time'] };

interface SavedCones {
  sha256: string;
  time: number;
  /** Version of the record's format; records of other versions are ignored. */
  version: typeof format;
  prescription: Prescription;
}

const maxStored = 200;

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

/** Identifies one mesh of a file. */
interface Place {
  file: { sha256: string };
  surface: number;
}

const keyOf = ({ file, surface }: Place): string =>
  surface === 0 ? file.sha256 : `${file.sha256}.${surface}`;

/** The stored cones of a mesh, if any; undefined as well if storage is not allowed. */
export async function restorable(mesh: Place): Promise<SavedCones | undefined> {
  try {
    const found: unknown = await answer((await openStore(cones, 'readonly')).get(keyOf(mesh)));
    return isSavedCones(found) ? found : undefined;
  } catch {
    return undefined;
  }
}

export async function saveCones(mesh: Place, prescription: Prescription): Promise<void> {
  try {
    const store = await openStore(cones, 'readwrite');
    const sha256 = keyOf(mesh);
    store.put({ sha256, time: Date.now(), version: format, prescription } satisfies SavedCones);
    const count = await answer(store.count());
    if (count <= maxStored) return;
    const oldest = store.index('time').openKeyCursor();
    oldest.onsuccess = () => {
      if (oldest.result) store.delete(oldest.result.primaryKey);
    };
  } catch {
    // The page works without storage.
  }
}
