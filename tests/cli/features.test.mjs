// Lines along features from outside: the files that the program writes, read by nothing of the project's own.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { toGlb, toObj } from '../support/meshes.mjs';
import { inFolder, shared } from '../support/program.mjs';
import { problems } from './schema.mjs';

const { at, put, read, run, good } = inFolder('features');

/** The surface of a box of n × n squares a side; `isOpen`: without its top. Edges of the box are its creases. */
function box(n, isOpen = false) {
  const vertices = [];
  const ids = new Map();
  const id = (p) => {
    const key = p.join(' ');
    if (!ids.has(key)) ids.set(key, vertices.push([p[0], p[1] * 1.3, p[2] * 0.7]) - 1);
    return ids.get(key);
  };
  const triangles = [];
  for (let axis = 0; axis < 3; axis++)
    for (const side of [0, n]) {
      if (isOpen && axis === 2 && side) continue;
      for (let i = 0; i < n; i++)
        for (let j = 0; j < n; j++) {
          const place = (u, v) => {
            const p = [0, 0, 0];
            [p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]] = [side, u, v];
            return id(p);
          };
          const [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
          if (side) triangles.push([a, b, c], [a, c, d]);
          else triangles.push([a, c, b], [a, d, c]);
        }
    }
  const isOnTwoSides = (key) => key.split(' ').map(Number).map((x) => x === 0 || x === n); // prettier-ignore
  const sides = new Map([...ids].map(([key, v]) => [v, isOnTwoSides(key)]));
  const creases = new Map();
  for (const t of triangles)
    for (let k = 0; k < 3; k++) {
      const [a, b] = [t[k], t[(k + 1) % 3]].sort((x, y) => x - y);
      const common = [0, 1, 2].filter((i) => sides.get(a)[i] && sides.get(b)[i] && vertices[a][i] === vertices[b][i]); // prettier-ignore
      if (common.length === 2) creases.set(`${a} ${b}`, [a, b]);
    }
  return { vertices, triangles, creases: [...creases.values()] };
}

/** uv of every corner of an OBJ of triangles, as numbers. */
function cornersOf(name) {
  const [uv, corners, faces] = [[], [], []];
  for (const line of read(name).split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'vt') uv.push(rest.slice(0, 2).map(Number));
    if (word !== 'f') continue;
    faces.push(rest.map((c) => Number(c.split('/')[0]) - 1));
    corners.push(rest.map((c) => uv[Number(c.split('/')[1]) - 1]));
  }
  return { corners, faces };
}

const key = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);

/** Sides of edges, `isAsked` by their vertices, that have no coordinate in common; every triangle must be positive. */
function crookedSides({ corners, faces }, isAsked) {
  let [count, crooked] = [0, 0];
  faces.forEach((t, f) => {
    const [[a, b], [c, d], [e, g]] = corners[f];
    assert.ok((c - a) * (g - b) - (d - b) * (e - a) > 0, `triangle ${f}`);
    for (let k = 0; k < 3; k++) {
      if (!isAsked(key(t[k], t[(k + 1) % 3]))) continue;
      count++;
      const [p, q] = [corners[f][k], corners[f][(k + 1) % 3]];
      if ((p[0] === q[0]) === (p[1] === q[1])) crooked++;
    }
  });
  assert.ok(count > 0);
  return crooked;
}

function rimsOf({ triangles }) {
  const count = new Map();
  for (const t of triangles)
    for (let k = 0; k < 3; k++) {
      const edge = key(t[k], t[(k + 1) % 3]);
      count.set(edge, (count.get(edge) ?? 0) + 1);
    }
  return new Set([...count].filter(([, n]) => n === 1).map(([edge]) => edge));
}

const closed = box(5);
const open = box(6, true);
put('closed.obj', toObj(closed));
put('open.obj', toObj(open));
put('creases.txt', closed.creases.map((e) => e.join(' ')).join('\n'));

