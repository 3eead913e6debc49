// Undo and redo of immutable values; the history itself is immutable as well. Edits of one kind
// within half a second are one step.

const mergeTime = 500; // milliseconds

interface Entry<T> {
  readonly value: T;
  readonly kind: string;
  readonly time: number;
}

const verb = (entry: { kind: string } | undefined): string => entry?.kind.split(':')[0] ?? '';

export class History<T> {
  readonly #entries: readonly Entry<T>[];
  readonly #at: number;

  private constructor(entries: readonly Entry<T>[], at: number) {
    this.#entries = entries;
    this.#at = at;
  }

  static of<T>(value: T): History<T> {
    return new History([{ value, kind: '', time: -Infinity }], 0);
  }

  get value(): T {
    return this.#entries[this.#at].value;
  }
  get canUndo(): boolean {
    return this.#at > 0;
  }
  get canRedo(): boolean {
    return this.#at < this.#entries.length - 1;
  }
  /** The kind of the edit that undo would revert. */
  get undoKind(): string {
    return verb(this.#entries[this.#at]);
  }
  get redoKind(): string {
    return verb(this.#entries[this.#at + 1]);
  }

  /** `kind` is "verb: field"; edits of the same kind in quick succession, and all moves of a drag, are one step. */
  push(value: T, kind: string, now = performance.now()): History<T> {
    const top = this.#entries[this.#at];
    const isSoon = now - top.time < mergeTime || kind.startsWith('move cone: ');
    const isMerged = this.#at > 0 && top.kind === kind && isSoon;
    const kept = this.#entries.slice(0, isMerged ? this.#at : this.#at + 1);
    return new History([...kept, { value, kind, time: now }], kept.length);
  }

  undo(): History<T> {
    return this.canUndo ? new History(this.#entries, this.#at - 1) : this;
  }
  redo(): History<T> {
    return this.canRedo ? new History(this.#entries, this.#at + 1) : this;
  }
}
