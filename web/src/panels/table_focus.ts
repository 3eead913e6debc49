// A table of controls is a single Tab stop: arrow keys move between its controls, Home and End to the ends of a row.

import { hasModifier } from '../model/modifiers';

const controls = 'button, input';

const itemsOf = (row: Element): HTMLElement[] => [...row.querySelectorAll<HTMLElement>(controls)];

const isStop = (item: HTMLElement): boolean => item.dataset.stop !== undefined;

/** Leaves one control in the Tab order: the one that had the focus last, or else the first one. */
export function keepOneStop(table: HTMLElement | null): void {
  if (!table) return;
  const items = itemsOf(table);
  const stop = items.find(isStop) ?? table.querySelector<HTMLElement>(`tbody :is(${controls})`);
  for (const item of items) item.tabIndex = item === stop ? 0 : -1;
}

/** Makes the focused control the one to which Tab returns. */
export function stopAt(event: FocusEvent): void {
  const table = event.currentTarget as HTMLElement;
  for (const item of itemsOf(table)) {
    if (item === event.target) item.dataset.stop = '';
    else delete item.dataset.stop;
  }
  keepOneStop(table);
}

const across: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1 };
const along: Record<string, number> = { ArrowUp: -1, ArrowDown: 1 };

/** The control to which a key leads; undefined if the key is not for the table. */
function target(event: KeyboardEvent, table: HTMLElement): HTMLElement | undefined {
  const from = event.target as HTMLElement;
  const row = from.closest('tr');
  if (!row) return undefined;
  const items = itemsOf(row);
  const at = items.indexOf(from);
  if (event.key === 'Home') return items[0];
  if (event.key === 'End') return items.at(-1);
  if (event.key in across) return items[at + across[event.key]];
  // A number changes by these keys.
  if (!(event.key in along) || from.matches('input')) return undefined;
  const rows = [...table.querySelectorAll('tr')].filter((one) => itemsOf(one).length > 0);
  const next = rows[rows.indexOf(row) + along[event.key]];
  if (!next) return undefined;
  const there = itemsOf(next);
  return there[Math.min(at, there.length - 1)];
}

export function moveInTable(event: KeyboardEvent): void {
  if (hasModifier(event)) return;
  const to = target(event, event.currentTarget as HTMLElement);
  if (!to) return;
  event.preventDefault();
  to.focus();
}
