// Members of the global object that a test replaces.

const replacedIn = new WeakMap();
/** Replaces a member of the global object until the test ends. */
export function replace(t, name, value) {
  const names = replacedIn.get(t) ?? new Set();
  replacedIn.set(t, names);
  const own = Object.getOwnPropertyDescriptor(globalThis, name);
  Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  // What stands there at a second time is not what was there before the test.
  if (names.has(name)) return;
  names.add(name);
  t.after(() => (own ? Object.defineProperty(globalThis, name, own) : delete globalThis[name]));
}
