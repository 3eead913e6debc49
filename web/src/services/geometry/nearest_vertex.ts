// The vertex nearest to a point, up to a distance, by cells of a regular grid.

type Vector = readonly [number, number, number];

const perCell = 4; // vertices of a surface in a cell, about
const none: number[] = [];

export class NearestVertex {
  /** The mean area around a vertex, about. */
  readonly meanSpacing: number;
  readonly #positions: Float64Array;
  /** By their places in the box of the vertices: texts as keys take ten times as long. */
  readonly #cells = new Map<number, number[]>();
  readonly #first: Vector;
  readonly #last: Vector;
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
    this.#first = this.#cellOf(low[0], low[1], low[2]);
    this.#last = this.#cellOf(high[0], high[1], high[2]);
    for (const v of vertices) {
      const at = this.#cellOf(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
      const key = this.#key(...at);
      const cell = this.#cells.get(key);
      if (cell) cell.push(v);
      else this.#cells.set(key, [v]);
    }
  }

  #cellOf(x: number, y: number, z: number): Vector {
    const size = this.#size;
    return [Math.floor(x / size), Math.floor(y / size), Math.floor(z / size)];
  }

  /** Of a cell in the box; −1 for all others. */
  #key(x: number, y: number, z: number): number {
    const [a, b, c] = this.#first;
    const [d, e, f] = this.#last;
    if (x < a || y < b || z < c || x > d || y > e || z > f) return -1;
    return ((x - a) * (e - b + 1) + (y - b)) * (f - c + 1) + (z - c);
  }

  /** −1 if no vertex is near enough. */
  of(point: Vector): number {
    const [i, j, k] = this.#cellOf(...point);
    // In cells: squares of small or large lengths would leave the range of numbers.
    const reach = this.#reach / this.#size;
    const max = Math.ceil(reach);
    let best = -1;
    let nearest = reach ** 2;
    // Cells in shells around the point: what is in a later shell is at least that far away.
    for (let shell = 0; shell <= max && (shell < 1 || (shell - 1) ** 2 <= nearest); shell++) {
      for (let x = i - shell; x <= i + shell; x++) {
        for (let y = j - shell; y <= j + shell; y++) {
          const isSide = Math.abs(x - i) === shell || Math.abs(y - j) === shell;
          for (let z = k - shell; z <= k + shell; z += isSide ? 1 : 2 * shell || 1) {
            for (const v of this.#cells.get(this.#key(x, y, z)) ?? none) {
              const far = this.#squareOf(v, point);
              if (far < nearest || (far === nearest && best < 0)) [best, nearest] = [v, far];
            }
          }
        }
      }
    }
    return best;
  }

  /** The square of a distance, in cells. */
  #squareOf(v: number, point: Vector): number {
    const [p, size] = [this.#positions, this.#size];
    const x = (p[3 * v] - point[0]) / size;
    const y = (p[3 * v + 1] - point[1]) / size;
    const z = (p[3 * v + 2] - point[2]) / size;
    return x * x + y * y + z * z;
  }
}
