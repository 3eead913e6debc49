// The page's connection to the solver in its worker.

import { createClient, type Client } from 'hgp';
import workerUrl from 'hgp/worker?worker&url';

// The one place where this page makes a URL that may run script.
const policy = (
  globalThis as { trustedTypes?: { createPolicy(name: string, rules: object): Policy } }
).trustedTypes?.createPolicy('hgp', {
  createScriptURL(url: string): string {
    if (url !== workerUrl) throw new TypeError(`not a script of this page: ${url}`);
    return url;
  },
});

interface Policy {
  createScriptURL(url: string): unknown;
}

export function createSolver(): Promise<Client> {
  return createClient({
    createWorker: () =>
      new Worker((policy?.createScriptURL(workerUrl) ?? workerUrl) as string, {
        type: 'module',
        name: 'hgp solver',
      }),
  });
}
