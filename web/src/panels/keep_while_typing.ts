// The value of a field that somebody may be typing into: what happens elsewhere on the page must not
// take the half of a number away. What was typed counts until it is committed or left.

import { noChange } from 'lit';
import { directive, Directive, type ElementPart, type PropertyPart } from 'lit/directive.js';
import { setCommittedValue } from 'lit/directive-helpers.js';

const beingTyped = new WeakSet<EventTarget>();
const begin = ({ target }: Event): void => void (target && beingTyped.add(target));
const end = ({ target }: Event): void => void (target && beingTyped.delete(target));
// While the event comes down: before any handler of the field's own.
document.addEventListener('input', begin, true);
document.addEventListener('change', end, true);
document.addEventListener('focusout', end, true);

class Typed extends Directive {
  override render(value: string): string {
    return value;
  }

  override update(part: PropertyPart | ElementPart, [value]: [string]): unknown {
    const field = part.element as HTMLInputElement;
    if (beingTyped.has(field) || field.value === value) return noChange;
    setCommittedValue(part as PropertyPart); // it may equal what was set last
    return value;
  }
}

/** For `.value` of text and number fields. */
export const keepWhileTyping = directive(Typed);
