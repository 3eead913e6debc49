// On a phone the panels are a bottom sheet, whose height changes by dragging or pressing its
// handle. On larger screens the handle is hidden.

import { html, type TemplateResult } from 'lit';
import type { Sheet, UiState } from '../model/ui_state';

const sizes: Sheet[] = ['peek', 'half', 'full'];
const parts: Record<Sheet, number> = { peek: 0, half: 0.5, full: 1 };
const clickMoves = 6; // pixels: a longer movement is a drag

let drag: { y: number; height: number; isMoved: boolean } | undefined;
let wasDrag = false;

const asideOf = (event: Event): HTMLElement => (event.currentTarget as Element).closest('aside')!;

function press(event: PointerEvent): void {
  const handle = event.currentTarget as HTMLElement;
  handle.setPointerCapture(event.pointerId);
  drag = { y: event.clientY, height: asideOf(event).offsetHeight, isMoved: false };
  wasDrag = false;
}

function move(event: PointerEvent): void {
  if (!drag) return;
  const up = drag.y - event.clientY;
  drag.isMoved ||= Math.abs(up) > clickMoves;
  if (!drag.isMoved) return;
  const max = asideOf(event).parentElement!.clientHeight;
  const height = Math.min(Math.max(drag.height + up, 46), max);
  asideOf(event).style.setProperty('--sheet-drag', `${height}px`);
}

/** Snaps to the nearest of the three heights. */
function release(ui: UiState, event: PointerEvent): void {
  const aside = asideOf(event);
  if (drag?.isMoved) {
    const part = aside.offsetHeight / aside.parentElement!.clientHeight;
    const far = (size: Sheet): number => Math.abs(parts[size] - part);
    ui.sheet = sizes.toSorted((a, b) => far(a) - far(b))[0];
    wasDrag = true;
  }
  aside.style.removeProperty('--sheet-drag');
  drag = undefined;
}

const next: Record<Sheet, Sheet> = { peek: 'half', half: 'full', full: 'peek' };
const does: Record<Sheet, string> = {
  peek: 'Show the panels',
  half: 'Panels over the whole page',
  full: 'Hide the panels',
};

export function sheetHandle(ui: UiState): TemplateResult {
  const click = (event: MouseEvent): void => {
    const isKey = event.detail === 0;
    if (isKey || !wasDrag) ui.sheet = next[ui.sheet];
  };
  return html`<div class="sheet-handle">
    <button
      type="button"
      id="sheet"
      aria-expanded=${ui.sheet !== 'peek'}
      aria-label=${does[ui.sheet]}
      @pointerdown=${press}
      @pointermove=${move}
      @pointerup=${(event: PointerEvent) => release(ui, event)}
      @pointercancel=${(event: PointerEvent) => release(ui, event)}
      @click=${click}
    ></button>
  </div>`;
}
