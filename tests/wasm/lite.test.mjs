// hgp/lite: the same maps as the whole package, from a module of less than half the size.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { BoxGeometry, TorusGeometry } from 'three';
import { limits } from '../../wasm/sizes.mjs';
import { cubeMesh } from '../support/meshes.mjs';
import { built, HgpError, withClient } from './support.mjs';

const { createLite } = await import(path.join(built, 'node/lite.js'));
const { optionsOf } = await import(path.join(built, 'lib/check_options.js'));
const { parametrizeGeometry } = await import(path.join(built, 'three.js'));
const lite = await createLite();

const flat = ({ vertices, triangles }) => ({
  positions: Float64Array.from(vertices.flat()),
  triangles: Uint32Array.from(triangles.flat()),
});
const cube = flat(cubeMesh(4));
const torus = () => {
  const { attributes, index } = new TorusGeometry(2, 0.7, 12, 24);
  return { positions: attributes.position.array, triangles: index.array };
};

/** Twice the least signed area of a triangle in uv, in doubles. */
const leastArea = ({ uv, cornerToUv }) => {
  let least = Infinity;
  for (let i = 0; i < cornerToUv.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      uv.subarray(2 * cornerToUv[i + k], 2 * cornerToUv[i + k] + 2),
    );
    least = Math.min(least, (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return least;
};

/** How far the two sides of a seam edge are from a rotation by 2πr/q, relative to its length. */
const worstSeam = ({ uv, seams, certificate: { q } }) =>
  Math.max(
    0,
    ...seams.map(({ a, b, r }) => {
      const side = ([from, to]) => [uv[2 * to] - uv[2 * from], uv[2 * to + 1] - uv[2 * from + 1]];
      const [x, y] = side(a);
      const [cos, sin] = [Math.cos((2 * Math.PI * r) / q), Math.sin((2 * Math.PI * r) / q)];
      const [u, v] = side(b);
      return Math.hypot(u - (cos * x - sin * y), v - (sin * x + cos * y)) / Math.hypot(x, y);
    }),
  );

test('the module is as small as promised', () => {
  const size = statSync(path.join(built, 'hgp-lite.wasm')).size;
  assert.ok(size <= limits.lite, `${size} bytes`);
});

test('maps are certified, positive, and their seams are rotations by the r that they name', () => {
  const cases = [
    [cube, {}],
    [cube, { q: 6, improve: 'isometric' }],
    [torus(), { count: 4 }],
    [{ positions: cube.positions, triangles: cube.triangles.slice(0, 12) }, {}],
  ];
  for (const [mesh, options] of cases)
    for (const precision of ['double', 'single']) {
      const map = lite.parametrizeMesh({ ...mesh, ...options, precision });
      assert.ok(map.certificate.certified, JSON.stringify(map.certificate));
      assert.ok(leastArea(map) > 0);
      assert.ok(worstSeam(map) < (precision === 'single' ? 1e-4 : 1e-9), `${worstSeam(map)}`);
      if (precision === 'single')
        assert.deepEqual(Float64Array.from(Float32Array.from(map.uv)), map.uv);
      for (const { triangles, positive } of map.certificate.components)
        assert.equal(positive, triangles);
      map.cornerToUv.forEach((i, corner) => {
        const [v, w] = [map.uvToVertex[i], mesh.triangles[corner]];
        for (let k = 0; k < 3; k++)
          assert.equal(mesh.positions[3 * v + k], mesh.positions[3 * w + k]);
      });
      const { uv, cornerToUv } = map;
      const { q } = map.certificate;
      if (precision === 'double')
        assert.ok(lite.verifyMesh({ ...mesh, uv, cornerToUv, q }).certified);
    }
});

test('cones are those of the whole package, or those that are asked for', () =>
  withClient(async (client) => {
    const { certificate } = lite.parametrizeMesh(cube);
    const whole = await client.parametrizeMesh(cube);
    const conesOf = (list) => list.map(({ vertex, k }) => [vertex, k]).sort((a, b) => a[0] - b[0]);
    assert.deepEqual(conesOf(certificate.components[0].cones), conesOf(whole.cones.cones));
    const cones = { q: 4, cones: whole.cones.cones.map(({ vertex, k }) => ({ vertex, k })) };
    const asked = lite.parametrizeMesh({ ...cube, cones });
    assert.deepEqual(conesOf(asked.certificate.components[0].cones), conesOf(cones.cones));
    // The whole package's verdict on lite's map, and lite's on that of the whole package.
    const { uv, cornerToUv } = whole;
    assert.ok(lite.verifyMesh({ ...cube, uv, cornerToUv, cones }).certified);
  }));

test('a map that is wrong is not certified, and the reason says how', () => {
  const { uv, cornerToUv } = lite.parametrizeMesh(cube);
  const mirrored = uv.map((x, i) => (i % 2 ? -x : x));
  const { certified, components } = lite.verifyMesh({ ...cube, uv: mirrored, cornerToUv });
  assert.equal(certified, false);
  assert.ok(
    components[0].reasons.some(({ rule, count }) => rule === 'orientation' && count === 192),
  );
  const moved = uv.slice();
  moved[2 * cornerToUv[0]] += 1e-3;
  assert.equal(lite.verifyMesh({ ...cube, uv: moved, cornerToUv }).certified, false);
  const other = { q: 4, cones: [{ vertex: 0, k: 2 }] };
  assert.equal(lite.verifyMesh({ ...cube, uv, cornerToUv, cones: other }).certified, false);
});

test('several components lie side by side; vertices at equal positions are joined unless that is not wanted', () => {
  const corners = [...cube.triangles].flatMap((v) => [
    ...cube.positions.subarray(3 * v, 3 * v + 3),
  ]);
  const soup = { positions: Float64Array.from(corners) };
  assert.equal(lite.parametrizeMesh(soup).certificate.components.length, 1);
  const apart = lite.parametrizeMesh({ ...soup, weld: false });
  assert.equal(apart.certificate.components.length, 192);
  assert.ok(apart.certificate.certified);
});

test('hgp/three takes hgp/lite', async () => {
  const geometry = new BoxGeometry(1, 1, 1, 4, 4, 4);
  const made = await parametrizeGeometry(lite, geometry, { q: 4 });
  assert.ok(made.certificate.certified);
  assert.equal(made.geometry.index.count, geometry.index.count);
  assert.ok(made.seams.geometry.attributes.position.count > 0);
  await assert.rejects(parametrizeGeometry(lite, geometry, { fix: { split: true } }), {
    code: 'usage',
    message: /hgp\/lite has no option 'fix'; hgp has/,
  });
});

test('hgp/three passes progress and signals to hgp/lite', async () => {
  const geometry = new BoxGeometry(1, 1, 1, 12, 12, 12);
  const stages = new Set();
  const onProgress = ({ stage }) => stages.add(stage);
  const { certificate } = await parametrizeGeometry(lite, geometry, {}, { onProgress });
  assert.ok(certificate.certified && stages.size > 2, [...stages].join());
  assert.equal(lite.onProgress, undefined);

  const reason = new Error('closed');
  const early = { signal: AbortSignal.abort(reason), onProgress: () => assert.fail('it ran') };
  await assert.rejects(parametrizeGeometry(lite, geometry, {}, early), reason);
  const controller = new AbortController();
  let calls = 0;
  const late = {
    signal: controller.signal,
    onProgress: () => {
      calls += 1;
      controller.abort(reason);
    },
  };
  await assert.rejects(parametrizeGeometry(lite, geometry, {}, late), reason);
  assert.equal(calls, 1);
  const wrong = {
    onProgress: () => {
      throw reason;
    },
  };
  await assert.rejects(parametrizeGeometry(lite, geometry, {}, wrong), reason);
  await assert.rejects(parametrizeGeometry(lite, geometry, {}, { keepWorker: true }), {
    code: 'usage',
    message: /no option 'keepWorker'/,
  });
  assert.ok((await parametrizeGeometry(lite, geometry)).certificate.certified);
});

test('errors have codes, and what only the whole package does is refused', () => {
  const refused = (call, code, message) =>
    assert.throws(call, (error) => {
      assert.ok(error instanceof HgpError, String(error));
      assert.equal(error.code, code, error.message);
      assert.match(error.message, message);
      return true;
    });
  refused(() => lite.parametrizeMesh({ ...cube, Q: 4 }), 'usage', /did you mean 'q'/);
  refused(() => lite.parametrizeMesh({ ...cube, grid: {} }), 'usage', /no option 'grid'/);
  const mapped = { ...cube, uv: [0, 0], cornerToUv: [...cube.triangles].fill(0) };
  for (const [call, mesh] of Object.entries({ parametrizeMesh: cube, verifyMesh: mapped }))
    for (const name of Object.keys(optionsOf[`lite.${call}`]))
      refused(() => lite[call]({ ...mesh, [name]: [] }), 'usage', new RegExp(`\\b${name} is .*an array`)); // prettier-ignore
  refused(() => lite.parametrizeMesh({ ...cube, q: 65 }), 'usage', /from 1 to 64/);
  const handles = { q: 4, cones: [], handles: [] };
  refused(() => lite.parametrizeMesh({ ...cube, cones: handles }), 'usage', /handles need hgp/);
  const wrong = { q: 4, cones: [{ vertex: 0, k: 3 }] };
  refused(() => lite.parametrizeMesh({ ...cube, cones: wrong }), 'prescription', /./);
  const nowhere = { q: 4, cones: [{ vertex: 9999, k: 3 }] };
  refused(() => lite.parametrizeMesh({ ...cube, cones: nowhere }), 'prescription', /vertex 9999/);
  const fan = { positions: cube.positions, triangles: [0, 1, 2, 0, 1, 3, 0, 1, 4] };
  refused(() => lite.parametrizeMesh({ ...fan }), 'unsupported', /hgp repairs such meshes/);
  refused(() => lite.verifyMesh({ ...cube, uv: [0, 0] }), 'usage', /cornerToUv names/);
  lite.onProgress = () => false;
  try {
    refused(() => lite.parametrizeMesh(torus()), 'cancelled', /./);
  } finally {
    lite.onProgress = undefined;
  }
  assert.ok(lite.parametrizeMesh(cube).certificate.certified);
});

test('every script of the package is loaded by one of its entries', () => {
  const { exports, bin = {} } = JSON.parse(readFileSync(path.join(built, 'package.json'), 'utf8'));
  const leaves = (entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(leaves);
  const scripts = readdirSync(built, { recursive: true, encoding: 'utf8' }).filter((name) =>
    /\.c?js$/.test(name),
  );
  const found = new Set();
  const visit = (name) => {
    if (found.has(name) || !scripts.includes(name)) return;
    found.add(name);
    const text = readFileSync(path.join(built, name), 'utf8');
    for (const [, other] of text.matchAll(/['"`](\.{1,2}\/[\w./-]+\.c?js)['"`]/g))
      visit(path.normalize(path.join(path.dirname(name), other)));
  };
  for (const entry of [...leaves(exports), ...leaves(bin)]) visit(path.normalize(entry));
  assert.ok(found.has(path.join('lib', 'lite.js')) && found.has('lite_module.js'));
  assert.deepEqual(
    scripts.filter((name) => !found.has(name)),
    [],
  );
});

test('with a URL, and with bytes', async () => {
  const file = path.join(built, 'hgp-lite.wasm');
  for (const options of [{ wasmUrl: pathToFileURL(file) }, { wasmBinary: readFileSync(file) }])
    assert.ok((await createLite(options)).parametrizeMesh(cube).certificate.certified);
  await assert.rejects(createLite({ wasmUrl: 'file:///no/such.wasm' }), {
    code: 'wasm-unavailable',
    message: /hgp-lite/,
  });
});
