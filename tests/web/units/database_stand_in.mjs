// A browser's database in memory, as far as the page uses one.

export function database(later) {
  const all = new Map();
  const versions = new Map();
  const ask = (find) => {
    const request = {};
    later(() => {
      try {
        request.result = find();
        request.onsuccess?.();
      } catch (error) {
        request.error = error;
        request.onerror?.();
      }
    });
    return request;
  };
  const storeOf = (name) => {
    const { entries, keyPath } = name;
    const sorted = (key) => [...entries.values()].sort((a, b) => (a[key] < b[key] ? -1 : 1));
    return {
      put: (value) => ask(() => void entries.set(value[keyPath], structuredClone(value))),
      get: (key) => ask(() => entries.get(key)),
      getAll: () => ask(() => sorted(keyPath)),
      count: () => ask(() => entries.size),
      delete: (key) => ask(() => void entries.delete(key)),
      clear: () => ask(() => entries.clear()),
      createIndex() {},
      index: (key) => ({
        openKeyCursor: () =>
          ask(() => {
            const [first] = sorted(key);
            return first && { primaryKey: first[keyPath] };
          }),
      }),
    };
  };
  const handleOf = (stores, version) => ({
    version,
    objectStoreNames: { contains: (name) => stores.has(name) },
    createObjectStore(name, { keyPath }) {
      stores.set(name, { keyPath, entries: new Map() });
      return storeOf(stores.get(name));
    },
    transaction: () => ({ objectStore: (name) => storeOf(stores.get(name)) }),
    close() {},
  });
  return {
    all,
    open(name, version = versions.get(name) ?? 1) {
      const request = {};
      later(() => {
        const isNew = !all.has(name) || version > versions.get(name);
        if (!all.has(name)) all.set(name, new Map());
        versions.set(name, version);
        request.result = handleOf(all.get(name), version);
        if (isNew) request.onupgradeneeded?.();
        request.onsuccess?.();
      });
      return request;
    },
  };
}
