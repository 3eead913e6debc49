// One verdict from all rows: a face is flipped, a vertex split, a file cut; the tick follows the number.

import assert from 'node:assert/strict';
import test from 'node:test';
import { randomFrom } from '../../mutation/draw.mjs';
import { readUv } from '../../../web/src/formats/read_uv.ts';
import { isCertified, verdictRows } from '../../../web/src/model/verdict.ts';
import { analyse } from '../../../web/src/services/geometry/analyse.ts';
import {
  certificate,
  counts,
  edgesOf,
  measuresOf,
  objOf,
  solutionOf,
  square,
} from './square_solution.mjs';

const failed = (solution) => verdictRows(solution).filter((row) => !row.isGood);

test('a map that is in the file as it was certified passes every row', () => {
  const solution = solutionOf(square());
  assert.deepEqual(failed(solution), []);
  assert.equal(isCertified(solution), true);
});

test('one reversed face: its area is negative, its row fails, and so does the verdict', () => {
  const map = square();
  for (const list of [map.triangles, map.cornerToUv]) [list[4], list[5]] = [list[5], list[4]];
  const solution = solutionOf(map);
  const [row] = failed(solution);
  assert.equal(row.name, 'Smallest area');
  assert.match(row.value, /^−2\.5e−1$/);
  assert.deepEqual(row.where, [{ kind: 'triangle', id: 1 }]);
  assert.deepEqual([...solution.distortion.flipped], [1]);
  assert.equal(isCertified(solution), false); // whatever the certificate says
});

test('triangles with opposite orientation are reported with the number in the certificate', () => {
  const turn = (map, c) => {
    for (const list of [map.triangles, map.cornerToUv])
      [list[c], list[c + 1]] = [list[c + 1], list[c]];
  };
  const map = square();
  turn(map, 4);
  const counted = () => {
    const solution = solutionOf(map);
    solution.result.certificate = { ...certificate, stored: counts({ reversed: 1 }) };
    return solution;
  };
  assert.equal(isCertified(counted()), true);
  const row = verdictRows(counted()).find(({ name }) => name === 'Triangles in the file');
  assert.match(row.tolerance, /1 wound the other way in the file/);
  turn(map, 7);
  assert.deepEqual(failed(counted()).map(({ name }) => name), ['Smallest area']); // prettier-ignore
});

test('triangles without area, and copies, are tolerated up to the number in the certificate', () => {
  const flat = (...corners) => {
    const map = square();
    // Three corners of one line: the triangle is in the file, and has no area.
    for (const c of corners)
      for (const list of [map.triangles, map.cornerToUv]) list[c] = list[c + 1];
    return map;
  };
  const verdictOf = (map, stored) => {
    const solution = solutionOf(map);
    solution.result.certificate = { ...certificate, stored: counts(stored) };
    const row = verdictRows(solution).find(({ name }) => name === 'Smallest area');
    return row.isGood;
  };
  assert.equal(verdictOf(flat(3), {}), false);
  assert.equal(verdictOf(flat(3), { zeroArea: 1 }), true);
  assert.equal(verdictOf(flat(3), { duplicates: 1 }), true);
  assert.equal(verdictOf(flat(3, 6), { zeroArea: 1 }), false);
  assert.equal(verdictOf(flat(3), { reversed: 1 }), false, 'another defect');
});

test('turnings have a row where any component has a boundary, and it follows the number of wrong ones', () => {
  const rowOf = (components, wrongTurnings) => {
    const solution = solutionOf(square());
    solution.result.certificate = { ...certificate, components, wrongTurnings };
    return verdictRows(solution).find(({ name }) => name === 'Boundary turning');
  };
  const [closed, open] = [{ turnings: [] }, { turnings: [{ loop: 0, turning: 4 }] }];
  assert.equal(rowOf([], 0), undefined);
  assert.equal(rowOf([closed], 0), undefined);
  assert.equal(rowOf([closed, {}, open], 0)?.isGood, true);
  assert.deepEqual([rowOf([open], 1)?.isGood, rowOf([open], 1)?.value], [false, '1 wrong']);
});

test('one vertex split in the file: the file does not hold the map, and the verdict fails', () => {
  const map = square();
  const torn = {
    ...map,
    uv: Float64Array.of(...map.uv, 0.7, 0.4),
    cornerToUv: map.cornerToUv.slice(),
  };
  torn.cornerToUv[2] = 5;
  const solution = solutionOf(map, objOf(torn));
  const [row] = failed(solution);
  assert.equal(row.name, 'The file holds this map');
  assert.match(row.tolerance, /coordinates are off by 2\.0e-1/);
  assert.equal(isCertified(solution), false);
});

