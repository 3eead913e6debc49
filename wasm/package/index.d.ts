// Seamless, provably fold-free texture coordinates with cones of your choice.
/// <reference lib="esnext.disposable" />

import type {
  CheckReport,
  Cones,
  Certificate,
  ConeFile,
  FileOptions,
  FileResult,
  FileSet,
  FileSource,
  InitOptions,
  LoadOptions,
  Loops,
  Measures,
  MeshArrays,
  MeshLoadOptions,
  ModelInfo,
  Progress,
  Result,
  SolveOptions,
  SuggestOptions,
  Surface,
  SurfaceFacts,
  VerifyOptions,
  QuadOptions,
  Quads,
  WriteOptions,
  Written,
} from './core.js';

export type {
  Certificate,
  CheckReport,
  ConeFile,
  Cones,
  FileOptions,
  FileResult,
  FileSet,
  FileSource,
  HgpErrorCode,
  InitOptions,
  LoadOptions,
  Loops,
  Measures,
  MeshArrays,
  MeshLoadOptions,
  MeshOutcome,
  ModelInfo,
  Progress,
  Report,
  Result,
  SolveOptions,
  SuggestOptions,
  Surface,
  SurfaceFacts,
  VerifyOptions,
  Where,
  QuadOptions,
  Quads,
  WriteOptions,
  Written,
} from './core.js';
export { HgpError } from './core.js';

export interface ClientOptions extends InitOptions {
  /** Creates the worker, for bundlers and Content-Security-Policies that must know its URL. */
  createWorker?: () => Worker;
  /**
   * URL of worker.js of this package, for bundlers that do not find it. If it is on another origin, a script of the
   * page's own origin imports it.
   */
  workerUrl?: string | URL;
  /**
   * Whether the worker solves a small model when it has started, so that the engine has
   * optimized the solver by the first call. Takes about 0.3 s; by default true.
   */
  warmUp?: boolean;
}

export interface CallOptions {
  /** Aborting terminates the worker immediately; the call rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Called at most ten times per second. If it throws, the call is cancelled and rejects with that error. */
  onProgress?(progress: Progress): void;
}

/** One model in one worker. Calls run one after another, in the order made. */
export interface Client extends AsyncDisposable {
  /** Starts the worker, with the model, if it is not running, so that the next call need not wait for it. */
  ready(call?: CallOptions): Promise<void>;
  load(source: FileSource | FileSet, options?: LoadOptions, call?: CallOptions): Promise<ModelInfo>;
  inspect(call?: CallOptions): Promise<ModelInfo>;
  /** The loaded surface, usable or not, to which vertex and triangle ids refer. */
  surface(call?: CallOptions): Promise<Surface>;
  /** A cone file of any known format as cones of the loaded surface. */
  readCones(file: ConeFile, call?: CallOptions): Promise<Cones>;
  /** The cones stored in the file, or null. */
  embeddedCones(call?: CallOptions): Promise<Cones | null>;
  suggestCones(options?: SuggestOptions, call?: CallOptions): Promise<Cones>;
  /** Checks cones against Gauss–Bonnet in exact integers; solves nothing. */
  check(cones: Cones, call?: CallOptions): Promise<CheckReport>;
  parametrize(options?: SolveOptions, call?: CallOptions): Promise<Result>;
  /**
   * Maps a mesh that is not in a file, such as a three.js geometry. Replaces the loaded model. Vertices
   * at equal positions are joined first (`weld`).
   */
  parametrizeMesh(
    mesh: MeshArrays & MeshLoadOptions & SolveOptions,
    call?: CallOptions,
  ): Promise<Result>;
  /**
   * Maps every mesh of a file and returns the file with all maps, as `hgp param` does. With `keepGoing`, a mesh
   * without a map does not prevent the others from being written. Replaces the loaded model by this file.
   */
  parametrizeFile(
    source: FileSource | FileSet,
    options?: FileOptions,
    call?: CallOptions,
  ): Promise<FileResult>;
  /** Verifies texture coordinates in the loaded file. */
  verify(options?: VerifyOptions, call?: CallOptions): Promise<Certificate>;
  /** The original file with the new texture coordinates and otherwise unchanged, or another format. */
  write(options?: WriteOptions, call?: CallOptions): Promise<Written>;
  /** Distortion per triangle, overlaps, and the seam to which each seam edge belongs. */
  measure(call?: CallOptions): Promise<Measures>;
  /**
   * Keeps the result of the last parametrize() under a name for recall(), even after other results are computed. The
   * two newest per surface are kept, up to 500 000 triangles in total.
   */
  keep(name: string, call?: CallOptions): Promise<void>;
  /**
   * Makes a kept result the one to which write(), measure() and quads() refer. False if it belongs to another surface
   * than the loaded one, or is no longer kept, for instance after a cancelled call. Other files may have been loaded in
   * the meantime: to write the maps of several meshes into one file, load what was written, and recall the next.
   */
  recall(name: string, call?: CallOptions): Promise<boolean>;
  /** Angles, valences, boundary, components and neighbours on the loaded surface, usable or not. */
  facts(call?: CallOptions): Promise<SurfaceFacts>;
  /** The boundary loops and handle generators of the loaded surface, in the order of their numbers. */
  loops(call?: CallOptions): Promise<Loops>;
  /** The cells of a map aligned in quad mode (`grid`) as a quad mesh. */
  quads(options?: QuadOptions, call?: CallOptions): Promise<Quads>;
  /** Terminates the worker and drops the model; pending calls reject with `AbortError`. */
  terminate(): void;
}

export function createClient(options?: ClientOptions): Promise<Client>;
