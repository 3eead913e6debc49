// Sentences, commands and clocks that need no browser; and the store that the page is drawn from.

import assert from 'node:assert/strict';
import test from 'node:test';
import { effect } from '@preact/signals-core';
import { deleteCone, setPrescription } from '../../../web/src/actions/edit_cones.ts';
import { Document } from '../../../web/src/model/document.ts';
import { suggestedK } from '../../../web/src/model/gauss_bonnet.ts';
import { balancingCones, weightsOf } from '../../../web/src/services/geometry/balance_cones.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { plainFacts } from './plain_facts.mjs';
import { quoted } from '../../../web/src/text/cli_command.ts';
import { TimeLeft } from '../../../web/src/text/time_left.ts';
import { cubeMesh } from '../../support/meshes.mjs';

test('file names are quoted in the command line that the page copies', () => {
  assert.equal(quoted('a b.obj'), "'a b.obj'");
  assert.equal(quoted('a$(touch x)`id`.obj'), "'a$(touch x)`id`.obj'");
  assert.equal(quoted("it's.obj"), "'it'\\''s.obj'");
  assert.equal(quoted('-o.obj'), './-o.obj');
  assert.equal(quoted('--help x'), "'./--help x'");
});

test('remaining seconds are shown only after a stage ended as estimated, and never increase', () => {
  const clock = new TimeLeft();
  const at = (stage, fraction, whole, now) => clock.update(stage, fraction, whole, 0, now);
  assert.equal(at('field', 0.1, 0.05, 1), undefined);
  assert.equal(at('field', 0.5, 0.1, 5), undefined);
  assert.equal(at('field', 1, 0.2, 10), undefined);
  assert.equal(at('solve', 0, 0.2, 10), 40); // as promised: believed from here on
  const said = at('solve', 0.3, 0.5, 22);
  assert.ok(said <= 28, `${said}`);
  // It takes longer: nothing is promised any more, instead of more and more.
  assert.equal(at('solve', 0.3, 0.5, 60), undefined);
  const wrong = new TimeLeft();
  wrong.update('field', 0.5, 0.1, 0, 2);
  wrong.update('field', 1, 0.2, 0, 30);
  assert.equal(wrong.update('solve', 0, 0.2, 0, 30), undefined);
});

test('readers of a value are notified of changes; derived values follow', () => {
  const doc = new Document();
  const seen = [];
  effect(() => void seen.push(doc.stateName));
  doc.state = { kind: 'empty' };
  const controller = new AbortController();
  doc.job = { kind: 'load', title: '', stage: 'read', entered: [], detail: '', fraction: 0, begin: 0, controller }; // prettier-ignore
  doc.look = { ...doc.look, tiles: 9 }; // about something else
  doc.job = undefined;
  assert.deepEqual(seen, ['starting', 'empty', 'loading', 'empty']);
});

function cubeSurface(n) {
  const { vertices, triangles } = cubeMesh(n);
  const positions = Float64Array.from(vertices.flat());
  const arrays = { positions, triangles: Uint32Array.from(triangles.flat()) };
  return locatedSurface(arrays, plainFacts({ vertices, triangles }));
}

test('a click on a flat side places a cone of the sign that is missing', () => {
  const surface = cubeSurface(8);
  surface.angle = surface.angle.slice();
  const flat =
    8 + surface.angle.subarray(8).findIndex((angle) => Math.abs(angle - 2 * Math.PI) < 1e-9);
  surface.angle[flat] += 0.02; // a saddle, by a degree
  assert.equal(suggestedK(surface, flat, 4, 8), 3);
  assert.equal(suggestedK(surface, flat, 4, -1), 5);
  assert.equal(suggestedK(surface, 0, 4, 8), 3); // a corner of the cube
  assert.equal(suggestedK(surface, 0, 6, 12), 5); // 270° are k = 4.5 for q = 6
});

test('the corners of a cube are where missing cones cost least', () => {
  const surface = cubeSurface(6);
  const added = balancingCones(surface, 4, [{ vertex: 3, k: 3 }], new Map([[0, 7]]));
  assert.deepEqual(added.map(({ k }) => k), [3, 3, 3, 3, 3, 3, 3]); // prettier-ignore
  const at = added.map(({ vertex }) => vertex).sort((a, b) => a - b);
  assert.deepEqual(at, [0, 1, 2, 4, 5, 6, 7]);
  // Too much of one kind is made up for by the other.
  const nine = Array.from({ length: 9 }, (_, vertex) => ({ vertex, k: 3 }));
  assert.deepEqual(balancingCones(surface, 4, nine, new Map([[0, -1]])).map(({ k }) => k), [5]); // prettier-ignore
});

