// Where the values of a JSON text are, so that one can be changed and every other byte stays: numbers
// keep their spelling, unknown members their place.

export interface JsonSpan {
  start: number;
  end: number;
  members?: Map<string, JsonSpan>;
  items?: JsonSpan[];
}

const space = /[ \t\r\n]*/y;
const scalar = /[^\s,\]}]+/y;
const quoted = /"(?:[^"\\]|\\.)*"/y;

/** @pre `text` is JSON that has been read before, not nested deeper than a call stack. */
export function spansIn(text: string): JsonSpan {
  let at = 0;
  const skip = (): void => {
    space.lastIndex = at;
    space.test(text);
    at = space.lastIndex;
  };
  const pass = (pattern: RegExp): string => {
    pattern.lastIndex = at;
    const found = pattern.exec(text)?.[0] ?? '';
    at += found.length;
    return found;
  };
  const value = (): JsonSpan => {
    skip();
    const start = at;
    if (text[at] === '{') {
      const members = new Map<string, JsonSpan>();
      for (at += 1, skip(); text[at] !== '}'; skip()) {
        if (text[at] === ',') at += 1;
        skip();
        const key = JSON.parse(pass(quoted)) as string;
        skip();
        at += 1; // the colon
        members.set(key, value());
      }
      at += 1;
      return { start, end: at, members };
    }
    if (text[at] === '[') {
      const items: JsonSpan[] = [];
      for (at += 1, skip(); text[at] !== ']'; skip()) {
        if (text[at] === ',') at += 1;
        items.push(value());
      }
      at += 1;
      return { start, end: at, items };
    }
    pass(text[at] === '"' ? quoted : scalar);
    return { start, end: at };
  };
  return value();
}

/** Changes to one text, made together. */
export class JsonEditor {
  readonly root: JsonSpan;
  readonly #text: string;
  readonly #edits: { start: number; end: number; text: string }[] = [];
  /** Items and members that were put at the end of a place before. */
  readonly #added = new Map<number, number>();

  constructor(text: string) {
    this.#text = text;
    this.root = spansIn(text);
  }

  replace({ start, end }: JsonSpan, value: unknown): void {
    this.#edits.push({ start, end, text: JSON.stringify(value) });
  }

  #put(into: JsonSpan, count: number, text: string): void {
    const before = count + (this.#added.get(into.end) ?? 0);
    this.#added.set(into.end, (this.#added.get(into.end) ?? 0) + 1);
    const at = into.end - 1;
    this.#edits.push({ start: at, end: at, text: `${before > 0 ? ',' : ''}${text}` });
  }

  /** Sets a member of an object, new or old. */
  set(object: JsonSpan, key: string, value: unknown): void {
    const old = object.members!.get(key);
    if (old) this.replace(old, value);
    else {
      const text = `${JSON.stringify(key)}:${JSON.stringify(value)}`;
      this.#put(object, object.members!.size, text);
    }
  }

  /** Adds to a list of the root, which may not be there yet; returns the index. Once for each list. */
  add(list: string, item: unknown): number {
    const place = this.root.members!.get(list);
    if (!place) {
      this.set(this.root, list, [item]);
      return 0;
    }
    this.#put(place, place.items!.length, JSON.stringify(item));
    return place.items!.length;
  }

  get result(): string {
    let out = this.#text;
    // From the back; of two at one place, the later one first.
    const order = this.#edits.map((edit, i) => ({ edit, i }));
    order.sort((a, b) => b.edit.start - a.edit.start || b.i - a.i);
    for (const { edit } of order) out = out.slice(0, edit.start) + edit.text + out.slice(edit.end);
    return out;
  }
}
