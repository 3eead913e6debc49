// Pictures of the page: lines on a grid of 16, in the colour of the text.

import { svg, type TemplateResult } from 'lit';
import { html } from 'lit';

const paths = {
  open: 'M2 13V3h4l1.5 2H14v8zM2 7h12',
  undo: 'M6 3 2.5 6.5 6 10M3 6.5h6.5a4 4 0 0 1 0 8H6',
  redo: 'M10 3l3.5 3.5L10 10M13 6.5H6.5a4 4 0 0 0 0 8H10',
  run: 'M4.5 2.5v11l9-5.5z',
  download: 'M8 2v8M4.5 7 8 10.5 11.5 7M2.5 13.5h11',
  help: 'M5.8 6a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6M8 12.2v.1M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13',
  theme: 'M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12',
  orbit: 'M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M1.5 9.5C3 13 13 13 14.5 9.5M1.5 6.5C3 3 13 3 14.5 6.5',
  place: 'M8 2v12M2 8h12M8 5.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5',
  frame: 'M2 5V2h3M11 2h3v3M14 11v3h-3M5 14H2v-3',
  wire: 'M2 13 8 2.5 14 13zM5 7.8h6M8 13 5 7.8M8 13l3-5.2',
  seams: 'M3 13c2-4 0-6 3-6s2 3 4 3 1-5 3-7',
  remove: 'M4 4l8 8M12 4l-8 8',
  more: 'M3 6l5 5 5-5',
  check: 'M3 8.5 6.5 12 13 4.5',
  cross: 'M4 4l8 8M12 4l-8 8',
  image: 'M2 3h12v10H2zM2 11l3.5-3.5L9 11l2-2 3 3M10.5 6h.1',
} as const;

export type Icon = keyof typeof paths;

export function icon(name: Icon): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 16 16" aria-hidden="true">
    ${svg`<path d=${paths[name]} />`}
  </svg>`;
}

const pictures: Record<string, string> = {
  sphere:
    'M24 6a18 18 0 1 0 0 36 18 18 0 0 0 0-36M6 24c6 7 30 7 36 0M24 6c-9 9-9 27 0 36M24 6c9 9 9 27 0 36',
  cube: 'M24 5 41 14v20L24 43 7 34V14zM7 14l17 9 17-9M24 23v20',
  torus:
    'M24 11C12 11 4 17 4 24s8 13 20 13 20-6 20-13-8-13-20-13M15 23c4 5 14 5 18 0M17 24.500c4-4 10-4 14 0',
  pipe: 'M8 40c0-20 8-30 28-32M22 41c0-12 4-18 18-19M8 40c2 3 12 3 14 1M36 8c4 2 6 10 4 14',
  pebble:
    'M22 6c8-3 13 4 12 10 8 0 11 8 7 14-3 5-8 4-10 8-3 6-12 6-15 1-2-4-8-3-10-9-2-7 4-10 7-12 1-5 3-10 9-12M18 22c4 4 10 4 14 0M20 32c2 2 6 2 8 0',
};

/** A drawing of an example. */
export function picture(id: string): TemplateResult {
  return html`<svg class="picture" viewBox="0 0 48 48" aria-hidden="true">
    ${svg`<path d=${pictures[id] ?? ''} />`}
  </svg>`;
}