test('a file with a missing face, or that cannot be read, does not hold the map', () => {
  const bytes = objOf(square());
  const text = new TextDecoder().decode(bytes);
  const less = new TextEncoder().encode(text.slice(0, text.lastIndexOf('f ')));
  assert.match(failed(solutionOf(square(), less))[0].tolerance, /3 triangles.*not 4/);
  const files = [{ name: 'x.glb', bytes: new Uint8Array(4) }];
  const edges = edgesOf(square().triangles, 5);
  const { analysis } = analyse(
    { map: square(), measures: measuresOf(square()), files, mesh: 0 },
    edges,
  );
  assert.match(analysis.difference, /cannot be read back/);
  assert.equal(analysis.isSameAsFile, false);
});

test('a comment that ends with a backslash does not continue on the next line', () => {
  const bytes = new TextEncoder().encode(`# C:\\\n${new TextDecoder().decode(objOf(square()))}`);
  assert.deepEqual(failed(solutionOf(square(), bytes)), []);
});

test('lines that begin with blanks are read', () => {
  const text = new TextDecoder().decode(objOf(square())).replace(/^/gm, ' \t');
  assert.deepEqual(failed(solutionOf(square(), new TextEncoder().encode(text))), []);
});

test('a refusal of the solver without a row of its own gets one', () => {
  const solution = solutionOf(square());
  solution.result.certificate = { ...certificate, certified: false };
  assert.deepEqual(failed(solution).map(({ name }) => name), ['All other checks']); // prettier-ignore
});

test('a polygon is the same map under any triangulation; another polygon is not', () => {
  const map = square();
  // The square as one quad whose diagonal the solver chose: 1–3, where a fan would have 0–2.
  const quad = {
    ...map,
    positions: map.positions.slice(0, 12),
    triangles: Uint32Array.of(0, 1, 3, 1, 2, 3),
    uv: map.uv.slice(0, 8),
    cornerToUv: Uint32Array.of(0, 1, 3, 1, 2, 3),
    uvToVertex: Uint32Array.of(0, 1, 2, 3),
  };
  const text = (face, vt) =>
    new TextEncoder().encode(
      `${[0, 1, 2, 3].map((v) => `v ${quad.positions.slice(3 * v, 3 * v + 3).join(' ')}`).join('\n')}\n` +
        `${vt.map((pair) => `vt ${pair.join(' ')}`).join('\n')}\nf ${face}\n`,
    );
  const own = [[0, 0], [1, 0], [1, 1], [0, 1]]; // prettier-ignore
  const compare = (bytes) => {
    const files = [{ name: 'quad.obj', bytes }];
    const edges = edgesOf(quad.triangles, 4);
    return analyse({ map: quad, measures: measuresOf(quad), files, mesh: 0 }, edges).analysis;
  };
  const same = compare(text('1/1 2/2 3/3 4/4', own));
  assert.equal(same.difference, '');
  assert.deepEqual([...same.cornerUv], [0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1]);
  assert.equal(compare(text('3/3 4/4 1/1 2/2', own)).difference, ''); // begun elsewhere
  const moved = own.map(([x, y], i) => (i === 2 ? [x, y + 0.1] : [x, y]));
  assert.match(compare(text('1/1 2/2 3/3 4/4', moved)).difference, /coordinates are off by/);
  assert.match(compare(text('1/1 2/2 4/4 3/3', own)).difference, /polygons are not those/);
  assert.match(compare(text('1/1 2/2 3/3', own)).difference, /1 triangles.*not 2/);
  // A face before its vertices; a corner that is there twice.
  const late = new TextDecoder().decode(text('1/1 2/2 3/3 4/4', own)).split('\n').filter(Boolean);
  assert.equal(compare(new TextEncoder().encode([late.at(-1), ...late.slice(0, -1)].join('\n'))).difference, ''); // prettier-ignore
  quad.triangles = Uint32Array.of(0, 1, 1, 0, 1, 3, 1, 2, 3);
  quad.cornerToUv = quad.triangles.slice();
  assert.equal(compare(text('1/1 2/2 2/2 3/3 4/4', own)).difference, '');
});

