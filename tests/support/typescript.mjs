// Lets Node import the page's TypeScript as it is: types are stripped, and a name without an ending
// finds its file. For the unit tests of modules that need no browser:
//
//   node --import ./tests/support/typescript.mjs --test tests/web/units/*.test.mjs

import { register } from 'node:module';

register('./typescript_hooks.mjs', import.meta.url);
