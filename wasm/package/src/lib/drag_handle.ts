// A cone that is dragged, in the client's worker.

import { checkVertex } from './check_options.js';
import type { CallOptions } from './client.js';
import { defineDisposal } from './disposal.js';
import type { DragPath } from './drag.js';
import { lost } from './handle.js';
import type { UvMap } from './handles.js';
import type { Recipe } from './protocol.js';
import type { Queue } from './queue.js';
import type { DragFrame, Result, SupersededFrame } from './results.js';

/** A cone that is dragged over a map. */
export class Drag implements AsyncDisposable {
  readonly #queue: Queue;
  readonly #id: number;
  readonly #mapOf: (id: number, dropped: Result) => UvMap;
  /** The map where the drag began; it does not change. */
  readonly map: UvMap;

  /**
   * @param mapOf  the handle of the map that is dropped
   * @internal
   */
  constructor(queue: Queue, id: number, map: UvMap, mapOf: (id: number, dropped: Result) => UvMap) {
    this.#queue = queue;
    this.#id = id;
    this.map = map;
    this.#mapOf = mapOf;
    lost.register(this, { queue, id }, this);
  }

  /**
   * The map with the cone at a vertex, as a preview: at most one waits. If the cone is dragged on before the worker has
   * begun with it, it resolves to `superseded`. Aborting it never ends the worker. Rejects with `usage` where no cone
   * can be: at other cones and on boundaries.
   */
  async dragTo(vertex: number, call?: CallOptions): Promise<DragFrame | SupersededFrame> {
    const prepare = (): unknown[] => {
      checkVertex('dragTo', vertex);
      return [vertex];
    };
    const superseded: SupersededFrame = { state: 'superseded', vertex };
    const learn = (result: unknown): undefined => {
      const recipe = this.#queue.recipeOf(this.#id);
      if (recipe && 'path' in (result as object))
        recipe.args = [recipe.args[0], (result as PathedFrame).path];
    };
    const request = { method: 'dragTo', on: this.#id, superseded, learn };
    const result = await this.#queue.add<PathedFrame | SupersededFrame>(request, prepare, call);
    return 'path' in result ? result.frame : result;
  }

  /**
   * Ends the drag after the calls made before, with its last certified map, verified as it is stored. The bytes of this
   * map depend on the path of the cone; parametrize() with its cones gives one that depends on nothing else.
   */
  async endDrag(call?: CallOptions): Promise<UvMap> {
    const makes = this.#queue.newId();
    const learn = (): Omit<Recipe, 'id'> | undefined => {
      const drag = this.#queue.recipeOf(this.#id);
      const base = this.#queue.recipeOf(drag?.on ?? 0);
      if (!drag || !base) return undefined;
      const [options, drags = []] = base.args as [object, unknown[]?];
      return { method: 'dragged', on: base.on, args: [options, [...drags, drag.args]] };
    };
    const request = { method: 'endDrag', on: this.#id, makes, learn };
    const dropped = await this.#queue.add<Result>(request, () => [], call);
    void this.dispose();
    return this.#mapOf(makes, dropped);
  }

  /** Whether it cannot go on: after endDrag() and dispose(), also of its map, and the client's terminate(). */
  get isDisposed(): boolean {
    return !this.#queue.isLive(this.#id);
  }

  /** Ends the drag without a map, after the calls made before. */
  dispose(): Promise<void> {
    lost.unregister(this);
    return this.#queue.release(this.#id);
  }

  [Symbol.asyncDispose](): Promise<void> {
    return this.dispose();
  }
}

/** What the worker answers: also the path that repeats the drag. */
interface PathedFrame {
  frame: DragFrame;
  path: DragPath;
}

defineDisposal(Drag.prototype);
