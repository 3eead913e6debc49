// The checks that the page makes itself: how far the file may be from the map, which triangles may be without area,
// which placements are reflections, and what a link may say.

import assert from 'node:assert/strict';
import test from 'node:test';
import { readHash, writeHash } from '../../../web/src/formats/hash_state.ts';
import { Document } from '../../../web/src/model/document.ts';
import { emptyPrescription } from '../../../web/src/model/prescription.ts';
import { differenceOf } from '../../../web/src/services/geometry/analyse.ts';
import { locatedSurface, placed } from '../../../web/src/services/geometry/placed_surface.ts';
import { cubeMesh } from '../../support/meshes.mjs';
import { plainFacts } from './plain_facts.mjs';

test('the file holds the map up to single precision, and not by more', () => {
  const map = {
    positions: Float64Array.from({ length: 90 }, (_, i) => Math.sin(i)),
    uv: Float64Array.from({ length: 60 }, (_, i) => 3 * Math.cos(i)),
  };
  const changed = (name, at, by) => ({ ...map, [name]: map[name].map((x, i) => (i === at ? x + by : x)) }); // prettier-ignore
  assert.equal(differenceOf(map, map), '');
  const rounded = { positions: map.positions.map(Math.fround), uv: map.uv.map(Math.fround) };
  assert.equal(differenceOf(rounded, map), '');
  const size = Math.max(...map.uv.map(Math.abs));
  for (const at of [0, 17, 59]) {
    assert.equal(differenceOf(changed('uv', at, 1e-6 * size), map), '', `${at}`);
    assert.match(differenceOf(changed('uv', at, 4e-6 * size), map), /coordinates are off by 4/);
    assert.match(differenceOf(changed('uv', at, -2e-3 * size), map), /coordinates are off/);
  }
  assert.match(differenceOf(changed('positions', 89, 4e-6), map), /positions are off by 4/);
  assert.match(differenceOf(changed('uv', 3, NaN), map), /off by Infinity/);
  const fewer = { ...map, uv: map.uv.subarray(6) };
  assert.match(differenceOf(fewer, map), /^9 triangles with the map are in the file, not 10/);
});

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const scaled = (x, y, z) => [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 5, 6, 7, 1];
const quarter = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1];

test('a placement is a reflection exactly if it turns the surface inside out', () => {
  const mesh = cubeMesh(2);
  const surface = locatedSurface(
    {
      positions: Float64Array.from(mesh.vertices.flat()),
      triangles: Uint32Array.from(mesh.triangles.flat()),
    },
    plainFacts(mesh),
  );
  for (const [matrix, isMirrored] of [
    [identity, false],
    [scaled(1, 1, 1), false],
    [scaled(2, 3, 0.1), false],
    [quarter, false],
    [scaled(-1, 1, 1), true],
    [scaled(-1, -1, 1), false],
    [scaled(-2, -1, -3), true],
  ]) {
    const made = placed(surface, matrix);
    assert.equal(made.isMirrored, isMirrored, `${matrix}`);
    // Normals point outwards of what is drawn, reflected or not.
    const centre = made.center;
    for (let v = 0; v < mesh.vertices.length; v++) {
      const out = [0, 1, 2].map((i) => made.places[3 * v + i] - centre[i]);
      const dot = out.reduce((sum, x, i) => sum + x * made.normals[3 * v + i], 0);
      assert.ok(dot > 0, `${matrix}, vertex ${v}: ${dot}`);
    }
  }
});

