// hgp/lite: maps and verdicts of arrays, synchronously, by a module of less than half the size. It has the method and the
// verifier, and neither files, repairs, grids nor documents.

import createModule, { type LiteModule } from '../lite_module.js';
import { checkOptions } from './check_options.js';
import { usage, valueOf } from './error.js';
import type { WebSignal } from './globals.js';
import type { Cones, MeshArrays, SuggestOptions } from './options.js';
import { progressCall } from './progress_call.js';
import type { Progress, Result } from './results.js';
import { checkMesh } from './sources.js';
import { startModule } from './start_module.js';

export interface LiteSolveOptions extends Omit<SuggestOptions, 'alignToCurvature'> {
  /** Chosen automatically if absent. Turnings of boundaries and rotations along handles are chosen by hgp. */
  cones?: Pick<Cones, 'q' | 'cones'>;
  /** As in the whole package. */
  improve?: 'isometric' | 'conformal' | 'area' | number;
}

export interface LiteMesh extends MeshArrays, LiteSolveOptions {
  /** `false`: vertices at equal positions are not joined. */
  weld?: boolean;
  /** The numbers in which the map will be stored, and for which it is certified; by default `double`. */
  precision?: 'double' | 'single';
}

export interface LiteMappedMesh extends MeshArrays {
  /** Two numbers per uv vertex. */
  uv: ArrayLike<number>;
  /** Three uv vertices per triangle; by default `triangles`, as for one uv per vertex. */
  cornerToUv?: ArrayLike<number>;
  /** Order of the rotations across seams; by default 4, or that of the cones. */
  q?: number;
  /** The cones that the map must have; by default any are accepted. */
  cones?: Pick<Cones, 'q' | 'cones'>;
  /** Of seams, relative to the length of each seam edge, and of angles in radians; by default 1e-6. */
  tolerance?: number;
  weld?: boolean;
}

/** What was verified, measured on exactly the numbers of the map. */
export interface LiteCertificate {
  /** Whether all components are certified. */
  certified: boolean;
  q: number;
  components: {
    certified: boolean;
    triangles: number;
    /** Triangles with exactly positive area in uv: all of them, if it is certified. */
    positive: number;
    genus: number;
    boundaries: number;
    /** Mean of μ, the conformal distortion. */
    meanMu: number;
    /** Vertices with the angle sum 2πk/q. */
    cones: { vertex: number; k: number }[];
    /** Why it is not certified: the rule, how many places break it, and the measured number at the worst. */
    reasons: { rule: string; count: number; worst: number }[];
  }[];
}

export interface LiteResult extends Pick<
  Result,
  'positions' | 'triangles' | 'uv' | 'cornerToUv' | 'uvToVertex' | 'seams'
> {
  certificate: LiteCertificate;
}

/** What belongs to one call of hgp/three with hgp/lite. */
export interface LiteCallOptions {
  /**
   * A call that is aborted before it begins, or by its own `onProgress`, rejects with the signal's reason: it runs in this
   * thread, where nothing else can abort it meanwhile.
   */
  signal?: WebSignal;
  /** If it throws, the call is cancelled and rejects with that error. */
  onProgress?: (progress: Progress) => void;
}

const balances = { isometric: 0, conformal: -1, area: 1 };

/** Cones as the module takes them: vertex and k in turn. */
function flatCones(call: string, cones: LiteSolveOptions['cones'], q?: number): object {
  if (!cones) return q === undefined ? {} : { q };
  if (q !== undefined && q !== cones.q)
    throw usage(`${call}: q is ${q}, and that of the cones ${cones.q}`);
  const others = (['boundaries', 'handles', 'features'] as const).filter((name) => name in cones);
  if (others.length > 0)
    throw usage(`${call}: ${others.join(' and ')} need hgp; hgp/lite has cones alone`);
  return { q: cones.q, cones: cones.cones.flatMap(({ vertex, k }) => [vertex, k]) };
}

/** The solver of hgp/lite. Calls are synchronous and throw HgpError: use it in a worker of your own for large meshes. */
export class Lite {
  readonly #module: LiteModule;

  /** Called during calls; returning false cancels the call. */
  onProgress: ((progress: Progress) => unknown) | undefined;

  private constructor(module: LiteModule) {
    this.#module = module;
  }

  /** @internal */
  static async make(wasmModule: WebAssembly.Module): Promise<Lite> {
    return new Lite(await startModule(createModule, wasmModule));
  }

