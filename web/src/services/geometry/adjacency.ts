// What triangles are connected to: neighbours, boundary, connected components.

import { forEachIndex } from './loops';

export interface Edges {
  starts: Uint32Array;
  neighbours: Uint32Array;
  isBoundary: Uint8Array;
}

const few = 64; // up to so many, sorting by insertion is faster than the engine's sort

function sortFew(list: Uint32Array, from: number, to: number): void {
  if (to - from > few) {
    list.subarray(from, to).sort();
    return;
  }
  for (let i = from + 1; i < to; i++) {
    const x = list[i];
    let j = i - 1;
    for (; j >= from && list[j] > x; j--) list[j + 1] = list[j];
    list[j + 1] = x;
  }
}

/** A triangle makes its corners neighbours; an edge of one triangle is the boundary. */
export function edgesOf(triangles: Uint32Array, vertexCount: number): Edges {
  const firsts = new Uint32Array(vertexCount + 1);
  for (let c = 0; c < triangles.length; c++) firsts[triangles[c] + 1] += 2;
  for (let v = 0; v < vertexCount; v++) firsts[v + 1] += firsts[v];
  const all = new Uint32Array(2 * triangles.length);
  const next = firsts.slice();
  forEachIndex(triangles.length / 3, (t) => {
    const a = triangles[3 * t];
    const b = triangles[3 * t + 1];
    const c = triangles[3 * t + 2];
    all[next[a]++] = b;
    all[next[a]++] = c;
    all[next[b]++] = c;
    all[next[b]++] = a;
    all[next[c]++] = a;
    all[next[c]++] = b;
  });
  const starts = new Uint32Array(vertexCount + 1);
  const isBoundary = new Uint8Array(vertexCount);
  let count = 0; // neighbours so far, kept in the front of `all`
  forEachIndex(vertexCount, (v) => {
    const end = firsts[v + 1];
    sortFew(all, firsts[v], end);
    for (let i = firsts[v]; i < end;) {
      const w = all[i];
      let times = 0;
      for (; i < end && all[i] === w; i++) times += 1;
      if (times === 1) isBoundary[v] = 1;
      all[count++] = w;
    }
    starts[v + 1] = count;
  });
  return { starts, neighbours: all.slice(0, count), isBoundary };
}

/** Connected component of each vertex; components are numbered by their smallest triangle. */
export function componentsOf(triangles: Uint32Array, vertexCount: number): Int32Array {
  const root = Int32Array.from({ length: vertexCount }, (_, v) => v);
  const find = (v: number): number => {
    while (root[v] !== v) v = root[v] = root[root[v]];
    return v;
  };
  forEachIndex(triangles.length / 3, (t) => {
    const a = find(triangles[3 * t]);
    root[find(triangles[3 * t + 1])] = a;
    root[find(triangles[3 * t + 2])] = a;
  });
  const numberOf = new Int32Array(vertexCount).fill(-1);
  const component = new Int32Array(vertexCount).fill(-1);
  let count = 0;
  forEachIndex(triangles.length, (c) => {
    const r = find(triangles[c]);
    if (numberOf[r] < 0) numberOf[r] = count++;
    component[triangles[c]] = numberOf[r];
  });
  return component;
}