test('creases of a file are straight, bit for bit, in every format', () => {
  good(
    'param',
    'closed.obj',
    '--features',
    'creases.txt',
    '-o',
    'out.obj',
    '--json',
    'report.json',
  );
  const asked = new Set(closed.creases.map(([a, b]) => key(a, b)));
  assert.equal(asked.size, 12 * 5);
  assert.equal(
    crookedSides(cornersOf('out.obj'), (edge) => asked.has(edge)),
    0,
  );
  const report = JSON.parse(read('report.json'));
  assert.deepEqual(problems('hgp-report', report), []);
  const { features } = report.certificate;
  assert.deepEqual(features, { edges: 60, straightEdges: 60, chains: 12, straightChains: 12, corners: 0 }); // prettier-ignore
  assert.equal(report.options.automaticCones, true);
  assert.deepEqual(report.certificate.components[0].cones.map((c) => c.measured), Array(8).fill(3)); // prettier-ignore
});

test('rims are straight, and the map is verified as such', () => {
  good('param', 'open.obj', '--rims', '-o', 'rims.obj');
  const rims = rimsOf(open);
  assert.equal(rims.size, 4 * 6);
  assert.equal(
    crookedSides(cornersOf('rims.obj'), (edge) => rims.has(edge)),
    0,
  );
  const { out } = good('verify', 'rims.obj', '--rims');
  assert.match(out, /ok +features +(\d+) of \1 chains straight, exactly; 24 edges/);
});

test('with a grid features lie on integers, in both modes', () => {
  const asked = new Set(closed.creases.map(([a, b]) => key(a, b)));
  for (const mode of ['tile', 'quad']) {
    good('param', 'closed.obj', '--features', 'creases.txt', '--cells', '200', '--grid-mode', mode, '-o', 'grid.obj'); // prettier-ignore
    const { corners, faces } = cornersOf('grid.obj');
    let count = 0;
    faces.forEach((t, f) => {
      for (let k = 0; k < 3; k++) {
        if (!asked.has(key(t[k], t[(k + 1) % 3]))) continue;
        const [p, q] = [corners[f][k], corners[f][(k + 1) % 3]];
        assert.ok(Number.isInteger(p[0] === q[0] ? p[0] : p[1]), `triangle ${f}`);
        count++;
      }
    });
    assert.equal(count, 2 * 60);
  }
});

test('quads cover the whole surface up to its rims, and corners are vertices', () => {
  const { out } = good('quads', 'open.obj', '--creases', '--cells', '150', '-o', 'quads.obj');
  assert.doesNotMatch(out, /left out|clipped/);
  const [vertices, count] = [[], new Map()];
  for (const line of read('quads.obj').split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') vertices.push(rest.map(Number));
    if (word !== 'f') continue;
    const quad = rest.map((c) => Number(c.split('/')[0]) - 1);
    quad.forEach((v, k) => {
      const edge = key(v, quad[(k + 1) % 4]);
      count.set(edge, (count.get(edge) ?? 0) + 1);
    });
  }
  // Open edges lie on the rim z = 4.2, and all around it: a box of 6 by 7.8.
  let length = 0;
  for (const [edge, n] of count) {
    const [a, b] = edge.split(' ').map((v) => vertices[v]);
    assert.ok(n === 2 || (n === 1 && Math.abs(a[2] - 4.2) < 1e-6 && Math.abs(b[2] - 4.2) < 1e-6));
    if (n === 1) length += Math.hypot(...a.map((x, i) => x - b[i]));
  }
  assert.ok(Math.abs(length - 2 * (6 + 7.8)) < 1e-5, `${length}`);
  for (const x of [0, 6])
    for (const y of [0, 7.8])
      for (const z of [0, 4.2])
        assert.ok(vertices.some((v) => Math.hypot(v[0] - x, v[1] - y, v[2] - z) < 1e-6));
});

test('without features rims are as before', () => {
  good('param', 'open.obj', '-o', 'plain.obj', '--json', 'plain.json');
  const rims = rimsOf(open);
  assert.ok(crookedSides(cornersOf('plain.obj'), (edge) => rims.has(edge)) > 0);
  assert.equal('features' in JSON.parse(read('plain.json')).certificate, false);
  const { code, out } = run('verify', 'plain.obj', '--rims');
  assert.equal(code, 6);
  assert.match(out, /no +features/);
  assert.match(out, /feature: \d+ of 24 feature edges are not straight/);
});

