// A link that carries cones and settings, but never the mesh.

import { flushAddress } from './remember';
import type { App } from './app';

export async function copyLink(app: App): Promise<void> {
  const { doc } = app;
  flushAddress(app);
  const isExample = new URLSearchParams(location.hash.slice(1)).has('example');
  const needs = isExample ? '' : ` Whoever opens it needs the file ${doc.model?.main ?? ''}, too.`;
  try {
    await navigator.clipboard.writeText(location.href);
    doc.say(`Copied: a link to these cones and settings.${needs}`, 'good');
  } catch {
    doc.say(
      `The browser does not let this page copy. The link is the address of the page.${needs}`,
    );
  }
}
