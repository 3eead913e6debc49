// A loaded mesh in the memory of WebAssembly, synchronous.

import type { Session, SessionResult, StoredResult, WholeFile } from '../module.js';
import { checkConeFile, checkCones, checkFeatures, checkOptions } from './check_options.js';
import type { Core } from './core.js';
import { CoreMap } from './core_map.js';
import { defineDisposal } from './disposal.js';
import type { Certificate, CheckReport, ModelInfo, Note, Report } from './documents.js';
import type { DragPath } from './drag.js';
import { usage, valueOf } from './error.js';
import type {
  ConeFile,
  Cones,
  FeatureFile,
  FeatureListOptions,
  Features,
  FileOptions,
  LoadOptions,
  SolveOptions,
  SuggestOptions,
  VerifyOptions,
} from './options.js';
import type {
  FeatureList,
  Loops,
  MovedCones,
  Placements,
  Progress,
  Result,
  Surface,
  SurfaceFacts,
} from './results.js';
import { progressCall, type ProgressCall } from './progress_call.js';
import { filesOf, forCore, jsonOf, listFile } from './to_core.js';

const nested = 'a call of this model is running: its onProgress cannot use the model, nor free it';

/**
 * What loading a model gives.
 * @internal
 */
export interface Loaded {
  info: ModelInfo;
  name: string;
  sides?: ReadonlyMap<string, Uint8Array>;
}

/** A loaded mesh. */
export class CoreModel {
  readonly #core: Core;
  #session: Session | undefined;
  #isReporting = false;

  /** The facts and defects of the mesh. */
  readonly info: ModelInfo;
  /**
   * Those with which it was loaded.
   * @internal
   */
  readonly options: LoadOptions;
  /**
   * The default name of the result of write().
   * @internal
   */
  readonly defaultName: string;

  /**
   * The files beside a .gltf, of which quads() needs the pictures.
   * @internal
   */
  sides: ReadonlyMap<string, Uint8Array>;

  /** @internal */
  constructor(
    core: Core,
    session: Session,
    { info, name, options, sides }: Loaded & { options: LoadOptions },
  ) {
    this.#core = core;
    this.#session = session;
    this.info = info;
    this.defaultName = name;
    this.options = options;
    this.sides = sides ?? new Map();
  }

