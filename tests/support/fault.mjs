// Lets Node load a source of the page or the package with a fault in it (tests/mutation): HGP_FAULT_FILE names the source,
// HGP_FAULT_TEXT the file with the changed text.

import { register } from 'node:module';

if (process.env.HGP_FAULT_FILE) register('./fault_hooks.mjs', import.meta.url);
