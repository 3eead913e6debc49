// The address of the page: q, pattern, overlay, scale, camera, cones. Numbers and known words only.

import { overlays, patterns, type App, type Overlay, type Pattern } from './app';

const mostText = 8192;

export interface Asked {
  q?: number;
  pattern?: Pattern;
  overlay?: Overlay;
  tiles?: number;
  camera?: string;
  cones?: { vertex: number; k: number }[];
}

const integer = (text: string | null, low: number, high: number): number | undefined => {
  const n = text === null ? NaN : Number(text);
  return Number.isInteger(n) && n >= low && n <= high ? n : undefined;
};

function conesOf(text: string | null): Asked['cones'] {
  if (!text || text.length > mostText || !/^[\w-]+$/.test(text)) return undefined;
  try {
    const list: unknown = JSON.parse(atob(text.replaceAll('-', '+').replaceAll('_', '/')));
    if (!Array.isArray(list)) return undefined;
    const cones = list.map((pair) => ({ vertex: Number(pair?.[0]), k: Number(pair?.[1]) }));
    const isFine = cones.every(
      ({ vertex, k }) => Number.isInteger(vertex) && vertex >= 0 && Number.isInteger(k) && k >= 1,
    );
    return isFine ? cones : undefined;
  } catch {
    return undefined;
  }
}

export function readAddress(hash: string): Asked {
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const known = <T>(list: readonly T[], key: string): T | undefined =>
    list.find((word) => word === words.get(key));
  const tiles = Number(words.get('tiles'));
  return {
    q: integer(words.get('q'), 1, 64),
    pattern: known(
      patterns.filter((name) => name !== 'image' && name !== 'material'),
      'pattern',
    ),
    overlay: known(overlays, 'overlay'),
    tiles: tiles >= 1 && tiles <= 1000 ? tiles : undefined,
    camera: words.get('camera') ?? undefined,
    cones: conesOf(words.get('cones')),
  };
}

/** What is different from a fresh page. */
export function addressOf(app: App, camera: string | undefined): string {
  const { look, asked } = app;
  const words = new URLSearchParams();
  words.set('q', String(asked.q));
  words.set('pattern', look.pattern);
  if (look.overlay !== 'none') words.set('overlay', look.overlay);
  words.set('tiles', look.tiles.toFixed(0));
  if (camera) words.set('camera', camera);
  const list = JSON.stringify(asked.cones.map(({ vertex, k }) => [vertex, k]));
  const cones = btoa(list).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
  if (asked.cones.length > 0 && cones.length <= mostText) words.set('cones', cones);
  return `#${words}`;
}
