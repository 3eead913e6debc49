// Lets Node import the page's TypeScript directly: types are stripped, and names without an extension
// are resolved. For unit tests of modules that need no browser:
//
//   node --import ./tests/support/typescript.mjs --test tests/web/units/*.test.mjs

import { register } from 'node:module';

register('./typescript_hooks.mjs', import.meta.url);
