// A browser's database in memory, as far as the page uses one, and as strict: writing needs a transaction for it, an index
// was made with its store, and a new version waits until all who have the database open have closed it.

export function database(later) {
  const all = new Map();
  const versions = new Map();
  /** Who has which database open. */
  const connections = new Map();
  const ask = (find, ended) => {
    const request = {};
    later(() => {
      try {
        request.result = find();
        request.onsuccess?.();
      } catch (error) {
        request.error = error;
        request.onerror?.();
      }
      ended?.();
    });
    return request;
  };
  const storeOf = ({ entries, keyPath, indices }, mode, ask) => {
    const sorted = (key) => [...entries.values()].sort((a, b) => (a[key] < b[key] ? -1 : 1));
    const write = (act) => {
      if (mode === 'readonly') throw new Error('a transaction for reading');
      return ask(act);
    };
    return {
      put: (value) => write(() => void entries.set(value[keyPath], structuredClone(value))),
      get: (key) => ask(() => entries.get(key)),
      getAll: () => ask(() => sorted(keyPath)),
      count: () => ask(() => entries.size),
      delete: (key) => write(() => void entries.delete(key)),
      clear: () => write(() => entries.clear()),
      createIndex: (name, path) => void indices.set(name, path),
      index(name) {
        if (!indices.has(name)) throw new Error(`no index ${name}`);
        const openKeyCursor = () =>
          ask(() => {
            const [first] = sorted(indices.get(name));
            return first && { primaryKey: first[keyPath] };
          });
        return { openKeyCursor };
      },
    };
  };
  /** A transaction ends when nothing that was asked of it is left. */
  const transactionOf = (stores, name, mode) => {
    const transaction = {};
    let asked = 0;
    const ended = () => later(() => asked === 0 && transaction.oncomplete?.());
    const own = (find) => {
      asked += 1;
      return ask(find, () => ((asked -= 1), ended()));
    };
    transaction.objectStore = (one) => {
      if (one !== name) throw new Error(`${one} is not in the transaction`);
      return storeOf(stores.get(one), mode, own);
    };
    return transaction;
  };
  const handleOf = (name, version) => {
    const stores = all.get(name);
    const open = connections.get(name);
    const handle = {
      version,
      objectStoreNames: { contains: (one) => stores.has(one) },
      createObjectStore(one, { keyPath }) {
        stores.set(one, { keyPath, entries: new Map(), indices: new Map() });
        return storeOf(stores.get(one), 'readwrite', ask);
      },
      transaction: (one, mode) => transactionOf(stores, one, mode),
      close: () => void open.delete(handle),
    };
    open.add(handle);
    return handle;
  };
  return {
    all,
    openCount: () => [...connections.values()].reduce((sum, { size }) => sum + size, 0),
    open(name, version) {
      const request = {};
      const begin = () => {
        if (!all.has(name)) {
          all.set(name, new Map());
          connections.set(name, new Set());
        }
        const before = versions.get(name) ?? 0;
        const wanted = version ?? Math.max(1, before);
        if (wanted < before) {
          request.error = new Error('an older version');
          return request.onerror?.();
        }
        if (wanted > before && connections.get(name).size > 0) {
          for (const one of connections.get(name)) one.onversionchange?.();
          return later(begin);
        }
        versions.set(name, wanted);
        request.result = handleOf(name, wanted);
        if (wanted > before) request.onupgradeneeded?.();
        request.onsuccess?.();
      };
      later(begin);
      return request;
    },
  };
}
