// Converts targets in the solver's form to what the views outline.

import type { Where } from 'hgp';
import type { Solution, Surface } from '../model/types';

export interface HighlightTargets {
  triangles: number[];
  /** By vertices of the surface. */
  edges: [number, number][];
  /** By uv vertices. */
  uvEdges: [number, number][];
  /** A vertex to look at, or −1. */
  first: number;
  text: string;
}

function trianglesAt(surface: Surface, vertex: number): number[] {
  const found: number[] = [];
  surface.triangles.forEach((v, c) => v === vertex && found.push(Math.floor(c / 3)));
  return found;
}

/** Boundary edges connected to a vertex. */
function loopThrough(surface: Surface, start: number): [number, number][] {
  const next = new Map<number, number>();
  const known = new Set<number>();
  const { triangles, vertexCount } = surface;
  for (let c = 0; c < triangles.length; c++) {
    known.add(triangles[c] * vertexCount + triangles[c % 3 === 2 ? c - 2 : c + 1]);
  }
  for (const key of known) {
    const [a, b] = [Math.floor(key / vertexCount), key % vertexCount];
    if (!known.has(b * vertexCount + a)) next.set(a, b);
  }
  const edges: [number, number][] = [];
  for (let v = start; next.has(v) && edges.length <= next.size;) {
    const w = next.get(v)!;
    edges.push([v, w]);
    v = w;
    if (v === start) break;
  }
  return edges;
}

export function highlightTargets(
  where: Where[],
  surface: Surface,
  solution?: Solution,
): HighlightTargets {
  const targets: HighlightTargets = { triangles: [], edges: [], uvEdges: [], first: -1, text: '' };
  for (const { kind, id, other } of where.slice(0, 500)) {
    if (kind === 'triangle') {
      targets.triangles.push(id);
      if (targets.first < 0) targets.first = surface.triangles[3 * id] ?? -1;
      targets.text = `triangle ${id}`;
    } else if (kind === 'vertex' && id < surface.vertexCount) {
      targets.triangles.push(...trianglesAt(surface, id));
      if (targets.first < 0) targets.first = id;
      targets.text = `vertex ${id}`;
    } else if (kind === 'edge' && other !== undefined) {
      targets.edges.push([id, other]);
      const seam = solution?.seamAt.get(
        Math.min(id, other) * surface.vertexCount + Math.max(id, other),
      );
      if (solution && seam !== undefined) {
        targets.uvEdges.push(solution.seams[seam].a, solution.seams[seam].b);
      }
      if (targets.first < 0) targets.first = id;
      targets.text = `edge ${id}–${other}`;
    } else if (kind === 'loop' && other !== undefined) {
      targets.edges.push(...loopThrough(surface, other));
      if (targets.first < 0) targets.first = other;
      targets.text = `boundary ${id + 1}`;
    }
  }
  return targets;
}
