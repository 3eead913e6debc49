// The divider between the two views, which can be dragged, moved with the arrow keys, or clicked.

import { hasModifier } from '../model/modifiers';
import type { UiState } from '../model/ui_state';

const places = [30, 58, 80]; // percent; each click moves to the next

export function listenToSplitter(splitter: HTMLElement, ui: UiState): void {
  const panes = splitter.parentElement!;
  let isDragged = false;
  splitter.addEventListener('pointerdown', (event) => {
    splitter.setPointerCapture(event.pointerId);
    isDragged = false;
  });
  splitter.addEventListener('click', () => {
    if (!isDragged) ui.setSplit(places.find((one) => one > ui.split) ?? places[0]);
  });
  splitter.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) return;
    isDragged = true;
    const left = panes.querySelector('#pane-surface')!.getBoundingClientRect().left;
    const right = panes.querySelector('#pane-map')!.getBoundingClientRect().right;
    ui.setSplit((100 * (event.clientX - left)) / (right - left));
  });
  splitter.addEventListener('keydown', (event) => {
    if ((event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') || hasModifier(event)) return;
    event.preventDefault();
    ui.setSplit(ui.split + (event.key === 'ArrowLeft' ? -4 : 4));
  });
}