test('cones are added with some distance from each other, where there is a choice', () => {
  // A cube with a thorn, at which one cone after the other would cost least.
  const { vertices, triangles } = cubeMesh(20);
  const high = Math.max(...vertices.map((p) => p[2]));
  const [mx, my] = [0, 1].map((i) => (Math.min(...vertices.map((p) => p[i])) + Math.max(...vertices.map((p) => p[i]))) / 2); // prettier-ignore
  const size = high - Math.min(...vertices.map((p) => p[2]));
  for (const p of vertices) {
    if (p[2] < high) continue;
    p[2] += 2 * size * Math.exp(-(((p[0] - mx) ** 2 + (p[1] - my) ** 2) / (0.01 * size ** 2)));
  }
  const positions = Float64Array.from(vertices.flat());
  const arrays = { positions, triangles: Uint32Array.from(triangles.flat()) };
  const surface = locatedSurface(arrays, plainFacts({ vertices, triangles }));
  const added = balancingCones(surface, 4, [], new Map([[surface.component[0], 8]]));
  assert.equal(added.length, 8);
  for (const [i, a] of added.entries()) {
    for (const b of added.slice(i + 1)) {
      const far = Math.hypot(
        ...[0, 1, 2].map((k) => vertices[a.vertex][k] - vertices[b.vertex][k]),
      );
      assert.ok(far > 0.06 * surface.diagonal, `${a.vertex} ${b.vertex}: ${far}`);
    }
  }
});

test('the weights of edges are cotangents: coordinates are harmonic where the surface is flat', () => {
  // A lattice of nearly equilateral triangles.
  const n = 8;
  const shift = (i) => 0.15 * Math.sin(37 * i);
  const vertices = Array.from({ length: n * n }, (_, v) => {
    const [i, j] = [v % n, Math.floor(v / n)];
    return [i + j / 2 + shift(v), (Math.sqrt(3) / 2) * j + shift(v + 100), 0];
  });
  const triangles = [];
  for (let j = 0; j + 1 < n; j++)
    for (let i = 0; i + 1 < n; i++) {
      const v = j * n + i;
      triangles.push([v, v + 1, v + n], [v + 1, v + n + 1, v + n]);
    }
  const positions = Float64Array.from(vertices.flat());
  const arrays = { positions, triangles: Uint32Array.from(triangles.flat()) };
  const surface = locatedSurface(arrays, plainFacts({ vertices, triangles }));
  const weights = weightsOf(surface);
  const { neighbourStart, neighbours, isBoundary } = surface;
  for (let v = 0; v < vertices.length; v++) {
    if (isBoundary[v]) continue;
    for (const i of [0, 1]) {
      let sum = 0;
      for (let k = neighbourStart[v]; k < neighbourStart[v + 1]; k++)
        sum += weights[k] * (vertices[v][i] - vertices[neighbours[k]][i]);
      assert.ok(Math.abs(sum) < 1e-12, `${v}: ${sum}`);
    }
  }
});

test('a component of few vertices is balanced with cones that share triangles, and with smaller k', () => {
  // A tetrahedron, whose four vertices need 8, and a cube.
  const { vertices, triangles } = cubeMesh(2);
  const first = vertices.length;
  const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((p) => p.map((x) => x + 5)); // prettier-ignore
  const sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map((t) => t.map((v) => v + first)); // prettier-ignore
  const mesh = { vertices: [...corners, ...vertices], triangles: [] };
  mesh.triangles = [
    ...sides.map((t) => t.map((v) => v - first)),
    ...triangles.map((t) => t.map((v) => v + 4)),
  ];
  const positions = Float64Array.from(mesh.vertices.flat());
  const arrays = { positions, triangles: Uint32Array.from(mesh.triangles.flat()) };
  const surface = locatedSurface(arrays, plainFacts(mesh));
  const [small, large] = [surface.component[0], surface.component[4]];
  const spent = (cones, component) =>
    cones.reduce((sum, { vertex, k }) => sum + (surface.component[vertex] === component ? 4 - k : 0), 0); // prettier-ignore
  const added = balancingCones(surface, 4, [], new Map([[small, 8], [large, 8]])); // prettier-ignore
  assert.deepEqual([spent(added, small), spent(added, large)], [8, 8]);
  assert.ok(added.every(({ k }) => k >= 1));
  assert.equal(new Set(added.map(({ vertex }) => vertex)).size, added.length);
  // Where nothing fits, the other components are balanced all the same.
  const full = balancingCones(surface, 4, [], new Map([[small, 80], [large, 8]])); // prettier-ignore
  assert.equal(spent(full, large), 8);
});

test('each cone that is deleted is one step of undo, however quickly', () => {
  const doc = new Document();
  const app = { doc };
  const cones = [3, 5, 7].map((vertex) => ({ vertex, k: 3 }));
  setPrescription(app, { ...doc.prescription, cones }, 'import cones');
  deleteCone(app, 0);
  deleteCone(app, 0);
  const left = () => doc.prescription.cones.map(({ vertex }) => vertex);
  assert.deepEqual(left(), [7]);
  doc.history = doc.history.undo();
  assert.deepEqual(left(), [5, 7]);
  doc.history = doc.history.undo();
  assert.deepEqual(left(), [3, 5, 7]);
});
