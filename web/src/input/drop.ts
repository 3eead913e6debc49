// Files dropped anywhere on the page.

import { attempt, type AppView } from '../actions/app';
import { open } from '../actions/open';
import { filesOfDrop } from '../formats/file_set';

export function listenToDrops(app: AppView): void {
  let depth = 0;
  const change = (to: number): void => {
    depth = to;
    document.body.classList.toggle('over', depth > 0);
  };
  document.addEventListener('dragenter', () => change(depth + 1));
  document.addEventListener('dragleave', () => change(depth - 1));
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    change(0);
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    const files = filesOfDrop(dataTransfer);
    void attempt(app, async () => open(app, await files));
  });
}