test('one changed bit makes verify say no', () => {
  good('param', 'open.obj', '--rims', '-o', 'one.obj');
  const lines = read('one.obj').split('\n');
  const { corners, faces } = cornersOf('one.obj');
  const rims = rimsOf(open);
  const places = faces.flatMap((t, f) => [0, 1, 2].map((k) => [f, k]));
  const [f, k] = places.find(([f, k]) => rims.has(key(faces[f][k], faces[f][(k + 1) % 3])));
  const uv = corners[f][k];
  const n = lines.findIndex((line) => {
    const [word, u, v] = line.trim().split(/\s+/);
    return word === 'vt' && Number(u) === uv[0] && Number(v) === uv[1];
  });
  const next = (x) => {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    view.setBigInt64(0, view.getBigInt64(0) + 1n);
    return view.getFloat64(0);
  };
  lines[n] = `vt ${uv.map((x) => next(x)).join(' ')}`;
  put('bent.obj', lines.join('\n'));
  assert.equal(run('verify', 'bent.obj').code, 0);
  assert.equal(run('verify', 'bent.obj', '--rims').code, 6);
});

test('features are stored with the cones, and solving these again gives the same map', () => {
  good(
    'param',
    'closed.obj',
    '--features',
    'creases.txt',
    '-o',
    'first.obj',
    '--json',
    'first.json',
  );
  const { cones } = JSON.parse(read('first.json'));
  assert.deepEqual(problems('hgp-cones', cones), []);
  const edges = cones.features.lines.flatMap(({ vertices: v }) => v.slice(1).map((b, i) => key(v[i], b))); // prettier-ignore
  assert.deepEqual(edges.sort(), closed.creases.map(([a, b]) => key(a, b)).sort());
  put('cones.json', JSON.stringify(cones));
  good('param', 'closed.obj', '--cones', 'cones.json', '-o', 'again.obj');
  assert.equal(read('again.obj'), read('first.obj'));
  good('verify', 'again.obj', '--cones', 'cones.json');
  good('param', 'closed.obj', '--cones', 'cones.json', '-o', 'again.glb', '--embed-cones');
  const { out } = good('verify', 'again.glb');
  assert.match(out, /ok +features +12 of 12 chains straight/);
});

test('features by sides of triangles and by lines of an OBJ are the same', () => {
  const asked = new Set(closed.creases.map(([a, b]) => key(a, b)));
  const rows = closed.triangles.flatMap((t, f) => [0, 1, 2].filter((k) => asked.has(key(t[k], t[(k + 1) % 3]))).map((k) => `1,${f},${k}`)); // prettier-ignore
  put('part.sharp', [rows.length, ...rows, ''].join('\n'));
  put('lines.obj', closed.creases.map((e) => `l ${e.map((v) => v + 1).join(' ')}`).join('\n'));
  good('param', 'closed.obj', '--features', 'creases.txt', '-o', 'a.obj');
  good('param', 'closed.obj', '--features', 'part.sharp', '-o', 'b.obj');
  good('param', 'closed.obj', '--features', 'lines.obj', '-o', 'c.obj');
  assert.equal(read('b.obj'), read('a.obj'));
  assert.equal(read('c.obj'), read('a.obj'));
});

test('creases are found by their angle', () => {
  good('param', 'closed.obj', '-o', 'found.obj', '--creases', '--json', 'found.json');
  good('param', 'closed.obj', '--features', 'creases.txt', '-o', 'listed.obj');
  assert.equal(read('found.obj'), read('listed.obj'));
  const { features } = JSON.parse(read('found.json')).cones;
  assert.equal(
    features.lines.reduce((sum, { vertices }) => sum + vertices.length - 1, 0),
    60,
  );
  good('param', 'closed.obj', '-o', 'none.obj', '--creases', '95', '--json', 'none.json');
  assert.equal('features' in JSON.parse(read('none.json')).certificate, false);
  for (const wrong of ['0', '180', 'nan', 'steep'])
    assert.equal(run('param', 'closed.obj', '-o', 'no.obj', '--creases', wrong).code, 2, wrong);
});