test('a PLY with its list of texture coordinates is read back, as text and as bytes', () => {
  const map = square();
  const faces = [0, 3, 6, 9].map((c) => [map.triangles, map.cornerToUv].map((list) => [...list.slice(c, c + 3)])); // prettier-ignore
  const header = (format) =>
    `ply\nformat ${format} 1.0\ncomment a square\nelement vertex 5\nproperty double x\nproperty double y\n` +
    'property double z\nelement face 4\nproperty uchar colour\nproperty list uchar int vertex_indices\n' +
    'property list uchar double texcoord\nend_header\n';
  const lines = [0, 1, 2, 3, 4].map((v) => map.positions.slice(3 * v, 3 * v + 3).join(' '));
  const uvOf = (corners) => corners.flatMap((i) => [...map.uv.slice(2 * i, 2 * i + 2)]);
  for (const [t, uv] of faces) lines.push(`7 3 ${t.join(' ')} 6 ${uvOf(uv).join(' ')}`);
  const asText = new TextEncoder().encode(`${header('ascii')}${lines.join('\n')}\n`);
  const body = Buffer.alloc(5 * 24 + 4 * (1 + 1 + 12 + 1 + 48));
  let at = 0;
  for (const x of map.positions) at = body.writeDoubleBE(x, at);
  for (const [t, uv] of faces) {
    at = body.writeUInt8(3, body.writeUInt8(7, at));
    for (const v of t) at = body.writeInt32BE(v, at);
    at = body.writeUInt8(6, at);
    for (const x of uvOf(uv)) at = body.writeDoubleBE(x, at);
  }
  const asBytes = new Uint8Array(Buffer.concat([Buffer.from(header('binary_big_endian')), body]));
  const edges = edgesOf(map.triangles, 5);
  for (const bytes of [asText, asBytes]) {
    const files = [{ name: 'square.ply', bytes }];
    assert.equal(
      analyse({ map, measures: measuresOf(map), files, mesh: 0 }, edges).analysis.difference,
      '',
    );
  }
  const files = [{ name: 'square.ply', bytes: new TextEncoder().encode(new TextDecoder().decode(asText).replace('0.5 0.5\n', '0.5 0.7\n')) }]; // prettier-ignore
  assert.match(
    analyse({ map, measures: measuresOf(map), files, mesh: 0 }, edges).analysis.difference,
    /off by/,
  );
});

test('with several components each row shows the worst place of the file, not of the first component', () => {
  const one = (triangle, size, vertex, angle, edge, residual) => ({
    distortion: { smallestTriangle: triangle, smallestToMeanArea: size },
    angles: { worstVertex: vertex, worstDistance: angle },
    seams: { worstEdge: edge, worstResidual: residual },
  });
  const solution = solutionOf(square());
  const components = [
    one(0, 1e-1, 0, 1e-12, [], 0),
    one(1, 1e-6, 1, 1e-7, [1, 4], 1e-13),
    one(2, 1e-3, 2, 1e-9, [2, 4], 1e-11),
  ];
  solution.result.certificate = { ...certificate, components };
  const where = (name) => verdictRows(solution).find((row) => row.name === name).where;
  assert.deepEqual(where('Flipped triangles'), [{ kind: 'triangle', id: 1 }]);
  assert.deepEqual(where('Regular vertices'), [{ kind: 'vertex', id: 1 }]);
  assert.deepEqual(where('Seams'), [{ kind: 'edge', id: 2, other: 4 }]);
});

test('flipped triangles are shown where the certificate has them, otherwise where they were measured', () => {
  const map = square();
  for (const list of [map.triangles, map.cornerToUv]) [list[4], list[5]] = [list[5], list[4]];
  const solution = solutionOf(map);
  const shown = (notPositive) => {
    const components = [{ orientation: { notPositive } }, {}];
    solution.result.certificate = { ...certificate, flipped: 1, components };
    return verdictRows(solution).find(({ name }) => name === 'Flipped triangles').where;
  };
  assert.deepEqual(shown([3, 0]), [{ kind: 'triangle', id: 3 }, { kind: 'triangle', id: 0 }]); // prettier-ignore
  assert.deepEqual(shown([2]), [{ kind: 'triangle', id: 2 }]);
  assert.deepEqual(shown([]), [{ kind: 'triangle', id: 1 }]);
});

