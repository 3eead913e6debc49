// A store: an object whose members are signals. Reading a member inside `effect` or `computed`
// subscribes to it; assigning to it notifies the subscribers.

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

/** The base class of a store with these members, all of which must be present from the start, even if undefined. */
export const storeOf = <T extends object>(): new (initial: T) => T =>
  Cells as unknown as new (initial: T) => T;