  /** Maps a mesh given as arrays, which must be an oriented manifold: hgp/lite repairs nothing. */
  parametrizeMesh(mesh: LiteMesh): LiteResult {
    const { positions: given, triangles: corners, ...options } = mesh;
    checkOptions('lite.parametrizeMesh', options);
    const { positions, triangles } = checkMesh({ positions: given, triangles: corners });
    const { q, cones, improve, weld = true, precision, ...rest } = options;
    const reply = this.#module.parametrize(
      { positions, triangles },
      {
        ...rest,
        ...flatCones('lite.parametrizeMesh', cones, q),
        improve: typeof improve === 'string' ? balances[improve] : improve,
        join: weld,
        float: precision === 'single',
      },
      progressCall(this.onProgress),
    );
    const made = valueOf(reply);
    const seams: Result['seams'] = [];
    for (let i = 0; i < made.seams.length; i += 5) {
      const [a0, a1, b0, b1, r] = made.seams.subarray(i, i + 5);
      seams.push({ a: [a0, a1], b: [b0, b1], r });
    }
    return {
      positions: Float64Array.from(positions),
      triangles: Uint32Array.from(triangles),
      uv: made.uv,
      cornerToUv: made.cornerToUv,
      uvToVertex: made.uvToVertex,
      seams,
      certificate: made.certificate,
    };
  }

  /** Verifies any map, whoever made it, on exactly these numbers. */
  verifyMesh(mesh: LiteMappedMesh): LiteCertificate {
    const { positions: given, triangles: corners, uv, cornerToUv, ...options } = mesh;
    checkOptions('lite.verifyMesh', options);
    const { positions, triangles } = checkMesh({ positions: given, triangles: corners });
    const uvCorners = cornerToUv ?? triangles;
    checkMap(uv, uvCorners, triangles.length);
    const { q, cones, tolerance, weld = true } = options;
    const reply = this.#module.verify(
      { positions, triangles, uv, cornerToUv: uvCorners },
      { ...flatCones('lite.verifyMesh', cones, q), tolerance, join: weld },
    );
    return valueOf(reply).certificate;
  }

  /**
   * What hgp/three calls: a mesh of a renderer, mapped in single precision.
   * @internal
   */
  parametrizeRendered(
    mesh: MeshArrays,
    load: object,
    solve: LiteSolveOptions,
    call: LiteCallOptions = {},
  ): LiteResult {
    const given = Object.entries(load).filter(([, value]) => value !== undefined);
    if (given.length > 0) throw usage(`hgp/lite has no option '${given[0][0]}'; hgp has`);
    checkOptions('lite.call', call);
    return this.#watched(call, () =>
      this.parametrizeMesh({ ...solve, ...mesh, precision: 'single' }),
    );
  }

  /** Runs one call with its own progress and signal, beside the progress of all calls. */
  #watched<Value>({ signal, onProgress }: LiteCallOptions, run: () => Value): Value {
    if (signal?.aborted) throw signal.reason;
    const ofAll = this.onProgress;
    let failed: { with: unknown } | undefined;
    if (signal || onProgress) {
      this.onProgress = (progress) => {
        try {
          onProgress?.(progress);
        } catch (error) {
          failed = { with: error };
        }
        return !failed && !signal?.aborted && ofAll?.(progress) !== false;
      };
    }
    try {
      return run();
    } catch (error) {
      if (failed) throw failed.with;
      throw signal?.aborted ? signal.reason : error;
    } finally {
      this.onProgress = ofAll;
    }
  }
}

function checkMap(uv: ArrayLike<number>, cornerToUv: ArrayLike<number>, corners: number): void {
  if (uv.length === 0 || uv.length % 2 !== 0)
    throw usage('lite.verifyMesh: uv are two numbers per uv vertex');
  if (cornerToUv.length !== corners)
    throw usage(`lite.verifyMesh: cornerToUv has ${cornerToUv.length} indices, not ${corners}`);
  for (let i = 0; i < cornerToUv.length; i++) {
    if (Number.isInteger(cornerToUv[i]) && cornerToUv[i] >= 0 && cornerToUv[i] < uv.length / 2)
      continue;
    throw usage(`lite.verifyMesh: cornerToUv names ${cornerToUv[i]} of ${uv.length / 2} uv`);
  }
}
