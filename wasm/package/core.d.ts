// The solver itself, synchronous: for use inside your own worker.

import type { Certificate, CheckReport, ModelInfo } from './documents.js';
import type {
  ConeFile,
  Cones,
  CoreFiles,
  FileOptions,
  InitOptions,
  LoadOptions,
  MeshArrays,
  MeshLoadOptions,
  QuadOptions,
  SolveOptions,
  SuggestOptions,
  VerifyOptions,
  WriteOptions,
} from './options.js';
import type {
  FileResult,
  HgpErrorCode,
  Loops,
  Measures,
  Progress,
  Quads,
  Result,
  Surface,
  SurfaceFacts,
  Where,
  Written,
} from './results.js';

export type { Certificate, CheckReport, ModelInfo, Report } from './documents.js';
export type * from './options.js';
export type * from './results.js';

export class HgpError extends Error {
  constructor(failure: { code: string; message: string; stage?: string; where?: Where[] });
  readonly code: HgpErrorCode;
  readonly details: { stage?: string; where?: Where[] };
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
