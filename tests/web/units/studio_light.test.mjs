// The light of the 3D view: its nine numbers against the integral that they approximate, its picture, and how it turns.

import assert from 'node:assert/strict';
import test from 'node:test';
import {
  DataUtils,
  EquirectangularReflectionMapping,
  Matrix3,
  Matrix4,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  Texture,
  Vector3,
} from 'three';
import { irradiance, radiance, StudioLight } from '../../../web/src/views/studio_light.ts';
import { randomFrom } from '../../mutation/draw.mjs';

const unit = (p) => p.map((x) => x / Math.hypot(...p));

/** What a white matte surface with this normal reflects: the integral of light times cosine, over π. */
function reflected([a, b, c]) {
  const [rows, columns] = [200, 400];
  let sum = 0;
  for (let i = 0; i < rows; i++) {
    const y = -1 + (2 * i + 1) / rows; // rings of equal area
    for (let j = 0; j < columns; j++) {
      const angle = (2 * Math.PI * j) / columns;
      const [x, z] = [Math.cos(angle), Math.sin(angle)].map((t) => t * Math.sqrt(1 - y * y));
      sum += radiance(x, y, z) * Math.max(0, a * x + b * y + c * z);
    }
  }
  return (4 * sum) / (rows * columns);
}

const approximated = ([x, y, z]) =>
  [1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y].reduce(
    (sum, term, i) => sum + term * irradiance[i],
    0,
  );

/** The mean of the light over the sphere of directions. */
function mean() {
  const [rows, columns] = [400, 800];
  let sum = 0;
  for (let i = 0; i < rows; i++) {
    const y = -1 + (2 * i + 1) / rows;
    for (let j = 0; j < columns; j++) {
      const angle = (2 * Math.PI * j) / columns;
      const [x, z] = [Math.cos(angle), Math.sin(angle)].map((t) => t * Math.sqrt(1 - y * y));
      sum += radiance(x, y, z);
    }
  }
  return sum / (rows * columns);
}

const normals = [
  ...[-1, 1].flatMap((s) => [0, 1, 2].map((k) => [0, 1, 2].map((i) => (i === k ? s : 0)))),
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((i) => unit([i & 1, (i >> 1) & 1, i >> 2].map((b) => 2 * b - 1))),
];

test('nine numbers give what a matte surface reflects, within 0.03', () => {
  for (const normal of normals) {
    const [seen, wanted] = [approximated(normal), reflected(normal)];
    assert.ok(Math.abs(seen - wanted) < 0.03, `${normal}: ${seen}, not ${wanted}`);
  }
});

test('of all functions that nine such numbers give, theirs is nearest to what is reflected: the rest has no part of any', () => {
  // Directions evenly on the sphere, as many for light as there is time for.
  const evenly = (count) =>
    Array.from({ length: count }, (_, i) => {
      const y = 1 - (2 * i + 1) / count;
      const angle = i * Math.PI * (3 - Math.sqrt(5));
      const r = Math.sqrt(1 - y * y);
      return [r * Math.cos(angle), y, r * Math.sin(angle)];
    });
  const light = evenly(20_000).map(([x, y, z]) => ({ x, y, z, of: radiance(x, y, z) }));
  const around = evenly(600);
  const terms = ([x, y, z]) => [1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y];
  const parts = Array(9).fill(0);
  const sizes = Array(9).fill(0);
  for (const normal of around) {
    const [a, b, c] = normal;
    let seen = 0;
    for (const { x, y, z, of } of light) seen += of * Math.max(0, a * x + b * y + c * z);
    const rest = (4 * seen) / light.length - approximated(normal);
    terms(normal).forEach((term, i) => {
      parts[i] += (rest * term) / around.length;
      sizes[i] += term ** 2 / around.length;
    });
  }
  parts.forEach((part, i) => {
    assert.ok(Math.abs(part / sizes[i]) < 1e-3, `number ${i} is ${part / sizes[i]} too small`);
  });
});

test('the first of the nine numbers is the mean of the light', () => {
  assert.ok(Math.abs(irradiance[0] / mean() - 1) < 1e-4, `${irradiance[0]}, ${mean()}`);
});

test('a white surface that faces the lamp is white, and no side is black', () => {
  const seen = normals.map(approximated);
  assert.ok(Math.max(...seen) > 0.85 && Math.max(...seen) < 1.05, `${Math.max(...seen)}`);
  assert.ok(Math.min(...seen) > 0.12, `${Math.min(...seen)}`);
});