test('each row shows the places that the certificate has for it, wherever they are, and none where it has none', () => {
  const random = randomFrom(4);
  const below = (n) => Math.floor(n * random());
  const rarely = (make) => (random() < 0.3 ? undefined : make());
  const list = (most, make) => Array.from({ length: below(most + 1) }, make);
  const solution = solutionOf(square());
  const seen = new Map();
  for (let round = 0; round < 400; round++) {
    const components = list(2, () => ({
      orientation: rarely(() => ({ notPositive: random() < 0.5 ? [] : list(2, () => below(3)) })),
      distortion: rarely(() => ({ smallestTriangle: below(3), smallestToMeanArea: random() })),
      angles: rarely(() => ({ worstVertex: rarely(() => below(4) - 1), worstDistance: random() })),
      wrongCones: rarely(() => list(2, () => ({ vertex: below(3) }))),
      seams: rarely(() => ({ worstEdge: random() < 0.4 ? [] : [below(3), below(3)], worstResidual: rarely(random) })), // prettier-ignore
    }));
    const [triangle, area] = [below(4) - 1, below(3) - 1];
    solution.result.certificate = { ...certificate, components };
    solution.smallestArea = { negative: 1, zero: 0, area, smallestPositive: 1, mean: 1, triangle };
    solution.distortion = { ...solution.distortion, flipped: Uint32Array.from(list(1, () => below(3))) }; // prettier-ignore

    const foremost = (key, measure, has) => components.map((one) => one[key]).filter((one) => one && has(one)).sort((a, b) => measure(b) - measure(a))[0]; // prettier-ignore
    const reported = components.flatMap(({ orientation }) => orientation?.notPositive ?? []);
    const folded = reported.length > 0 ? reported : [...solution.distortion.flipped];
    const smallest = foremost(
      'distortion',
      (one) => -one.smallestToMeanArea,
      () => true,
    );
    const worst = foremost(
      'angles',
      (one) => one.worstDistance,
      (one) => one.worstVertex >= 0,
    );
    const edge = foremost('seams', (one) => one.worstResidual ?? 0, (one) => one.worstEdge.length > 0)?.worstEdge; // prettier-ignore
    const at = (kind, ids) => ids.map((id) => ({ kind, id }));
    const expected = {
      'Flipped triangles': at('triangle', folded.length > 0 ? folded : smallest ? [smallest.smallestTriangle] : []), // prettier-ignore
      'Smallest area': at('triangle', area > 0 || triangle < 0 ? [] : [triangle]),
      'Regular vertices': at('vertex', worst ? [worst.worstVertex] : []),
      'Cone angles': at('vertex', components.flatMap(({ wrongCones }) => (wrongCones ?? []).map(({ vertex }) => vertex))), // prettier-ignore
      Seams: edge ? [{ kind: 'edge', id: edge[0], other: edge[1] }] : [],
    };
    const rows = verdictRows(solution);
    for (const [name, places] of Object.entries(expected)) {
      assert.deepEqual(rows.find((row) => row.name === name).where, places, name);
      for (const { id = 'none' } of places.length > 0 ? places : [{}]) seen.set(`${name} ${id}`, true); // prettier-ignore
    }
  }
  for (const name of [
    'Flipped triangles',
    'Smallest area',
    'Regular vertices',
    'Cone angles',
    'Seams',
  ])
    // prettier-ignore
    for (const id of [0, 1, 'none']) assert.ok(seen.has(`${name} ${id}`), `${name} ${id}`);
});

test('faces of any number of corners are read from a PLY as from an OBJ, as text or bytes', () => {
  const places = Array.from({ length: 6 }, (_, i) => [Math.cos(i), Math.sin(i), i]);
  const uvOf = (v) => [places[v][0] / 2, places[v][1] + 1];
  const encode = (text) => new TextEncoder().encode(text);
  for (const sizes of [[3, 3], [3, 4], [4, 3], [4, 4], [5, 3, 6], [3]]) {
    // prettier-ignore
    const faces = sizes.map((n, f) => Array.from({ length: n }, (_, k) => (k + f) % 6));
    const obj = [...places.map((p) => `v ${p.join(' ')}`), ...places.map((_, v) => `vt ${uvOf(v).join(' ')}`), ...faces.map((f) => `f ${f.map((v) => `${v + 1}/${v + 1}`).join(' ')}`)].join('\n'); // prettier-ignore
    const header = `ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\nelement face ${sizes.length}\nproperty list uchar int vertex_indices\nproperty list uchar double texcoord\nend_header\n`; // prettier-ignore
    const rows = [...places.map((p) => p.join(' ')), ...faces.map((f) => `${f.length} ${f.join(' ')} ${2 * f.length} ${f.flatMap(uvOf).join(' ')}`)]; // prettier-ignore
    const [fromObj, fromPly] = [['a.obj', obj], ['a.ply', `${header}${rows.join('\n')}\n`]].map(([name, text]) => readUv([{ name, bytes: encode(text) }], 0)); // prettier-ignore
    assert.deepEqual(fromPly, fromObj, `faces of ${sizes}`);
    assert.deepEqual(fromObj.sizes, sizes.some((n) => n > 3) ? sizes : undefined);
  }
});

