// The solver itself, synchronous: for use inside your own worker. The JSON documents are those of the
// command line; their types are generated from the schemas in hgp/schema.

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
  /** Which mesh of the file; by default the one with the most triangles. */
  surface?: number;
  /**
   * Join vertices closer than this, in the file's unit. By default vertices at equal positions are joined where the
   * format requires it (glTF, STL), and in other formats if no two faces share a vertex.
   */
  weld?: number;
  /** Larger files are refused with the code `limit`; by default 2 GiB and 16 million triangles. */
  limits?: { bytes?: number; triangles?: number };
  /** Make exactly these repairs; by default those that the defects of the mesh need. */
  fix?: { orient?: boolean; split?: boolean; degenerate?: boolean };
  /** Make no repairs, and refuse a mesh that needs one. */
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
   * Join vertices closer than this. By default 0: vertices at equal positions are joined, because renderers split
   * vertices where normals or texture coordinates differ. `false`: vertices are not joined.
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

/** hgp-cones: cone angles 2πk/q, turning angles of boundary loops 2πl/q, rotations along handles 2πr/q. */
export interface Cones {
  q: number;
  cones: { vertex: number; k: number; position?: [number, number, number] }[];
  boundaries?: { loop: number; l: number; anchor?: number }[];
  handles?: { generator: number; r: number }[];
}

/** The loaded surface, to which vertex and triangle ids refer. */
export interface Surface {
  /** Three numbers per vertex, in the file's unit. */
  positions: Float64Array;
  /** Three vertices per triangle. */
  triangles: Uint32Array;
  /** The surface after welds and repairs, which is the one solved; absent if they changed nothing. */
  repaired?: {
    /** Three of its vertices per triangle. */
    triangles: Uint32Array;
    /** Its vertex → a vertex of the surface. */
    vertexOrigin: Int32Array;
    /** Vertex of the surface → its vertex; −1 if a repair removed it. */
    vertexImage: Int32Array;
  };
}

/** A file of cones or of a field: hgp-cones JSON, OBJ with `c` and `sm` lines, .sing, curvatures, Th_hat, .rawfield,
 * .rosy, .ffield. */
export interface ConeFile {
  name: string;
  text: string;
  /** The order q, for files that do not state one; by default 4. */
  q?: number;
}

export interface SuggestOptions {
  q?: number;
  /** Number of cones; by default chosen by `conesFor`. A note says so if this number is not possible. */
  count?: number;
  /**
   * `balanced` (default): low distortion, and the map follows boundaries. `few`: as few as keep areas within a
   * factor of about two. `low-distortion`: as many as lower distortion noticeably, with free boundary turning.
   */
  conesFor?: 'balanced' | 'few' | 'low-distortion';
  /** Align the field that determines the cones to principal curvature directions; q must be even. */
  alignToCurvature?: boolean;
}