test('a link holds the settings of Run that differ from those of a new page', () => {
  const { look, solve } = new Document();
  const prescription = emptyPrescription(4, 0, 0);
  const read = (more) =>
    readHash(writeHash({ look, prescription, solve: { ...solve, ...more } }).hash);
  const none = read({});
  assert.deepEqual([none.grid, none.improve], [undefined, undefined]);
  for (const grid of [
    { isOn: false, mode: 'tile', cells: undefined },
    { isOn: true, mode: 'quad', cells: undefined },
    { isOn: true, mode: 'tile', cells: 1200 },
  ])
    assert.deepEqual(read({ grid }).grid, grid);
  for (const improve of [-1, 0, 0.25, 1]) assert.equal(read({ improve }).improve, improve);
  assert.deepEqual([none.rounds, none.timeLimit, none.features], [undefined, undefined, undefined]);
  assert.equal(read({ rounds: 30 }).rounds, 30);
  assert.equal(read({ timeLimit: 90 }).timeLimit, 90);
  for (const bad of ['#rounds=0', '#rounds=2.5', '#limit=-1', '#limit=soon'])
    assert.deepEqual([readHash(bad).rounds, readHash(bad).timeLimit], [undefined, undefined]);
  for (const bad of ['#improve=2', '#improve=x', '#grid=hex', '#cells=12'])
    assert.deepEqual([readHash(bad).grid, readHash(bad).improve], [undefined, undefined]);
});

test('a link holds the edges that lines follow, and tells what it has no room for', () => {
  const { look, solve } = new Document();
  const model = 'c0ffee00.0';
  const none = emptyPrescription(4, 0, 0);
  const written = (features, prescription = none) =>
    writeHash({ look, solve, prescription, features, model });
  const chosen = { hasCreases: true, hasRims: true, edges: [[3, 5], [5, 8]], rims: [[0, 1]] }; // prettier-ignore
  const read = readHash(written(chosen).hash);
  const { rims: _, ...asked } = chosen;
  assert.deepEqual(read.features, asked);
  assert.equal(read.model, model);
  const onlyRims = { hasCreases: false, hasRims: true, edges: [] };
  assert.deepEqual(readHash(written(onlyRims).hash).features, onlyRims);
  const mirrored = { hasCreases: false, hasRims: false, edges: [], isSymmetric: true };
  assert.deepEqual(readHash(written(mirrored).hash).features, mirrored);
  assert.equal(readHash(written(mirrored).hash).model, model);
  assert.equal(readHash(written(undefined).hash).features, undefined);
  assert.equal(readHash('#creases=1').features, undefined);
  assert.equal(readHash(`#edges=${btoa('[[-1,2]]').replaceAll('=', '')}`).features, undefined);
  assert.deepEqual(written(chosen).omitted, []);
  const many = (n) => Array.from({ length: n }, (_, i) => [i, i + 1]);
  const cones = many(5000).map(([vertex]) => ({ vertex, k: 3 }));
  const long = written({ ...chosen, edges: many(4000) }, { ...none, cones });
  assert.deepEqual(long.omitted, ['5000 cones', '4000 edges that lines follow']);
  assert.ok(long.hash.length < 500);
  assert.equal(readHash(long.hash).cones, undefined);
});

test('a link holds every q from 1 to 64, and nothing else', () => {
  for (const q of [1, 4, 63, 64]) assert.equal(readHash(`#q=${q}`).q, q);
  for (const q of ['0', '65', '-4', '4.5', 'four', '1e9', '']) assert.equal(readHash(`#q=${q}`).q, undefined, q); // prettier-ignore
  const { look, solve } = new Document();
  const prescription = { ...emptyPrescription(64, 2, 2), cones: [{ vertex: 12, k: 63 }] };
  prescription.turnings = [null, -5];
  prescription.handles = [7, null];
  const read = readHash(
    writeHash({ look: { ...look, overlay: 'area' }, solve, prescription }).hash,
  );
  assert.equal(read.q, 64);
  assert.deepEqual(read.cones, [{ vertex: 12, k: 63 }]);
  assert.deepEqual([read.turnings, read.handles], [[[1, -5]], [[0, 7]]]);
  assert.deepEqual([read.overlay, read.pattern], ['area', look.pattern]);
  // Of a cone without an angle, and of pictures, which are not in the link, nothing is taken.
  const bad = writeHash({
    look,
    solve,
    prescription: { ...prescription, cones: [{ vertex: 1, k: 0 }] },
  });
  assert.equal(readHash(bad.hash).cones, undefined);
  for (const pattern of ['image', 'material', 'javascript:'])
    assert.equal(readHash(`#pattern=${pattern}`).pattern, undefined);
  for (const tiles of ['0', '1001', 'NaN']) assert.equal(readHash(`#tiles=${tiles}`).tiles, undefined); // prettier-ignore
});
