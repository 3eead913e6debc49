// A file of several meshes with one grid: every component is aligned, or the run ends with 6 and says which is not.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { Random } from '../attack/random.mjs';
import { cubeMesh, toGlb, toObj } from '../support/meshes.mjs';
import { inFolder } from '../support/program.mjs';
import { flatSquare, torusMesh } from '../web/shapes.mjs';

const { at, folder, put, run, read, good } = inFolder('several-grids');

/** Twice the area of a triangle with these corners; with two coordinates, signed. */
function doubleArea([a, b, c]) {
  const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
  if (u.length === 2) return u[0] * v[1] - u[1] * v[0];
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]); // prettier-ignore
}

/** Of every group `o` of an OBJ file: its area in space and in uv. */
function areasOfObj(text) {
  const [v, vt, groups] = [[], [], []];
  for (const line of text.split('\n')) {
    const [key, ...words] = line.split(' ');
    if (key === 'v') v.push(words.slice(0, 3).map(Number));
    else if (key === 'vt') vt.push(words.slice(0, 2).map(Number));
    else if (key === 'o') groups.push({ inSpace: 0, inUv: 0 });
    else if (key === 'f') {
      const corners = words.map((word) => word.split('/').map((n) => Number(n) - 1));
      groups.at(-1).inSpace += doubleArea(corners.map(([i]) => v[i])) / 2;
      groups.at(-1).inUv += doubleArea(corners.map(([, i]) => vt[i])) / 2;
    }
  }
  return groups;
}

const scaled = ({ vertices, triangles }, size) => ({
  vertices: vertices.map((point) => point.map((x) => size * x)),
  triangles,
});

test('with several meshes every component is aligned, or the run ends with 6 and says why not', () => {
  const random = new Random(6);
  const shapes = [cubeMesh(3), cubeMesh(4), torusMesh(12, 8), flatSquare(6)];
  let aligned = 0;
  for (let n = 0; n < 8; n++) {
    const meshes = Array.from({ length: 3 }, () =>
      scaled(shapes[random.integer(0, 3)], 10 ** (random.integer(0, 20) / 10 - 1)),
    );
    const file = put(`${n}.glb`, toGlb(meshes));
    const [cells, mode] = [[60, 400, 2000][n % 3], ['tile', 'quad'][n % 2]];
    const done = run('param', file, '--cells', `${cells}`, '--grid-mode', mode, '-o', 'map.glb', '--force', '--json', 'map.json'); // prettier-ignore
    const components = JSON.parse(read('map.json')).meshes.flatMap(({ document }) => document.components); // prettier-ignore
    assert.equal(components.length, 3);
    const all = components.every(({ grid }) => grid?.aligned);
    assert.equal(done.code, all ? 0 : 6, `${cells} ${mode}: ${done.err}`);
    for (const { grid } of components) if (!grid?.aligned) assert.ok(grid?.reason, done.err);
    if (!all) continue;
    aligned++;
  }
  assert.ok(aligned >= 4, `${aligned} of 8 files are aligned`);
});

/** The same of every mesh of a GLB file; uv is that of the set TEXCOORD_0, V downwards. */
async function areasOfGlb(file) {
  const document = await new NodeIO().readBinary(readFileSync(path.join(folder, file)));
  return document
    .getRoot()
    .listMeshes()
    .map((mesh) => {
      const [part] = mesh.listPrimitives();
      const [p, t] = ['POSITION', 'TEXCOORD_0'].map((name) => part.getAttribute(name));
      const index = [...part.getIndices().getArray()];
      const sum = { inSpace: 0, inUv: 0 };
      for (let i = 0; i < index.length; i += 3) {
        const corners = index.slice(i, i + 3);
        sum.inSpace += doubleArea(corners.map((n) => p.getElement(n, []))) / 2;
        sum.inUv -= doubleArea(corners.map((n) => t.getElement(n, []))) / 2;
      }
      return sum;
    });
}

