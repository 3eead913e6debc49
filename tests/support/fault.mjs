// Lets Node load a script of the built package with a fault in its source (tests/mutation): HGP_FAULT_FILE names the source,
// HGP_FAULT_TEXT the file with the changed text. Sources of the page are replaced by typescript_hooks.mjs.

import { register } from 'node:module';

if (process.env.HGP_FAULT_FILE) register('./fault_hooks.mjs', import.meta.url);
