// The geometry of a map while a cone is dragged: the same triangles with other texture coordinates, which are written
// into buffers of their own; those of the solution come back afterwards.

import { BufferAttribute, DynamicDrawUsage, type BufferGeometry } from 'three';
import type { LiveMap } from '../model/live';
import type { Surface } from '../model/types';
import { overlayColours } from '../services/geometry/overlay_colours';
import { FlatAttribute } from './gathered_attribute';

type Name = 'uv' | 'position' | 'tint';
type Values = Float32Array | Uint8Array;

/** Replaces attributes of a geometry, and puts back those that it had. */
export class LiveGeometry {
  #geometry?: BufferGeometry;
  readonly #usual = new Map<Name, BufferAttribute | undefined>();
  readonly #isFlat: boolean;

  /** @param isFlat  whether the map itself is drawn */
  constructor(isFlat: boolean) {
    this.#isFlat = isFlat;
  }

  get isShown(): boolean {
    return this.#geometry !== undefined;
  }

  /** Without a map, restores the geometry. */
  show(geometry: BufferGeometry, live?: LiveMap, surface?: Pick<Surface, 'triangles'>): void {
    if (!live || !surface) return this.restore();
    this.#geometry = geometry;
    this.#set(geometry, 'uv', live.cornerUv, 2);
    if (this.#isFlat) this.#place(geometry);
    this.#set(geometry, 'tint', coloursOf(live, surface.triangles), 4);
  }

  restore(): void {
    for (const [name, usual] of this.#usual) {
      if (usual) this.#geometry?.setAttribute(name, usual);
      else this.#geometry?.deleteAttribute(name);
    }
    this.#usual.clear();
    this.#geometry = undefined;
  }

  #set(geometry: BufferGeometry, name: Name, values: Values, size: number): void {
    const now = geometry.getAttribute(name) as BufferAttribute | undefined;
    if (this.#usual.has(name) && now?.array.length === values.length) {
      (now.array as Float32Array).set(values);
      now.needsUpdate = true;
      return;
    }
    if (!this.#usual.has(name)) this.#usual.set(name, now);
    const own =
      this.#isFlat && values instanceof Float32Array
        ? new FlatAttribute(values.slice())
        : new BufferAttribute(values.slice(), size, values instanceof Uint8Array);
    geometry.setAttribute(name, own.setUsage(DynamicDrawUsage));
  }

  /** Puts the corners of the map where its texture coordinates are. */
  #place(geometry: BufferGeometry): void {
    if (!this.#usual.has('position'))
      this.#usual.set('position', geometry.getAttribute('position') as BufferAttribute);
    geometry.setAttribute('position', geometry.getAttribute('uv'));
  }
}

/** Nothing over a map that passes, its folded triangles over one that fails, the scale where there is no map. */
function coloursOf({ state, heat, notPositive }: LiveMap, triangles: Uint32Array): Uint8Array {
  const none = new Float32Array(0);
  const isHeat = state === 'heat' && heat.length > 0;
  const area = isHeat ? meanOf(heat, triangles) : none;
  const values = { area, areaSize: none, stretch: none, seamDistance: none, flipped: notPositive };
  const areaSize = { p99: largestOf(area) };
  const limits = { stretch: areaSize, areaSize, seamDistance: areaSize } as never;
  return overlayColours(isHeat ? 'area' : 'none', values, limits, triangles);
}

function meanOf(heat: Float32Array, triangles: Uint32Array): Float32Array {
  const out = new Float32Array(triangles.length / 3);
  for (let t = 0; t < out.length; t++) {
    const sum = heat[triangles[3 * t]] + heat[triangles[3 * t + 1]] + heat[triangles[3 * t + 2]];
    out[t] = Number.isNaN(sum) ? 0 : sum / 3;
  }
  return out;
}

/** Close to cones the scale has no bound: the largest percent is left out. */
function largestOf(values: Float32Array): number {
  const sizes = values.map(Math.abs).sort();
  return sizes[Math.floor(0.99 * sizes.length)] ?? 0;
}
