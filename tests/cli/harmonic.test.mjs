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

/** Relative residuals of the harmonic rows at the vertices of a closed surface. */
function residuals({ v, vt, faces }, q) {
  const next = new Map(); // vertex, neighbour → the face to the left of that edge
  faces.forEach((f, n) => {
    for (let k = 0; k < 3; k++) next.set(`${f[k][0]} ${f[(k + 1) % 3][0]}`, [n, k]);
  });
  const first = new Map();
  faces.forEach((f, n) => f.forEach(([vertex], k) => first.set(vertex, [n, k])));
  return [...first].map(([vertex, start]) => {
    let sum = [0, 0];
    let weights = 0;
    let edges = 0;
    let count = 0;
    let angle = 0; // of this sector against the first one
    let [n, k] = start;
    do {
      const f = faces[n];
      const [i, a, b] = [f[k], f[(k + 1) % 3], f[(k + 2) % 3]];
      const pa = minus(v[a[0]], v[i[0]]);
      const pb = minus(v[b[0]], v[i[0]]);
      const dot = pa.reduce((s, x, c) => s + x * pb[c], 0);
      const half = Math.tan(Math.acos(dot / (length(pa) * length(pb))) / 2);
      for (const [corner, p] of [
        [a, pa],
        [b, pb],
      ]) {
        const w = half / length(p);
        const d = minus(vt[corner[1]], vt[i[1]]);
        const [c, s] = [Math.cos(-angle), Math.sin(-angle)];
        sum = [sum[0] + w * (c * d[0] - s * d[1]), sum[1] + w * (s * d[0] + c * d[1])];
        weights += w;
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
    return { vertex, residual: length(sum) / weights / (edges / count) };
  });
}

for (const [name, options] of [
  ['automatic', []],
  ['with distortion', ['--quality']],
  ['prescribed', ['--cone', '3:3', '--cone', '77:3', '--cone', '130:5', '--cone', '200:5']],
]) {
  test(`the report's harmonicity is that of the file: ${name}`, () => {
    writeFileSync(at('torus.obj'), torus(24, 16));
    const args = ['param', at('torus.obj'), '-o', at('out.obj'), '--json', at('r.json'), '--force'];
    const { status, stderr } = spawnSync(hgp, [...args, '--quiet', ...options], {
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const cones = new Set(report.cones.cones.map(({ vertex }) => vertex));
    const rows = residuals(readObj(readFileSync(at('out.obj'), 'utf8')), report.cones.q).filter(
      ({ vertex }) => !cones.has(vertex),
    );
    const [{ harmonic, theorem61, theorem61Reason }] = report.components;
    const largest = Math.max(...rows.map(({ residual }) => residual));
    assert.equal(harmonic.rows, rows.length);
    assert.ok(Math.abs(harmonic.largestResidual - largest) < 1e-9 + 1e-6 * largest, `${largest}`);
    const near = rows.filter(({ residual }) => Math.abs(residual / 1e-6 - 1) < 1e-3).length;
    const violated = rows.filter(({ residual }) => residual > 1e-6).length;
    assert.ok(Math.abs(harmonic.violated - violated) <= near, `${violated}`);
    assert.equal(theorem61, harmonic.violated > 0 ? 'silent' : 'applies');
    assert.ok(theorem61Reason.length > 0);
  });
}
