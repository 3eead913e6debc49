// What a client returns: a loaded mesh, and a map of it. They stay usable when a call was cancelled or a worker was
// lost: the next call on them makes them again, from a copy of the source and with the same options.

import { checkConeFile, checkCones, checkFeatures, checkVertex } from './check_options.js';
import type { CallOptions } from './client.js';
import { defineDisposal } from './disposal.js';
import { Drag } from './drag_handle.js';
import type { Certificate, CheckReport, ModelInfo } from './documents.js';
import { usage } from './error.js';
import { lost, taken } from './handle.js';
import { MapData } from './map_data.js';
import type {
  ConeFile,
  Cones,
  FeatureFile,
  FeatureListOptions,
  Features,
  QuadOptions,
  SolveOptions,
  SuggestOptions,
  VerifyOptions,
  WriteOptions,
} from './options.js';
import type { Queue } from './queue.js';
import type {
  FeatureList,
  Loops,
  Measures,
  MovedCones,
  Placements,
  Quads,
  Result,
  Surface,
  SurfaceFacts,
  Written,
} from './results.js';

/**
 * A loaded mesh, in the client's worker. Calls run one after another with all others of the client, in the order made.
 * Ids of vertices and triangles are those of `surface()`.
 */
export class Model implements AsyncDisposable {
  readonly #queue: Queue;
  readonly #id: number;

  /** The facts and defects of the mesh, as load() found them. */
  readonly info: ModelInfo;

  /** @internal */
  constructor(queue: Queue, id: number, info: ModelInfo) {
    this.#queue = queue;
    this.#id = id;
    this.info = info;
    lost.register(this, { queue, id }, this);
  }

  /** The facts and defects of the mesh. */
  inspect(call?: CallOptions): Promise<ModelInfo> {
    return this.#call('inspect', () => [], call);
  }

  /** The loaded surface, usable or not, to which vertex and triangle ids refer. */
  surface(call?: CallOptions): Promise<Surface> {
    return this.#call('surface', () => [], call);
  }

  /** Angles, valences, boundary, components and neighbours on the surface, usable or not. */
  facts(call?: CallOptions): Promise<SurfaceFacts> {
    return this.#call('facts', () => [], call);
  }

  /** By mesh of the file, how its nodes use it; empty in formats without nodes. */
  placements(call?: CallOptions): Promise<Placements[]> {
    return this.#call('placements', () => [], call);
  }

  /** The boundary loops and handle generators, in the order of their numbers. */
  loops(call?: CallOptions): Promise<Loops> {
    return this.#call('loops', () => [], call);
  }

  /** A cone file of any known format as cones of the surface. */
  readCones(file: ConeFile, call?: CallOptions): Promise<Cones> {
    const checked = (): unknown[] => {
      checkConeFile('readCones', file);
      return [structuredClone(file)];
    };
    return this.#call('readCones', checked, call);
  }

  /** The cones stored in the file, or null. */
  embeddedCones(call?: CallOptions): Promise<Cones | null> {
    return this.#call('embeddedCones', () => [], call);
  }

  /** Automatic cones. */
  suggestCones(options: SuggestOptions = {}, call?: CallOptions): Promise<Cones> {
    return this.#call('suggestCones', () => [taken('suggestCones', options)], call);
  }

  /**
   * The edges that features mean on this mesh, rims included, as a file of a name: `.json` (hgp-cones with positions),
   * `.sharp`, `.obj` (`l` lines), otherwise rows of two vertices.
   */
  listFeatures(
    features: Features | FeatureFile,
    options: FeatureListOptions = {},
    call?: CallOptions,
  ): Promise<FeatureList> {
    const checked = (): unknown[] => {
      checkFeatures('listFeatures', features);
      return [structuredClone(features), taken('listFeatures', options)];
    };
    return this.#call('listFeatures', checked, call);
  }

  /** The cones with those that Gauss–Bonnet misses, placed where they cause the least distortion. */
  balanceCones(cones: Cones, call?: CallOptions): Promise<Cones> {
    const checked = (): unknown[] => {
      checkCones('balanceCones', cones);
      return [structuredClone(cones)];
    };
    return this.#call('balanceCones', checked, call);
  }

