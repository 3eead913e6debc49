// The solver itself, synchronous: for use inside your own worker. The JSON documents are those of the
// command line; their types are made from the schemas in hgp/schema.

import type { Certificate, CheckReport, ModelInfo, Report, Where as Places } from './documents.js';

export type { Certificate, CheckReport, ModelInfo, Report } from './documents.js';

/** A place on the mesh (ids of the surface) or in the file. */
export type Where = Places[number];

export interface InitOptions {
  /** Where hgp.wasm is; by default in this package. In Node also a path. */
  wasmUrl?: string | URL;
  wasmBinary?: BufferSource;
  wasmModule?: WebAssembly.Module;
}

/** A File or Blob, or the bytes of one; gzip is decompressed. */
export type FileSource = File | Blob | ArrayBuffer | ArrayBufferView;

/** Relative names only; `main` is one of them. */
export interface FileSet {
  main: string;
  files: Map<string, FileSource> | Record<string, FileSource>;
}

export interface LoadOptions {
  /** Name of the file, for sources without one; its extension helps to recognise the format. */
  name?: string;
  /** Which mesh of the file; by default the one with most triangles. */
  surface?: number;
  /**
   * Join vertices closer than this; by default what the format needs, and vertices at equal positions
   * where every face is a component of its own.
   */
  weld?: number;
  /** Larger files end with the code `limit`; by default 2 GiB and 16 million triangles. */
  limits?: { bytes?: number; triangles?: number };
  /** Make exactly these repairs; by default those that the defects of the mesh need. */
  fix?: { orient?: boolean; split?: boolean; degenerate?: boolean };
  /** Make no repairs; refuse a mesh that needs one. */
  strict?: boolean;
  /**
   * Write repairs into the file: flipped faces and copies of split vertices. Otherwise faces and
   * vertices are unchanged, and the certificate counts the differences. Ids are those of the repaired
   * file: vertices keep theirs, copies follow.
   */
  writeRepairs?: boolean;
  /**
   * Convert the file to this format when it is read, so that write() writes it: a GLB of OBJ, OFF, PLY, STL or
   * .gltf, an OBJ of glTF. Notes say what is not kept.
   */
  target?: 'obj' | 'glb' | 'gltf';
}