/** Those without a note have cells of one size, the others the part of it that their note says. */
function checkCells(what, areas, partsOf) {
  // A cell is a unit square in uv; maps keep areas about as well as cones, rims and integers allow.
  const cell = areas.map(({ inSpace, inUv }) => Math.sqrt(inSpace / inUv));
  areas.forEach(({ inUv }, n) => {
    const ratio = (cell[n] * partsOf(n)) / cell[0];
    assert.ok(ratio > 0.7 && ratio < 1.4, `${what}, component ${n}: cells of ${cell}`);
    assert.ok(Number.isInteger(Math.log2(partsOf(n))), `${what}, component ${n}`);
    assert.ok(inUv > 1, `${what}, component ${n} has the area of ${inUv} cells`);
  });
  assert.equal(partsOf(1), 1, what);
  assert.ok(partsOf(areas.length - 1) > 1, what);
}

test('cells have one size within a file; a component smaller than a few cells has a half, a quarter … of it', async () => {
  const parts = [20, 5, 1, 0.4, 0.1, 0.02].map((size, n) =>
    scaled([cubeMesh(4), torusMesh(12, 8)][n % 2], size),
  );
  let offset = 0;
  const text = parts.flatMap(({ vertices, triangles }, n) => {
    const first = offset + 1;
    offset += vertices.length;
    return [
      `o part${n}`,
      ...vertices.map(([x, y, z]) => `v ${x + 60 * n} ${y} ${z}`),
      ...triangles.map((corners) => `f ${corners.map((i) => i + first).join(' ')}`),
    ];
  });
  put('sizes.obj', `${text.join('\n')}\n`);
  put('sizes.glb', toGlb(parts));
  for (const mode of ['tile', 'quad'])
    for (const format of ['obj', 'glb']) {
      const done = run('param', `sizes.${format}`, '--cells', '400', '--grid-mode', mode, '-o', `sized.${format}`, '--force', '--json', 'sized.json'); // prettier-ignore
      assert.equal(done.code, 0, done.err);
      const areas =
        format === 'obj' ? areasOfObj(read('sized.obj')) : await areasOfGlb('sized.glb');
      assert.equal(areas.length, parts.length);
      const report = JSON.parse(read('sized.json'));
      const reports = report.meshes?.map(({ document }) => document) ?? [report];
      const found = reports.flatMap(({ components, notes }) =>
        components.map((component, n) => ({
          ...component,
          parts: notes.find(({ code, numbers }) => code === 'grid-smaller-cells' && numbers.component === n)?.numbers.parts ?? 1, // prettier-ignore
        })),
      );
      assert.ok(found.every(({ grid }) => grid.aligned));
      checkCells(`${mode} ${format}`, areas, (n) => found[n].parts);
    }
});

test('automatic cells have one size in a scene, as its nodes show the meshes, or a half, a quarter … of it', async () => {
  // The largest mesh as shown is neither the first nor the largest in its own units.
  const [shapes, sizes, scales] = [
    [cubeMesh(4), torusMesh(24, 16), cubeMesh(6), torusMesh(24, 16), cubeMesh(4)],
    [1, 3, 100, 0.2, 0.02],
    [1, 1, 0.06, 10, 5],
  ];
  const document = await new NodeIO().readBinary(toGlb(shapes.map((s, n) => scaled(s, sizes[n]))));
  document
    .getRoot()
    .listNodes()
    .forEach((node, n) => node.setScale([scales[n], scales[n], -scales[n]]));
  put('scene.glb', await new NodeIO().writeBinary(document));
  for (const cells of ['auto', '3000']) {
    const done = run('param', 'scene.glb', '--cells', cells, '-o', 'scene.out.glb', '--force', '--json', 'scene.json'); // prettier-ignore
    assert.equal(done.code, 0, done.err);
    const grids = JSON.parse(read('scene.json')).meshes.map(({ document: { components } }) => components[0].grid); // prettier-ignore
    const areas = await areasOfGlb('scene.out.glb');
    const cell = areas.map(({ inSpace, inUv }, n) => scales[n] * Math.sqrt(inSpace / inUv));
    assert.ok(grids.every(({ aligned }) => aligned));
    const parts = cell.map((length) => Math.log2(cell[2] / length));
    // On the smallest of 3000 cells in all there are so few that their size is not near that of the grid.
    for (const part of cells === 'auto' ? parts : parts.slice(0, 4))
      assert.ok(Math.abs(part - Math.round(part)) < 0.3 && part > -0.3, `${cells}: ${parts}`);
    if (cells === 'auto') {
      for (const [n, { inUv }] of areas.entries())
        assert.ok(inUv > 150 && (parts[n] < 0.5 || inUv < 1100), `${n}: ${inUv} cells, ${parts}`);
      assert.ok(parts[4] > 3 && parts[0] > 1 && Math.abs(parts[1] - parts[3]) < 0.3, `${parts}`);
    } else {
      // The others have room for cells of the same size; the smallest has not.
      assert.deepEqual(parts.slice(0, 4).map(Math.round).map(Math.abs), [0, 0, 0, 0], `${parts}`);
      assert.ok(parts[4] > 1, `${parts}`);
    }
  }
});

