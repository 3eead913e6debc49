// Tells users in another tab that a run has ended: by the title of the page, and by a notification if it was long.

import { effect } from '@preact/signals-core';
import { isCertified } from '../model/verdict';
import type { App } from './app';

const longRun = 10; // seconds: from here on a notification is shown, not only a title

export function notifyAtEnd({ doc }: Pick<App, 'doc'>): () => void {
  let running: { begin: number } | undefined;
  const title = document.title;
  addEventListener('focus', () => (document.title = title));
  const callBack = (seconds: number): void => {
    const { current, message } = doc;
    const text = current && isCertified(current) ? 'Certified' : (message?.text ?? 'Done');
    document.title = `● ${text} · hgp`;
    if (seconds < longRun || !('Notification' in globalThis)) return;
    if (Notification.permission === 'granted') new Notification('hgp', { body: text });
  };
  return effect(() => {
    const { job } = doc;
    if (job?.kind === 'run') running = { begin: job.begin };
    if (job || !running) return;
    const seconds = (performance.now() - running.begin) / 1000;
    running = undefined;
    // The outcome is set in the same task, after the job.
    if (document.hidden) setTimeout(() => callBack(seconds));
  });
}
