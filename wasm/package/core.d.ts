// The solver itself, synchronous: for use inside your own worker. The JSON documents are those of the
// command line; their schemas are in the repository under docs/schema.

export interface InitOptions {
  /** Where hgp.wasm is; by default beside this file. */
  wasmUrl?: string | URL;
  wasmBinary?: BufferSource;
  wasmModule?: WebAssembly.Module;
}

/** Relative names only; `main` is one of them. */
export interface FileSet {
  main: string;
  files: Map<string, Blob | Uint8Array>;
}

export interface LoadOptions {
  /** Name of the file where the source has none; its extension helps to tell formats apart. */
  name?: string;
  /** Which mesh of the file; by default the one with most triangles. */
  surface?: number;
  /** Join vertices closer than this; by default only what the format needs. */
  weld?: number;
  /** Larger files end with the code `limit`; by default 2 GiB and 16 million triangles. */
  limits?: { bytes?: number; triangles?: number };
  fix?: { orient?: boolean; split?: boolean; degenerate?: boolean };
}

export interface Where {
  kind: 'vertex' | 'edge' | 'triangle' | 'loop' | 'line' | 'byte';
  id: number;
  other?: number;
}

export type HgpErrorCode =
  | 'usage'
  | 'malformed'
  | 'unsupported'
  | 'prescription'
  | 'no-map'
  | 'write-failed'
  | 'limit'
  | 'internal'
  | 'cancelled'
  | 'worker-lost'
  | 'wasm-unavailable';

export class HgpError extends Error {
  constructor(failure: { code: string; message: string; stage?: string; where?: Where[] });
  readonly code: HgpErrorCode;
  readonly details: { stage?: string; where?: Where[] };
}

/** hgp-inspect */
export interface ModelInfo {
  usable: boolean;
  file: { name: string; format: string; bytes: number; sha256: string };
  surfaces: {
    index: number;
    name: string;
    vertices: number;
    storedVertices: number;
    welded: boolean;
    triangles: number;
    uvSets: number[];
    notes: string[];
  }[];
  surface: number;
  vertices: number;
  triangles: number;
  diagonal: number;
  defects: { kind: string; fatal: boolean; count: number; where: Where[] }[];
  notes: string[];
  /** Where the mesh is usable: */
  eulerCharacteristic?: number;
  genus?: number;
  boundaryLoops?: number;
  isolatedVertices?: number;
  components?: {
    component: number;
    vertices: number;
    edges: number;
    triangles: number;
    eulerCharacteristic: number;
    genus: number;
    handleGenerators: { first: number; count: number };
    boundaryLoops: {
      loop: number;
      vertices: number;
      anchor: number;
      length: number;
      turningAngle: number;
    }[];
  }[];
  /** Where it is not: */
  error?: { code: HgpErrorCode; stage: string; message: string; where: Where[] };
}

/** hgp-cones: cone angles are 2πk/q, turning angles 2πl/q, handle rotations 2πr/q. */
export interface Cones {
  q: number;
  cones: { vertex: number; k: number; position?: [number, number, number] }[];
  boundaries?: { loop: number; l: number; anchor?: number }[];
  handles?: { generator: number; r: number }[];
}

/** hgp-check: the budget of Gauss–Bonnet in exact integers. */
export interface CheckReport {
  valid: boolean;
  q?: number;
  components: {
    component: number;
    valid: boolean;
    automatic: boolean;
    genus: number;
    boundaryLoops: number;
    cones: number;
    budget: { have: number; need: number; left: number; openLoops: number } | null;
    warnings: string[];
    error?: ModelInfo['error'];
  }[];
  notes: string[];
  error?: ModelInfo['error'];
}

/** What vertex and triangle ids refer to. */
export interface Surface {
  /** Three per vertex. */
  positions: Float64Array;
  /** Three vertices per triangle. */
  triangles: Uint32Array;
  /** What a weld or repairs made of it, where they changed anything; this is what is solved. */
  repaired?: {
    triangles: Uint32Array;
    /** Its vertex → a vertex of the surface. */
    vertexOrigin: Int32Array;
    /** Vertex of the surface → its vertex, −1 where a repair removed it. */
    vertexImage: Int32Array;
  };
}

/** hgp-cones JSON, OBJ with `c` and `sm` lines, .sing, curvatures, Th_hat, .rawfield, .rosy, .ffield. */
export interface ConeFile {
  name: string;
  text: string;
  /** Where the file names no order. */
  q?: number;
}

export interface SuggestOptions {
  q?: number;
  /** Roughly how many; by default as many as the field has. */
  count?: number;
  alignToCurvature?: boolean;
}

