// Stores of the browser's database, which may be forbidden, slow, or made by another version of the page.

export interface Store {
  database: string;
  name: string;
  keyPath: string;
  /** Further keys by which entries are found. */
  indices?: readonly string[];
}

/** A connection to the database: as it is, or in its next version, where the store is added. */
function connect({ database, name, keyPath, indices = [] }: Store, version?: number) {
  return new Promise<IDBDatabase>((resolve, reject) => {
    const opening = indexedDB.open(database, version);
    opening.onupgradeneeded = () => {
      if (opening.result.objectStoreNames.contains(name)) return;
      const store = opening.result.createObjectStore(name, { keyPath });
      for (const key of indices) store.createIndex(key, key);
    };
    opening.onerror = () => reject(opening.error ?? new Error('no storage'));
    opening.onsuccess = () => {
      opening.result.onversionchange = () => opening.result.close();
      resolve(opening.result);
    };
  });
}

/** Rejects where there is no storage; a database without the store gets it. */
export async function openStore(store: Store, mode: IDBTransactionMode): Promise<IDBObjectStore> {
  let database = await connect(store);
  if (!database.objectStoreNames.contains(store.name)) {
    database.close();
    // Who opened it at the same time asks for the same version, and nothing that was stored is lost.
    database = await connect(store, database.version + 1);
  }
  const transaction = database.transaction(store.name, mode);
  transaction.oncomplete = transaction.onabort = () => database.close();
  return transaction.objectStore(store.name);
}

export const answer = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('storage failed'));
  });