export interface SolveOptions extends SuggestOptions {
  /** Chosen automatically if absent. */
  cones?: Cones;
  /** A direction field (.rawfield, .rosy, .ffield): it determines what `cones` leave open, and must have these cones. */
  field?: ConeFile;
  /**
   * Frames of the map. `auto`: a smooth field that hgp computes with the prescribed cones, turnings and rotations.
   * `file`: the directions of `field`, which must have exactly these; otherwise the call fails with `prescription`,
   * or with `usage` if there is no field with directions.
   */
  frames?: 'auto' | 'file';
  /** `convex`: maps a disk without cones onto a convex polygon. */
  boundary?: 'free' | 'convex';
  /** Maximum number of programs per component; by default 24. */
  maxRounds?: number;
  /**
   * `auto`: soft frame constraints if they suffice, then hard ones with the frames of the connection and of an angle
   * structure, then untangling.
   * `harmonic`: hard constraints on triangles at cones and boundary. `soft`: soft ones. `printed`: program and
   * iteration as printed in the paper. `all-frames`: hard constraints on every triangle.
   */
  method?: 'auto' | 'harmonic' | 'soft' | 'printed' | 'all-frames';
  /**
   * Lower the distortion of a certified map; the result is again certified. `isometric` (angles and areas), `conformal`
   * (angles), `area`, or a number from -1 (angles) through 0 (isometric) to 1 (areas).
   */
  improve?: 'isometric' | 'conformal' | 'area' | number;
  /** The same as `improve: 'isometric'`. */
  quality?: boolean;
  /**
   * If a component has no map, do not fail: it keeps its uv or is cut open to a disk. The map
   * as a whole is then not certified, and write() needs `allowUncertified`.
   */
  keepGoing?: boolean;
  /** `solved`: as solved. `unit`: mean uv edge length 1. `fit`: scaled uniformly into [0, 1]². */
  scale?: 'solved' | 'unit' | 'fit';
  /**
   * If no map is found, split edges and solve again. `positions` and `triangles` of the result, and written files, are
   * then those of the refined mesh, in which vertices keep their ids; `report.refined` says what was split.
   * A refined result is written as OBJ.
   */
  refine?: boolean;
  /**
   * Align the map to a grid (q = 2 or 4): all translations of seams become integers, with one cell per unit of uv, so
   * that grid lines meet at every seam. About `cells` cells in total, or cells of edge length `spacing` in the file's
   * unit; `quad`: cones lie on grid points as well. If no aligned map is found, the result is the map without a grid,
   * and `report.components[].grid` says why and how many cells would work.
   */
  grid?: { cells?: number; spacing?: number; mode?: 'tile' | 'quad' };
}

/** Measurements of the result per triangle and per seam edge, in the order of `triangles` and `seams`. */
export interface Measures {
  /** Ratio of the singular values of the derivative, at least 1; 1 preserves angles. */
  stretch: Float32Array;
  /** log₂ of uv area per surface area, minus that of all triangles together. */
  area: Float32Array;
  /** Triangles covered by the certificate that are flipped or have no area in the map. */
  flipped: Uint32Array;
  /** Total area of the triangles on the surface, in the file's unit squared. */
  surfaceArea: number;
  /** Total area of the triangles in the map, in absolute values. */
  uvArea: number;
  /** Triangles that overlap in the plane and share no uv, which is allowed; `isMore`: counting stopped early. */
  overlaps: { pairs: number; triangles: Uint32Array; isMore: boolean };
  /** For each seam edge, the number of the seam to which it belongs. */
  seamChains: Uint32Array;
}

/** Facts about the surface as it is solved (after welds and repairs), in ids of the file. */
export interface SurfaceFacts {
  /** The vertex with which a vertex was joined, or itself; −1 if a repair removed it. */
  representative: Int32Array;
  /** Sum of the triangle angles at each vertex, in radians. */
  angle: Float64Array;
  /** Number of triangles at each vertex; the maximum over its copies if a repair split it. */
  valence: Uint32Array;
  /** 1 for vertices on the boundary; for a split vertex, if all copies are. */
  isBoundary: Uint8Array;
  /** Connected component of each vertex, in the order of `ModelInfo.components`; −1 for vertices without triangles. */
  component: Int32Array;
  /** Connected component of each triangle; −1 if a repair left it out. */
  triangleComponent: Int32Array;
  /** Neighbours of v: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1]. */
  neighbourStart: Uint32Array;
  neighbours: Uint32Array;
  /** Total area of the triangles, in the file's unit squared. */
  area: number;
}

/** Boundary loops and handle generators, in the order of the numbers `boundaries[].loop` and `handles[].generator`. */
export interface Loops {
  /** Vertices in order, the surface on their left. */
  boundaries: Uint32Array[];
  /** Two vertices for each edge that the generator crosses, in order along a closed walk over triangles. */
  handles: Uint32Array[];
}

export interface QuadOptions {
  /** File name, whose extension determines the format: .obj for quads, .glb for triangles, for viewing. */
  name?: string;
}

