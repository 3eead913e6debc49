// The numbers of a map, which its handles have as members.

import type { Certificate, Report } from './documents.js';
import type { Cones } from './options.js';
import type { Result, SolvedTriangles } from './results.js';

export class MapData implements Result {
  /** Three numbers per surface vertex. */
  readonly positions: Float64Array;
  /** Three surface vertices per triangle, as given: also those that repairs turn over or leave out. */
  readonly triangles: Uint32Array;
  /** Two numbers per uv vertex, v pointing up, rounded as the file will store them. */
  readonly uv: Float64Array;
  /** Three uv vertices per triangle. */
  readonly cornerToUv: Uint32Array;
  /** The triangles as solved; the same arrays, unless repairs turned triangles over or left some out. */
  readonly solved: SolvedTriangles;
  /** uv vertex → surface vertex. */
  readonly uvToVertex: Uint32Array;
  /** The two sides of each seam edge as uv vertices, and r: side b is side a rotated by 2πr/q and translated. */
  readonly seams: { a: [number, number]; b: [number, number]; r: number }[];
  readonly certificate: Certificate;
  readonly cones: Cones;
  readonly report: Report;
  /** Size of the solver's linear memory in bytes; it never shrinks. */
  readonly memory: number;

  /** @internal */
  constructor(result: Result) {
    this.positions = result.positions;
    this.triangles = result.triangles;
    this.uv = result.uv;
    this.cornerToUv = result.cornerToUv;
    this.solved = result.solved;
    this.uvToVertex = result.uvToVertex;
    this.seams = result.seams;
    this.certificate = result.certificate;
    this.cones = result.cones;
    this.report = result.report;
    this.memory = result.memory;
  }

  /**
   * The numbers alone.
   * @internal
   */
  get data(): Result {
    const { positions, triangles, uv, cornerToUv, solved, uvToVertex, seams } = this;
    const { certificate, cones, report, memory } = this;
    return {
      positions,
      triangles,
      uv,
      cornerToUv,
      solved,
      uvToVertex,
      seams,
      certificate,
      cones,
      report,
      memory,
    };
  }
}
