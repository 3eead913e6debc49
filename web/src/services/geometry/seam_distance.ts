// The distance of each vertex from the nearest seam along edges, by Dijkstra's algorithm from all seams at once.

import type { Seam, Surface } from '../../model/types';

/** A binary heap of vertices by distance. */
class Heap {
  readonly #items: { v: number; d: number }[] = [];
  get isEmpty(): boolean {
    return this.#items.length === 0;
  }
  push(v: number, d: number): void {
    const items = this.#items;
    items.push({ v, d });
    for (let i = items.length - 1; i > 0;) {
      const up = (i - 1) >> 1;
      if (items[up].d <= items[i].d) return;
      [items[up], items[i]] = [items[i], items[up]];
      i = up;
    }
  }
  pop(): { v: number; d: number } {
    const items = this.#items;
    const top = items[0];
    const last = items.pop()!;
    if (items.length === 0) return top;
    items[0] = last;
    for (let i = 0; ;) {
      let smallest = i;
      for (const child of [2 * i + 1, 2 * i + 2]) {
        if (child < items.length && items[child].d < items[smallest].d) smallest = child;
      }
      if (smallest === i) return top;
      [items[smallest], items[i]] = [items[i], items[smallest]];
      i = smallest;
    }
  }
}

export function distanceToSeams(
  {
    positions: p,
    neighbourStart,
    neighbours,
    vertexCount,
  }: Pick<Surface, 'positions' | 'neighbourStart' | 'neighbours' | 'vertexCount'>,
  seams: Seam[],
  uvToVertex: Uint32Array,
): Float32Array {
  const distance = new Float32Array(vertexCount).fill(Infinity);
  const heap = new Heap();
  for (const { a } of seams) {
    for (const end of a) {
      const v = uvToVertex[end];
      if (distance[v] === 0) continue;
      distance[v] = 0;
      heap.push(v, 0);
    }
  }
  while (!heap.isEmpty) {
    const { v, d } = heap.pop();
    if (d > distance[v]) continue;
    for (let n = neighbourStart[v]; n < neighbourStart[v + 1]; n++) {
      const w = neighbours[n];
      const x = p[3 * w] - p[3 * v];
      const y = p[3 * w + 1] - p[3 * v + 1];
      const z = p[3 * w + 2] - p[3 * v + 2];
      const along = Math.sqrt(x * x + y * y + z * z);
      const next = Math.fround(d + along);
      if (next >= distance[w]) continue;
      distance[w] = next;
      heap.push(w, next);
    }
  }
  return distance;
}
