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
  /** Makes the worker where a bundler or a Content-Security-Policy must know its URL. */
  createWorker?: () => Worker;
  /**
   * Where worker.js of this package is, for bundlers that do not follow it and for other origins: then
   * a script of the page's own origin imports it.
   */
  workerUrl?: string | URL;
  /**
   * Whether the worker solves a small model first, while nothing else is asked of it, so that the
   * engine has optimized the solver by the first call. Takes about 0.3 s; by default true.
   */
  warmUp?: boolean;
}

export interface CallOptions {
  /** Aborting ends the worker at once; the call rejects with the signal's reason. */
  signal?: AbortSignal;
  /** At most ten times a second. What it throws ends the call. */
  onProgress?(progress: Progress): void;
}

/** One model in one worker. Calls run one after another, in the order made. */
export interface Client extends AsyncDisposable {
  /** Starts the worker where there is none, with the model, so that the next call need not wait. */
  ready(call?: CallOptions): Promise<void>;
  load(source: FileSource | FileSet, options?: LoadOptions, call?: CallOptions): Promise<ModelInfo>;
  inspect(call?: CallOptions): Promise<ModelInfo>;
  /** The loaded surface, usable or not: what vertex and triangle ids refer to. */
  surface(call?: CallOptions): Promise<Surface>;
  /** A cone file of any known kind as cones of the loaded surface. */
  readCones(file: ConeFile, call?: CallOptions): Promise<Cones>;
  /** The cones that are stored inside the file, or null. */
  embeddedCones(call?: CallOptions): Promise<Cones | null>;
  suggestCones(options?: SuggestOptions, call?: CallOptions): Promise<Cones>;
  /** The exact integer budget of Gauss–Bonnet; solves nothing. */
  check(cones: Cones, call?: CallOptions): Promise<CheckReport>;
  parametrize(options?: SolveOptions, call?: CallOptions): Promise<Result>;
  /**
   * For meshes that come from no file, such as a three.js geometry. Replaces the loaded model. Vertices
   * at the same place are joined first (`weld`).
   */
  parametrizeMesh(
    mesh: MeshArrays & MeshLoadOptions & SolveOptions,
    call?: CallOptions,
  ): Promise<Result>;
  /**
   * Every mesh of a file, one after the other, and the file with all of their maps: what `hgp param` does. One
   * bad mesh does not spoil the rest where `keepGoing` is set. Replaces the loaded model by this file.
   */
  parametrizeFile(
    source: FileSource | FileSet,
    options?: FileOptions,
    call?: CallOptions,
  ): Promise<FileResult>;
  /** Verifies the texture coordinates that are in the file. */
  verify(options?: VerifyOptions, call?: CallOptions): Promise<Certificate>;
  /** The original file with the new texture coordinates and nothing else changed. */
  write(options?: WriteOptions, call?: CallOptions): Promise<Written>;
  /** Distortion by triangle, overlaps, and which seam edges are one seam. */
  measure(call?: CallOptions): Promise<Measures>;
  /**
   * The result of the last parametrize() can be recalled by this name, though others are made: two of a surface, of up
   * to 500 000 triangles together, the newest first.
   */
  keep(name: string, call?: CallOptions): Promise<void>;
  /**
   * Makes a kept result the one that write(), measure() and quads() are about; false where it is of another surface than
   * the one that is loaded, or not there any more, as after a call that was cancelled. Other files may have been loaded
   * meanwhile: the maps of several meshes are written into one file by loading what was written, and recalling the next.
   */
  recall(name: string, call?: CallOptions): Promise<boolean>;
  /** Angles, valences, boundary, components and neighbours of the loaded surface, usable or not. */
  facts(call?: CallOptions): Promise<SurfaceFacts>;
  /** What the numbers of boundary loops and handle generators mean, on the loaded surface. */
  loops(call?: CallOptions): Promise<Loops>;
  /** The cells of a map aligned in quad mode (`grid`) as a quad mesh. */
  quads(options?: QuadOptions, call?: CallOptions): Promise<Quads>;
  /** Ends the worker and forgets the model; pending calls reject with `AbortError`. */
  terminate(): void;
}

export function createClient(options?: ClientOptions): Promise<Client>;