export interface SolveOptions extends SuggestOptions {
  /** Without cones, they are chosen. */
  cones?: Cones;
  /** A direction field (.rawfield, .rosy, .ffield): it decides what `cones` leave open, and must have them. */
  field?: ConeFile;
  /**
   * `auto`: a smooth field of our own with the asked cones, turning and handles. `file`: the directions
   * of `field`, which must have them exactly; anything else rejects with `prescription` or, where there
   * is no field with directions, with `usage`.
   */
  frames?: 'auto' | 'file';
  /** `convex`: a disk without cones onto a convex polygon. */
  boundary?: 'free' | 'convex';
  maxRounds?: number;
  /** Lower distortion at the price of harmonicity. */
  quality?: boolean;
  scale?: 'solved' | 'unit' | 'fit';
}

export interface VerifyOptions {
  cones?: Cones;
  /** As in SolveOptions. */
  field?: ConeFile;
  q?: number;
  uvSet?: number;
  tolerance?: number;
}

export interface WriteOptions {
  uvSet?: number;
  name?: string;
  embedCones?: boolean;
  allowUncertified?: boolean;
}

export interface Progress {
  stage: string;
  /** Of the stage, 0 to 1. */
  fraction: number;
  /** Of the solver; -1 outside it, and so is the residual. */
  iteration: number;
  residual: number;
  /** Of solve, judge, repair: from 1 to at most maxRounds; both are 0 outside it. */
  round: number;
  maxRounds: number;
}

/** hgp-certificate: what was measured on the map as it is stored. */
export interface Certificate {
  certified: boolean;
  usable: boolean;
  q: number;
  precision: 'float32' | 'float64';
  triangles: number;
  flipped: number;
  wrongAngles: number;
  wrongTurnings: number;
  seamEdges: number;
  brokenSeams: number;
  maxConeDistance: number;
  maxTurningDistance: number;
  maxSeamResidual: number;
  seamTolerance: number;
  components: Record<string, unknown>[];
}

/** hgp-report: options, input, rounds of the solver, times; contains cones and certificate. */
export interface Report {
  program: { name: string; version: string };
  certified: boolean;
  input: Record<string, unknown>;
  options: Record<string, unknown>;
  seconds: number;
  notes: string[];
  components: Record<string, unknown>[];
  cones: Cones;
  certificate: Certificate;
}

export interface Result {
  /** Three per surface vertex. */
  positions: Float64Array;
  /** Three surface vertices per triangle. */
  triangles: Uint32Array;
  /** Two per uv vertex, v pointing up, rounded as the file will store them. */
  uv: Float64Array;
  /** Three uv vertices per triangle. */
  cornerToUv: Uint32Array;
  /** uv vertex → surface vertex. */
  uvToVertex: Uint32Array;
  /** The two sides of each seam edge as uv vertices, and r: side b is side a turned by 2πr/q. */
  seams: { a: [number, number]; b: [number, number]; r: number }[];
  certificate: Certificate;
  cones: Cones;
  report: Report;
  /** Bytes of linear memory that were in use at most; it never shrinks. */
  memory: number;
}

export interface MeshArrays {
  positions: ArrayLike<number> & (Float32Array | Float64Array);
  triangles: Uint32Array | Uint16Array | Int32Array;
}

export interface Written {
  name: string;
  bytes: Uint8Array;
  /** All files, the main one first. */
  files: { name: string; bytes: Uint8Array }[];
  notes: string[];
  /** Written vertex → stored vertex; empty when they are the same. */
  xref: Int32Array;
}

export class Core {
  onProgress?: (progress: Progress) => boolean | void;
  readonly version: string;
  /** Bytes of linear memory in use; it never shrinks. */
  readonly memory: number;
  /** Makes the engine optimize the solver (about 0.3 s), so that the first solve is not slow. */
  warmUp(): void;
  /** Loads the decoders of compressed glTF, where the file needs any. Before load(). */
  prepare(source: { main: string; files: Map<string, Uint8Array> }): Promise<void>;
  load(source: { main: string; files: Map<string, Uint8Array> }, options?: LoadOptions): ModelInfo;
  loadMesh(mesh: MeshArrays, options?: LoadOptions): ModelInfo;
  inspect(): ModelInfo;
  surface(): Surface;
  readCones(file: ConeFile): Cones;
  embeddedCones(): Cones | null;
  suggestCones(options?: SuggestOptions): Cones;
  check(cones: Cones): CheckReport;
  parametrize(options?: SolveOptions): Result;
  verify(options?: VerifyOptions): Certificate;
  write(options?: WriteOptions): Written;
  free(): void;
}

export function compile(options?: InitOptions): Promise<WebAssembly.Module>;
export function createCore(options?: InitOptions): Promise<Core>;
