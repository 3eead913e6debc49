// The 3D view as a picture, and as a film of one turn.

import { nameStem } from '../formats/file_set';
import { saveBlob } from './download';
import type { App } from './app';

const pictureWidth = 2048; // pixels, at least
const turn = 6000; // milliseconds
const framesPerSecond = 30;
const bitsPerSecond = 8_000_000;
const kinds = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];

const nextFrame = (): Promise<number> => new Promise((done) => requestAnimationFrame(done));

export async function savePicture({ doc, ui, views }: App): Promise<void> {
  if (!views || !doc.model) return;
  if (ui.tab !== 'surface') {
    ui.tab = 'surface';
    await nextFrame();
    await nextFrame();
  }
  const blob = await views.model.picture(pictureWidth);
  const name = `${nameStem(doc.model.main)}.png`;
  saveBlob(blob, name);
  doc.say(`Saved the 3D view as ${name}; what is behind the model is transparent.`, 'good');
}

const filmKind = (): string | undefined =>
  'MediaRecorder' in globalThis && 'captureStream' in HTMLCanvasElement.prototype
    ? kinds.find((kind) => MediaRecorder.isTypeSupported(kind))
    : undefined;

export const whyNoTurntable = (): string =>
  filmKind() === undefined ? 'This browser cannot record a film.' : '';

/** The film of a stream, from when `during` begins until it ends. */
async function recorded(
  stream: MediaStream,
  mimeType: string,
  during: () => Promise<void>,
): Promise<Blob> {
  const recorder = new MediaRecorder(stream, { mimeType, videoBitsPerSecond: bitsPerSecond });
  const parts: Blob[] = [];
  recorder.addEventListener('dataavailable', ({ data }) => parts.push(data));
  const ended = new Promise<void>((resolve, reject) => {
    recorder.addEventListener('stop', () => resolve());
    recorder.addEventListener('error', () => reject(new Error('the film could not be recorded')));
  });
  recorder.start();
  try {
    await during();
  } finally {
    recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  await ended;
  return new Blob(parts, { type: mimeType });
}

/** Records one turn around the model; a second call stops it without saving. */
export async function saveTurntable(app: App): Promise<void> {
  const { doc, ui, views } = app;
  const kind = filmKind();
  if (!views || !doc.model || !kind) return;
  if (ui.isRecording) return void (ui.isRecording = false);
  const { model: view } = views;
  const { main } = doc.model;
  const { orbit } = view;
  ui.tab = 'surface';
  ui.isRecording = true;
  doc.say('Recording one turn; please wait.', 'note', [
    { label: 'Stop', run: () => (ui.isRecording = false) },
  ]);
  const turnOnce = async (): Promise<void> => {
    const begin = await nextFrame();
    for (let done = 0; done < 1 && ui.isRecording && doc.model?.main === main;) {
      const part = Math.min(1, ((await nextFrame()) - begin) / turn);
      orbit.move(2 * Math.PI * (part - done), 0);
      done = part;
    }
  };
  const place = orbit.toText();
  view.setBacking(getComputedStyle(view.canvas.parentElement!).backgroundColor);
  try {
    const stream = view.canvas.captureStream(framesPerSecond);
    const film = await recorded(stream, kind, turnOnce);
    if (!ui.isRecording) return doc.say('The turntable was stopped and not saved.');
    const name = `${nameStem(main)}.${kind.startsWith('video/mp4') ? 'mp4' : 'webm'}`;
    saveBlob(film, name);
    doc.say(`Saved one turn as ${name}.`, 'good');
  } finally {
    ui.isRecording = false;
    view.setBacking(undefined);
    orbit.fromText(place);
  }
}
