// A map in the memory of WebAssembly, synchronous.

import type { Module, Session, StoredResult } from '../module.js';
import { checkOptions, checkVertex } from './check_options.js';
import type { CoreModel } from './core_model.js';
import { defineDisposal } from './disposal.js';
import type { Note } from './documents.js';
import { CoreDrag } from './drag.js';
import { usage, valueOf } from './error.js';
import { MapData } from './map_data.js';
import type { QuadOptions, WriteOptions } from './options.js';
import type { Measures, Quads, Result, Written } from './results.js';

/** The default file name of write() in another format: "x.flat.obj" of "x.glb". */
function exportName(name: string, format: string): string {
  const stem = name.replace(/\.[^.]*$/, '') || 'mesh';
  return `${stem}.${format === 'flat-obj' ? 'flat.obj' : format}`;
}

/** A map of a model: its numbers, and calls that write and measure it. */
export class CoreMap extends MapData {
  /** @internal */
  readonly model: CoreModel;
  readonly #module: Module;
  #stored: StoredResult | undefined;

  /** @internal */
  constructor(model: CoreModel, module: Module, stored: StoredResult, result: Result) {
    super(result);
    this.model = model;
    this.#module = module;
    this.#stored = stored;
  }

  /**
   * Starts to drag a cone of this map, which must be certified and not on a refined mesh. This prepares the
   * neighbourhood of the cone, which takes a part of the time of parametrize().
   */
  beginDrag(vertex: number): CoreDrag {
    checkVertex('beginDrag', vertex);
    return new CoreDrag(this.#module, this, vertex);
  }

  /** The original file with the new texture coordinates and otherwise unchanged, or another format. */
  write(options: WriteOptions = {}): Written {
    checkOptions('write', options);
    const { format = 'same' } = options;
    const { defaultName } = this.model;
    const name = format === 'same' ? defaultName : exportName(defaultName, format);
    const reply = this.current().write(JSON.stringify({ name, ...options }));
    const { files, notes, xref, certified } = valueOf(reply);
    const told = JSON.parse(notes) as Note[];
    return { name: files[0].name, bytes: files[0].bytes, files, notes: told, xref, certified };
  }

  /** Distortion per triangle, overlaps, and the seam to which each seam edge belongs. */
  measure(): Measures {
    return valueOf(this.current().measure());
  }

  /** The cells of a map aligned in quad mode; throws `no-map` if it is not aligned. */
  quads(options: QuadOptions = {}): Quads {
    checkOptions('quads', options);
    const { name = 'quads.obj' } = options;
    const { sides } = this.model;
    const reply = this.current().quads(name, [...sides.keys()], [...sides.values()]);
    const { notes, ...made } = valueOf(reply);
    return { name, ...made, notes: JSON.parse(notes) as Note[] };
  }

  /**
   * The session of its model with this map as its current result.
   * @internal
   */
  current(): Session {
    return this.model.showing(this.#live);
  }

  /** Frees the map, of which only the numbers can be used afterwards. */
  free(): void {
    this.#stored?.delete();
    this.#stored = undefined;
  }

  [Symbol.dispose](): void {
    this.free();
  }

  get #live(): StoredResult {
    if (this.#stored) return this.#stored;
    throw usage('this map has been freed');
  }
}

defineDisposal(CoreMap.prototype);