test('nodes that scale a mesh beyond all numbers do not change its cells', async () => {
  for (const scale of [1e120, 1e-120, 0]) {
    const document = await new NodeIO().readBinary(toGlb([cubeMesh(4), torusMesh(24, 16)]));
    document.getRoot().listNodes()[1].setScale([scale, scale, scale]);
    put('beyond.glb', await new NodeIO().writeBinary(document));
    for (const cells of ['auto', '900']) {
      const done = run('param', 'beyond.glb', '--cells', cells, '-o', 'beyond.out.glb', '--force', '--json', 'beyond.json'); // prettier-ignore
      assert.equal(done.code, 0, done.err);
      for (const { inUv } of await areasOfGlb('beyond.out.glb'))
        assert.ok(inUv > 150 && inUv < 1500, `${cells}, scale ${scale}: ${inUv} cells`);
    }
  }
});

test('a small piece without integers has cells of the size of the others', () => {
  const { vertices, triangles } = cubeMesh(4);
  const needle = [[9, 0, 0], [9.2, 0, 0], [9.1, 0.0001, 0]]; // prettier-ignore
  const all = { vertices: [...vertices, ...needle], triangles: [...triangles, [0, 1, 2].map((i) => i + vertices.length)] }; // prettier-ignore
  const text = [...all.vertices.map((p) => `v ${p.join(' ')}`), ...all.triangles.map((t) => `f ${t.map((i) => i + 1).join(' ')}`), '']; // prettier-ignore
  put('needle.obj', text.join('\n'));
  for (const cells of ['400', 'auto']) {
    const done = run('param', 'needle.obj', '--cells', cells, '-o', 'needle.out.obj', '--force', '--json', 'needle.json'); // prettier-ignore
    assert.equal(done.code, 0, done.err);
    const { components, notes } = JSON.parse(read('needle.json'));
    const [whole, small] = components.map(({ grid }) => grid);
    assert.equal(small.integers, 0);
    assert.ok(Math.abs(Math.log2(small.spacing / whole.spacing)) < 0.5, `${small.spacing}`);
    assert.ok(!notes.some(({ code }) => code === 'grid-smaller-cells'));
  }
});

test('a number of cells that was not reached is said without cones where there are none', () => {
  const [long, round] = [300, 4];
  const vertices = [];
  for (let j = 0; j < round; j++)
    for (let i = 0; i < long; i++) {
      const [a, b] = [(2 * Math.PI * i) / long, (2 * Math.PI * j) / round];
      const r = 1 + 0.01 * Math.cos(b);
      vertices.push([r * Math.cos(a), r * Math.sin(a), 0.01 * Math.sin(b)]);
    }
  const at = (i, j) => (j % round) * long + (i % long);
  const triangles = [];
  for (let j = 0; j < round; j++)
    for (let i = 0; i < long; i++) {
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  put('ring.obj', toObj({ vertices, triangles }));
  good(
    'param',
    'ring.obj',
    '--cells',
    '300',
    '-o',
    'ring_out.obj',
    '--force',
    '--json',
    'ring.json',
  );
  const { notes } = JSON.parse(read('ring.json'));
  const { asked, cones, cells } = notes.find(({ code }) => code === 'grid-cells-far').numbers;
  assert.deepEqual([asked, cones], [300, 0]);
  assert.ok(cells > 0 && cells !== 300);
});

test('cells that are too small are refused with a length that works', () => {
  put('cube.obj', toObj(cubeMesh(3)));
  const asked = (length) => run('param', at('cube.obj'), '--grid', length, '-o', at('tiny.obj'));
  const { code, err } = asked(1e-300);
  assert.equal(code, 2);
  const [, works] = err.match(/edges of (\S+) or more/);
  assert.equal(asked(works).code, 0);
  assert.equal(asked(Number(works) / 1.1).code, 2);
});
