// What a report says of harmonicity is what its file has: recomputed here from the written numbers.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { hgp, inFolder } from '../support/program.mjs';

const { at } = inFolder('harmonic');

/** A bumpy torus of n × m vertices. */
function torus(n, m) {
  const lines = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      const a = (2 * Math.PI * i) / n;
      const b = (2 * Math.PI * j) / m;
      const r = 0.4 + 0.08 * Math.sin(3 * a) * Math.cos(2 * b);
      const R = 1 + r * Math.cos(b);
      lines.push(`v ${R * Math.cos(a)} ${R * Math.sin(a)} ${r * Math.sin(b)}`);
    }
  const id = (i, j) => (i % n) * m + (j % m) + 1;
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) {
      lines.push(`f ${id(i, j)} ${id(i + 1, j)} ${id(i + 1, j + 1)}`);
      lines.push(`f ${id(i, j)} ${id(i + 1, j + 1)} ${id(i, j + 1)}`);
    }
  return lines.join('\n') + '\n';
}

/** A closed cylinder of long triangles: n sides, two fans. */
function cylinder(n, height) {
  const lines = ['v 0 0 0', `v 0 0 ${height}`];
  for (let i = 0; i < n; i++) {
    const [x, y] = [Math.cos((2 * Math.PI * i) / n), Math.sin((2 * Math.PI * i) / n)];
    lines.push(`v ${x} ${y} 0`, `v ${x} ${y} ${height}`);
  }
  for (let i = 0; i < n; i++) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => 3 + ((2 * i + k) % (2 * n)));
    lines.push(`f 1 ${c} ${a}`, `f 2 ${b} ${d}`, `f ${a} ${c} ${d}`, `f ${a} ${d} ${b}`);
  }
  return lines.join('\n') + '\n';
}

function readObj(text) {
  const v = [];
  const vt = [];
  const faces = [];
  for (const line of text.split('\n')) {
    const [key, ...rest] = line.trim().split(/\s+/);
    if (key === 'v') v.push(rest.slice(0, 3).map(Number));
    if (key === 'vt') vt.push(rest.slice(0, 2).map(Number));
    if (key === 'f') faces.push(rest.map((c) => c.split('/').map((n) => Number(n) - 1)));
  }
  return { v, vt, faces };
}

const minus = (a, b) => a.map((x, k) => x - b[k]);
const length = (a) => Math.hypot(...a);

const halfAngle = (a, b) =>
  Math.acos(a.reduce((s, x, c) => s + x * b[c], 0) / (length(a) * length(b))) / 2;

/** Relative residuals of the harmonic rows at the vertices of a closed surface, with the weights that a report names. */
function residuals({ v, vt, faces }, q, weights) {
  // Half the cotangent of the angle that faces edge k of face n, and of the one on the other side.
  const cotangent = (n, k) => {
    const [a, b, third] = [0, 1, 2].map((j) => v[faces[n][(k + j) % 3][0]]);
    return 0.5 / Math.tan(2 * halfAngle(minus(a, third), minus(b, third)));
  };
  const cotangents = (n, k) => {
    const [a, b] = [faces[n][k][0], faces[n][(k + 1) % 3][0]];
    const sum = cotangent(n, k) + cotangent(...next.get(`${b} ${a}`));
    return Math.min(Math.max(sum, 0.01), 20);
  };
  const next = new Map(); // vertex, neighbour → the face to the left of that edge
  faces.forEach((f, n) => {
    for (let k = 0; k < 3; k++) next.set(`${f[k][0]} ${f[(k + 1) % 3][0]}`, [n, k]);
  });
  const first = new Map();
  faces.forEach((f, n) => f.forEach(([vertex], k) => first.set(vertex, [n, k])));
  return [...first].map(([vertex, start]) => {
    let sum = [0, 0];
    let total = 0;
    let edges = 0;
    let count = 0;
    let angle = 0; // of this sector against the first one
    let [n, k] = start;
    do {
      const f = faces[n];
      const [i, a, b] = [f[k], f[(k + 1) % 3], f[(k + 2) % 3]];
      const pa = minus(v[a[0]], v[i[0]]);
      const pb = minus(v[b[0]], v[i[0]]);
      const half = Math.tan(halfAngle(pa, pb));
      for (const [corner, p, edge] of [
        [a, pa, k],
        [b, pb, (k + 2) % 3],
      ]) {
        const w = weights === 'cotangent' ? cotangents(n, edge) / 2 : half / length(p);
        const d = minus(vt[corner[1]], vt[i[1]]);
        const [c, s] = [Math.cos(-angle), Math.sin(-angle)];
        sum = [sum[0] + w * (c * d[0] - s * d[1]), sum[1] + w * (s * d[0] + c * d[1])];
        total += w;
        edges += length(d);
        count++;
      }
      // Counterclockwise over the edge to b; what its two sides differ by is the seam's rotation.
      const [m, l] = next.get(`${vertex} ${b[0]}`);
      const g = faces[m];
      const here = minus(vt[b[1]], vt[i[1]]);
      const there = minus(vt[g[(l + 1) % 3][1]], vt[g[l][1]]);
      const turned = Math.atan2(there[1], there[0]) - Math.atan2(here[1], here[0]);
      angle += (Math.round((turned * q) / (2 * Math.PI)) * 2 * Math.PI) / q;
      [n, k] = [m, l];
    } while (n !== start[0]);
    return { vertex, residual: length(sum) / total / (edges / count) };
  });
}

for (const [name, mesh, weights, options] of [
  ['automatic, without cones', torus(24, 16), 'cotangent', []],
  ['automatic, of long triangles', cylinder(24, 8), 'cotangent', []],
  ['with distortion', torus(24, 16), 'mean-value', ['--quality']],
  [
    'prescribed',
    torus(24, 16),
    'mean-value',
    ['--cone', '3:3', '--cone', '77:3', '--cone', '130:5', '--cone', '200:5'],
  ],
]) {
  test(`the report's harmonicity is that of the file: ${name}`, () => {
    writeFileSync(at('mesh.obj'), mesh);
    const args = ['param', at('mesh.obj'), '-o', at('out.obj'), '--json', at('r.json'), '--force'];
    const { status, stderr } = spawnSync(hgp, [...args, '--quiet', ...options], {
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const cones = new Set(report.cones.cones.map(({ vertex }) => vertex));
    const [{ harmonic, theorem61, theorem61Reason }] = report.components;
    assert.equal(harmonic.weights, weights);
    const mapped = readObj(readFileSync(at('out.obj'), 'utf8'));
    const rows = residuals(mapped, report.cones.q, harmonic.weights).filter(
      ({ vertex }) => !cones.has(vertex),
    );
    const largest = Math.max(...rows.map(({ residual }) => residual));
    assert.equal(harmonic.rows, rows.length);
    assert.ok(Math.abs(harmonic.largestResidual - largest) < 1e-9 + 1e-6 * largest, `${largest}`);
    const near = rows.filter(({ residual }) => Math.abs(residual / 1e-6 - 1) < 1e-3).length;
    const violated = rows.filter(({ residual }) => residual > 1e-6).length;
    assert.ok(Math.abs(harmonic.violated - violated) <= near, `${violated}`);
    assert.equal(theorem61, harmonic.violated > 0 ? 'silent' : 'applies');
    assert.ok(theorem61Reason.length > 0);
    if (weights === 'cotangent') assert.equal(theorem61, 'applies');
  });
}