test('where no edge is as sharp as asked, a note says that lines follow none', () => {
  put(
    'flat.obj',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .4 .6 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n',
  );
  const noteOf = (mesh, ...words) => {
    good('param', mesh, words, '-o', 'none.obj', '--force', '--json', 'none.json');
    const { notes } = JSON.parse(read('none.json'));
    return notes.find(({ code }) => code === 'creases-none')?.numbers;
  };
  assert.deepEqual(noteOf('flat.obj', '--creases', '20'), { degrees: 20, rims: 1 });
  assert.equal(noteOf('flat.obj', '--creases', '--rims'), undefined);
  assert.deepEqual(noteOf('closed.obj', '--creases', '179'), { degrees: 179, rims: 0 });
});

test('check looks at triangles between three features as a run does: split', () => {
  assert.match(good('check', 'closed.obj', '--creases').out, /chosen automatically\nvalid/);
  const [a, b, c] = closed.triangles[7];
  put('triangle.txt', `${a} ${b}\n${b} ${c}\n${c} ${a}\n`);
  good('check', 'closed.obj', '--features', 'triangle.txt', '--json', 'check.json');
  assert.deepEqual(problems('hgp-check', JSON.parse(read('check.json'))), []);
  good('param', 'closed.obj', '--features', 'triangle.txt', '-o', 'split.obj', '--json', 'split.json'); // prettier-ignore
  const report = JSON.parse(read('split.json'));
  assert.deepEqual(problems('hgp-report', report), []);
  const [{ edges }] = report.refined.where;
  assert.ok(edges.every(({ id, other }) => [a, b, c].includes(id) && [a, b, c].includes(other))); // prettier-ignore
});

/** A wavy sheet of m × n squares. */
function sheet(m, n) {
  const vertices = [];
  for (let j = 0; j <= n; j++)
    for (let i = 0; i <= m; i++) vertices.push([i + 0.2 * Math.sin(j), j, 0.5 * Math.sin(i * 0.9)]);
  const triangles = [];
  for (let j = 0; j < n; j++)
    for (let i = 0; i < m; i++) {
      const a = j * (m + 1) + i;
      triangles.push([a, a + 1, a + m + 2], [a, a + m + 2, a + m + 1]);
    }
  return { vertices, triangles };
}

/** Which sides of the box around all uv hold each vertex, by the stored numbers: "l", "r", "b" and "t". */
function sidesOf(name) {
  const { corners, faces } = cornersOf(name);
  const all = corners.flat();
  const [[left, right], [bottom, top]] = [0, 1].map((k) => [Math.min(...all.map((p) => p[k])), Math.max(...all.map((p) => p[k]))]); // prettier-ignore
  const sides = new Map();
  faces.forEach((face, f) =>
    face.forEach((v, k) => {
      const [x, y] = corners[f][k];
      sides.set(v, (x === left ? 'l' : '') + (x === right ? 'r' : '') + (y === bottom ? 'b' : '') + (y === top ? 't' : '')); // prettier-ignore
    }),
  );
  return sides;
}

/** Expects that the boundary of the sheet lies on the sides of a rectangle, nothing else does, and where its corners are. */
function expectRectangle(name, { m, n }, corners) {
  const sides = sidesOf(name);
  for (const [v, on] of sides) {
    const [i, j] = [v % (m + 1), Math.floor(v / (m + 1))];
    const isOnRim = j <= n && (i === 0 || j === 0 || i === m || j === n); // later ones split edges
    assert.equal(on.length > 0, isOnRim, `vertex ${v} at ${i} ${j}`);
  }
  const found = [...sides].filter(([, on]) => on.length === 2).map(([v]) => v);
  if (corners) assert.deepEqual(found.sort((a, b) => a - b), corners); // prettier-ignore
  assert.equal(found.length, 4);
}

