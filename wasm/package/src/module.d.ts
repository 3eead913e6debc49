// The module that Emscripten builds from wasm/bindings.cpp.

/** The results of a call, or the JSON of its failure. */
type Reply<T = unknown> = { error: string } | ({ error?: undefined } & T);
type JsonReply = Reply<{ json: string }>;
type ProgressCall = import('./lib/progress_call.js').ProgressCall;

/** An object of the module, which is freed by delete(). */
export interface StoredResult {
  delete(): void;
}

/** As write() of a session; notes are JSON of Note[]. */
interface WrittenReply {
  files: { name: string; bytes: Uint8Array }[];
  notes: string;
  xref: Int32Array;
  certified: boolean;
}

export interface WrittenFile extends WrittenReply {
  mapNotes: { mesh: number; notes: string }[];
}

/** Maps of several meshes of a file. */
export interface FileMaps {
  add(session: Session, options: string): Reply;
  write(meshes: number[]): Reply<WrittenFile>;
  delete(): void;
}

export interface WholeFile {
  /** JSON of the report, or of the error. */
  meshes: {
    mesh: number;
    certified: boolean;
    aligned: boolean;
    report?: string;
    error?: string;
  }[];
  file?: WrittenFile;
}

export interface SessionResult {
  positions: Float64Array;
  triangles: Uint32Array;
  uv: Float64Array;
  cornerToUv: Uint32Array;
  uvToVertex: Uint32Array;
  /** a0 a1 b0 b1 r of each seam edge. */
  seams: Int32Array;
  /** Absent where they are `triangles` and `cornerToUv`. */
  solved?: import('./lib/results.js').SolvedTriangles;
  report: string;
}

/** A cone that is dragged, once a session has begun it. */
export interface Drag {
  moveTo(vertex: number): Reply<
    Omit<import('./lib/results.js').DragFrame, 'vertex' | 'cones' | 'isApproaching'> & {
      cones: string;
      wantsPreparation: boolean;
    }
  >;
  prepareHere(): Reply;
  /** `vertex`: of the position reached; −1: no nearer one has a certified map. */
  prepareToward(vertex: number): Reply<{ vertex: number }>;
  drop(): Reply;
  delete(): void;
}

/** `options` are objects as JSON, which optionsFromJson of the core reads. */
export interface Session {
  load(
    main: string,
    names: string[],
    contents: Uint8Array[],
    decoders: object,
    options: string,
  ): JsonReply;
  loadMesh(positions: ArrayLike<number>, triangles: ArrayLike<number>, options: string): JsonReply;
  inspect(): JsonReply;
  check(cones: string): JsonReply;
  logScale(cones: string): Reply<{ logScale: Float32Array }>;
  surface(): Reply<import('./lib/results.js').Surface>;
  readCones(name: string, text: string, q: number): JsonReply;
  embeddedCones(): Reply<{ json?: string }>;
  features(
    list: object,
    name: string,
  ): Reply<
    Omit<import('./lib/results.js').FeatureList, 'name' | 'notes'> & {
      /** JSON of Note[]. */
      notes: string;
    }
  >;
  suggestCones(options: string, onProgress?: ProgressCall): JsonReply;
  balanceCones(cones: string): JsonReply;
  transferCones(cones: string, from: Session): Reply<{ json: string; lost: string }>;
  parametrize(
    cones: string,
    files: object,
    options: string,
    onProgress?: ProgressCall,
  ): Reply<SessionResult>;
  result(): Reply<SessionResult>;
  beginDrag(drag: Drag, vertex: number): Reply;
  storedResult(): StoredResult;
  use(result: StoredResult): boolean;
  verify(cones: string, files: object, options: string): JsonReply;
  write(options: string): Reply<WrittenReply>;
  parametrizeFile(
    options: string,
    write: string,
    files: object,
    onProgress: ProgressCall | undefined,
    onMesh: (mesh: number, meshes: number) => void,
  ): Reply<WholeFile>;
  measure(): Reply<import('./lib/results.js').Measures>;
  facts(): Reply<import('./lib/results.js').SurfaceFacts>;
  placements(): Reply<{ meshes: import('./lib/results.js').Placements[] }>;
  loops(): Reply<import('./lib/results.js').Loops>;
  quads(
    name: string,
    names: string[],
    contents: Uint8Array[],
  ): Reply<Omit<import('./lib/results.js').Quads, 'name' | 'notes'> & { notes: string }>;
  delete(): void;
}

export interface Module {
  Session: new () => Session;
  Drag: new () => Drag;
  FileMaps: new () => FileMaps;
  neededDecoders(json: Uint8Array): Reply<{ draco: boolean; meshopt: boolean }>;
  version(): string;
  HEAPU8: Uint8Array;
}

export default function createModule(options: object): Promise<Module>;
