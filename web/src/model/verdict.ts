// The verdict on a map: the rows of the certificate. Banner, status, page state and Download are derived from
// these rows; each row's tick is computed from the number that the row shows.

import type { Certificate, Where } from 'hgp';
import type { SmallestArea } from './measures';
import type { Solution } from './types';

export interface VerdictRow {
  name: string;
  value: string;
  tolerance: string;
  isGood: boolean;
  /** Whether the row is information only and does not affect the verdict. */
  isFact?: boolean;
  where: Where[];
}

interface ComponentCertificate {
  orientation?: { notPositive?: number[] };
  angles?: { worstVertex?: number; worstDistance?: number };
  wrongCones?: { vertex: number }[];
  distortion?: Record<string, number>;
  seams?: { worstEdge?: number[]; worstResidual?: number };
  turnings?: unknown[];
  reasons?: { message: string; where?: Where[] }[];
}

export const componentsOf = ({ components }: Certificate): ComponentCertificate[] => components;

/** "1.2e−7" */
export const shortNumber = (x: number): string =>
  x === 0 ? '0' : x.toExponential(1).replace('e+0', '').replaceAll('-', '−');

/** The id of the largest measure in the file, over all components; −1 where none has an id. */
function foremost(
  components: ComponentCertificate[],
  of: (one: ComponentCertificate) => { id?: number; measure: number },
): number {
  let worst = { id: -1, measure: -Infinity };
  for (const one of components) {
    const { id = -1, measure } = of(one);
    if (id >= 0 && (worst.id < 0 || measure > worst.measure)) worst = { id, measure };
  }
  return worst.id;
}

const triangles = (ids: Iterable<number>): Where[] =>
  Array.from(ids, (id): Where => ({ kind: 'triangle', id }));

function orientationRows({ result, smallestArea, distortion }: Solution): VerdictRow[] {
  const { certificate } = result;
  const components = componentsOf(certificate);
  const reported = components.flatMap(({ orientation }) => orientation?.notPositive ?? []);
  const folded = reported.length > 0 ? reported : distortion.flipped;
  const smallest = foremost(components, ({ distortion: d }) => ({
    id: d?.smallestTriangle,
    measure: -(d?.smallestToMeanArea ?? Infinity),
  }));
  return [
    {
      name: 'Flipped triangles',
      value: `${certificate.flipped} of ${certificate.triangles}`,
      tolerance: 'exactly 0, exact sign',
      isGood: certificate.flipped === 0,
      where: folded.length > 0 ? triangles(folded) : triangles(smallest < 0 ? [] : [smallest]),
    },
    areaRow(certificate, smallestArea),
    ...outsideRow(certificate),
  ];
}

/**
 * The areas of the triangles as stored in the file. As many may be zero or negative as the certificate counts as
 * reversed, as duplicates or as without area in space, but no more.
 */
function areaRow({ stored }: Certificate, found: SmallestArea): VerdictRow {
  const { negative, zero, area, smallestPositive, mean, triangle } = found;
  const isCounted =
    negative <= stored.reversed + stored.duplicates && zero <= stored.zeroArea + stored.duplicates;
  const smallest = isCounted ? smallestPositive : area;
  const isGood = smallest > 0 && Number.isFinite(smallest);
  return {
    name: 'Smallest area',
    value: shortNumber(smallest),
    tolerance: `of the stored triangles, above 0; the mean is ${shortNumber(mean)}`,
    isGood,
    where: triangles(triangle < 0 || isGood ? [] : [triangle]),
  };
}

/** Triangles of the file that were verified with another orientation, or not at all. */
function outsideRow({ stored }: Certificate): VerdictRow[] {
  const { triangles: all, verified, duplicates, zeroArea, reversed, splitVertices } = stored;
  const counts: [number, string, string][] = [
    [reversed, 'wound the other way in the file', 'wound the other way in the file'],
    [duplicates, 'a copy of another', 'copies of others'],
    [zeroArea, 'without area', 'without area'],
    [splitVertices, 'vertex verified as several', 'vertices verified as several'],
  ];
  const told = counts
    .filter(([count]) => count > 0)
    .map(([count, one, more]) => `${count} ${count === 1 ? one : more}`);
  if (told.length === 0) return [];
  const value = `${verified} of ${all} verified`;
  const isGood = verified === all;
  return [
    {
      name: 'Triangles in the file',
      value,
      tolerance: told.join(', '),
      isGood,
      isFact: true,
      where: [],
    },
  ];
}

function turningRow({ certificate }: Solution['result']): VerdictRow[] {
  if (!componentsOf(certificate).some(({ turnings }) => (turnings?.length ?? 0) > 0)) return [];
  return [
    {
      name: 'Boundary turning',
      value: `${certificate.wrongTurnings} wrong`,
      tolerance: `off by ≤ ${shortNumber(certificate.maxTurningDistance)} rad`,
      isGood: certificate.wrongTurnings === 0,
      where: [],
    },
  ];
}