test('a disk becomes a rectangle, with corners that are chosen or given', () => {
  const [m, n] = [14, 9];
  const last = (m + 1) * (n + 1) - 1;
  put('sheet.obj', toObj(sheet(m, n)));
  good('param', 'sheet.obj', '--boundary', 'rectangle', '-o', 'chosen.obj', '--json', 'chosen.json'); // prettier-ignore
  assert.deepEqual(problems('hgp-report', JSON.parse(read('chosen.json'))), []);
  expectRectangle('chosen.obj', { m, n }, [0, m, last - m, last]);
  const told = JSON.parse(read('chosen.json')).cones.cones.map(({ vertex, k }) => [vertex, k]);
  assert.deepEqual(told, [[0, 1], [m, 1], [last - m, 1], [last, 1]]); // prettier-ignore
  const given = [4, 2 * (m + 1), m, last - 3];
  const cones = given.flatMap((v) => ['--cone', `${v}:1`]);
  good('param', 'sheet.obj', '--boundary', 'rectangle', cones, '-o', 'given.obj');
  expectRectangle('given.obj', { m, n }, given.sort((a, b) => a - b)); // prettier-ignore
  good('param', 'sheet.obj', '--boundary', 'rectangle', cones, '--improve', 'isometric', '-o', 'better.obj'); // prettier-ignore
  expectRectangle(
    'better.obj',
    { m, n },
    given.sort((a, b) => a - b),
  );
  assert.ok(dirichletOf('better.obj') < dirichletOf('given.obj'));
  good('verify', 'given.obj', '--rims', cones);
  const moved = run('verify', 'given.obj', '--rims', ...cones.slice(2), '--cone', `${given[0] + 1}:1`); // prettier-ignore
  assert.equal(moved.code, 6, moved.err);
  assert.match(moved.out, /cone-angle|angle sums? (is|are) not as asked/);
  // The same with the rims as features, and with a cone inside, which leaves three corners.
  good('param', 'sheet.obj', '--rims', cones, '-o', 'rims.obj');
  assert.equal(read('rims.obj').replace(/^#.*/gm, ''), read('given.obj').replace(/^#.*/gm, ''));
  const inside = 4 * (m + 1) + 6;
  good('param', 'sheet.obj', '--rims', '--cone', `${inside}:3`, '-o', 'three.obj', '--json', 'three.json'); // prettier-ignore
  const { cones: found } = JSON.parse(read('three.json'));
  assert.deepEqual(found.cones.map(({ vertex, k }) => [vertex, k]), [[inside, 3]]); // prettier-ignore
  good('verify', 'three.obj', '--rims', '--cone', `${inside}:3`, '--turning', '0:3');
  const refused = (code, pattern, ...words) => {
    const result = run('param', 'sheet.obj', '-o', 'no.obj', words);
    assert.equal(result.code, code, result.err);
    assert.match(result.err, pattern);
  };
  const asked = ['--boundary', 'rectangle'];
  refused(2, /no cones inside/, ...asked, '--cone', `${inside}:3`);
  refused(2, /four corners of 90°/, ...asked, ...cones.slice(2));
  refused(2, /four corners of 90°/, ...asked, ...cones.slice(2), '--cone', `${given[0]}:2`);
  refused(2, /q = 4/, ...asked, '--q', '3');
  refused(2, /not carried over to a refined/, ...asked, '--refine');
  refused(5, /given twice/, '--rims', '--cone', '0:1', '--cone', '0:1');
  refused(5, /k < 1/, '--rims', '--cone', `${inside}:0`);
  refused(5, /prescribed cones and corners/, '--rims', '--cone', `${inside}:3`, ...cones);
});

test('with --keep-going components that are no disks are left out of a rectangle, and said', () => {
  const mesh = (vertices, faces, first) =>
    [
      ...vertices.map((v) => `v ${v.join(' ')}`),
      ...faces.map((f) => `f ${f.map((v) => v + first + 1).join(' ')}`),
    ].join('\n');
  const square = [[0, 0, 0], [2, 0, 0], [2, 1, 0.2], [0, 1, 0], [1, 0.5, 0.3]]; // prettier-ignore
  const disk = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]; // prettier-ignore
  const corners = [[5, 0, 0], [6, 0, 0], [5, 1, 0], [5, 0, 1]]; // prettier-ignore
  const closed = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]; // prettier-ignore
  put('both.obj', `${mesh(square, disk, 0)}\n${mesh(corners, closed, 5)}\n`);
  put('none.obj', `${mesh(corners, closed, 0)}\n`);
  const asked = ['--boundary', 'rectangle', '--json', 'both.json', '-o'];
  assert.equal(run('param', 'both.obj', ...asked, 'stops.obj').code, 4);
  const { code, err } = run('param', 'both.obj', ...asked, 'goes.obj', '--keep-going');
  assert.equal(code, 6);
  assert.match(err, /component 1 has genus 0 and 0 loops/);
  const { components } = JSON.parse(read('both.json')).certificate;
  assert.deepEqual(components.map(({ certified }) => certified), [true, false]); // prettier-ignore
  // The corners of the disk are those of a rectangle.
  const uv = read('goes.obj').split('\n').filter((row) => row.startsWith('vt ')).slice(0, 5); // prettier-ignore
  const [u, v] = [0, 1].map((k) => new Set(uv.map((row) => row.split(' ')[k + 1])));
  assert.deepEqual([u.size, v.size], [3, 3], 'two values at the corners and one in the middle');
  assert.equal(run('param', 'none.obj', ...asked, 'none-out.obj', '--keep-going').code, 4);
});

