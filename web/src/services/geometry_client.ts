// The page's side of the geometry worker: calls that return promises. Large arrays are transferred to
// the worker and returned with the answer, so that nothing large is copied on the main thread.

import type { Measures, SurfaceFacts } from 'hgp';
import type { Analysis, MapNumbers, OutputFile, Surface } from '../model/types';
import type { AnalysisRequest } from './geometry/analyse';
import {
  buffersIn,
  type GeometryAnswer,
  type GeometryCalls,
  type GeometryMethod,
} from './geometry/protocol';
import type { SurfaceArrays } from './geometry/placed_surface';
import { geometryUrl, scriptUrl } from './trusted_types';

interface Pending {
  resolve: (result: never) => void;
  reject: (error: Error) => void;
}

export class GeometryClient {
  #worker?: Worker;
  #pending = new Map<number, Pending>();
  #calls = 0;
  #ids = 0;
  /** Ids of what the worker has. */
  readonly #surfaces = new Set<number>();
  readonly #maps = new Set<number>();

  #start(): Worker {
    const worker = new Worker(scriptUrl(geometryUrl), { type: 'module', name: 'geometry' });
    worker.addEventListener('message', ({ data }: MessageEvent<GeometryAnswer>) => {
      const { call, result, error } = data;
      const pending = this.#pending.get(call);
      this.#pending.delete(call);
      if (error === undefined) pending?.resolve(result as never);
      else pending?.reject(new Error(error));
    });
    worker.addEventListener('error', ({ message }) => this.#lose(message ?? 'it did not start'));
    return worker;
  }

  /** The worker has run out of memory or could not be loaded: pending calls fail, and the next call starts another. */
  #lose(reason: string): void {
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#surfaces.clear();
    this.#maps.clear();
    for (const { reject } of pending) reject(new Error(`The geometry worker stopped (${reason}).`));
  }

  /** Starts the worker before the first call, so that an open page keeps working if its files on the server change. */
  prepare(): void {
    this.#worker ??= this.#start();
  }

  call<M extends GeometryMethod>(
    method: M,
    args: Parameters<GeometryCalls[M]>,
    lent?: unknown,
  ): Promise<Awaited<ReturnType<GeometryCalls[M]>>> {
    this.prepare();
    const call = ++this.#calls;
    return new Promise((resolve, reject) => {
      this.#pending.set(call, { resolve, reject });
      this.#worker!.postMessage({ call, method, args }, [...buffersIn(lent)]);
    });
  }

  surface(arrays: SurfaceArrays, facts: SurfaceFacts, matrix: readonly number[]): Promise<Surface> {
    const id = ++this.#ids;
    this.#surfaces.add(id);
    return this.call('surface', [id, arrays, facts, matrix], [arrays, facts]);
  }

  /** Makes the worker forget all other surfaces and maps. */
  keepOnly(surfaces: ReadonlySet<number>, maps: ReadonlySet<number>): void {
    const oldSurfaces = [...this.#surfaces].filter((id) => !surfaces.has(id));
    const oldMaps = [...this.#maps].filter((id) => !maps.has(id));
    if (oldSurfaces.length + oldMaps.length === 0) return;
    for (const id of oldSurfaces) this.#surfaces.delete(id);
    for (const id of oldMaps) this.#maps.delete(id);
    void this.call('forget', [oldSurfaces, oldMaps]).catch(() => undefined); // it has ended
  }

  /** How the map in a file differs from the given one; empty if it does not. */
  compare(
    { positions, triangles, uv, cornerToUv, uvToVertex, seams }: MapNumbers,
    files: OutputFile[],
    where: Pick<AnalysisRequest, 'mesh' | 'uvSet'>,
  ): Promise<{ difference: string }> {
    const map = { positions, triangles, uv, cornerToUv, uvToVertex, seams };
    return this.call('compare', [{ ...where, map, files }]);
  }

  /** `measures` are kept; `result` and `files` are returned with other arrays of the same content, the surface's where those are. */
  async analyse(
    surface: Surface,
    result: MapNumbers,
    measures: Measures,
    files: OutputFile[],
    where: Pick<AnalysisRequest, 'mesh' | 'uvSet'>,
  ): Promise<{ analysis: Analysis; preserved: string; result: MapNumbers; files: OutputFile[] }> {
    const { uv, cornerToUv, uvToVertex, seams } = result;
    const positions = result.positions === surface.positions ? undefined : result.positions;
    const triangles = result.triangles === surface.triangles ? undefined : result.triangles;
    const map = { positions, triangles, uv, cornerToUv, uvToVertex, seams };
    const request = { ...where, map, measures, files };
    const id = ++this.#ids;
    this.#maps.add(id);
    const answer = await this.call('analyse', [id, surface.id, request], request);
    const { analysis, preserved, files: returned } = answer;
    const own = {
      positions: answer.map.positions ?? surface.positions,
      triangles: answer.map.triangles ?? surface.triangles,
    };
    return { analysis, preserved, result: { ...result, ...answer.map, ...own }, files: returned };
  }
}
