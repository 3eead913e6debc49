import type { Example } from './examples.mjs';
export function firstScreen(examples: readonly Example[]): string;