test('the least area is that of the triangles in the file; of the map where the file has others or cannot be read', () => {
  const map = square();
  const edges = edgesOf(map.triangles, 5);
  const least = (bytes) => analyse({ map, measures: measuresOf(map), files: [{ name: 'a.obj', bytes }], mesh: 0 }, edges).analysis.smallestArea; // prettier-ignore
  const own = least(objOf(map));
  for (const y of [0.1, 0.3, -0.2, 0.9]) {
    const uv = map.uv.slice();
    uv[9] = y; // the middle of the square, at another height
    const { area, negative } = least(objOf({ ...map, uv }));
    assert.ok(Math.abs(area - Math.min(y, 1 - y) / 2) < 1e-9, `${area} for ${y}`);
    assert.equal(negative, y < 0 ? 1 : 0);
  }
  const text = new TextDecoder().decode(objOf(map));
  const fewer = text.split('\n').slice(0, -1).join('\n');
  for (const other of [fewer, 'nothing']) assert.deepEqual(least(new TextEncoder().encode(other)), own); // prettier-ignore
});

test('each thing that is wrong fails its row and the verdict, in any company; what is a fact only does not', () => {
  const wrong = {
    'Flipped triangles': { flipped: 1 },
    'Boundary turning': { wrongTurnings: 2 },
    'Regular vertices': { wrongAngles: 1 },
    Seams: { brokenSeams: 1 },
    'Areas in the file': { usable: false },
  };
  const facts = {
    'Exact seams': { exactSeams: 0, seamEdges: 3 },
    'Lines meet': { exactSeams: 0, seamEdges: 3, integerSeams: 2 },
  };
  const random = randomFrom(11);
  const some = (all) => Object.entries(all).filter(() => random() < 0.3);
  const made = new Map();
  for (let round = 0; round < 120; round++) {
    const [bad, plain] = [some(wrong), some(facts)];
    const isHeld = random() < 0.8;
    const solution = solutionOf(square());
    const { components } = certificate;
    const [first, ...others] = components;
    const parts = Object.assign({}, ...[...bad, ...plain].map(([, part]) => part));
    solution.result.certificate = { ...certificate, components: [{ ...first, turnings: [0] }, ...others], ...parts }; // prettier-ignore
    solution.isSameAsFile = isHeld;
    const expected = [...bad.map(([name]) => name), ...(isHeld ? [] : ['The file holds this map'])];
    const rows = verdictRows(solution);
    const names = rows.filter(({ isGood, isFact }) => !isGood && !isFact).map(({ name }) => name);
    assert.deepEqual(names.sort(), expected.sort());
    assert.equal(isCertified(solution), expected.length === 0, `${expected}`);
    assert.deepEqual(rows.filter(({ isGood, isFact }) => !isGood && isFact).map(({ name }) => name).slice(0, 1), plain.length > 0 ? ['Exact seams'] : []); // prettier-ignore
    for (const name of expected) made.set(name, true);
    // An objection of the solver has a row of its own only where no other row says it.
    solution.result.certificate = { ...solution.result.certificate, certified: false };
    const refused = verdictRows(solution).filter(({ isGood, isFact }) => !isGood && !isFact);
    assert.equal(refused.length, Math.max(1, expected.length));
  }
  assert.equal(made.size, Object.keys(wrong).length + 1);
});

test('how many seams are exact is a row only where it was counted and there are seams', () => {
  const rowsFor = (part) => {
    const solution = solutionOf(square());
    solution.result.certificate = { ...certificate, ...part };
    return verdictRows(solution).filter(({ name }) => /Exact seams|Lines meet/.test(name)).length;
  };
  assert.equal(rowsFor({ exactSeams: 2, seamEdges: 3 }), 2);
  assert.equal(rowsFor({ exactSeams: 0, seamEdges: 3 }), 2);
  for (const exactSeams of [null, undefined]) assert.equal(rowsFor({ exactSeams, seamEdges: 3 }), 0); // prettier-ignore
  assert.equal(rowsFor({ exactSeams: 0, seamEdges: 0 }), 0);
});
