// The page's connection to the solver in its worker, and the service worker for offline use.

import { createClient, type Client } from 'hgp';
import { offlineUrl, scriptUrl, workerUrl } from './trusted_types';

export function createSolver(): Promise<Client> {
  return createClient({
    createWorker: () => new Worker(scriptUrl(workerUrl), { type: 'module', name: 'hgp solver' }),
  });
}

/** Starts a new worker after one was terminated, so that the next call need not wait for it. */
export function ensureWorker(client: Client): void {
  client.ready().catch(() => undefined); // the next call reports the error
}

/** Registers the service worker last; if that is not allowed, the page needs a network. */
export function keepOffline(): void {
  if (import.meta.env.DEV || !('serviceWorker' in navigator)) return;
  const register = (): void => {
    navigator.serviceWorker.register(scriptUrl(offlineUrl)).catch(() => undefined);
  };
  if ('requestIdleCallback' in globalThis) requestIdleCallback(register, { timeout: 5000 });
  else setTimeout(register, 2000);
}
