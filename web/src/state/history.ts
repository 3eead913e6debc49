// Undo and redo over values that never change. Edits of one kind within half a second are one step.

const mergeTime = 500; // milliseconds

interface Step<T> {
  value: T;
  kind: string;
  time: number;
}

export class History<T> {
  #steps: Step<T>[];
  #at = 0;

  constructor(value: T) {
    this.#steps = [{ value, kind: '', time: -Infinity }];
  }

  get value(): T {
    return this.#steps[this.#at].value;
  }
  get canUndo(): boolean {
    return this.#at > 0;
  }
  get canRedo(): boolean {
    return this.#at < this.#steps.length - 1;
  }
  /** What undo would take back. */
  get undoKind(): string {
    return this.#steps[this.#at].kind.split(':')[0];
  }
  get redoKind(): string {
    return this.#steps[this.#at + 1]?.kind.split(':')[0] ?? '';
  }

  /** `kind` is "verb: field"; the same kind soon after merges into one step, a drag always. */
  push(value: T, kind: string, now = performance.now()): void {
    const top = this.#steps[this.#at];
    const isSoon = now - top.time < mergeTime || kind.startsWith('move cone: ');
    const isMerged = this.#at > 0 && top.kind === kind && isSoon;
    this.#steps.length = this.#at + 1;
    if (isMerged) this.#steps[this.#at] = { value, kind, time: now };
    else {
      this.#steps.push({ value, kind, time: now });
      this.#at += 1;
    }
  }

  undo(): void {
    if (this.canUndo) this.#at -= 1;
  }
  redo(): void {
    if (this.canRedo) this.#at += 1;
  }
}
