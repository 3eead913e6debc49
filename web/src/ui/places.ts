// From places as the solver names them to what the views can outline.

import type { Where } from 'hgp';
import type { Solved } from '../state/solved';
import type { Surface } from '../state/surface';

export interface Places {
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

export function placesOf(where: Where[], surface: Surface, solved?: Solved): Places {
  const places: Places = { triangles: [], edges: [], uvEdges: [], first: -1, text: '' };
  for (const { kind, id, other } of where.slice(0, 500)) {
    if (kind === 'triangle') {
      places.triangles.push(id);
      if (places.first < 0) places.first = surface.triangles[3 * id] ?? -1;
      places.text = `triangle ${id}`;
    } else if (kind === 'vertex' && id < surface.vertexCount) {
      places.triangles.push(...trianglesAt(surface, id));
      if (places.first < 0) places.first = id;
      places.text = `vertex ${id}`;
    } else if (kind === 'edge' && other !== undefined) {
      places.edges.push([id, other]);
      const seam = solved?.seamAt.get(
        Math.min(id, other) * surface.vertexCount + Math.max(id, other),
      );
      if (solved && seam !== undefined) {
        places.uvEdges.push(solved.seams[seam].a, solved.seams[seam].b);
      }
      if (places.first < 0) places.first = id;
      places.text = `edge ${id}–${other}`;
    } else if (kind === 'loop' && other !== undefined) {
      places.edges.push(...loopThrough(surface, other));
      if (places.first < 0) places.first = other;
      places.text = `boundary ${id + 1}`;
    }
  }
  return places;
}
