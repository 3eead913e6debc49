// Lists of features: what the file marks, what `hgp features` writes, and that every format means the same edges.
import assert from 'node:assert/strict';
import test from 'node:test';
import { inFolder } from '../support/program.mjs';
import { sentenceOf } from '../support/notes.mjs';
import { problems } from './schema.mjs';

const { put, read, run, good } = inFolder('feature-lists');

/** A strip of n × 2 squares that is folded by 90° along its middle line; `head(f)` is written before square f. */
function folded(n, head = () => '', corner = (v) => `${v}`) {
  const lines = [];
  for (let i = 0; i <= n; i++) lines.push(`v ${i} -1 0`, `v ${i} 0 0`, `v ${i} 0 1`);
  for (let f = 0; f < 2 * n; f++) {
    const [i, j] = [f >> 1, f & 1];
    const [a, b, c, d] = [3 * i + j, 3 * i + 3 + j, 3 * i + 4 + j, 3 * i + j + 1].map((v) => v + 1);
    lines.push(head(f), `f ${[a, b, c].map((v) => corner(v, j)).join(' ')}`, `f ${[a, c, d].map((v) => corner(v, j)).join(' ')}`); // prettier-ignore
  }
  return lines.filter(Boolean).join('\n') + '\n';
}

/** The edges of rows of two vertices, without the rim of the strip. */
const inner = (text, n) =>
  text
    .trim()
    .split('\n')
    .map((row) => row.split(' ').map(Number))
    .filter(([a, b]) => a % 3 === 1 && b % 3 === 1 && Math.abs(a - b) === 3 && a <= 3 * n + 1)
    .map(([a, b]) => `${Math.min(a, b)} ${Math.max(a, b)}`)
    .sort();
const fold = [0, 1, 2, 3, 4].map((i) => `${3 * i + 1} ${3 * i + 4}`).sort();
const n = 5;
const polyline = 'l ' + [0, 1, 2, 3, 4, 5].map((i) => 3 * i + 2).join(' ');
const normals = 'vn 0 0 1\nvn 0 -1 0\n';
const marked = {
  lines: folded(n) + polyline + '\n',
  smoothing: folded(n, (f) => `s ${f & 1 ? 'off' : 1}`),
  materials: folded(n, (f) => `usemtl m${f & 1}`),
  normals: normals + folded(n, undefined, (v, j) => `${v}//${j + 1}`),
};

for (const [kind, text] of Object.entries(marked)) {
  test(`edges that a file marks by ${kind} are features`, () => {
    put(`${kind}.obj`, text);
    good('features', `${kind}.obj`, '--marked', kind, '-o', `${kind}.txt`);
    assert.deepEqual(inner(read(`${kind}.txt`), n), fold);
    good('features', `${kind}.obj`, '--marked', '-o', 'all.txt');
    assert.equal(read('all.txt'), read(`${kind}.txt`));
    for (const other of Object.keys(marked).filter((k) => k !== kind)) {
      const { code, err } = run('features', `${kind}.obj`, '--marked', other);
      assert.equal(code, 5);
      assert.match(err, /the file marks no edges/);
    }
  });
}

test('normals mark an edge where their directions differ by more than a degree, whatever their lengths', () => {
  const turned = (degrees, length) => {
    const angle = (degrees * Math.PI) / 180;
    const [y, z] = [-length * Math.sin(angle), length * Math.cos(angle)];
    const text = folded(n, undefined, (v, j) => `${v}//${j + 1}`);
    put('turned.obj', `vn 0 0 1\nvn 0 ${y} ${z}\n${text}`);
    return run('features', 'turned.obj', '--marked', 'normals', '-o', 'turned.txt').code;
  };
  for (const length of [0.25, 1, 3]) {
    assert.equal(turned(0.9, length), 5);
    assert.equal(turned(1.1, length), 0);
    assert.deepEqual(inner(read('turned.txt'), n), fold);
  }
});