function angleRows({ result: { certificate }, prescription }: Solution): VerdictRow[] {
  const components = componentsOf(certificate);
  const wrongCones = components.flatMap((one) => one.wrongCones ?? []);
  const worst = foremost(components, ({ angles }) => ({
    id: angles?.worstVertex,
    measure: angles?.worstDistance ?? 0,
  }));
  const wrongRegular = certificate.wrongAngles - wrongCones.length;
  return [
    {
      name: 'Regular vertices',
      value: `${wrongRegular} wrong`,
      tolerance: 'every angle sum is 360°',
      isGood: wrongRegular === 0,
      where: worst < 0 ? [] : [{ kind: 'vertex', id: worst }],
    },
    {
      name: 'Cone angles',
      value: `${wrongCones.length} of ${prescription.cones.length} wrong`,
      tolerance: `off by ≤ ${shortNumber(certificate.maxConeDistance)} rad`,
      isGood: wrongCones.length === 0,
      where: wrongCones.map(({ vertex: id }) => ({ kind: 'vertex', id })),
    },
  ];
}

function seamRows({ certificate }: Solution['result']): VerdictRow[] {
  const { brokenSeams, seamEdges, maxSeamResidual, seamTolerance } = certificate;
  const [edge] = componentsOf(certificate)
    .flatMap(({ seams }) => (seams?.worstEdge?.length === 2 ? [seams] : []))
    .sort((a, b) => (b.worstResidual ?? 0) - (a.worstResidual ?? 0))
    .map(({ worstEdge = [] }) => worstEdge);
  return [
    {
      name: 'Seams',
      value: `${brokenSeams} broken of ${seamEdges}`,
      tolerance: `${shortNumber(maxSeamResidual)} ≤ ${shortNumber(seamTolerance)} of its length`,
      isGood: brokenSeams === 0,
      where: edge ? [{ kind: 'edge', id: edge[0], other: edge[1] }] : [],
    },
  ];
}

/** Whether both sides of all seams agree exactly, which a certified map does not require. */
function exactRow({ certificate }: Solution['result']): VerdictRow[] {
  const { exactSeams, seamEdges, q } = certificate;
  const exactly = q % 3 === 0 ? 'as points of a triangular lattice' : 'bit for bit';
  if (exactSeams === null || exactSeams === undefined || seamEdges === 0) return [];
  const value = `${exactSeams} of ${seamEdges}`;
  const isGood = exactSeams === seamEdges;
  const { integerSeams } = certificate;
  const whole = `${integerSeams ?? 0} of ${seamEdges}`;
  return [
    { name: 'Exact seams', value, tolerance: exactly, isGood, isFact: true, where: [] },
    {
      name: 'Lines meet',
      value: whole,
      tolerance: 'seams shifted by whole cells',
      isGood: integerSeams === seamEdges,
      isFact: true,
      where: [],
    },
  ];
}

/** Whether the number type can resolve the range of areas. */
function rangeRow({ certificate }: Solution['result']): VerdictRow[] {
  if (certificate.usable) return [];
  const tolerance = `they span more than ${certificate.precision} resolves`;
  return [
    { name: 'Areas in the file', value: 'too far apart', tolerance, isGood: false, where: [] },
  ];
}

/** Whether a reader that shares no code with the writer found the certified map in the written bytes. */
function readBackRow({ isSameAsFile, difference, written }: Solution): VerdictRow {
  return {
    name: 'The file holds this map',
    value: isSameAsFile ? 'same map' : 'differs',
    tolerance: difference || `read back from ${(written.bytes.length / 1024).toFixed(0)} KB`,
    isGood: isSameAsFile,
    where: [],
  };
}

/** Reasons of the solver against the map that have no other row. */
function otherRow({ certificate }: Solution['result'], rows: VerdictRow[]): VerdictRow[] {
  if (certificate.certified || rows.some(({ isGood, isFact }) => !isGood && !isFact)) return [];
  const value = 'not passed';
  const tolerance = 'see the reasons below';
  return [{ name: 'All other checks', value, tolerance, isGood: false, where: [] }];
}

export function verdictRows(solution: Solution): VerdictRow[] {
  const { result } = solution;
  const rows = [
    ...orientationRows(solution),
    ...turningRow(result),
    ...angleRows(solution),
    ...seamRows(result),
    ...exactRow(result),
    ...rangeRow(result),
    readBackRow(solution),
  ];
  return [...rows, ...otherRow(result, rows)];
}

const known = new WeakMap<Solution, boolean>();

/** True if all rows are. */
export function isCertified(solution: Solution): boolean {
  let is = known.get(solution);
  if (is === undefined)
    known.set(solution, (is = verdictRows(solution).every((row) => row.isGood || row.isFact)));
  return is;
}

export const reasonsOf = ({ result }: Solution): { message: string; where?: Where[] }[] =>
  componentsOf(result.certificate).flatMap(({ reasons }) => reasons ?? []);
