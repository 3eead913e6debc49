// Transfers the prescription when the surface is read again. After a weld or a repair, vertices keep
// their numbers but may be merged, removed, or moved to the boundary; in another version of the file,
// vertices are identified by their exact position.

import { emptyPrescription, type Cone, type Prescription } from './prescription';
import type { Model, Surface } from './types';

type Reading = Pick<Model, 'surface' | 'info'>;

export interface Transfer {
  prescription: Prescription;
  kept: number;
  /** Descriptions of what could not be transferred. */
  lost: string[];
}

type Place = (vertex: number) => number | string;

const byNumber =
  ({ representative }: Surface): Place =>
  (v) =>
    representative[v] >= 0 ? representative[v] : 'its vertex was removed';

function byPosition(old: Surface, now: Surface, wanted: number[]): Place {
  const key = (p: Float64Array, v: number): string => `${p[3 * v]} ${p[3 * v + 1]} ${p[3 * v + 2]}`;
  const found = new Map(wanted.map((v) => [key(old.positions, v), new Set<number>()]));
  const lefts = new Set(wanted.map((v) => old.positions[3 * v]));
  for (let v = 0; v < now.vertexCount; v++) {
    if (!lefts.has(now.positions[3 * v]) || now.representative[v] < 0) continue;
    found.get(key(now.positions, v))?.add(now.representative[v]);
  }
  return (v) => {
    const [first, ...more] = found.get(key(old.positions, v)) ?? [];
    if (first === undefined) return 'no vertex is there now';
    return more.length > 0 ? `${more.length + 1} vertices are there now` : first;
  };
}

const loopsOf = ({ info }: Reading): { loop: number; anchor: number }[] =>
  (info.components ?? []).flatMap(({ boundaryLoops }) => boundaryLoops);

function transferTurnings(
  { turnings }: Prescription,
  old: Reading,
  now: Reading,
  place: Place,
  lost: string[],
): (number | null)[] {
  const [before, after] = [loopsOf(old), loopsOf(now)];
  const made = after.map((): number | null => null);
  turnings.forEach((l, loop) => {
    if (l === null) return;
    const at = before.find((one) => one.loop === loop)?.anchor ?? -1;
    const isOnly = before.length === 1 && after.length === 1;
    const same = isOnly ? after[0] : after.find(({ anchor }) => at >= 0 && anchor === place(at));
    if (same) made[same.loop] = l;
    else lost.push(`the turning of boundary ${loop + 1}`);
  });
  return made;
}

const isSame = (a: Uint32Array, b: Uint32Array): boolean =>
  a.length === b.length && a.every((x, i) => x === b[i]);

/** Transfers handle rotations only if connectivity is the same, because it determines the loops. */
function transferHandles(
  { handles }: Prescription,
  { surface: old }: Reading,
  { surface: now, info }: Reading,
  lost: string[],
): (number | null)[] {
  const made = Array.from({ length: 2 * (info.genus ?? 0) }, (): number | null => null);
  const isFixed = isSame(old.neighbours, now.neighbours) && isSame(old.triangles, now.triangles);
  handles.forEach((r, generator) => {
    if (r === null) return;
    if (isFixed && generator < made.length) made[generator] = r;
    else lost.push(`the rotation of handle loop ${generator + 1}`);
  });
  return made;
}

/** `isSameFile`: the file is the same, read with other repairs or another weld, so that vertices keep their numbers. */
export function transferPrescription(
  prescription: Prescription,
  old: Reading,
  now: Reading,
  isSameFile: boolean,
): Transfer {
  const { surface, info } = now;
  if (!info.usable) {
    // The mesh is not usable, but another repair may make it so; the cones are kept until then.
    return {
      prescription: { ...prescription, turnings: [], handles: [] },
      kept: prescription.cones.length,
      lost: [],
    };
  }
  const anchors = loopsOf(old).map(({ anchor }) => anchor);
  const wanted = [...prescription.cones.map(({ vertex }) => vertex), ...anchors];
  const place = isSameFile ? byNumber(surface) : byPosition(old.surface, surface, wanted);
  const lost: string[] = [];
  const cones: Cone[] = [];
  prescription.cones.forEach(({ vertex, k }, i) => {
    const to = place(vertex);
    const lose = (why: string): void => void lost.push(`cone ${i + 1} (${why})`);
    if (typeof to === 'string') return lose(to);
    if (surface.isBoundary[to]) return lose('now on the boundary');
    const there = cones.findIndex((one) => one.vertex === to);
    if (there >= 0) return lose(`now one with cone ${there + 1}`);
    cones.push({ vertex: to, k });
  });
  const turnings = transferTurnings(prescription, old, now, place, lost);
  const handles = transferHandles(prescription, old, now, lost);
  const empty = emptyPrescription(prescription.q, turnings.length, handles.length);
  return {
    prescription: { ...empty, cones, turnings, handles },
    kept: cones.length,
    lost,
  };
}

const few = 4;

/** "7 cones kept; not kept: cone 3 (now on the boundary)." */
export function describeTransfer({ kept, lost }: Transfer): string {
  if (kept + lost.length === 0) return '';
  const cones = `${kept} ${kept === 1 ? 'cone' : 'cones'} kept`;
  if (lost.length === 0) return ` ${cones}.`;
  const more = lost.length > few ? ` and ${lost.length - few} more` : '';
  return ` ${cones}; not kept: ${lost.slice(0, few).join(', ')}${more}.`;
}
