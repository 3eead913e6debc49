// The only place where the page creates URLs of scripts: those of its workers and its service worker.

import workerUrl from 'hgp/worker?worker&url';
import geometryUrl from './geometry_worker?worker&url';
import validatorUrl from './validator_worker?worker&url';

export { geometryUrl, validatorUrl, workerUrl };
export const offlineUrl = './sw.js';

interface Policy {
  createScriptURL(url: string): unknown;
}

const policy = (
  globalThis as { trustedTypes?: { createPolicy(name: string, rules: object): Policy } }
).trustedTypes?.createPolicy('hgp', {
  createScriptURL(url: string): string {
    if (![workerUrl, geometryUrl, validatorUrl, offlineUrl].includes(url)) {
      throw new TypeError(`not a script of this page: ${url}`);
    }
    return url;
  },
});

/** The URL, as a trusted one if the browser supports Trusted Types. */
export const scriptUrl = (url: string): string => (policy?.createScriptURL(url) ?? url) as string;