/** The LoadOptions that apply to a mesh given as arrays. */
export interface MeshLoadOptions {
  /**
   * Join vertices closer than this; by default 0, those at the same place, as renderers split vertices
   * along normals and texture coordinates. `false`: the triangles share just the vertices they name.
   */
  weld?: number | false;
  limits?: LoadOptions['limits'];
  fix?: LoadOptions['fix'];
  strict?: LoadOptions['strict'];
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

/** hgp-cones: cone angles are 2πk/q, turning angles 2πl/q, handle rotations 2πr/q. */
export interface Cones {
  q: number;
  cones: { vertex: number; k: number; position?: [number, number, number] }[];
  boundaries?: { loop: number; l: number; anchor?: number }[];
  handles?: { generator: number; r: number }[];
}

/** The surface that vertex and triangle ids refer to. */
export interface Surface {
  /** Three per vertex. */
  positions: Float64Array;
  /** Three vertices per triangle. */
  triangles: Uint32Array;
  /** The surface after weld and repairs, if they changed anything; this one is solved. */
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
  /** Number of cones; by default as `conesFor` says. A note says so where that number is not possible. */
  count?: number;
  /**
   * `balanced` (default): low distortion, and the map follows boundaries. `few`: as few as keep areas within a
   * factor of about two. `low-distortion`: as many as lower distortion noticeably, with free boundary turning.
   */
  conesFor?: 'balanced' | 'few' | 'low-distortion';
  alignToCurvature?: boolean;
}

export interface SolveOptions extends SuggestOptions {
  /** Chosen automatically if absent. */
  cones?: Cones;
  /** A direction field (.rawfield, .rosy, .ffield): determines what `cones` leave open; must have these cones. */
  field?: ConeFile;
  /**
   * `auto`: a smooth field that hgp computes with the prescribed cones, turning and handles. `file`: the directions
   * of `field`, which must have exactly these; otherwise the call rejects with `prescription` or, where there
   * is no field with directions, with `usage`.
   */
  frames?: 'auto' | 'file';
  /** `convex`: a disk without cones onto a convex polygon. */
  boundary?: 'free' | 'convex';
  maxRounds?: number;
  /**
   * `auto`: soft frame constraints where they suffice, then hard ones along the frames of the connection and of an
   * angle structure, then untangling.
   * `harmonic`: hard constraints. `soft`: soft ones. `printed`: program and iteration as printed in the paper.
   * `all-frames`: hard constraints on every triangle.
   */
  method?: 'auto' | 'harmonic' | 'soft' | 'printed' | 'all-frames';
  /**
   * Lower the distortion of a certified map; the result is again certified. `isometric` (angles and areas), `conformal`
   * (angles), `area`, or a number on the line from -1 (angles) through 0 (isometric) to 1 (areas).
   */
  improve?: 'isometric' | 'conformal' | 'area' | number;
  /** The same as `improve: 'isometric'`. */
  quality?: boolean;
  /**
   * A component without a map keeps its uv, or is cut open to a disk, instead of ending the call; the map
   * as a whole is then not certified, and write() needs `allowUncertified`.
   */
  keepGoing?: boolean;
  scale?: 'solved' | 'unit' | 'fit';
  /**
   * Where there is no map, split edges and solve again. The result's `positions`, `triangles` and files are
   * then of the refined mesh, in which vertices keep their ids; `report.refined` says what was split.
   * A refined result is written as OBJ.
   */
  refine?: boolean;
  /**
   * Align the map to a grid (q = 2 or 4): every translation an integer, one cell per unit of uv, so that
   * lines meet at every seam. About `cells` cells in all, or cells of edge length `spacing`; `quad`: cones on grid
   * points as well. Where no aligned map is found, the result is the map without a grid, and
   * `report.components[].grid` says why and how many cells would work.
   */
  grid?: { cells?: number; spacing?: number; mode?: 'tile' | 'quad' };
}

/** Measurements of the result per triangle and per seam edge, in the order of `triangles` and `seams`. */
export interface Measures {
  /** Ratio of the singular values of the derivative, at least 1; 1 preserves angles. */
  stretch: Float32Array;
  /** log₂ of uv area per surface area, minus that of all triangles together. */
  area: Float32Array;
  /** Triangles that are flipped or have no area in the map, of those that the certificate covers. */
  flipped: Uint32Array;
  surfaceArea: number;
  uvArea: number;
  /** Triangles that share area of the plane and no uv, which is allowed; `isMore`: counting stopped. */
  overlaps: { pairs: number; triangles: Uint32Array; isMore: boolean };
  /** For each seam edge: the number of the seam that it is part of. */
  seamChains: Uint32Array;
}

/** Facts on the surface as it is solved (after weld and repairs), with the ids of the file. */
export interface SurfaceFacts {
  /** The vertex that a vertex was joined with, in most cases itself; −1 where a repair removed it. */
  representative: Int32Array;
  /** Sum of the triangle angles at each vertex, in radians. */
  angle: Float64Array;
  /** Triangles at each vertex; the most, where a repair made several of it. */
  valence: Uint32Array;
  /** 1 on the boundary. */
  isBoundary: Uint8Array;
  /** Connected component of each vertex, in the order of `ModelInfo.components`; −1 without triangles. */
  component: Int32Array;
  /** The same of each triangle; −1 where a repair left it out. */
  triangleComponent: Int32Array;
  /** Neighbours of v: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1]. */
  neighbourStart: Uint32Array;
  neighbours: Uint32Array;
  /** Of all triangles, in the square of the file's unit. */
  area: number;
}

/** As a prescription numbers them (`boundaries[].loop`, `handles[].generator`). */
export interface Loops {
  /** Vertices in order, the surface on their left. */
  boundaries: Uint32Array[];
  /** Two vertices for each edge that the generator crosses, in order: a closed walk over triangles. */
  handles: Uint32Array[];
}

/** The name says the format: .obj for quads, .glb for triangles to look at. */
export interface QuadOptions {
  name?: string;
}

export interface Quads {
  name: string;
  bytes: Uint8Array;
  vertices: number;
  quads: number;
  /** Cells that a boundary cuts: left out. */
  clipped: number;
  /** How often cells were cut into four, so that no two edges have the same ends. */
  halvings: number;
  /** Pairs of vertices that more than one edge of uncut cells joins, around handles and cones one or two cells apart. */
  multipleEdges: number;
  /** At cones of k = 1: their only quad has two of its edges in common. */
  foldedQuads: number;
}

export interface VerifyOptions {
  cones?: Cones;
  /** As in SolveOptions. */
  field?: ConeFile;
  q?: number;
  uvSet?: number;
  /** Of each seam edge's own length, and radians for angles; 1e-6 where none is given. */
  tolerance?: number;
}

export interface WriteOptions {
  /**
   * `same`: the original with the map, and nothing else changed. `glb`, `gltf`, `obj`: the mesh on its own, its
   * uv snapped to the numbers of that format and verified again. `flat-obj`: the map laid flat. `svg`: its edges.
   */
  format?: 'same' | 'glb' | 'gltf' | 'obj' | 'flat-obj' | 'svg';
  /** glTF, OBJ: a grid as the material, so many tiles per unit of uv; `true`: as many as can be seen. */
  gridMaterial?: boolean | number;
  uvSet?: number;
  name?: string;
  embedCones?: boolean;
  allowUncertified?: boolean;
  /** glTF: the materials' pictures use the set that is written; without it a note says which they use. */
  use?: boolean;
}

/** What parametrizeFile() takes: of load, of parametrize and, in `write`, of write. */
export interface FileOptions
  extends
    Omit<LoadOptions, 'surface'>,
    Omit<SolveOptions, 'cones' | 'field' | 'frames' | 'refine'> {
  write?: Omit<WriteOptions, 'format'>;
}

/** What became of one mesh: its report, or why it has no map. */
export interface MeshOutcome {
  mesh: number;
  certified: boolean;
  report?: Report;
  error?: { code: HgpErrorCode; message: string; stage?: string; where?: Where[] };
}

export interface FileResult {
  /** Every mesh. */
  certified: boolean;
  meshes: MeshOutcome[];
  /**
   * The file with all maps, the main one first. Empty where a mesh is not certified, unless `keepGoing` or
   * `write.allowUncertified` were given.
   */
  files: { name: string; bytes: Uint8Array }[];
  /** Of the main file, where there is one. */
  name?: string;
  bytes?: Uint8Array;
  notes: string[];
}

export interface Progress {
  stage: string;
  /** Of the stage, 0 to 1. */
  fraction: number;
  /** Of the solver or the improvement; -1 outside. */
  iteration: number;
  /** Of the solver relative to its target; where an energy descends (stages `improve` and `align`) its excess over an isometry; -1 outside. */
  residual: number;
  /** Of solve, verify, repair: from 1 to at most maxRounds; both are 0 outside it. */
  round: number;
  maxRounds: number;
  /** In parametrizeFile(): which mesh, of how many. */
  mesh?: number;
  meshes?: number;
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
  /** Three per vertex. */
  positions: ArrayLike<number>;
  /** Three vertices per triangle; left out: every three vertices are one. */
  triangles?: ArrayLike<number> | null;
}

export interface Written {
  name: string;
  bytes: Uint8Array;
  /** All files, the main one first. */
  files: { name: string; bytes: Uint8Array }[];
  notes: string[];
  /** Written vertex → stored vertex; empty when they are the same. */
  xref: Int32Array;
  /** Whether the numbers in the file are certified: formats round differently. */
  certified: boolean;
}

/** Files as bytes; `main` is one of their names. */
export interface CoreFiles {
  main: string;
  files: Map<string, Uint8Array>;
  /** What prepare() found out about the files; first among the notes of load(). */
  notes?: string[];
}

export class Core {
  onProgress?: (progress: Progress) => boolean | void;
  readonly version: string;
  /** Bytes of linear memory in use; it never shrinks. */
  readonly memory: number;
  /** Makes the engine optimize the solver (about 0.3 s), so that the first solve is not slow. */
  warmUp(): void;
  /**
   * Before load(), which waits for nothing: decompresses gzip, and loads the decoders of compressed
   * glTF. Resolves to the files to load.
   */
  prepare(source: CoreFiles, options?: LoadOptions): Promise<CoreFiles>;
  load(source: CoreFiles, options?: LoadOptions): ModelInfo;
  loadMesh(mesh: MeshArrays, options?: MeshLoadOptions): ModelInfo;
  inspect(): ModelInfo;
  surface(): Surface;
  readCones(file: ConeFile): Cones;
  embeddedCones(): Cones | null;
  suggestCones(options?: SuggestOptions): Cones;
  check(cones: Cones): CheckReport;
  parametrize(options?: SolveOptions): Result;
  /** Every mesh of a file, which prepare() has made ready; afterwards the file itself is loaded. */
  parametrizeFile(source: CoreFiles, options?: FileOptions): FileResult;
  verify(options?: VerifyOptions): Certificate;
  write(options?: WriteOptions): Written;
  measure(): Measures;
  keep(name: string): void;
  recall(name: string): boolean;
  facts(): SurfaceFacts;
  loops(): Loops;
  /** The cells of a map aligned in quad mode; rejects with `no-map` where it is not. */
  quads(options?: QuadOptions): Quads;
  free(): void;
}

export function compile(options?: InitOptions): Promise<WebAssembly.Module>;
export function createCore(options?: InitOptions): Promise<Core>;
