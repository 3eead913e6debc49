// The prescription: cones, turnings and handles as exact integers. Values are immutable; every
// edit makes a new one, and undo keeps the old ones.

import type { Cones } from 'hgp';

export interface Cone {
  readonly vertex: number;
  readonly k: number;
  /** A triangle of the file: if repairs split the vertex, its copy in this triangle is meant. */
  readonly triangle?: number;
}

export interface Prescription {
  readonly q: number;
  readonly cones: readonly Cone[];
  /** By boundary loop; null: chosen by the solver so that Gauss–Bonnet holds. */
  readonly turnings: readonly (number | null)[];
  /** By handle generator; null: that of the smooth field. */
  readonly handles: readonly (number | null)[];
}

export const orders = { min: 1, max: 64 };

export function emptyPrescription(q: number, loops: number, generators: number): Prescription {
  const nothing = (count: number): null[] => Array.from({ length: count }, () => null);
  return { q, cones: [], turnings: nothing(loops), handles: nothing(generators) };
}

/** The prescription as hgp-cones, with positions if known, so that the file can be used after remeshing. */
export function toCones(prescription: Prescription, positions?: ArrayLike<number>): Cones {
  const position = (v: number): [number, number, number] | undefined =>
    positions && [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const listed = <T>(values: readonly (number | null)[], make: (i: number, n: number) => T): T[] =>
    values.flatMap((n, i) => (n === null ? [] : [make(i, n)]));
  return {
    q: prescription.q,
    cones: prescription.cones.map((cone) => ({ ...cone, position: position(cone.vertex) })),
    boundaries: listed(prescription.turnings, (loop, l) => ({ loop, l })),
    handles: listed(prescription.handles, (generator, r) => ({ generator, r })),
  };
}

export function fromCones(cones: Cones, loops: number, generators: number): Prescription {
  const made = emptyPrescription(cones.q, loops, generators);
  const turnings = [...made.turnings];
  const handles = [...made.handles];
  for (const { loop, l } of cones.boundaries ?? []) if (loop < loops) turnings[loop] = l;
  for (const { generator, r } of cones.handles ?? []) {
    if (generator < generators) handles[generator] = r;
  }
  return {
    q: cones.q,
    cones: cones.cones.map(({ vertex, k, triangle }: Cone) => ({
      vertex,
      k,
      ...(triangle === undefined ? {} : { triangle }),
    })),
    turnings,
    handles,
  };
}

/** Cones along features: turnings and handles are those of the field of these cones, and others where a cone is moved. */
export const alongFeatures = ({ q, cones }: Cones): Cones => ({ q, cones });

/** The prescription with all indices multiplied by q′/q; undefined if one is then not an integer. */
export function withOrder(prescription: Prescription, q: number): Prescription | undefined {
  const convert = (n: number): number => (n * q) / prescription.q;
  const cones = prescription.cones.map((cone) => ({ ...cone, k: convert(cone.k) }));
  const turnings = prescription.turnings.map((l) => (l === null ? null : convert(l)));
  const handles = prescription.handles.map((r) => (r === null ? null : convert(r)));
  const all = [...cones.map(({ k }) => k), ...turnings, ...handles];
  if (!all.every((n) => n === null || Number.isInteger(n))) return undefined;
  return { q, cones, turnings, handles };
}

const sameList = <T>(a: readonly T[], b: readonly T[], isSame: (x: T, y: T) => boolean): boolean =>
  a === b || (a.length === b.length && a.every((x, i) => isSame(x, b[i])));

export function samePrescription(a: Prescription, b: Prescription): boolean {
  if (a === b) return true;
  return (
    a.q === b.q &&
    sameList(
      a.cones,
      b.cones,
      (x, y) => x.vertex === y.vertex && x.k === y.k && x.triangle === y.triangle,
    ) &&
    sameList(a.turnings, b.turnings, Object.is) &&
    sameList(a.handles, b.handles, Object.is)
  );
}

/** Whether nothing is prescribed. */
export const isSilent = ({ cones, turnings, handles }: Prescription): boolean =>
  cones.length === 0 && [...turnings, ...handles].every((n) => n === null);

/** "+1/4" instead of "¼", which screen readers pronounce badly. */
export function indexText(k: number, q: number): string {
  let [n, d] = [q - k, q];
  if (n === 0) return '0';
  const gcd = (a: number, b: number): number => (b === 0 ? Math.abs(a) : gcd(b, a % b));
  const common = gcd(n, d);
  [n, d] = [n / common, d / common];
  const sign = n > 0 ? '+' : '−';
  return d === 1 ? `${sign}${Math.abs(n)}` : `${sign}${Math.abs(n)}/${d}`;
}

export function angleText(k: number, q: number): string {
  const degrees = (360 * k) / q;
  return `${Number.isInteger(degrees) ? degrees : degrees.toFixed(1)}°`.replace('-', '−');
}
