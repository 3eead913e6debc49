// The page's connection to the solver in its worker, and what keeps the page working offline.

import { createClient, type Client } from 'hgp';
import { offlineUrl, scriptUrl, workerUrl } from './trusted_types';

export function createSolver(): Promise<Client> {
  return createClient({
    createWorker: () => new Worker(scriptUrl(workerUrl), { type: 'module', name: 'hgp solver' }),
  });
}

/** Starts another worker where one was ended, so that whatever comes next need not wait for it. */
export function ensureWorker(client: Client): void {
  client.ready().catch(() => undefined); // the next call says what is wrong
}

/** After everything else; where it is not allowed, the page works with a network only. */
export function keepOffline(): void {
  if (import.meta.env.DEV || !('serviceWorker' in navigator)) return;
  const register = (): void => {
    navigator.serviceWorker.register(scriptUrl(offlineUrl)).catch(() => undefined);
  };
  if ('requestIdleCallback' in globalThis) requestIdleCallback(register, { timeout: 5000 });
  else setTimeout(register, 2000);
}
