// Parts with wide flat faces: the field in the middle of a face is weak, and pairs of cones that only the triangulation
// explains must not cost the map.
import assert from 'node:assert/strict';
import test from 'node:test';
import { toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';

const { put, run } = inFolder('flat-pairs');

/** A gear wheel with a bore; `steps` edges along each of the four sides of a tooth. */
function gear(teeth, steps, height = 0.22) {
  const shares = [0.2, 0.35, 0.65, 0.8];
  const corner = (side) => {
    const angle = 2 * Math.PI * (Math.floor(side / 4) + shares[side % 4]) / teeth; // prettier-ignore
    const radius = side % 4 === 1 || side % 4 === 2 ? 1 : 0.78;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  const between = (a, b, t) => a.map((x, i) => x + t * (b[i] - x));
  const outside = [];
  for (let side = 0; side < 4 * teeth; side++)
    for (let i = 0; i < steps; i++) outside.push(between(corner(side), corner(side + 1), i / steps)); // prettier-ignore
  const inside = outside.map(([x, y]) => [x, y].map((c) => (0.34 * c) / Math.hypot(x, y)));
  const [flat, tall] = [4 * steps, 2 * steps];
  const rows = [];
  const add = (from, to, z, w, count) => {
    for (let r = 0; r < count; r++) rows.push(from.map((p, i) => [...between(p, to[i], r / count), z + ((w - z) * r) / count])); // prettier-ignore
  };
  add(inside, outside, height, height, flat);
  add(outside, outside, height, -height, tall);
  add(outside, inside, -height, -height, flat);
  add(inside, inside, -height, height, tall);
  const n = outside.length;
  const triangles = rows.flatMap((_, r) =>
    outside.flatMap((__, i) => {
      const [a, b] = [r * n + i, r * n + ((i + 1) % n)];
      const next = (r + 1) % rows.length;
      const [d, c] = [next * n + i, next * n + ((i + 1) % n)];
      return (r + i) % 2 === 0 ? [[a, c, b], [a, d, c]] : [[a, d, b], [b, d, c]]; // prettier-ignore
    }),
  );
  return { vertices: rows.flat(), triangles };
}

test('gears have maps along all creases, with a cone at each corner of a tooth and nowhere else', () => {
  for (const [teeth, steps] of [
    [7, 4],
    [5, 3],
  ]) {
    const name = put(`gear_${teeth}_${steps}.obj`, toObj(gear(teeth, steps)));
    const { code, out, err } = run(['param', name, '--creases', '-o', 'mapped.obj', '--json', '-']);
    assert.equal(code, 0, err);
    const { cones, refined, certificate, components } = JSON.parse(out);
    assert.equal(refined, null, 'no edge is split');
    const count = (k) => cones.cones.filter((cone) => cone.k === k).length;
    assert.deepEqual([cones.cones.length, count(3), count(5)], [8 * teeth, 4 * teeth, 4 * teeth]);
    const { features } = certificate ?? components[0].certificate;
    assert.equal(features.straightChains, 12 * teeth + 2);
    const prescribed = run(['verify', 'mapped.obj', '--creases']);
    assert.equal(prescribed.code, 0, prescribed.out);
  }
});
