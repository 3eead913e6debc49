// The value of a field that the user may be typing into: updates of the page must not replace an
// unfinished number. The typed text stays until it is committed or the field loses the focus.

import { noChange } from 'lit';
import { directive, Directive, type ElementPart, type PropertyPart } from 'lit/directive.js';
import { setCommittedValue } from 'lit/directive-helpers.js';

const beingTyped = new WeakSet<EventTarget>();
const begin = ({ target }: Event): void => void (target && beingTyped.add(target));
const end = ({ target }: Event): void => void (target && beingTyped.delete(target));
// In the capture phase, before any handler of the field itself.
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
    setCommittedValue(part); // it may be equal to the value set last
    return value;
  }
}

/** For `.value` of text and number fields. */
export const keepWhileTyping = directive(Typed);