test('the room grows lighter from the floor over the walls to the ceiling, wherever one looks', () => {
  const least = (y) => Math.min(...Array.from({ length: 90 }, (_, i) => radiance(Math.cos(i) * Math.sqrt(1 - y * y), y, Math.sin(i) * Math.sqrt(1 - y * y)))); // prettier-ignore
  const heights = [-0.8, -0.4, 0, 0.4, 0.8, 1].map(least);
  for (let i = 1; i < heights.length; i++) assert.ok(heights[i] > heights[i - 1], `${heights}`);
  assert.ok(heights[2] > 1.5 * heights[0] && heights[5] > 2.5 * heights[0], `${heights}`);
});

test('materials are lit by a picture of the studio: every pixel shows the light from its direction', (t) => {
  const pictures = [];
  const disposed = [];
  const generators = t.mock.method(PMREMGenerator.prototype, 'dispose').mock;
  t.mock.method(PMREMGenerator.prototype, 'fromEquirectangular', (picture) => {
    picture.addEventListener('dispose', () => disposed.push(picture));
    pictures.push(picture);
    return { texture: new Texture() };
  });
  const scene = new Scene();
  const light = new StudioLight({}, scene, new Matrix3());
  light.restore();
  assert.equal(pictures.length, 0, 'nobody has asked for it');
  light.lightMaterials();
  const { environment } = scene;
  light.lightMaterials();
  assert.deepEqual([pictures.length, scene.environment], [1, environment], 'once');
  light.restore();
  assert.equal(pictures.length, 2);
  assert.ok(scene.environment && scene.environment !== environment, 'drawn again');
  assert.deepEqual(disposed, pictures, 'the pictures are of no more use');
  assert.equal(generators.callCount(), 2, 'nor are the programs that drew them');
  for (const { mapping, image, version } of pictures) {
    assert.deepEqual([mapping, version], [EquirectangularReflectionMapping, 1]);
    const { data, width, height } = image;
    assert.deepEqual([data.length, width], [4 * width * height, 2 * height]);
    for (let i = 0; i < width * height; i++) {
      // As three.js looks it up: along the equator, and from the lowest row to the highest.
      const [u, v] = [((i % width) + 0.5) / width, (Math.floor(i / width) + 0.5) / height];
      const [around, up] = [2 * Math.PI * (u - 0.5), Math.PI * (v - 0.5)];
      const seen = radiance(Math.cos(around) * Math.cos(up), Math.sin(up), Math.sin(around) * Math.cos(up)); // prettier-ignore
      const pixel = [...data.subarray(4 * i, 4 * i + 4)].map((half) => DataUtils.fromHalfFloat(half)); // prettier-ignore
      if (pixel.slice(0, 3).some((x) => Math.abs(x / seen - 1) > 1e-3) || pixel[3] !== 1) assert.fail(`${pixel} instead of ${seen} at ${u}, ${v}`); // prettier-ignore
    }
  }
});

test('the studio turns with the camera around its target and stays upright, its lamp ahead or at the side', () => {
  const random = randomFrom(2);
  const some = (size) => new Vector3(...[0, 1, 2].map(() => size * (2 * random() - 1)));
  const [scene, toStudio] = [new Scene(), new Matrix3()];
  const light = new StudioLight({}, scene, toStudio);
  for (let round = 0; round < 60; round++) {
    const [target, camera] = [some(2), new PerspectiveCamera()];
    camera.position.copy(some(5).add(target));
    camera.lookAt(target);
    camera.updateMatrixWorld();
    const isFromSide = round % 2 === 1;
    light.isFromSide = isFromSide;
    light.turn(camera, target);
    // A direction in the picture, in the scene, and in the studio: up stays up, towards the camera is ahead.
    const turned = (eye) => eye.clone().applyMatrix3(toStudio);
    const inEye = (way) => way.clone().transformDirection(camera.matrixWorldInverse);
    const up = turned(inEye(new Vector3(0, 1, 0)));
    assert.ok(up.distanceTo(new Vector3(0, 1, 0)) < 1e-6, `${up.toArray()}`);
    const back = camera.position.clone().sub(target).setY(0).normalize();
    const ahead = turned(inEye(back));
    const aside = isFromSide ? 1.1 : 0;
    assert.ok(ahead.distanceTo(new Vector3(-Math.sin(aside), 0, Math.cos(aside))) < 1e-6, `${ahead.toArray()}`); // prettier-ignore
    // Materials look the light up in the same studio.
    const way = some(1).normalize();
    const looked = way.clone().applyMatrix4(new Matrix4().makeRotationFromEuler(scene.environmentRotation).invert()); // prettier-ignore
    assert.ok(looked.distanceTo(turned(inEye(way))) < 1e-6, `${looked.toArray()}`);
  }
});
