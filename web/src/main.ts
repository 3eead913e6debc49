// Drop a mesh, see it with a texture that folds nowhere.

import { createSolver } from './state/solver';
import { openAndRun } from './state/document';
import { showCertificate } from './ui/certificate';
import { Viewer } from './view/viewer';

function element<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

const status = element('status');
const progress = element<HTMLProgressElement>('progress');
const cancel = element<HTMLButtonElement>('cancel');
const input = element<HTMLInputElement>('file');
const drop = element('drop');
const canvas = element<HTMLCanvasElement>('view');

function say(text: string, isError = false): void {
  status.textContent = text;
  status.classList.toggle('error', isError);
}

const viewer = new Viewer(canvas);
const client = await createSolver();
let running: AbortController | undefined;

async function open(file: File): Promise<void> {
  running?.abort();
  const own = (running = new AbortController());
  for (const part of [progress, cancel]) part.hidden = false;
  element('result').hidden = true;
  say(`Reading ${file.name} …`);
  try {
    const { info, result } = await openAndRun(client, file, {
      signal: own.signal,
      onProgress({ stage, fraction, iteration }) {
        progress.value = fraction;
        say(iteration >= 0 ? `${stage}, iteration ${iteration}` : stage);
      },
    });
    element('empty').hidden = true;
    viewer.show(result);
    showCertificate(element('result'), result);
    canvas.ariaLabel = `3D view: ${file.name}, ${info.triangles} triangles, textured`;
    say(`${file.name}: ${info.vertices} vertices, ${info.triangles} triangles`);
    document.body.dataset.state = 'result';
  } catch (error) {
    if (own !== running) return;
    const { name, message } = error as Error;
    say(name === 'AbortError' ? 'Cancelled.' : message, name !== 'AbortError');
    document.body.dataset.state = name === 'AbortError' ? 'empty' : 'error';
  } finally {
    if (own === running) for (const part of [progress, cancel]) part.hidden = true;
  }
}

element('open').addEventListener('click', () => input.click());
input.addEventListener('change', () => {
  if (input.files?.[0]) void open(input.files[0]);
  input.value = '';
});
cancel.addEventListener('click', () => running?.abort());
drop.addEventListener('dragover', (event) => {
  event.preventDefault();
  drop.classList.add('over');
});
drop.addEventListener('dragleave', () => drop.classList.remove('over'));
drop.addEventListener('drop', (event) => {
  event.preventDefault();
  drop.classList.remove('over');
  const file = event.dataTransfer?.files[0];
  if (file) void open(file);
});

document.body.dataset.state = 'empty';
say('Ready.');