  /** The facts and defects of the mesh. */
  inspect(): ModelInfo {
    return jsonOf(this.#live.inspect()) as ModelInfo;
  }

  /** The loaded surface, usable or not, to which vertex and triangle ids refer. */
  surface(): Surface {
    return valueOf(this.#live.surface());
  }

  /** Facts about the vertices and triangles of the surface, usable or not. */
  facts(): SurfaceFacts {
    return valueOf(this.#live.facts());
  }

  /** By mesh of the file, how its nodes use it; empty in formats without nodes. */
  placements(): Placements[] {
    return valueOf(this.#live.placements()).meshes;
  }

  /** The boundary loops and handle generators, in the order of their numbers. */
  loops(): Loops {
    return valueOf(this.#live.loops());
  }

  /** A cone file of any known format as cones of the surface. */
  readCones(file: ConeFile): Cones {
    checkConeFile('readCones', file);
    const { name = '', text, q = 0 } = file as Partial<ConeFile>;
    return jsonOf(this.#live.readCones(name, text ?? '', q)) as Cones;
  }

  /** The cones stored in the file, or null. */
  embeddedCones(): Cones | null {
    const { json } = valueOf(this.#live.embeddedCones());
    return json === undefined ? null : (JSON.parse(json) as Cones);
  }

  /** Automatic cones. */
  suggestCones(options: SuggestOptions = {}): Cones {
    checkOptions('suggestCones', options);
    const asked = JSON.stringify(options);
    return jsonOf(
      this.#reporting((session, progress) => session.suggestCones(asked, progress)),
    ) as Cones;
  }

  /** The cones with those that Gauss–Bonnet misses, placed where they cause the least distortion. */
  balanceCones(cones: Cones): Cones {
    checkCones('balanceCones', cones);
    return jsonOf(this.#live.balanceCones(JSON.stringify(cones))) as Cones;
  }

  /**
   * The cones of another reading or version of this surface on this one: by number where both have the same vertices and
   * triangles, otherwise by exact position.
   */
  transferCones(cones: Cones, from: CoreModel): MovedCones {
    checkCones('transferCones', cones);
    const isModel = (from as unknown) instanceof CoreModel && from.#core === this.#core;
    if (!isModel) throw usage('transferCones: the cones are of another model of this core');
    const { json, lost } = valueOf(this.#live.transferCones(JSON.stringify(cones), from.#live));
    return { cones: JSON.parse(json) as Cones, lost: JSON.parse(lost) as Note[] };
  }

  /** Checks cones against Gauss–Bonnet in exact integers; solves nothing. */
  check(cones: Cones): CheckReport {
    checkCones('check', cones);
    return jsonOf(this.#live.check(JSON.stringify(cones))) as CheckReport;
  }

  /**
   * The logarithm of the conformal factor that the map of these cones follows, by surface vertex: a preview in a part of
   * the time of parametrize(). NaN on components for which nothing is prescribed.
   */
  logScale(cones: Cones): Float32Array {
    checkCones('logScale', cones);
    return valueOf(this.#live.logScale(JSON.stringify(cones))).logScale;
  }

  /**
   * The edges that features mean on this mesh, rims included, as a file of a name: `.json` (hgp-cones with positions),
   * `.sharp`, `.obj` (`l` lines), otherwise rows of two vertices.
   */
  listFeatures(features: Features | FeatureFile, options: FeatureListOptions = {}): FeatureList {
    checkFeatures('listFeatures', features);
    checkOptions('listFeatures', options);
    const { name = 'features.json' } = options;
    const { notes, ...list } = valueOf(this.#live.features(listFile(features), name));
    return { name, ...list, notes: JSON.parse(notes) as Note[] };
  }

  /** Solves, and verifies the map as it will be stored; without `cones` they are chosen automatically. */
  parametrize(options: SolveOptions = {}): CoreMap {
    checkOptions('parametrize', options);
    const { cones, field, features, ...rest } = options;
    const text = cones ? JSON.stringify(cones) : '';
    const asked = JSON.stringify(forCore(rest));
    const files = filesOf(field, features);
    return this.#mapOf(
      this.#reporting((session, progress) => session.parametrize(text, files, asked, progress)),
    );
  }

  /**
   * The map that was dropped at the end of a drag, which is the session's result.
   * @internal
   */
  dropped(): CoreMap {
    return this.#mapOf(this.#live.result());
  }

  /**
   * The map of parametrize() after drags, each given by its cone and its path.
   * @internal
   */
  dragged(options: SolveOptions, drags: readonly [number, DragPath][]): CoreMap {
    return drags.reduce((map, [cone, path]) => {
      const drag = map.beginDrag(cone);
      try {
        return drag.repeat(path).endDrag();
      } finally {
        drag.free();
        map.free();
      }
    }, this.parametrize(options));
  }

  /**
   * Maps every mesh of its file.
   * @internal
   */
  parametrizeFile({
    write = {},
    features,
    ...solve
  }: Omit<FileOptions, keyof LoadOptions>): WholeFile {
    const { onProgress } = this.#core;
    let [mesh, meshes] = [0, 1];
    const onMesh = (...now: [number, number]): void => void ([mesh, meshes] = now);
    const report = onProgress && ((now: Progress) => onProgress({ ...now, mesh, meshes }));
    const [options, how] = [forCore(solve), { name: this.defaultName, ...write }];
    const texts = [options, how].map((one) => JSON.stringify(one)) as [string, string];
    const files = filesOf(undefined, features);
    return valueOf(
      this.#reporting(
        (session, progress) => session.parametrizeFile(...texts, files, progress, onMesh),
        report,
      ),
    );
  }

  /** Verifies texture coordinates in the file. */
  verify(options: VerifyOptions = {}): Certificate {
    checkOptions('verify', options);
    const { cones, field, features, ...rest } = options;
    const text = cones ? JSON.stringify(cones) : '';
    const reply = this.#live.verify(text, filesOf(field, features), JSON.stringify(rest));
    return jsonOf(reply) as Certificate;
  }

  /**
   * The session with a result as its current one.
   * @internal
   */
  showing(result: StoredResult): Session {
    const session = this.#live;
    if (!session.use(result)) throw usage('the map is of another surface');
    return session;
  }

  /** Frees the model. Neither it nor its maps can be used afterwards. */
  free(): void {
    if (this.#isReporting) throw usage(nested);
    this.#session?.delete();
    this.#session = undefined;
    this.sides = new Map();
  }

  [Symbol.dispose](): void {
    this.free();
  }

  get #live(): Session {
    if (this.#isReporting) throw usage(nested);
    if (this.#session) return this.#session;
    throw usage('this model has been freed');
  }

  #mapOf(reply: SessionResult | { error: string }): CoreMap {
    const numbers = valueOf(reply);
    const seams: Result['seams'] = [];
    for (let i = 0; i < numbers.seams.length; i += 5) {
      const [a0, a1, b0, b1, r] = numbers.seams.subarray(i, i + 5);
      seams.push({ a: [a0, a1], b: [b0, b1], r });
    }
    const report = JSON.parse(numbers.report) as Report;
    const { certificate, cones } = report;
    const { memory, module } = this.#core;
    const solved = numbers.solved ?? {
      triangles: numbers.triangles,
      uvTriangles: numbers.cornerToUv,
      origin: Uint32Array.from({ length: numbers.triangles.length / 3 }, (_, f) => f),
    };
    const result = {
      ...numbers,
      solved,
      seams,
      report,
      certificate,
      cones: cones as Cones,
      memory,
    };
    return new CoreMap(this, module, this.#live.storedResult(), result);
  }

  /** A call that reports its progress, during which its session cannot be used otherwise. */
  #reporting<T>(
    call: (session: Session, progress: ProgressCall | undefined) => T,
    onProgress = this.#core.onProgress,
  ): T {
    const session = this.#live;
    this.#isReporting = true;
    try {
      return call(session, progressCall(onProgress));
    } finally {
      this.#isReporting = false;
    }
  }
}

defineDisposal(CoreModel.prototype);
