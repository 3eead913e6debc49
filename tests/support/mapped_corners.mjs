// What a mapped file stores, read by nothing of the project's own.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

const float = Math.fround;
const run = (count, item) => Array.from({ length: count }, (_, i) => item(i));

/** By format: positions and uv of the corners of every triangle, [[p, uv] × 3]. */
export const readers = {
  obj(file) {
    const [v, vt, out] = [[], [], []];
    for (const line of readFileSync(file, 'utf8').split('\n')) {
      const [word, ...rest] = line.trim().split(/\s+/);
      if (word === 'v') v.push(rest.slice(0, 3).map(Number));
      if (word === 'vt') vt.push(rest.map(Number));
      if (word !== 'f') continue;
      out.push(rest.map((c) => c.split('/').map(Number)).map(([a, b]) => [v[a - 1], vt[b - 1]]));
    }
    return out;
  },
  ply(file) {
    const text = readFileSync(file, 'latin1');
    assert.match(text, /format ascii/);
    const count = (what) => Number(new RegExp(`element ${what} (\\d+)`).exec(text)[1]);
    const rows = text.slice(text.indexOf('end_header\n') + 11).trim().split('\n').map((row) => row.trim().split(/\s+/).map(Number)); // prettier-ignore
    const v = rows.slice(0, count('vertex')).map((row) => row.slice(0, 3));
    return rows.slice(v.length, v.length + count('face')).map((row) => {
      assert.equal(row[4], 6);
      return [0, 1, 2].map((k) => [v[row[1 + k]], row.slice(5 + 2 * k, 7 + 2 * k).map(float)]);
    });
  },
  glb(file) {
    const bytes = readFileSync(file);
    const length = bytes.readUInt32LE(12);
    const json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
    const bin = bytes.subarray(28 + length);
    const values = (index) => {
      const { bufferView, byteOffset = 0, componentType, count, type } = json.accessors[index];
      const { byteOffset: start = 0, byteStride } = json.bufferViews[bufferView];
      const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[type];
      const [size, read] = { 5123: [2, 'readUInt16LE'], 5125: [4, 'readUInt32LE'], 5126: [4, 'readFloatLE'] }[componentType]; // prettier-ignore
      return run(count, (i) => run(width, (k) => bin[read](start + byteOffset + i * (byteStride ?? size * width) + k * size))); // prettier-ignore
    };
    return json.meshes.flatMap(({ primitives }) =>
      primitives.flatMap(({ attributes, indices }) => {
        const sets = Object.keys(attributes).filter((word) => word.startsWith('TEXCOORD_')).sort(); // prettier-ignore
        const [p, uv] = [values(attributes.POSITION), values(attributes[sets.at(-1)])];
        const corners = values(indices).map(([i]) => [p[i], [uv[i][0], -uv[i][1]]]); // v points down
        return run(corners.length / 3, (t) => corners.slice(3 * t, 3 * t + 3));
      }),
    );
  },
};
