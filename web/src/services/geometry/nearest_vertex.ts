// The vertex nearest to a point, up to a distance, by cells of a regular grid.

type Vector = readonly [number, number, number];

const perCell = 4; // vertices of a surface in a cell, about

export class NearestVertex {
  /** The mean area around a vertex, about. */
  readonly meanSpacing: number;
  readonly #positions: Float64Array;
  readonly #cells = new Map<string, number[]>();
  readonly #size: number;
  readonly #reach: number;

  constructor(positions: Float64Array, vertices: readonly number[], reach: number) {
    this.#positions = positions;
    this.#reach = reach;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const v of vertices) {
      for (let i = 0; i < 3; i++) {
        low[i] = Math.min(low[i], positions[3 * v + i]);
        high[i] = Math.max(high[i], positions[3 * v + i]);
      }
    }
    const [a, b, c] = high.map((x, i) => x - low[i]);
    this.meanSpacing = (2 * (a * b + b * c + c * a)) / Math.max(1, vertices.length);
    this.#size = Math.sqrt(perCell * this.meanSpacing) || 1;
    for (const v of vertices) {
      const key = this.#cellOf(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]).join();
      const cell = this.#cells.get(key);
      if (cell) cell.push(v);
      else this.#cells.set(key, [v]);
    }
  }

  #cellOf(...at: Vector): number[] {
    return at.map((x) => Math.floor(x / this.#size));
  }

  /** −1 if no vertex is near enough. */
  of(point: Vector): number {
    const [i, j, k] = this.#cellOf(...point);
    const max = Math.ceil(this.#reach / this.#size);
    let best = -1;
    let nearest = this.#reach;
    // Cells in shells around the point: what is in a later shell is at least that far away.
    for (let shell = 0; shell <= max && (shell - 1) * this.#size <= nearest; shell++) {
      for (let x = i - shell; x <= i + shell; x++) {
        for (let y = j - shell; y <= j + shell; y++) {
          const isSide = Math.abs(x - i) === shell || Math.abs(y - j) === shell;
          for (let z = k - shell; z <= k + shell; z += isSide ? 1 : 2 * shell || 1) {
            for (const v of this.#cells.get(`${x},${y},${z}`) ?? []) {
              const far = this.#distance(v, point);
              if (far < nearest || (far === nearest && best < 0)) [best, nearest] = [v, far];
            }
          }
        }
      }
    }
    return best;
  }

  #distance(v: number, [x, y, z]: Vector): number {
    const p = this.#positions;
    return Math.hypot(p[3 * v] - x, p[3 * v + 1] - y, p[3 * v + 2] - z);
  }
}