test('what does not go together is refused', () => {
  const refused = (code, pattern, ...words) => {
    const result = run('param', 'closed.obj', '-o', 'no.obj', '--features', 'creases.txt', words);
    assert.equal(result.code, code, words.join(' '));
    assert.match(result.err, pattern);
    assert.ok(!existsSync(at('no.obj')));
  };
  refused(2, /q = 4/, '--q', '6');
  refused(2, /not carried over to a refined/, '--refine');
  refused(2, /--boundary convex cannot be combined/, '--boundary', 'convex');
  refused(5, /Σ = 4, need 8/, '--cone', '0:2', '--cone', '1:2');
  refused(4, /rectangle needs a disk/, '--boundary', 'rectangle');
  put('strange.txt', '0 3\n0 99999\n');
  const strange = run('param', 'closed.obj', '--features', 'strange.txt', '-o', 'no.obj');
  assert.equal(strange.code, 5);
  assert.match(strange.err, /feature at vertex 99999/);
  put('diagonal.txt', '0 3\n2 5\n0 140\n');
  const diagonal = run('param', 'closed.obj', '--features', 'diagonal.txt', '-o', 'no.obj');
  assert.equal(diagonal.code, 5);
  assert.match(diagonal.err, /no edges? of the mesh/);
  put('bad.txt', '0 x\n');
  assert.equal(run('param', 'closed.obj', '--features', 'bad.txt', '-o', 'no.obj').code, 3);
});

/** The edges of a .sharp file, whose rows name a face and one of its sides. */
function edgesOfList(sharp, faces) {
  const rows = readFileSync(sharp, 'utf8').trim().split('\n').slice(1);
  return new Set(rows.map((row) => {
    const [, f, k] = row.split(',').map(Number);
    return key(faces[f][k], faces[f][(k + 1) % 3]);
  })); // prettier-ignore
}

/** Mean of σ₁² + σ₂² + σ₁⁻² + σ₂⁻² − 4 over the surface, at the best scale, from a file alone. */
function dirichletOf(name) {
  const vertices = read(name).split('\n').filter((line) => line.startsWith('v ')).map((line) => line.split(/\s+/).slice(1, 4).map(Number)); // prettier-ignore
  const { corners, faces } = cornersOf(name);
  let [grown, shrunk, surface] = [0, 0, 0];
  faces.forEach((t, f) => {
    const [[p, q, r], [a, b, c]] = [t.map((v) => vertices[v]), corners[f]];
    const [e, g] = [q, r].map((x) => x.map((_, k) => x[k] - p[k]));
    const dot = (x, y) => x.reduce((sum, _, k) => sum + x[k] * y[k], 0);
    const double = Math.sqrt(dot(e, e) * dot(g, g) - dot(e, g) ** 2);
    const [u, v] = [b, c].map((x) => [x[0] - a[0], x[1] - a[1]]);
    const det = (u[0] * v[1] - u[1] * v[0]) / double;
    // The squared norm of the derivative by the metric of the surface.
    const norm2 = (dot(u, u) * dot(g, g) - 2 * dot(u, v) * dot(e, g) + dot(v, v) * dot(e, e)) / double ** 2; // prettier-ignore
    grown += double * norm2;
    shrunk += (double * norm2) / det ** 2;
    surface += double;
  });
  return (2 * Math.sqrt(grown * shrunk)) / surface - 4;
}

