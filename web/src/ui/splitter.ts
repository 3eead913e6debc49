// The line between the two views: dragged, or moved with the arrow keys.

import type { Controls } from './controls';

export function listenToSplitter(splitter: HTMLElement, ui: Controls): void {
  const panes = splitter.parentElement!;
  splitter.addEventListener('pointerdown', (event) => splitter.setPointerCapture(event.pointerId));
  splitter.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) return;
    const left = panes.querySelector('#pane-surface')!.getBoundingClientRect().left;
    const right = panes.querySelector('#pane-map')!.getBoundingClientRect().right;
    ui.setSplit((100 * (event.clientX - left)) / (right - left));
  });
  splitter.addEventListener('keydown', (event) => {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    ui.setSplit(ui.split + (event.key === 'ArrowLeft' ? -4 : 4));
  });
}
