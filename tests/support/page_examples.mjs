// What the page's bundler makes of virtual:examples, for tests under Node. Making them takes seconds: what was made before
// of the same script is read.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';

const script = new URL('../../web/examples.mjs', import.meta.url);
const kept = new URL('../../build/scripts/', import.meta.url);
const hash = createHash('sha256').update(readFileSync(script)).digest('hex').slice(0, 32);
const place = new URL(`examples-${hash}.json`, kept);

if (!existsSync(place)) {
  const { examples: made } = await import(script.href);
  mkdirSync(kept, { recursive: true });
  const begun = new URL(`${place.href}.${process.pid}`);
  writeFileSync(begun, JSON.stringify(made().map(({ bytes, ...about }) => about)));
  renameSync(begun, place);
}
export const examples = JSON.parse(readFileSync(place, 'utf8'));
