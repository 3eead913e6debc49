// The loops around handles, as the solver numbers them: tree–cotree on the surface with its boundary
// loops filled in. It depends on connectivity alone, so both sides find the same loops.

import type { Surface } from '../../model/types';

type SurfaceGraph = Pick<Surface, 'triangles' | 'component' | 'vertexCount'>;

/** Halfedge 3t + k goes from corner k of triangle t to the next; −1: the boundary. */
function twinsOf({ triangles, vertexCount }: SurfaceGraph): Int32Array {
  const twin = new Int32Array(triangles.length).fill(-1);
  const waiting = new Map<number, number>();
  for (let h = 0; h < triangles.length; h++) {
    const [a, b] = [triangles[h], triangles[next(h)]];
    const key = Math.min(a, b) * vertexCount + Math.max(a, b);
    const other = waiting.get(key);
    if (other === undefined) waiting.set(key, h);
    else {
      twin[h] = other;
      twin[other] = h;
    }
  }
  return twin;
}

const next = (h: number): number => (h % 3 === 2 ? h - 2 : h + 1);
const face = (h: number): number => Math.floor(h / 3);

class Forest {
  readonly #parent: Int32Array;
  constructor(count: number) {
    this.#parent = Int32Array.from({ length: count }, (_, i) => i);
  }
  #root(a: number): number {
    const p = this.#parent;
    while (p[a] !== a) a = p[a] = p[p[a]];
    return a;
  }
  join(a: number, b: number): boolean {
    [a, b] = [this.#root(a), this.#root(b)];
    if (a === b) return false;
    this.#parent[Math.max(a, b)] = Math.min(a, b);
    return true;
  }
}

interface DualTree {
  entry: Int32Array;
  depth: Int32Array;
  isCrossed: Uint8Array;
}

/** Breadth-first over triangles from the first of each part. */
function growDualTree(twin: Int32Array): DualTree {
  const faces = twin.length / 3;
  const tree: DualTree = {
    entry: new Int32Array(faces).fill(-1),
    depth: new Int32Array(faces).fill(-1),
    isCrossed: new Uint8Array(twin.length),
  };
  for (let seed = 0; seed < faces; seed++) {
    if (tree.depth[seed] >= 0) continue;
    tree.depth[seed] = 0;
    const queue = [seed];
    for (let at = 0; at < queue.length; at++) {
      for (let k = 0; k < 3; k++) {
        const h = 3 * queue[at] + k;
        if (twin[h] < 0 || tree.depth[face(twin[h])] >= 0) continue;
        tree.depth[face(twin[h])] = tree.depth[queue[at]] + 1;
        tree.entry[face(twin[h])] = h;
        tree.isCrossed[h] = tree.isCrossed[twin[h]] = 1;
        queue.push(face(twin[h]));
      }
    }
  }
  return tree;
}

/** The closed walk through the tree and across h: the halfedges it crosses, in order. */
function closeLoop(twin: Int32Array, { depth, entry }: DualTree, h: number): number[] {
  const [down, up]: [number[], number[]] = [[], []];
  let [a, b] = [face(h), face(twin[h])];
  while (a !== b) {
    if (depth[a] >= depth[b]) {
      down.push(entry[a]);
      a = face(entry[a]);
    } else {
      up.push(twin[entry[b]]);
      b = face(entry[b]);
    }
  }
  return [...down.reverse(), h, ...up];
}

/** Crossed halfedges of every generator, part after part. */
export function handleLoops(surface: SurfaceGraph): number[][] {
  const { triangles, component, vertexCount } = surface;
  const twin = twinsOf(surface);
  const forest = new Forest(vertexCount);
  const isTree = new Uint8Array(twin.length);
  for (let h = 0; h < twin.length; h++) {
    if (twin[h] >= 0) continue;
    forest.join(triangles[h], triangles[next(h)]);
    isTree[h] = 1;
  }
  const tree = growDualTree(twin);
  const loops: { component: number; crossed: number[] }[] = [];
  for (let h = 0; h < twin.length; h++) {
    if ((twin[h] >= 0 && twin[h] < h) || isTree[h] || tree.isCrossed[h]) continue;
    if (forest.join(triangles[h], triangles[next(h)])) continue;
    loops.push({ component: component[triangles[h]], crossed: closeLoop(twin, tree, h) });
  }
  return loops.sort((x, y) => x.component - y.component).map(({ crossed }) => crossed);
}

/** From the middle of each crossed edge to the next: six numbers a segment. */
export function loopSegments(
  { positions: p, triangles }: Pick<Surface, 'positions' | 'triangles'>,
  crossed: number[],
): Float32Array {
  const middle = (h: number): number[] => {
    const [a, b] = [3 * triangles[h], 3 * triangles[next(h)]];
    return [0, 1, 2].map((i) => (p[a + i] + p[b + i]) / 2);
  };
  return Float32Array.from(
    crossed.flatMap((h, i) => [...middle(h), ...middle(crossed[(i + 1) % crossed.length])]),
  );
}