/** Standard deviation over mean of the areas of the quads of a file, all of whose faces must be quads. */
function unevennessOf(name) {
  const [vertices, areas] = [[], []];
  for (const line of read(name).split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') vertices.push(rest.slice(0, 3).map(Number));
    if (word !== 'f') continue;
    assert.equal(rest.length, 4);
    const [a, b, c, d] = rest.map((corner) => vertices[Number(corner.split('/')[0]) - 1]);
    const [e, g] = [[0, 1, 2].map((k) => c[k] - a[k]), [0, 1, 2].map((k) => d[k] - b[k])];
    areas.push(0.5 * Math.hypot(...[0, 1, 2].map((k) => e[(k + 1) % 3] * g[(k + 2) % 3] - e[(k + 2) % 3] * g[(k + 1) % 3]))); // prettier-ignore
  }
  const mean = areas.reduce((sum, x) => sum + x, 0) / areas.length;
  return Math.sqrt(areas.reduce((sum, x) => sum + (x - mean) ** 2, 0) / areas.length) / mean;
}

/** Without and with --improve: as straight and certified, with less distortion and more even quads. */
function expectImproved(mesh, words, asked, sizes = ['500', '3000']) {
  good('param', mesh, words, '-o', 'before.obj', '--force');
  good('param', mesh, words, '--improve', 'isometric', '-o', 'after.obj', '--force', '--json', 'after.json'); // prettier-ignore
  const report = JSON.parse(read('after.json'));
  assert.deepEqual(problems('hgp-report', report), []);
  assert.ok(report.certified);
  const { features } = report.certificate;
  assert.equal(features.straightChains, features.chains);
  assert.equal(features.straightEdges, features.edges);
  const { improvement } = report.components[0];
  assert.ok(improvement.kept);
  const [before, after] = [dirichletOf('before.obj'), dirichletOf('after.obj')];
  assert.ok(after < 0.9 * before, `${mesh}: ${before}, then ${after}`);
  assert.ok(Math.abs(improvement.after.symmetricDirichlet - after) < 1e-3 * after);
  const isAsked = asked(cornersOf('after.obj'));
  assert.equal(crookedSides(cornersOf('after.obj'), isAsked), 0, mesh); // prettier-ignore
  for (const cells of sizes) {
    good('quads', mesh, words, '--cells', cells, '-o', 'before.quads.obj', '--force');
    good('quads', mesh, words, '--cells', cells, '--improve', 'isometric', '-o', 'after.quads.obj', '--force', '--json', 'quads.json'); // prettier-ignore
    const { grid, improvement: both } = JSON.parse(read('quads.json')).components[0];
    assert.ok(grid.aligned && both.onGrid);
    const [uneven, even] = [unevennessOf('before.quads.obj'), unevennessOf('after.quads.obj')];
    assert.ok(even < 0.9 * uneven, `${mesh}, ${cells} cells: ${uneven}, then ${even}`);
  }
}

test('an improvement leaves features straight, and makes quads more even', () => {
  const bent = ([x, y, z]) => [x * (1 + 0.12 * y + 0.1 * z), y * (1 + 0.2 * z), z * (1 + 0.09 * x)];
  put('bent.obj', toObj({ ...closed, vertices: closed.vertices.map(bent) }));
  const creases = new Set(closed.creases.map(([a, b]) => key(a, b)));
  expectImproved('bent.obj', ['--features', 'creases.txt'], () => (edge) => creases.has(edge));
  put('bent-open.obj', toObj({ ...open, vertices: open.vertices.map(bent) }));
  const rims = rimsOf(open);
  expectImproved('bent-open.obj', ['--rims'], () => (edge) => rims.has(edge));
});

test('parts with lists of their sharp edges are improved', (t) => {
  const folder = path.join(shared, '../cases/features');
  if (!existsSync(folder)) return t.skip(`${folder} is absent`);
  for (const name of ['wrench', 'joint']) {
    const sharp = path.join(folder, `${name}_rem.sharp`);
    expectImproved(path.join(folder, `${name}_rem.obj`), ['--features', sharp], ({ faces }) => {
      const edges = edgesOfList(sharp, faces);
      return (edge) => edges.has(edge);
    }, ['3000']); // prettier-ignore
  }
});

