// Generates closed and open surfaces of any genus from unit blocks.

/**
 * The boundary of the cells '#' of a drawing, one block thick; every square is divided n × n and slightly rounded
 * so that no two triangles are equal. `open` lists squares to leave out: 'x y +z'.
 */
export function blocks(rows, { n = 2, open = [] } = {}) {
  const isSolid = (x, y, z) => z === 0 && rows[y]?.[x] === '#';
  const left = new Set(open);
  const ids = new Map();
  const vertices = [];
  const vertex = (p) => {
    const key = p.join(' ');
    if (!ids.has(key)) {
      ids.set(key, vertices.length);
      const [x, y, z] = p.map((c) => c / n);
      const wave = 0.07 * Math.sin(1.3 * x + 0.7 * y) + 0.05 * Math.cos(0.9 * y - 1.1 * z);
      vertices.push([x + 0.04 * Math.sin(2 * y), y + wave, z + 0.06 * Math.sin(x + 0.5 * y)]);
    }
    return ids.get(key);
  };
  const triangles = [];
  const square = (x, y, axis, side) => {
    const at = (i, j) => {
      const p = [x * n, y * n, 0];
      p[axis] += side > 0 ? n : 0;
      p[(axis + 1) % 3] += i;
      p[(axis + 2) % 3] += j;
      return vertex(p);
    };
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        if (side > 0) triangles.push([a, b, c], [a, c, d]);
        else triangles.push([a, c, b], [a, d, c]);
      }
    }
  };
  rows.forEach((row, y) =>
    [...row].forEach((cell, x) => {
      if (cell !== '#') return;
      for (const [axis, name] of [...'xyz'].entries()) {
        for (const side of [-1, 1]) {
          const next = [x, y, 0];
          next[axis] += side;
          const isLeftOut = left.has(`${x} ${y} ${side > 0 ? '+' : '-'}${name}`);
          if (!isSolid(...next) && !isLeftOut) square(x, y, axis, side);
        }
      }
    }),
  );
  return used({ vertices, triangles });
}

/** The mesh without unused vertices. */
function used({ vertices, triangles }) {
  const number = new Map();
  for (const v of triangles.flat()) if (!number.has(v)) number.set(v, number.size);
  return {
    vertices: [...number.keys()].map((v) => vertices[v]),
    triangles: triangles.map((t) => t.map((v) => number.get(v))),
  };
}

export const ring = ['###', '#.#', '###'];
export const eight = ['#####', '#.#.#', '#####'];

/** Two meshes side by side as one. */
export function beside(a, b) {
  const shift = a.vertices.length;
  return {
    vertices: [...a.vertices, ...b.vertices.map(([x, y, z]) => [x + 20, y, z])],
    triangles: [...a.triangles, ...b.triangles.map((t) => t.map((v) => v + shift))],
  };
}
