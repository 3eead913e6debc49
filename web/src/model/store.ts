// A store: an object whose members are signals. Reading a member inside `effect` or `computed`
// subscribes to it; assigning tells whoever has read it.

import { signal } from '@preact/signals-core';

class Cells {
  constructor(initial: object) {
    for (const [key, value] of Object.entries(initial)) {
      const cell = signal<unknown>(value);
      Object.defineProperty(this, key, {
        enumerable: true,
        get: () => cell.value,
        set: (next) => {
          cell.value = next;
        },
      });
    }
  }
}

/** The base of a store with these members; all must be there from the beginning, undefined ones, too. */
export const storeOf = <T extends object>(): new (initial: T) => T =>
  Cells as unknown as new (initial: T) => T;
