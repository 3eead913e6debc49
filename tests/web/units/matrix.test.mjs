// The page's few operations on matrices against those of three.js.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { composed, determinant, identity, product } from '../../../web/src/model/matrix.ts';

const near = (a, b) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 1e-12, `${a} ${b}`));

test('composed, product and determinant are those of three.js', () => {
  assert.deepEqual(identity, new Matrix4().toArray());
  const made = [1, 2, 3].map((seed) => {
    const at = (i) => Math.sin(12.9 * seed + 4.1 * i);
    const [t, s] = [[at(0), at(1), at(2)], [1 + at(3), at(4) - 2, 3 + at(5)]]; // prettier-ignore
    const r = new Quaternion(at(6), at(7), at(8), at(9)).normalize();
    const theirs = new Matrix4().compose(new Vector3(...t), r, new Vector3(...s));
    const own = composed(t, r.toArray(), s);
    near(own, theirs.toArray());
    assert.ok(Math.abs(determinant(own) - theirs.determinant()) < 1e-12);
    assert.ok(determinant(own) < 0, 'one axis is reversed');
    return { own, theirs };
  });
  const [a, b] = made;
  near(product(a.own, b.own), new Matrix4().multiplyMatrices(a.theirs, b.theirs).toArray());
  assert.deepEqual(product(a.own, identity), a.own);
});