  /**
   * The cones of another reading or version of this surface on this one: by number where both have the same vertices and
   * triangles, otherwise by exact position. `from` is a model of the same client.
   */
  transferCones(cones: Cones, from: Model, call?: CallOptions): Promise<MovedCones> {
    const isModel = from instanceof Model && from.#queue === this.#queue;
    const checked = (): unknown[] => {
      checkCones('transferCones', cones);
      if (!isModel) throw usage('transferCones: the cones are of another model of this client');
      return [structuredClone(cones), from.#id];
    };
    const needs = isModel ? [this.#id, from.#id] : [];
    return this.#queue.add({ method: 'transferCones', on: this.#id, needs }, checked, call);
  }

  /** Checks cones against Gauss–Bonnet in exact integers; solves nothing. */
  check(cones: Cones, call?: CallOptions): Promise<CheckReport> {
    const checked = (): unknown[] => {
      checkCones('check', cones);
      return [structuredClone(cones)];
    };
    return this.#call('check', checked, call);
  }

  /**
   * The logarithm of the conformal factor that the map of these cones follows, by surface vertex: a preview in a part of
   * the time of parametrize(). NaN on components for which nothing is prescribed.
   */
  logScale(cones: Cones, call?: CallOptions): Promise<Float32Array> {
    const checked = (): unknown[] => {
      checkCones('logScale', cones);
      return [structuredClone(cones)];
    };
    return this.#call('logScale', checked, call);
  }

  /** Solves, and verifies the map as it will be stored; without `cones` they are chosen automatically. */
  async parametrize(options: SolveOptions = {}, call?: CallOptions): Promise<UvMap> {
    const makes = this.#queue.newId();
    const request = { method: 'parametrize', on: this.#id, makes };
    const solved = this.#queue.add<Result>(request, () => [taken('parametrize', options)], call);
    return new UvMap(this.#queue, makes, this, await solved);
  }

  /** Verifies texture coordinates in the file. */
  verify(options: VerifyOptions = {}, call?: CallOptions): Promise<Certificate> {
    return this.#call('verify', () => [taken('verify', options)], call);
  }

  /** Whether it cannot be used any more: after dispose() or the client's terminate(). */
  get isDisposed(): boolean {
    return !this.#queue.isLive(this.#id);
  }

  /** Frees the model and its maps, after the calls made before. Calls made afterwards are `usage` errors. */
  dispose(): Promise<void> {
    lost.unregister(this);
    return this.#queue.release(this.#id);
  }

  [Symbol.asyncDispose](): Promise<void> {
    return this.dispose();
  }

  #call<T>(method: string, prepare: () => unknown[], call?: CallOptions): Promise<T> {
    return this.#queue.add({ method, on: this.#id }, prepare, call);
  }
}

/** A map of a model: its numbers, and calls that write and measure it. */
export class UvMap extends MapData implements AsyncDisposable {
  readonly #queue: Queue;
  readonly #id: number;
  /** The model of which this is a map. */
  readonly model: Model;

  /** @internal */
  constructor(queue: Queue, id: number, model: Model, result: Result) {
    super(result);
    this.#queue = queue;
    this.#id = id;
    this.model = model;
    lost.register(this, { queue, id }, this);
  }

  /** The original file with the new texture coordinates and otherwise unchanged, or another format. */
  write(options: WriteOptions = {}, call?: CallOptions): Promise<Written> {
    return this.#call('write', () => [taken('write', options)], call);
  }

  /**
   * Starts to drag a cone of this map, which must be certified and not on a refined mesh. This prepares the
   * neighbourhood of the cone, which takes a part of the time of parametrize().
   */
  async beginDrag(vertex: number, call?: CallOptions): Promise<Drag> {
    const makes = this.#queue.newId();
    const prepare = (): unknown[] => {
      checkVertex('beginDrag', vertex);
      return [vertex];
    };
    await this.#queue.add({ method: 'beginDrag', on: this.#id, makes }, prepare, call);
    const mapOf = (id: number, dropped: Result): UvMap =>
      new UvMap(this.#queue, id, this.model, dropped);
    return new Drag(this.#queue, makes, this, mapOf);
  }

  /** Distortion per triangle, overlaps, and the seam to which each seam edge belongs. */
  measure(call?: CallOptions): Promise<Measures> {
    return this.#call('measure', () => [], call);
  }

  /** The cells of a map aligned in quad mode (`grid`) as a quad mesh. */
  quads(options: QuadOptions = {}, call?: CallOptions): Promise<Quads> {
    return this.#call('quads', () => [taken('quads', options)], call);
  }

  /** Whether only its numbers can be used: after dispose(), of the model as well, or the client's terminate(). */
  get isDisposed(): boolean {
    return !this.#queue.isLive(this.#id);
  }

  /** Frees the map in the worker, after the calls made before; its numbers stay. */
  dispose(): Promise<void> {
    lost.unregister(this);
    return this.#queue.release(this.#id);
  }

  [Symbol.asyncDispose](): Promise<void> {
    return this.dispose();
  }

  /** @internal */
  static idOf(map: UvMap): number {
    return map.#id;
  }

  /** @internal */
  static isOf(map: UvMap, queue: Queue): boolean {
    return map.#queue === queue;
  }

  #call<T>(method: string, prepare: () => unknown[], call?: CallOptions): Promise<T> {
    return this.#queue.add({ method, on: this.#id }, prepare, call);
  }
}

defineDisposal(Model.prototype);
defineDisposal(UvMap.prototype);
