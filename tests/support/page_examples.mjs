// What the page's bundler makes of virtual:examples, for tests under Node.

import { examples as made } from '../../web/examples.mjs';

export const examples = made().map(({ bytes, ...about }) => about);