test('a part has a grid where integers turn triangles away from the map as solved', (t) => {
  const part = path.join(shared, '../cases/features/deckel_rem.obj');
  if (!existsSync(part)) return t.skip(`${part} is absent`);
  const asked = ['--creases', '--cells', '800', '--grid-mode', 'quad'];
  good('param', part, asked, '-o', 'part.obj', '--force', '--json', 'part.json');
  const [{ grid }] = JSON.parse(read('part.json')).components;
  assert.ok(grid.aligned && Math.abs(grid.cells / 800 - 1) < 0.2, `${grid.cells} cells`);
});

test('where frames contradict the integers of hundreds of lines, the map is untangled', (t) => {
  const part = path.join(shared, '../cases/features/casting.off.gz');
  if (!existsSync(part)) return t.skip(`${part} is absent`);
  for (const mode of ['tile', 'quad']) {
    const asked = ['--creases', '--cells', '2000', '--grid-mode', mode];
    good('param', part, asked, '-o', 'part.obj', '--force', '--json', 'part.json');
    const [{ grid }] = JSON.parse(read('part.json')).components;
    assert.ok(grid.aligned && grid.cells < 2 * 2000, `${mode}: ${grid.cells} cells`);
  }
});

test('creases and rims are those of every mesh of a file', async () => {
  const boxes = [box(3), box(2, true), box(4)];
  put('boxes.glb', toGlb(boxes));
  good('param', 'boxes.glb', '--creases', '--rims', '-o', 'out.glb', '--json', 'out.json');
  assert.equal(JSON.parse(read('out.json')).meshes.length, 3);
  const meshes = (await new NodeIO().read(at('out.glb'))).getRoot().listMeshes();
  meshes.forEach((mesh, n) => {
    const [part] = mesh.listPrimitives();
    const rows = (name, size) => {
      const values = [...part.getAttribute(name).getArray()];
      return Array.from({ length: values.length / size }, (_, i) => values.slice(size * i, size * (i + 1))); // prettier-ignore
    };
    const [uv, points] = [rows('TEXCOORD_0', 2), rows('POSITION', 3).map(String)];
    const corners = [...part.getIndices().getArray()];
    const asked = new Set(boxes[n].creases.map((edge) => edge.map((v) => String(boxes[n].vertices[v].map(Math.fround))).sort().join('|'))); // prettier-ignore
    const faces = Array.from({ length: corners.length / 3 }, (_, f) => corners.slice(3 * f, 3 * f + 3)); // prettier-ignore
    const found = new Set();
    for (const t of faces)
      for (let k = 0; k < 3; k++) {
        const [a, b] = [t[k], t[(k + 1) % 3]];
        const edge = [points[a], points[b]].sort().join('|');
        if (!asked.has(edge)) continue;
        found.add(edge);
        assert.notEqual(uv[a][0] === uv[b][0], uv[a][1] === uv[b][1], `mesh ${n}, ${edge}`);
      }
    assert.equal(found.size, asked.size, `mesh ${n}`);
  });
  good('verify', 'out.glb', '--creases', '--rims');
  // Of the smooth default maps, none has them straight.
  good('param', 'boxes.glb', '-o', 'free.glb');
  assert.equal(run('verify', 'free.glb', '--creases').code, 6);
});

test('parts with lists of their sharp edges', (t) => {
  const folder = path.join(shared, '../cases/features');
  if (!existsSync(folder)) return t.skip(`${folder} is absent`);
  for (const name of ['wrench', 'joint']) {
    const sharp = path.join(folder, `${name}_rem.sharp`);
    good('param', path.join(folder, `${name}_rem.obj`), '--features', sharp, '-o', 'part.obj');
    const map = cornersOf('part.obj');
    const asked = edgesOfList(sharp, map.faces);
    assert.ok(asked.size > 300);
    assert.equal(
      crookedSides(map, (edge) => asked.has(edge)),
      0,
      name,
    );
  }
});