test('materials and split normals of a GLB mark the same edges, and the map follows them', () => {
  for (const kind of ['materials', 'normals']) {
    put(`${kind}.obj`, marked[kind]);
    good('param', `${kind}.obj`, '--rims', '-o', `${kind}.glb`);
    good('features', `${kind}.glb`, '--marked', kind, '-o', 'glb.json');
    const { features, cones } = JSON.parse(read('glb.json'));
    assert.equal(cones, undefined);
    assert.deepEqual(problems('hgp-cones', JSON.parse(read('glb.json'))), []);
    const onFold = features.lines.flatMap(
      ({ positions }) =>
      positions.slice(1).filter((p, i) => p[1] === 0 && p[2] === 0 && positions[i][1] === 0 && positions[i][2] === 0), // prettier-ignore
    );
    assert.equal(onFold.length, n);
    good('param', `${kind}.glb`, '--marked', kind, '-o', 'out.glb', '--json', 'out.json');
    const report = JSON.parse(read('out.json'));
    assert.equal(report.certificate.features.straightEdges, 5 + 2 * n + 4);
  }
});

test('a file that is shaded flat marks nothing by its normals, and the message says what to do', () => {
  // A hill: no two triangles are coplanar, and each has a normal of its own.
  const [lines, faces] = [[], []];
  for (let i = 0; i <= 4; i++)
    for (let j = 0; j <= 4; j++) lines.push(`v ${i} ${j} ${Math.sin(i) + Math.cos(j * 1.3)}`);
  for (let i = 0; i < 4; i++)
    for (let j = 0; j < 4; j++) {
      const a = 5 * i + j + 1;
      for (const t of [
        [a, a + 5, a + 6],
        [a, a + 6, a + 1],
      ]) {
        // prettier-ignore
        const k = faces.length;
        lines.push(`vn ${Math.cos(k)} ${Math.sin(k)} 1`);
        faces.push(`f ${t.map((v) => `${v}//${k + 1}`).join(' ')}`);
      }
    }
  put('flat.obj', [...lines, ...faces].join('\n'));
  const { code, err } = run('features', 'flat.obj', '--marked', 'normals');
  assert.equal(code, 5);
  assert.match(err, /normals differ at 40 of 40 edges: the file is shaded flat.*--creases/s);
});

test('a list means the same edges in every format that it is written in', () => {
  put('fold.obj', folded(n));
  good('features', 'fold.obj', '-o', 'fold.txt');
  for (const end of ['sharp', 'obj', 'json']) {
    good('features', 'fold.obj', '-o', `list.${end}`);
    good('features', 'fold.obj', '--features', `list.${end}`, '-o', `from-${end}.txt`);
    assert.equal(read(`from-${end}.txt`), read('fold.txt'), end);
  }
  // The strip is folded upwards: seen from its outer side the fold is a valley.
  const rows = read('list.sharp').trim().split('\n');
  assert.equal(Number(rows[0]), rows.length - 1);
  assert.equal(rows.filter((row) => row.startsWith('0,')).length, n);
});

test('without options creases above 30° are listed, and inspect counts them', () => {
  put('fold.obj', folded(n));
  const { out, err } = good('features', 'fold.obj');
  assert.equal(JSON.parse(out).features.lines.length > 0, true);
  assert.match(err, /5 crease edges and 14 rim edges in 3 chains/);
  good('inspect', 'fold.obj', '--json', 'inspect.json');
  const document = JSON.parse(read('inspect.json'));
  assert.deepEqual(problems('hgp-inspect', document), []);
  assert.deepEqual(document.features, { degrees: 30, creaseEdges: 5, creaseChains: 1, rimEdges: 14 }); // prettier-ignore
});

test('an unknown kind of mark is refused with the known ones', () => {
  put('fold.obj', folded(n));
  const { code, err } = run('features', 'fold.obj', '--marked', 'lines,colours');
  assert.equal(code, 2);
  assert.match(err, /lines, smoothing, materials and normals/);
});

test('options of automatic cones say that they choose nothing where a surface has features', () => {
  put('fold.obj', folded(n));
  const plain = good('param', 'fold.obj', '--creases', '-o', 'plain.obj');
  assert.doesNotMatch(plain.err, sentenceOf('features-own-cones'));
  for (const option of [['--count', '9'], ['--cones-for', 'few'], ['--align']]) {
    const { err } = good('param', 'fold.obj', '--creases', ...option, '-o', 'chosen.obj');
    assert.match(err, sentenceOf('features-own-cones'));
    assert.equal(read('chosen.obj'), read('plain.obj'));
  }
});

test('a list that was made for another file says so, and vertices are found by their positions', () => {
  put('fold.obj', folded(n));
  good('features', 'fold.obj', '-o', 'fold.json');
  const { err: same } = good('features', 'fold.obj', '--features', 'fold.json', '-o', 'same.txt');
  assert.doesNotMatch(same, sentenceOf('features-other-file'));
  // Vertices in reverse order: the same edges have other numbers.
  const lines = folded(n).trim().split('\n');
  const vertices = lines.filter((line) => line.startsWith('v '));
  const turned = (word) => `${vertices.length + 1 - Number(word)}`;
  const faces = lines
    .filter((line) => line.startsWith('f '))
    .map((line) => `f ${line.slice(2).split(' ').map(turned).join(' ')}`);
  put('turned.obj', [...vertices.reverse(), ...faces].join('\n') + '\n');
  const { err } = good('features', 'turned.obj', '--features', 'fold.json', '-o', 'turned.txt');
  assert.match(err, sentenceOf('features-other-file'));
  assert.match(err, /positions/);
  const last = vertices.length - 1;
  const back = read('turned.txt').replace(/\d+/g, (word) => `${last - Number(word)}`);
  assert.deepEqual(inner(back, n), fold);
  // Without positions the numbers are all there is.
  const list = JSON.parse(read('fold.json'));
  for (const line of list.features.lines) delete line.positions;
  put('numbers.json', JSON.stringify(list));
  const { err: numbers } = run(
    'features',
    'turned.obj',
    '--features',
    'numbers.json',
    '-o',
    'x.txt',
  );
  assert.match(numbers, sentenceOf('features-other-file'));
  assert.match(numbers, /numbers/);
});

test('marked pairs that are no edges are counted, and where all are none the run is refused', () => {
  put('some.obj', folded(n) + polyline + '\nl 1 18\nl 1 12\n');
  const { err } = good('features', 'some.obj', '--marked', 'lines', '-o', 'some.txt');
  assert.match(err, sentenceOf('marks-no-edges', { pairs: 2 }));
  assert.deepEqual(inner(read('some.txt'), n), fold);
  put('none.obj', folded(n) + 'l 1 18\n');
  const none = run('features', 'none.obj', '--marked', 'lines');
  assert.equal(none.code, 5);
  assert.match(
    none.err,
    /the file marks 1 pair of vertices, and none is an edge of the mesh.*--creases/,
  );
});

test('lines that name a vertex which a weld joins to another one are edges', () => {
  const twice = folded(n).trim().split('\n');
  const vertices = twice.filter((line) => line.startsWith('v '));
  const moved = (line) => `f ${line.slice(2).split(' ').map((v) => Number(v) + vertices.length).join(' ')}`; // prettier-ignore
  const faces = twice.filter((line) => line.startsWith('f '));
  const half = faces.map((line, i) => (i < 4 ? line : moved(line)));
  // The second half of the strip has its own copies of the vertices, and the line uses these alone.
  const line = 'l ' + [0, 1, 2, 3, 4, 5].map((i) => vertices.length + 3 * i + 2).join(' ');
  put('halves.obj', [...vertices, ...vertices, ...half, line].join('\n') + '\n');
  const { err } = good('features', 'halves.obj', '--weld', 'exact', '--marked', 'lines', '--json', 'halves.json', '-o', 'halves.txt'); // prettier-ignore
  assert.doesNotMatch(err, sentenceOf('marks-no-edges'));
  assert.match(err, /5 crease edges/);
});
