// The shadow in the scene: where the ground is dark in the picture is where the model stands, whichever way the texture lies.

import assert from 'node:assert/strict';
import test from 'node:test';
import { FrontSide, Raycaster, Vector3 } from 'three';
import { ContactShadow } from '../../../web/src/views/contact_shadow.ts';
import { groundShadow } from '../../../web/src/services/geometry/shadow_map.ts';

/** A foot at each place (x, z), of half a unit, and a point high above that makes the model larger. */
function feet(...places) {
  const points = [];
  for (const [x, z, half = 0.25] of places)
    for (let i = -10; i <= 10; i++)
      for (let j = -10; j <= 10; j++) points.push(x + (half * i) / 10, 3, z + (half * j) / 10);
  return points;
}

/** How dark the ground is at (x, z) of the scene, from 0 to 1, looked up as a graphics card does. */
function darkAt(shadow, x, z) {
  shadow.updateMatrixWorld(true);
  const ray = new Raycaster(new Vector3(x, 1000, z), new Vector3(0, -1, 0));
  const [hit] = ray.intersectObject(shadow);
  if (!hit) return 0;
  const { data, width, height } = shadow.material.map.image;
  const [column, row] = [hit.uv.x * width, hit.uv.y * height].map(Math.floor);
  return data[4 * (Math.min(row, height - 1) * width + Math.min(column, width - 1)) + 3] / 255;
}

test('the ground is dark below each foot and nowhere else, on every side of the model', () => {
  const places = [[-4, -5], [5, -1.9, 0.4], [1.8, 4]]; // prettier-ignore
  const shadow = new ContactShadow();
  const model = feet(...places);
  shadow.show(model);
  assert.equal(shadow.visible, true);
  const { dark, x, z, side } = groundShadow(model);
  const cells = Math.sqrt(dark.length);
  let most = 0;
  for (let i = 0; i < cells; i += 5)
    for (let j = 0; j < cells; j += 5) {
      const [px, pz] = [x + ((i + 0.5) / cells - 0.5) * side, z + ((j + 0.5) / cells - 0.5) * side];
      const is = darkAt(shadow, px, pz);
      // A half as dark at most, as a room has light from everywhere.
      assert.ok(Math.abs(is - 0.5 * dark[j * cells + i]) < 0.005, `${px}, ${pz}: ${is}`);
      most = Math.max(most, is);
    }
  for (const [px, pz] of places) {
    assert.ok(darkAt(shadow, px, pz) > 0.1, `${px}, ${pz}`);
    assert.ok(darkAt(shadow, px, -pz) < 0.01 && darkAt(shadow, -px, pz) < 0.01);
  }
  assert.ok(most <= 0.5);
  const plate = new ContactShadow();
  plate.show(feet([0, 0, 3]));
  const middle = darkAt(plate, 0, 0);
  assert.ok(middle > 0.45 && middle <= 0.51, `${middle}`);
  // It is dark, not coloured, and its edge is smooth.
  const { image, magFilter } = shadow.material.map;
  assert.ok(image.data.every((value, i) => i % 4 === 3 || value === 0));
  assert.ok(shadow.material.map.version > 0 && magFilter !== 1003);
});

test('the ground is just below the lowest point, for models of every size, and seen from above only', () => {
  for (const factor of [0.001, 1, 2000]) {
    const shadow = new ContactShadow();
    shadow.show(feet([0, 0], [2, 1]).map((x) => factor * x));
    shadow.updateMatrixWorld(true);
    const below = new Vector3(0, 3 * factor, 0).sub(shadow.position).y / (2 * factor);
    assert.ok(below > 1e-4 && below < 0.01, `${below}`);
    const at = (y, way) => new Raycaster(new Vector3(0, y * factor, 0), new Vector3(0, way, 0)).intersectObject(shadow); // prettier-ignore
    assert.deepEqual([at(9, -1).length, at(-9, 1).length], [1, 0]);
    assert.equal(shadow.material.side, FrontSide);
  }
});

test('it is drawn before everything else, hides nothing, and is never left out', () => {
  const shadow = new ContactShadow();
  const { transparent, depthWrite, depthTest, toneMapped } = shadow.material;
  assert.deepEqual([transparent, depthWrite, depthTest, toneMapped], [true, false, true, false]);
  assert.ok(shadow.renderOrder < 0);
  assert.equal(shadow.frustumCulled, false);
  assert.equal(shadow.visible, false, 'before there is a model');
});

test('it is computed once for each model; the one before is freed, and without a model there is none', () => {
  const shadow = new ContactShadow();
  const freed = [];
  const [first, second] = [feet([0, 0]), feet([1, 1, 0.5])];
  const show = (places) => {
    shadow.show(places);
    const { map } = shadow.material;
    if (map && !map.isNoted) map.addEventListener('dispose', () => freed.push(map));
    if (map) map.isNoted = true;
    assert.equal(shadow.visible, map !== null);
    return map;
  };
  const a = show(first);
  const { version } = shadow.material;
  assert.equal(show(first), a);
  assert.deepEqual([freed, shadow.material.version], [[], version], 'nothing for the same one');
  const b = show(second);
  assert.notEqual(b, a);
  assert.deepEqual(freed, [a]);
  assert.ok(shadow.material.version > version);
  assert.equal(show(undefined), null);
  assert.deepEqual(freed, [a, b]);
  assert.notEqual(show(second), null, 'back again');
  assert.equal(show([1, 2, 3]), null, 'a point has none');
  assert.equal(freed.length, 3);
});
