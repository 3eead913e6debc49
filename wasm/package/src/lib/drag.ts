// A cone that is dragged over a certified map, in the thread of the solver.

import type { Drag, Module } from '../module.js';
import { checkVertex } from './check_options.js';
import type { CoreMap } from './core_map.js';
import { defineDisposal } from './disposal.js';
import { usage, valueOf } from './error.js';
import type { Cones } from './options.js';
import type { DragFrame } from './results.js';

/** Where a drag prepared the neighbourhood of its cone, and its last certified position: enough to repeat it. */
export type DragPath = readonly number[];

/** A cone that is dragged. */
export class CoreDrag {
  readonly #map: CoreMap;
  #drag: Drag | undefined;
  /** Positions at which it was prepared. */
  readonly #anchors: number[] = [];
  #last: number;
  #wantsPreparation = false;
  /** The vertex that the last call did not reach. */
  #outOfReach: number | undefined;

  /** @internal */
  constructor(module: Module, map: CoreMap, vertex: number) {
    this.#map = map;
    this.#last = vertex;
    const drag = new module.Drag();
    try {
      valueOf(map.current().beginDrag(drag, vertex));
    } catch (error) {
      drag.delete();
      throw error;
    }
    this.#drag = drag;
  }

  /**
   * The map with the cone at a vertex. After a leap the state is `heat` at first, which takes a frame's time, and
   * `isApproaching` is true: each further call with the same vertex prepares a neighbourhood nearer to it, until its map
   * is there. Throws `usage` where no cone can be: at other cones and on boundaries.
   */
  dragTo(vertex: number): DragFrame {
    checkVertex('dragTo', vertex);
    const drag = this.#current();
    // From the rim of the prepared neighbourhood one step is enough for the next vertex.
    const mayStep = this.#wantsPreparation || this.#outOfReach === vertex;
    let reply = valueOf(drag.moveTo(vertex));
    const isOut = (): boolean => reply.state === 'heat' && reply.wantsPreparation;
    let isApproaching = isOut();
    if (isApproaching && mayStep) {
      const isNearer = this.#approach(vertex);
      reply = valueOf(drag.moveTo(vertex));
      isApproaching = isNearer && isOut();
    }
    const { wantsPreparation, cones, ...frame } = reply;
    this.#outOfReach = isApproaching ? vertex : undefined;
    this.#wantsPreparation = frame.state !== 'heat' && wantsPreparation;
    if (frame.state === 'certified') this.#last = vertex;
    return { ...frame, vertex, isApproaching, cones: JSON.parse(cones) as Cones };
  }

  /**
   * Prepares the neighbourhood of the last certified position if the next positions will need it, for about as long as
   * the drag took to begin. Otherwise dragTo() does it when it is needed.
   */
  prepare(): void {
    if (!this.#wantsPreparation) return;
    this.#wantsPreparation = false;
    try {
      valueOf(this.#current().prepareHere());
    } catch (error) {
      this.free(); // its state is not that of a position any more
      throw error;
    }
    if (this.#anchors.at(-1) !== this.#last) this.#anchors.push(this.#last);
  }

  /** Goes towards a vertex out of reach and prepares that neighbourhood; whether a nearer position has a certified map. */
  #approach(vertex: number): boolean {
    let reached;
    try {
      reached = valueOf(this.#current().prepareToward(vertex)).vertex;
    } catch (error) {
      this.free();
      throw error;
    }
    if (reached < 0) return false;
    this.#last = reached;
    this.#anchors.push(reached);
    return true;
  }

  /**
   * Ends the drag with its last certified map, verified as it is stored. The bytes of this map depend on the path of the
   * cone; parametrize() with its cones gives one that depends on nothing else.
   */
  endDrag(): CoreMap {
    valueOf(this.#current().drop());
    this.free();
    return this.#map.model.dropped();
  }

  /** @internal */
  get path(): DragPath {
    return [...this.#anchors, this.#last];
  }

  /**
   * Does again what a drag with this path did.
   * @internal
   */
  repeat(path: DragPath): this {
    path.forEach((vertex, i) => {
      if (vertex !== path[i - 1]) this.dragTo(vertex);
      this.#wantsPreparation = i < path.length - 1;
      this.prepare();
    });
    return this;
  }

  /** Ends the drag; the map is as it was. */
  free(): void {
    this.#drag?.delete();
    this.#drag = undefined;
  }

  [Symbol.dispose](): void {
    this.free();
  }

  #current(): Drag {
    if (!this.#drag) throw usage('this drag has ended');
    this.#map.current();
    return this.#drag;
  }
}

defineDisposal(CoreDrag.prototype);