export interface Quads {
  name: string;
  bytes: Uint8Array;
  vertices: number;
  quads: number;
  /** Number of cells that the boundary cuts; they are left out. */
  clipped: number;
  /** How often all cells were divided into four, so that no two edges have the same end vertices. */
  halvings: number;
  /** Pairs of vertices that several edges joined before cells were divided, around short handles and close cones. */
  multipleEdges: number;
  /** Quads that are the only one at a cone with k = 1, so that two of their edges coincide. */
  foldedQuads: number;
}

export interface VerifyOptions {
  /** The prescription that the map must have; by default any cones are accepted. */
  cones?: Cones;
  /** As in SolveOptions. */
  field?: ConeFile;
  /** Order of the rotations, if no cones are given; by default 4. */
  q?: number;
  /** The uv set to verify; by default the last one. */
  uvSet?: number;
  /** Tolerance of seams, relative to the length of each seam edge, and of angles in radians; by default 1e-6. */
  tolerance?: number;
}

export interface WriteOptions {
  /**
   * `same` (default): the original file with the map, otherwise unchanged. `glb`, `gltf`, `obj`: the mesh alone; its
   * uv are snapped to the numbers of that format and verified again. `flat-obj`: the map as a flat mesh. `svg`: the
   * edges of the map as a drawing.
   */
  format?: 'same' | 'glb' | 'gltf' | 'obj' | 'flat-obj' | 'svg';
  /** glTF, OBJ: a grid as the material, with this number of tiles per unit of uv; `true`: a suitable number. */
  gridMaterial?: boolean | number;
  /** The uv set to write, replaced if it exists; by default the one after the last. */
  uvSet?: number;
  /** File name of the result. */
  name?: string;
  /** Store the cones in the file, for use when it is loaded again. */
  embedCones?: boolean;
  /** Write a map that is not certified; otherwise the call fails with `no-map`. */
  allowUncertified?: boolean;
  /** glTF: make the materials' textures use the written set; otherwise a note says which set they use. */
  use?: boolean;
}

/** Options of parametrizeFile(): those of load() and parametrize() and, in `write`, those of write(). */
export interface FileOptions
  extends
    Omit<LoadOptions, 'surface'>,
    Omit<SolveOptions, 'cones' | 'field' | 'frames' | 'refine'> {
  write?: Omit<WriteOptions, 'format'>;
}

/** The outcome for one mesh: its report, or the error if it has no map. */
export interface MeshOutcome {
  /** Index among the meshes of the file that have triangles. */
  mesh: number;
  certified: boolean;
  report?: Report;
  error?: { code: HgpErrorCode; message: string; stage?: string; where?: Where[] };
}

export interface FileResult {
  /** Whether the maps of all meshes are certified. */
  certified: boolean;
  meshes: MeshOutcome[];
  /**
   * The file with all maps and its side files, the main file first. Empty if a mesh is not certified, unless
   * `keepGoing` or `write.allowUncertified` is set.
   */
  files: { name: string; bytes: Uint8Array }[];
  /** Name and bytes of the main file, if there is one. */
  name?: string;
  bytes?: Uint8Array;
  notes: string[];
}

export interface Progress {
  stage: string;
  /** Progress of the stage, 0 to 1. */
  fraction: number;
  /** Iteration of the solver or of the improvement; -1 outside these. */
  iteration: number;
  /**
   * Residual of the solver relative to its target; in the stages `improve` and `align`, the energy's excess over an
   * isometry; -1 otherwise.
   */
  residual: number;
  /** Round of the loop "solve, verify, repair", from 1 to at most maxRounds; both are 0 outside the loop. */
  round: number;
  maxRounds: number;
  /** In parametrizeFile(): index of the mesh, and the number of meshes. */
  mesh?: number;
  meshes?: number;
}

export interface Result {
  /** Three numbers per surface vertex. */
  positions: Float64Array;
  /** Three surface vertices per triangle. */
  triangles: Uint32Array;
  /** Two numbers per uv vertex, v pointing up, rounded as the file will store them. */
  uv: Float64Array;
  /** Three uv vertices per triangle. */
  cornerToUv: Uint32Array;
  /** uv vertex → surface vertex. */
  uvToVertex: Uint32Array;
  /** The two sides of each seam edge as uv vertices, and r: side b is side a rotated by 2πr/q and translated. */
  seams: { a: [number, number]; b: [number, number]; r: number }[];
  certificate: Certificate;
  cones: Cones;
  report: Report;
  /** Size of the linear memory in bytes; it never shrinks. */
  memory: number;
}

