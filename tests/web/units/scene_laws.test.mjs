// Laws of the meshes beside the open one: which are drawn, how quiet each is, what a pointer finds, what framing looks at.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Color, Matrix3, Matrix4, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { BufferAttribute, BufferGeometry } from 'three';
import { randomFrom } from '../../mutation/draw.mjs';
import { shapeOf, WholeScene } from '../../../web/src/views/whole_scene.ts';

const palette = { paper: new Color('#eee'), ink: new Color(), second: new Color() };
/** A square of two triangles, from (0, 0) to (1, 1), placed by these matrices. */
const square = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0);
function part(index, matrices, isPlaced = true) {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(square, 3));
  const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }));
  return { mesh: index, isPlaced, cornerPositions: square, cornerNormals: new Int8Array(24), tree, matrices: matrices.map((one) => one.elements) }; // prettier-ignore
}
const at = (x, y = 0, z = 0) => new Matrix4().makeTranslation(x, y, z);
const mapOf = (more = {}) => ({ cornerUv: new Float32Array(12), pattern: 'checker', q: 4, scale: 3, isAligned: false, isCertified: true, ...more }); // prettier-ignore
const sceneOf = (parts, more = {}) => {
  const scene = new WholeScene(new Matrix3());
  const show = (some) => scene.show({ parts, open: -1, maps: new Map(), isOwnShown: false, palette, ...more, ...some }); // prettier-ignore
  show();
  return { scene, show };
};
const own = () => ({ visible: false, quiet: { value: -1 }, paper: { value: undefined } });
const drawn = ({ scene }) => scene.children.filter((one) => one.visible).map(({ userData }) => `${userData.mesh}.${userData.instance}`); // prettier-ignore

test('a mesh is the quieter the less there is to see of it: under the pointer, certified, with a map, without one', () => {
  const parts = [0, 1, 2, 3].map((i) => part(i, [at(2 * i)]));
  const maps = new Map([[0, mapOf()], [1, mapOf({ isCertified: false })]]); // prettier-ignore
  const { scene, show } = sceneOf(parts, { maps, open: 3 });
  const quiet = () => scene.children.map(({ material }) => material.uniforms.dim.value);
  const [certified, mapped, bare] = quiet();
  assert.ok(0 < certified && certified < mapped && mapped < bare && bare < 1);
  for (const i of [0, 1, 2]) {
    assert.equal(scene.pointAt(i), true);
    assert.equal(scene.pointAt(i), false, 'nothing new');
    const now = quiet();
    assert.ok(now[i] > 0 && now.every((one, k) => k === i || one > now[i]), 'least of all');
  }
  assert.equal(scene.pointAt(-1), true);
  assert.deepEqual(quiet().slice(0, 3), [certified, mapped, bare]);
  // With materials of the file, all are between untouched and what a pattern would be.
  const all = new Map(parts.map(({ mesh }) => [mesh, [own()]]));
  scene.setOwn(all);
  const ownQuiet = [...all.values()].map(([one]) => one.quiet.value);
  assert.equal(ownQuiet[3], 0, 'the open one is as it is');
  [certified, mapped, bare].forEach((one, i) => assert.ok(ownQuiet[i] > 0 && ownQuiet[i] < one));
  for (const [one] of all.values()) assert.equal(one.paper.value, palette.paper);
  show({ open: 0 });
  assert.equal(all.get(0)[0].quiet.value, 0);
  assert.ok(all.get(3)[0].quiet.value > 0);
});

test('every part has a ball around it, and one with positions that are not finite does not trouble three.js', () => {
  for (let round = 0; round < 20; round++) {
    const some = part(0, [at(0)]);
    some.cornerPositions = Float32Array.from({ length: 18 }, (_, i) => Math.sin(7.3 * round + i * i) * 10 ** (round % 5)); // prettier-ignore
    const [{ geometry }] = sceneOf([some]).scene.children;
    const ball = geometry.boundingSphere;
    const position = geometry.getAttribute('position');
    const far = Array.from({ length: 6 }, (_, i) => new Vector3().fromBufferAttribute(position, i).distanceTo(ball.center)); // prettier-ignore
    assert.ok(Math.max(...far) <= ball.radius * (1 + 1e-6));
    assert.ok(Math.max(...far) >= ball.radius / 2, 'and no larger than the box of the points');
    for (const bad of [NaN, Infinity, -Infinity]) {
      const broken = { ...some, cornerPositions: some.cornerPositions.with(round % 18, bad) };
      const [{ geometry: of }] = sceneOf([broken]).scene.children;
      assert.deepEqual(of.boundingSphere.center.toArray(), [0, 0, 0]);
    }
  }
});

