// Stores of the browser's database, which may be forbidden, slow, or made by another version of the page.

export interface Store {
  database: string;
  name: string;
  keyPath: string;
  /** Further keys by which entries are found. */
  indices?: readonly string[];
}

/** Rejects where there is no storage; a database without the store is deleted, for the next time. */
export function openStore(
  { database, name, keyPath, indices = [] }: Store,
  mode: IDBTransactionMode,
): Promise<IDBObjectStore> {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(database, 1);
    opening.onupgradeneeded = () => {
      const store = opening.result.createObjectStore(name, { keyPath });
      for (const key of indices) store.createIndex(key, key);
    };
    opening.onerror = () => reject(opening.error ?? new Error('no storage'));
    opening.onsuccess = () => {
      const { result } = opening;
      result.onversionchange = () => result.close();
      if (!result.objectStoreNames.contains(name)) {
        result.close();
        indexedDB.deleteDatabase(database);
        return reject(new Error('no such store'));
      }
      const transaction = result.transaction(name, mode);
      transaction.oncomplete = transaction.onabort = () => result.close();
      resolve(transaction.objectStore(name));
    };
  });
}

export const answer = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('storage failed'));
  });
