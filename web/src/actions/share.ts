// A link that carries cones, features and settings, but never the mesh.

import { listed } from '../text/format';
import { flushAddress } from './remember';
import type { App } from './app';

/** What whoever opens the link has to get in another way. */
function restOf({ doc }: App, omitted: string[]): string {
  const isExample = new URLSearchParams(location.hash.slice(1)).has('example');
  const { main = '' } = doc.model ?? {};
  const needs = isExample ? '' : ` Whoever opens it needs the file ${main}, too.`;
  const { askedField: field } = doc;
  const missing = [...omitted, ...(field ? [`the directions of ${field.name}`] : [])];
  const without =
    missing.length > 0 ? ` Not in it, because a link is too short: ${listed(missing)}.` : '';
  return `${needs}${without}`;
}

export async function copyLink(app: App): Promise<void> {
  const { doc } = app;
  const rest = restOf(app, flushAddress(app));
  try {
    await navigator.clipboard.writeText(location.href);
    doc.say(`Copied: a link to these cones and settings.${rest}`, 'good');
  } catch {
    doc.say(`The browser does not let this page copy. The link is the address of the page.${rest}`);
  }
}
