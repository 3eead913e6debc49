// A toolbar or list of tabs is a single Tab stop; arrow keys move inside it, Home and End to its ends.

import { hasModifier } from '../model/modifiers';

const steps: Record<string, number> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

function itemsOf(group: HTMLElement): HTMLElement[] {
  const all = group.querySelectorAll<HTMLElement>('button, select, input');
  return [...all].filter((one) => one.offsetParent !== null && !one.matches(':disabled'));
}

/** Whether an element uses the arrow keys itself. */
const usesArrows = (target: HTMLElement): boolean => target.matches('select, input[type="range"]');

export function roveFocus(event: KeyboardEvent): void {
  const group = event.currentTarget as HTMLElement;
  const target = event.target as HTMLElement;
  const isEnd = event.key === 'Home' || event.key === 'End';
  const step = steps[event.key];
  if ((!step && !isEnd) || usesArrows(target) || hasModifier(event)) return;
  const items = itemsOf(group);
  const at = items.indexOf(target);
  if (at < 0) return;
  event.preventDefault();
  const to = isEnd ? (event.key === 'Home' ? 0 : items.length - 1) : at + step;
  focusItem(items, (to + items.length) % items.length);
}

/** Makes the focused element the one to which Tab returns. */
export function keepRoving(event: FocusEvent): void {
  const items = itemsOf(event.currentTarget as HTMLElement);
  const at = items.indexOf(event.target as HTMLElement);
  // Lists and sliders remain separate Tab stops, because they use the arrow keys themselves.
  if (at >= 0) items.forEach((one, i) => (one.tabIndex = i === at || usesArrows(one) ? 0 : -1));
}

function focusItem(items: HTMLElement[], at: number): void {
  items[at].focus();
  if (items[at].getAttribute('role') === 'tab') items[at].click();
}