export interface MeshArrays {
  /** Three numbers per vertex. */
  positions: ArrayLike<number>;
  /** Three vertices per triangle; if absent, every three consecutive vertices are a triangle. */
  triangles?: ArrayLike<number> | null;
}

export interface Written {
  /** Name and bytes of the main file. */
  name: string;
  bytes: Uint8Array;
  /** The main file and its side files, in this order. */
  files: { name: string; bytes: Uint8Array }[];
  notes: string[];
  /** Written vertex → stored vertex; empty if they are the same. */
  xref: Int32Array;
  /** Whether the map is certified with the numbers in this file; formats round differently. */
  certified: boolean;
}

/** Files as bytes; `main` is one of their names. */
export interface CoreFiles {
  main: string;
  files: Map<string, Uint8Array>;
  /** Notes of prepare() on the files, which precede those of load(). */
  notes?: string[];
}

/** One session with one loaded model. Calls are synchronous, except prepare(), and throw HgpError. */
export class Core {
  /** Called during calls; returning false cancels the call. */
  onProgress?: (progress: Progress) => boolean | void;
  readonly version: string;
  /** Size of the linear memory in bytes; it never shrinks. */
  readonly memory: number;
  /** Makes the engine optimize the solver by a small solve (about 0.3 s), so that the first call is not slow. */
  warmUp(): void;
  /**
   * Asynchronous preparation for load(), which is synchronous: decompresses gzip, and loads the decoders of compressed
   * glTF. Resolves to the files to load.
   */
  prepare(source: CoreFiles, options?: LoadOptions): Promise<CoreFiles>;
  /** Loads a file. If it fails, the previous model and result are kept. */
  load(source: CoreFiles, options?: LoadOptions): ModelInfo;
  /** Loads a mesh given as arrays. */
  loadMesh(mesh: MeshArrays, options?: MeshLoadOptions): ModelInfo;
  /** The facts and defects of the loaded model. */
  inspect(): ModelInfo;
  /** The loaded surface, usable or not. */
  surface(): Surface;
  /** A cone file of any known format as cones of the loaded surface. */
  readCones(file: ConeFile): Cones;
  /** The cones stored in the file, or null. */
  embeddedCones(): Cones | null;
  /** Automatic cones. */
  suggestCones(options?: SuggestOptions): Cones;
  /** Checks cones against Gauss–Bonnet in exact integers; solves nothing. */
  check(cones: Cones): CheckReport;
  /** Solves, and verifies the map as it will be stored; without `cones` they are chosen automatically. */
  parametrize(options?: SolveOptions): Result;
  /** Maps every mesh of a file from prepare(); afterwards the given file is loaded. */
  parametrizeFile(source: CoreFiles, options?: FileOptions): FileResult;
  /** Verifies texture coordinates in the loaded file. */
  verify(options?: VerifyOptions): Certificate;
  /** The file with the result, or the result in another format. */
  write(options?: WriteOptions): Written;
  /** Measurements of the result. */
  measure(): Measures;
  /** Keeps the result under a name for recall(), see Client.keep(). */
  keep(name: string): void;
  /** Makes a kept result the current one; false if it is no longer kept or belongs to another surface. */
  recall(name: string): boolean;
  /** Facts about the vertices and triangles of the loaded surface, usable or not. */
  facts(): SurfaceFacts;
  /** Boundary loops and handle generators of the loaded surface. */
  loops(): Loops;
  /** The cells of a map aligned in quad mode; throws `no-map` if it is not aligned. */
  quads(options?: QuadOptions): Quads;
  /** Frees the session, which cannot be used afterwards. */
  free(): void;
}

export function compile(options?: InitOptions): Promise<WebAssembly.Module>;
export function createCore(options?: InitOptions): Promise<Core>;