test('each instance is drawn once: by the view, with its own materials, or with the pattern', () => {
  const parts = [part(0, [at(0), at(2)]), part(1, [at(4), at(6)]), part(2, [at(8)], false)];
  const maps = new Map([[1, mapOf()]]);
  const scene = sceneOf(parts, { maps, open: 0 });
  assert.deepEqual(drawn(scene), ['0.1', '1.0', '1.1']);
  const all = new Map(parts.map(({ mesh, matrices }) => [mesh, matrices.map(own)]));
  const shownOwn = () => [...all].flatMap(([i, some]) => some.flatMap(({ visible }, k) => (visible ? [`${i}.${k}`] : []))); // prettier-ignore
  scene.scene.setOwn(all);
  assert.deepEqual([drawn(scene), shownOwn()], [['1.0', '1.1'], ['0.1']], 'what has a map shows it'); // prettier-ignore
  scene.show({ isOwnShown: true });
  assert.deepEqual([drawn(scene), shownOwn()], [[], ['0.1', '1.0', '1.1']]);
  scene.show({ open: 1 });
  assert.equal(all.get(1)[0].visible, true, 'the view decides of the open one');
  all.get(1)[0].visible = false;
  scene.show({ open: 1 });
  assert.deepEqual([drawn(scene), shownOwn()], [['1.1'], ['0.0', '0.1']]);
  scene.scene.setOwn(undefined);
  assert.deepEqual(drawn(scene), ['0.0', '0.1', '1.1']);
});

test('the map of a mesh is on its corners, and one of another size is not shown', () => {
  const parts = [part(0, [at(0)])];
  const { scene, show } = sceneOf(parts);
  const [{ geometry, material }] = scene.children;
  const pattern = () => material.defines.PATTERN;
  assert.equal(pattern(), 0);
  const map = mapOf();
  show({ maps: new Map([[0, map]]) });
  const uv = geometry.getAttribute('uv');
  assert.equal(uv.array, map.cornerUv);
  assert.deepEqual([pattern() > 0, material.uniforms.scale.value], [true, 3]);
  show({ maps: new Map([[0, { ...map, scale: 5 }]]) });
  assert.equal(geometry.getAttribute('uv'), uv, 'uploaded once');
  assert.equal(material.uniforms.scale.value, 5);
  show({ maps: new Map([[0, mapOf({ cornerUv: new Float32Array(10) })]]) });
  assert.equal(pattern(), 0);
  show({ maps: new Map([[0, mapOf()]]) });
  assert.notEqual(geometry.getAttribute('uv'), uv);
  // Other parts replace them all.
  let isDisposed = false;
  geometry.addEventListener('dispose', () => (isDisposed = true));
  show({ parts: [part(5, [at(0)])] });
  assert.deepEqual([isDisposed, scene.children.length], [true, 1]);
});

test('a pointer finds the nearest instance, wherever matrices place, turn and stretch it', () => {
  const random = randomFrom(3);
  const turned = () => new Matrix4().makeRotationZ(6 * random()).scale(new Vector3(1 + random(), 2 + random(), 1)); // prettier-ignore
  const parts = [0, 1, 2, 3].map((i) => part(i, [0, 1].map((k) => turned().premultiply(at(random(), random(), i + 4 * k))), i !== 2)); // prettier-ignore
  const { scene, show } = sceneOf(parts);
  let found = 0;
  for (const open of [-1, 0, 3]) {
    show({ open });
    for (let i = 0; i < 100; i++) {
      const eye = new Vector3(4 * random() - 2, 4 * random() - 2, 20);
      // Each square is at one height: whether the point below the eye is in it.
      const hits = parts.flatMap(({ mesh, isPlaced, matrices }) =>
        matrices.flatMap((elements, k) => {
          const matrix = new Matrix4().fromArray(elements);
          const z = elements[14];
          const p = eye.clone().setZ(z).applyMatrix4(matrix.invert());
          const isIn = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
          return isPlaced && isIn && !(mesh === open && k === 0) ? [[20 - z, mesh]] : [];
        }),
      );
      const [far, nearest] = hits.sort((a, b) => a[0] - b[0])[0] ?? [Infinity, -1];
      const ray = new Ray(eye, new Vector3(0, 0, -1));
      assert.equal(scene.pick(ray, Infinity), nearest);
      if (nearest < 0) continue;
      found += 1;
      assert.equal(scene.pick(ray, far + 0.01), nearest);
      const within = hits.find(([one]) => one < far - 0.01) ?? [0, -1];
      assert.equal(scene.pick(ray, far - 0.01), within[1], 'something else is in front');
    }
  }
  assert.ok(found > 60, `${found}`);
});

test('framing looks at every instance that is placed, and at its finite points alone', () => {
  const parts = [part(0, [at(0), at(10)]), part(1, [at(0, 7)]), part(2, [at(99)], false)];
  const { center, radius, places } = shapeOf(parts);
  const points = Array.from({ length: places.length / 3 }, (_, i) => new Vector3().fromArray(places, 3 * i)); // prettier-ignore
  const spans = ['x', 'y', 'z'].map((key) => [Math.min(...points.map((p) => p[key])), Math.max(...points.map((p) => p[key]))]); // prettier-ignore
  assert.deepEqual(spans, [[0, 11], [0, 8], [0, 0]]); // prettier-ignore
  for (const p of points) assert.ok(p.distanceTo(center) <= radius + 1e-9);
  const odd = part(3, [at(0)]);
  odd.cornerPositions = square.slice().fill(NaN, 0, 3);
  assert.equal(shapeOf([odd]).places.length, square.length - 3);
  assert.equal(shapeOf([part(0, [at(0)], false)]), undefined);
  assert.equal(shapeOf([]), undefined);
  // Of many instances a share of the points each.
  const many = shapeOf([
    part(
      0,
      Array.from({ length: 4000 }, (_, i) => at(i)),
    ),
  ]);
  assert.ok(many.places.length <= 3 * 8000 && many.radius > 1999);
});
