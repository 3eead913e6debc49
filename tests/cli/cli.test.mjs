// The command line from outside: exit codes, streams, files and documents.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  existsSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { cubeMesh, toGltf } from '../support/meshes.mjs';
import { problems } from './schema.mjs';
import { hgp, inFolder, shared } from '../support/program.mjs';
import { sentenceOf } from '../support/notes.mjs';

const { folder, at, put, read, run } = inFolder('cli');

function isValid(name, text) {
  const value = JSON.parse(text);
  assert.deepEqual(problems(name, value).slice(0, 5), []);
  return value;
}

/** An octahedron with every triangle cut n × n, pushed out to the sphere. */
function sphere(n) {
  const corners = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [-1, 0, 0],
    [0, -1, 0],
    [0, 0, -1],
  ];
  const faces = [
    [0, 1, 2],
    [1, 3, 2],
    [3, 4, 2],
    [4, 0, 2],
    [1, 0, 5],
    [3, 1, 5],
    [4, 3, 5],
    [0, 4, 5],
  ];
  const ids = new Map();
  const lines = ['# a sphere', 'g ball'];
  const triangles = [];
  const vertex = (p) => {
    const length = Math.hypot(...p);
    const key = p.map((x) => (x / n).toFixed(9)).join(' ');
    if (!ids.has(key)) {
      ids.set(key, ids.size);
      lines.push(`v ${p.map((x) => x / length).join(' ')}`);
    }
    return ids.get(key);
  };
  for (const [a, b, c] of faces) {
    const point = (i, j) =>
      vertex(
        [0, 1, 2].map((k) => corners[a][k] * (n - i - j) + corners[b][k] * i + corners[c][k] * j),
      );
    for (let i = 0; i < n; i++) {
      for (let j = 0; i + j < n; j++) {
        triangles.push([point(i, j), point(i + 1, j), point(i, j + 1)]);
        if (i + j + 1 < n) triangles.push([point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)]);
      }
    }
  }
  for (const t of triangles) lines.push(`f ${t.map((v) => v + 1).join(' ')}`);
  return lines.join('\n') + '\n';
}

const disk = (() => {
  const lines = ['v 0 0 0'];
  const rings = 4;
  for (let r = 1; r <= rings; r++) {
    for (let i = 0; i < 12; i++) {
      lines.push(
        `v ${r * Math.cos((i * Math.PI) / 6)} ${r * Math.sin((i * Math.PI) / 6)} ${0.1 * r * r}`,
      );
    }
  }
  const id = (r, i) => (r === 0 ? 1 : 2 + (r - 1) * 12 + (i % 12));
  for (let i = 0; i < 12; i++) {
    lines.push(`f 1 ${id(1, i)} ${id(1, i + 1)}`);
    for (let r = 1; r < rings; r++) {
      lines.push(`f ${id(r, i)} ${id(r + 1, i)} ${id(r + 1, i + 1)} ${id(r, i + 1)}`);
    }
  }
  return lines.join('\n') + '\n';
})();

put('ball.obj', sphere(6));
put('disk.obj', disk);
const sixCones = [0, 1, 2, 3, 4, 5].map((i) => ({ i }));
const conesOf = (q, list) =>
  JSON.stringify({
    format: 'hgp-cones',
    version: 1,
    q,
    cones: list.map(([vertex, k]) => ({ vertex, k })),
  });
/** The six corners of the octahedron, wherever the generator has put them. */
const corners = (() => {
  const found = [];
  sphere(6)
    .split('\n')
    .filter((line) => line.startsWith('v '))
    .forEach((line, i) => {
      if (
        line
          .split(' ')
          .slice(1)
          .filter((x) => Math.abs(Number(x)) === 1).length === 1
      )
        found.push(i);
    });
  return found;
})();
const six = corners.map((v, i) => [v, i < 4 ? 3 : 2]);
put('cones.json', conesOf(4, six));
put('ball.cones', `q 4\ncones 6\n${six.map((pair) => pair.join(' ')).join('\n')}\n`);

test('the sample has six corners', () => assert.equal(corners.length, sixCones.length));

test('help and version go to standard output and end with 0', () => {
  for (const args of [['--help'], ['param', '--help'], ['--version']]) {
    const { code, out, err } = run(args);
    assert.equal(code, 0);
    assert.notEqual(out, '');
    assert.equal(err, '');
  }
});

test('usage errors end with 2, say so on standard error and suggest', () => {
  const cases = [
    [[], ''],
    [['parm', 'ball.obj'], 'param'],
    [['param', 'ball.obj'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--conse', 'c'], '--cone'],
    [['param', 'ball.obj', '-o', 'x.obj', '--q', '4', '--q', '6'], ''],
    [['inspect', 'ball.obj', '--quiet', '--quiet'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--q', '0'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--cone', '3'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--cone', '3:x'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--fix', 'nothing'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--cones', 'cones.json', '--cone', '1:2'], ''],
    [['param', 'ball.obj', '-o', 'x.obj', '--cones', 'cones.json', '--q', '6'], ''],
    [['param', 'ball.obj', '-o', '-', '--json', '-'], ''],
    [['param', 'ball.obj', '-o', 'ball.obj'], ''],
    [['param', 'ball.obj', '-o', './ball.obj'], ''],
    [['param', 'ball.obj', '-o', 'x.stl'], 'obj'],
    [['param', 'ball.obj', '-o', 'x.obj.gz'], 'obj'],
    [['inspect', 'ball.obj', '--mesh', '7'], ''],
  ];
  for (const [args, hint] of cases) {
    const { code, out, err } = run(args);
    assert.equal(code, 2, `${args.join(' ')}\n${err}`);
    assert.equal(out, '', args.join(' '));
    assert.match(err, /^hgp: /);
    assert.ok(err.includes(hint), `${hint} in ${err}`);
  }
  assert.ok(!existsSync(at('x.obj')));
  assert.equal(read('ball.obj'), sphere(6));
});

test('input that cannot be read ends with 3', () => {
  put('broken.obj', 'v 0 0 0\nf 1 2 3\n');
  put('page.obj', '<html>');
  put('empty.obj', '');
  put('cut.obj.gz', gzipSync(Buffer.from(sphere(4))).subarray(0, 200));
  for (const name of ['missing.obj', 'broken.obj', 'page.obj', 'empty.obj', 'cut.obj.gz', '.']) {
    const { code, err } = run(['inspect', name]);
    assert.equal(code, 3, `${name}: ${err}`);
  }
  const { code, err, out } = run(['inspect', 'broken.obj', '--json', '-']);
  assert.equal(code, 3);
  assert.match(err, /line 2/);
  const error = isValid('hgp-error', out);
  assert.equal(error.code, 'malformed');
});

test('limits end with 8', () => {
  assert.equal(run(['inspect', 'ball.obj', '--max-triangles', '10']).code, 8);
  assert.equal(run(['inspect', 'ball.obj', '--max-bytes', '10']).code, 8);
});

test('inspect prints text, or JSON alone where that goes to standard output', () => {
  const text = run(['inspect', 'ball.obj']);
  assert.equal(text.code, 0);
  assert.match(text.out, /genus +0/);
  assert.equal(text.err, '');
  const json = run(['inspect', 'ball.obj', '--json', '-']);
  const report = isValid('hgp-inspect', json.out);
  assert.equal(report.eulerCharacteristic, 2);
  assert.equal(report.triangles, 288);
  assert.equal(run(['inspect', 'ball.obj', '--quiet']).out, '');
});

test('unusable geometry is repaired, or with --strict refused (4) with the place', () => {
  const lines = sphere(6).split('\n');
  const first = lines.findIndex((line) => line.startsWith('f '));
  const [f, a, b, c] = lines[first].split(' ');
  lines[first] = [f, b, a, c].join(' ');
  put('flipped.obj', lines.join('\n'));
  const { code, out } = run(['inspect', 'flipped.obj', '--strict', '--json', '-']);
  assert.equal(code, 4);
  const report = isValid('hgp-inspect', out);
  assert.ok(report.defects.some((d) => d.fatal && d.where.length > 0));
  assert.equal(run(['param', 'flipped.obj', '-o', 'x.obj', '--strict']).code, 4);
  const repaired = run(['param', 'flipped.obj', '-o', 'x.obj']);
  assert.equal(repaired.code, 0);
  assert.match(repaired.err, sentenceOf('defect-inconsistent-edge', { count: 3 }));
  assert.equal(run(['verify', 'x.obj']).code, 0);
  assert.equal(run(['param', 'ball.obj', '-o', 'x.obj', '--strict', '--fix', 'split']).code, 2);
  const fixed = run(['inspect', 'flipped.obj', '--fix', 'orient', '--json', '-']);
  assert.equal(fixed.code, 0);
  assert.ok(isValid('hgp-inspect', fixed.out).notes.some(({ code }) => code === 'repair-turned'));
});

test('gzip and standard input are read', () => {
  put('ball.obj.gz', gzipSync(Buffer.from(sphere(6))));
  assert.equal(run(['inspect', 'ball.obj.gz']).code, 0);
  assert.equal(run(['inspect', '-', '--format', 'obj'], { input: sphere(3) }).code, 0);
});

test('check ends with 0 or 5', () => {
  const good = run(['check', 'ball.obj', '--cones', 'cones.json', '--json', '-']);
  assert.equal(good.code, 0, good.err);
  assert.equal(isValid('hgp-check', good.out).components[0].budget.left, 0);
  const bad = run(['check', 'ball.obj', '--cone', '3:3', '--json', '-']);
  assert.equal(bad.code, 5);
  assert.equal(isValid('hgp-check', bad.out).valid, false);
  assert.equal(run(['check', 'ball.obj', '--cone', '99999:3']).code, 5);
  assert.equal(run(['param', 'ball.obj', '--cone', '3:3', '-o', 'x.obj']).code, 5);
});

const paramRuns = {
  json: ['--q', '4', '--cones', 'cones.json'],
  text: ['--cones', 'ball.cones'],
  typed: ['--q', '4', ...six.flatMap(([v, k]) => ['--cone', `${v}:${k}`])],
  automatic: [],
};
for (const [name, options] of Object.entries(paramRuns)) {
  test(`param with ${name} cones: certified, lossless, and verify agrees`, () => {
    const args = ['param', 'ball.obj', ...options, '-o', `${name}.obj`, '--json', `${name}.json`];
    const { code, out, err } = run(args);
    assert.equal(code, 0, err);
    assert.equal(out, '');
    const report = isValid('hgp-report', read(`${name}.json`));
    assert.equal(report.certified, true);
    assert.equal(report.certificate.flipped, 0);
    const kept = (text) => text.split('\n').filter((line) => !/^(vt|f) /.test(line));
    assert.deepEqual(kept(read(`${name}.obj`)), kept(read('ball.obj')));
    put(`${name}.cones.json`, JSON.stringify(report.cones));
    const verified = run(['verify', `${name}.obj`, '--cones', `${name}.cones.json`, '--json', '-']);
    assert.equal(verified.code, 0, verified.out);
    isValid('hgp-certificate', verified.out);
  });
}

test('verify ends with 6 for a broken map and names the rule', () => {
  run(['param', 'ball.obj', '--cones', 'cones.json', '-o', 'good.obj']);
  const lines = read('good.obj').split('\n');
  const i = lines.findIndex((line) => line.startsWith('vt '));
  lines[i] = 'vt 100 100';
  put('bad.obj', lines.join('\n'));
  const { code, out } = run(['verify', 'bad.obj', '--cones', 'cones.json', '--json', '-']);
  assert.equal(code, 6);
  const certificate = isValid('hgp-certificate', out);
  assert.ok(certificate.components[0].reasons.length > 0);
  const other = run(['verify', 'good.obj', '--cone', `${corners[0]}:3`]);
  assert.notEqual(other.code, 0);
  assert.equal(run(['verify', 'ball.obj']).code, 4, 'no uv at all');
});

test('param --boundary convex maps a disk with polygons', () => {
  const { code, err } = run(['param', 'disk.obj', '--boundary', 'convex', '-o', 'flat.obj']);
  assert.equal(code, 0, err);
  assert.match(read('flat.obj'), /\nf \d+\/\d+ \d+\/\d+ \d+\/\d+ \d+\/\d+\n/);
  assert.equal(run(['verify', 'flat.obj']).code, 0);
  assert.equal(run(['param', 'ball.obj', '--boundary', 'convex', '-o', 'x.obj']).code, 4);
  // What such a map does not have is not silently left out.
  for (const words of [
    ['--count', '4'],
    ['--cones-for', 'few'],
    ['--align'],
    ['--q', '6'],
    ['--method', 'soft'],
  ]) {
    const refused = run(['param', 'disk.obj', '--boundary', 'convex', '-o', 'x.obj', ...words]);
    assert.equal(refused.code, 2, words.join(' '));
    assert.match(refused.err, /onto a convex polygon has .*leave out/);
  }
});

test('param --improve lowers what it is named for and stays certified', () => {
  const solve = (...words) => {
    const result = run([
      'param',
      at('sphere.obj'),
      '-o',
      at('better.obj'),
      '--json',
      '-',
      ...words,
    ]);
    assert.equal(result.code, 0, result.err);
    const report = isValid('hgp-report', result.out);
    assert.ok(report.certified);
    return report.components[0].improvement;
  };
  writeFileSync(at('sphere.obj'), sphere(8));
  assert.equal(solve(), null);
  const isometric = solve('--improve', 'isometric');
  assert.ok(isometric.kept);
  assert.ok(isometric.after.symmetricDirichlet < 0.8 * isometric.before.symmetricDirichlet);
  assert.deepEqual(solve('--quality'), isometric);
  assert.deepEqual(solve('--improve', '0'), isometric);
  const conformal = solve('--improve', 'conformal');
  assert.equal(conformal.balance, -1);
  assert.ok(conformal.after.meanMu < conformal.before.meanMu);
  const area = solve('--improve', 'area');
  assert.ok(area.after.rmsLogArea < 0.5 * area.before.rmsLogArea);
  const between = solve('--improve', '-0.5');
  assert.ok(between.after.meanMu < isometric.after.meanMu);
  assert.equal(run(['verify', at('better.obj')]).code, 0);
  assert.equal(isometric.onGrid, null);
  const { onGrid } = solve('--improve', 'isometric', '--cells', '400');
  assert.ok(onGrid.kept, onGrid.outcome);
  assert.ok(onGrid.after.symmetricDirichlet < onGrid.before.symmetricDirichlet);
  assert.equal(run(['verify', at('better.obj')]).code, 0);

  for (const words of [
    ['--improve', 'nice'],
    ['--improve', '1.5'],
    ['--improve', 'nan'],
    ['--improve', ''],
    ['--improve', 'area', '--quality'],
    ['--improve', 'area', '--boundary', 'convex'],
  ])
    assert.equal(run(['param', at('sphere.obj'), '-o', at('x.obj'), ...words]).code, 2, words);
});

test('cones are chosen and converted', () => {
  const chosen = run(['cones', 'ball.obj', '-o', 'chosen.json']);
  assert.equal(chosen.code, 0, chosen.err);
  isValid('hgp-cones', read('chosen.json'));
  assert.equal(run(['check', 'ball.obj', '--cones', 'chosen.json']).code, 0);
  const converted = run(['cones', 'ball.obj', '--convert', 'ball.cones']);
  assert.equal(converted.code, 0, converted.err);
  const cones = isValid('hgp-cones', converted.out);
  assert.deepEqual(
    cones.cones.map((c) => [c.vertex, c.k]),
    [...six].sort((a, b) => a[0] - b[0]).sort((a, b) => six.indexOf(a) - six.indexOf(b)),
  );
});

test('xref names the input vertex of every output vertex', () => {
  const { code } = run([
    'param',
    'ball.obj',
    '--cones',
    'cones.json',
    '-o',
    'a.obj',
    '--xref',
    'a.txt',
  ]);
  assert.equal(code, 0);
  const xref = read('a.txt').trim().split('\n').map(Number);
  const lines = read('a.obj').split('\n');
  assert.equal(xref.length, lines.filter((line) => line.startsWith('vt ')).length);
  for (const line of lines.filter((l) => l.startsWith('f '))) {
    for (const corner of line.slice(2).split(' ')) {
      const [v, vt] = corner.split('/').map(Number);
      assert.equal(xref[vt - 1], v - 1);
    }
  }
});

test('the same run gives the same bytes', () => {
  for (const name of ['one.obj', 'two.obj']) {
    assert.equal(run(['param', 'ball.obj', '--cones', 'cones.json', '-o', name]).code, 0);
  }
  assert.equal(read('one.obj'), read('two.obj'));
});

test('embedded cones are used again', () => {
  const args = [
    'param',
    'ball.obj',
    '--cones',
    'cones.json',
    '--embed-cones',
    '-o',
    'embedded.obj',
  ];
  assert.equal(run(args).code, 0);
  const again = run(['check', 'embedded.obj', '--json', '-']);
  assert.equal(isValid('hgp-check', again.out).components[0].cones, 6);
  // The file's own cones give the file's own map.
  assert.equal(run(['param', 'embedded.obj', '--embed-cones', '-o', 'again.obj']).code, 0);
  const nameless = (text) => text.replace(/"sha256":"\w+"/, '"sha256":""'); // of another file
  assert.equal(nameless(read('again.obj')), nameless(read('embedded.obj')));
});

test('exit code, text, report, certificate and verify have the same verdict', () => {
  // Cones that no map can be found for in one round, and ones that can.
  const cones = (list) =>
    JSON.stringify({ format: 'hgp-cones', version: 1, q: 4, cones: list.map(([vertex, k]) => ({ vertex, k })) }); // prettier-ignore
  put('close.json', cones([[0, 1], [1, 1], [2, 1], [3, 1], [5, 8]])); // prettier-ignore
  const verdicts = new Set();
  for (const asked of ['cones.json', 'close.json']) {
    const args = ['--cones', asked, '--rounds', '1'];
    const { code, out, err } = run([
      'param',
      'ball.obj',
      ...args,
      '-o',
      'v.obj',
      '--json',
      'v.json',
    ]);
    const report = isValid('hgp-report', read('v.json'));
    verdicts.add(report.certified);
    assert.equal(code, report.certified ? 0 : 6, err);
    assert.equal(report.certificate.certified, report.certified);
    assert.equal(
      report.certificate.components.every(({ certified }) => certified),
      report.certified,
    );
    assert.equal(/^certified/m.test(out + err), report.certified, out + err);
    if (!report.certified) continue;
    const again = run(['verify', 'v.obj', '--cones', asked, '--json', '-']);
    assert.equal(again.code, 0);
    assert.equal(isValid('hgp-certificate', again.out).certified, true);
  }
  assert.equal(verdicts.size, 2, 'both verdicts were seen');
});

test('the input is replaced with --force only, and a failed write ends with 7', () => {
  put('own.obj', sphere(4));
  assert.equal(run(['param', 'own.obj', '-o', 'own.obj']).code, 2);
  assert.equal(run(['param', 'own.obj', '-o', 'own.obj', '--force']).code, 0);
  assert.match(read('own.obj'), /\nvt /);
  assert.equal(run(['param', 'ball.obj', '-o', 'no/such/folder/x.obj']).code, 7);
});

test('standard output carries the map alone', () => {
  const { code, out } = run(['param', 'ball.obj', '--cones', 'cones.json', '-o', '-']);
  assert.equal(code, 0);
  assert.match(out, /^# a sphere\n/);
});

test('a GLB stays a GLB', { skip: !existsSync(shared) && 'no data folder' }, () => {
  const torus = path.join(shared, 'gltf/torus.glb');
  assert.equal(run(['param', torus, '-o', 'torus.ply']).code, 2);
  const { code, err } = run(['param', torus, '--embed-cones', '-o', 'torus.glb']);
  assert.equal(code, 0, err);
  assert.equal(run(['verify', 'torus.glb', '--uv-set', '1']).code, 0);
});

test(
  'the field problems give the same result from every format',
  {
    skip: !existsSync(shared) && 'no data folder',
  },
  () => {
    const mesh = path.join(shared, 'Directional/eight.off');
    const convert = (file) => run(['cones', mesh, '--convert', file]);
    const text = convert(path.join(shared, 'cones/Directional__eight.cones'));
    assert.equal(text.code, 0, text.err);
    assert.equal(convert(path.join(shared, 'Directional/eight.rawfield.gz')).out, text.out);
    const sings = JSON.parse(convert(path.join(shared, 'Directional/eight.sings')).out);
    assert.deepEqual(sings.cones, JSON.parse(text.out).cones);
  },
);

/** A flat square of n × n squares. */
function square(n) {
  const lines = [];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) lines.push(`v ${i} ${j} 0`);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = j * (n + 1) + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + n + 2}`, `f ${a} ${a + n + 2} ${a + n + 1}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** The same cross on every triangle of the plane, its arm at `angle`. */
const crosses = (count, angle) =>
  `4 ${count}\n${Array(count)
    .fill([0, 1, 2, 3].map((a) => angle + (a * Math.PI) / 2))
    .map((arms) => arms.map((a) => `${Math.cos(a)} ${Math.sin(a)} 0`).join(' '))
    .join('\n')}\n`;

test('frames of a field file decide how the map is turned', () => {
  put('square.obj', square(6));
  const turned = (angle, frames) => {
    put('turned.rawfield', crosses(72, angle));
    const args = ['--field', 'turned.rawfield', '--frames', frames, '-o', 'turned.obj'];
    const { code, out, err } = run([
      'param',
      'square.obj',
      ...args,
      '--json',
      '-',
      '--scale',
      'unit',
    ]);
    assert.equal(code, 0, err);
    const report = isValid('hgp-report', out);
    assert.equal(report.options.frames, frames);
    const uv = read('turned.obj').match(/^vt .*$/gm).map((line) => line.split(' ').slice(1).map(Number)); // prettier-ignore
    const at = new Map(
      [...read('turned.obj').matchAll(/(\d+)\/(\d+)/g)].map(([, v, vt]) => [Number(v), uv[vt - 1]]),
    );
    const [a, b] = [at.get(1), at.get(7)]; // the lower edge, along x
    return Math.atan2(b[1] - a[1], b[0] - a[0]);
  };
  for (const angle of [0, 0.3, -0.6]) {
    assert.ok(Math.abs(turned(angle, 'file') + angle) < 1e-6, `${angle}`);
  }
  assert.equal(turned(0, 'auto'), turned(0.3, 'auto'));
});

test('frames that a file does not have, or that contradict the cones, are refused', () => {
  put('square.obj', square(6));
  put('turned.rawfield', crosses(72, 0.3));
  put('matched.cones', 'q 4\ncones 0\nmatchings 1\n0 1 0 8 4\n');
  const param = (...args) => run(['param', 'square.obj', ...args, '-o', 'never.obj']);
  const file = ['--frames', 'file'];
  for (const [args, code, text] of [
    [file, 2, /--frames file needs --field/],
    [['--frames', 'yes', '--field', 'turned.rawfield'], 2, /--frames/],
    [[...file, '--field', 'matched.cones'], 2, /no directions/],
    [[...file, '--field', 'turned.rawfield', '--cone', '16:3'], 5, /k = 3|cones/],
    [[...file, '--field', 'turned.rawfield', '--turning', '0:3'], 5, /l = 4 where l = 3|Lemma 6.2/],
  ]) {
    const { code: found, err } = param(...args);
    assert.equal(found, code, `${args.join(' ')}: ${err}`);
    assert.match(err, text);
  }
  put('short.rawfield', crosses(71, 0.3));
  const short = param(...file, '--field', 'short.rawfield');
  assert.equal(short.code, 5);
  assert.match(short.err, /71 faces, the mesh 72/);
});

test(
  'the fields of the shared meshes are certified with their own frames',
  { skip: !existsSync(shared) && 'no data folder' },
  () => {
    for (const [mesh, field] of [
      ['eight.off', 'eight.rawfield.gz'],
      ['torus.obj', 'torus-hex.rawfield'],
      ['train-station.off', 'train-station-5.rawfield'],
      ['vase.off', 'vase-7.rawfield'],
    ]) {
      const [model, crossed] = [mesh, field].map((name) => path.join(shared, 'Directional', name));
      const asked = ['--field', crossed];
      const solved = run(['param', model, ...asked, '--frames', 'file', '-o', 'framed.obj']);
      assert.equal(solved.code, 0, `${field}: ${solved.err}`);
      assert.equal(run(['verify', 'framed.obj', ...asked]).code, 0, field);
    }
  },
);

test('an interrupted run leaves nothing behind and ends with 130', async () => {
  const before = readdirSync(folder).sort();
  // A small surface may be through before the signal comes: then a larger one is taken.
  for (const n of [40, 150]) {
    put('large.obj', sphere(n));
    const child = spawn(hgp, ['param', 'large.obj', '-o', 'large.out.obj'], { cwd: folder });
    await new Promise((resolve) => child.stderr.once('data', resolve));
    child.kill('SIGINT');
    const code = await new Promise((resolve) => child.on('close', (c) => resolve(c)));
    rmSync(path.join(folder, 'large.obj'));
    if (n === 40 && code === 0) {
      rmSync(path.join(folder, 'large.out.obj'));
      continue;
    }
    assert.equal(code, 130);
    break;
  }
  assert.deepEqual(readdirSync(folder).sort(), before);
});

test('control bytes from a file never reach the terminal', () => {
  put('evil.obj', 'v 0 0 \x1b[31mred\n');
  const { err } = run(['inspect', 'evil.obj']);
  assert.ok(!err.includes('\x1b'));
});

test(
  'the field problems of the shared meshes',
  { skip: !existsSync(shared) && 'no data folder' },
  () => {
    const cases = [
      ['Directional/torus.obj', 'cones/Directional__torus-hex.cones', 0],
      ['Directional/torus.obj', 'cones/Directional__torus_twosings.cones', 5],
      ['Directional/train-station.off', 'cones/Directional__train-station-5.cones', 0],
      ['Directional/vase.off', 'cones/Directional__vase-7.cones', 0],
    ];
    for (const [mesh, cones, expected] of cases) {
      const { code, err } = run([
        'check',
        path.join(shared, mesh),
        '--cones',
        path.join(shared, cones),
      ]);
      assert.equal(code, expected, `${cones}: ${err}`);
    }
    const aircraft = path.join(shared, 'ConformalIdealDelaunay/aircraft');
    const { code, err, out } = run([
      'check',
      `${aircraft}.obj`,
      '--cones',
      `${aircraft}_Th_hat`,
      '--json',
      '-',
    ]);
    assert.equal(code, 0, err);
    assert.equal(JSON.parse(out).components[0].cones, 41);
  },
);

test('input files are never overwritten, not even by a run that is refused', () => {
  put('own-cones.json', read('cones.json'));
  const before = new Map(['ball.obj', 'own-cones.json'].map((name) => [name, read(name)]));
  const cones = ['--cones', 'own-cones.json'];
  for (const args of [
    ['param', 'ball.obj', '-o', 'x.obj', '--json', 'ball.obj'],
    ['param', 'ball.obj', '-o', 'x.obj', '--xref', './ball.obj', '--force'],
    ['param', 'ball.obj', ...cones, '-o', 'x.obj', '--json', 'own-cones.json'],
    ['check', 'ball.obj', ...cones, '--json', `${folder}/own-cones.json`],
    ['cones', 'ball.obj', '--convert', 'own-cones.json', '-o', 'own-cones.json'],
    ['inspect', 'ball.obj', '--json', 'ball.obj'],
    ['inspect', 'missing.obj', '--json', './missing.obj'],
    ['param', 'ball.obj', '-o', 'y.obj', '--json', './y.obj'],
    ['param', 'ball.obj', '-o', 'y.obj', '--json', 'z', '--xref', './z'],
  ]) {
    const { code, err } = run(args);
    assert.equal(code, 2, `${args.join(' ')}: ${err}`);
    for (const [name, text] of before) assert.equal(read(name), text, args.join(' '));
  }
  assert.ok(!existsSync(at('y.obj')) && !existsSync(at('z')) && !existsSync(at('missing.obj')));
});

// A program for Windows under Wine writes to files alone.
const hasDevices = process.env.HGP_ON_WINDOWS === undefined;
const inDevices = hasDevices ? test : (name) => console.log(`SKIPPING on Windows: ${name}`);
inDevices('devices and pipes are written to and stay what they are, links stay links', async () => {
  symlinkSync('/dev/null', at('sink.obj'));
  assert.equal(run(['param', 'ball.obj', '-o', 'sink.obj', '--json', 'sink.obj']).code, 0);
  assert.ok(lstatSync(at('sink.obj')).isSymbolicLink());
  assert.ok(statSync('/dev/null').isCharacterDevice());

  mkdirSync(at('elsewhere'));
  put('elsewhere/real.obj', 'old');
  symlinkSync('elsewhere/real.obj', at('link.obj'));
  assert.equal(run(['param', 'ball.obj', '-o', 'link.obj']).code, 0);
  assert.ok(lstatSync(at('link.obj')).isSymbolicLink());
  assert.match(read('elsewhere/real.obj'), /\nvt /);

  assert.equal(spawnSync('mkfifo', [at('pipe.obj')]).status, 0);
  const child = spawn(hgp, ['param', 'ball.obj', '-o', 'pipe.obj', '--quiet'], { cwd: folder });
  const ended = new Promise((resolve) => child.once('close', resolve));
  const got = await readFile(at('pipe.obj'), 'utf8');
  assert.equal(await ended, 0);
  assert.match(got, /\nvt /);
  assert.ok(statSync(at('pipe.obj')).isFIFO());
  assert.equal(run(['param', 'ball.obj', '-o', 'elsewhere']).code, 7, 'a folder');
});

test('invalid or out-of-range numbers are usage errors with short messages', () => {
  for (const [option, value] of [
    ['--time-limit', 'nan'],
    ['--time-limit', '0'],
    ['--time-limit', '-1'],
    ['--weld', 'nan'],
    ['--weld', 'inf'],
    ['--weld', '-1'],
    ['--count', '-5'],
    ['--mesh', '-1'],
    ['--max-bytes', '-1'],
    ['--max-bytes', '0'],
    ['--max-triangles', 'many'],
    ['--threads', '0'],
    ['--threads', '17'],
    ['--threads', 'all'],
    ['--uv-set', '-2'],
  ]) {
    const { code, err } = run(['param', 'ball.obj', '-o', 'x.obj', option, value]);
    assert.equal(code, 2, `${option} ${value}: ${err}`);
    assert.ok(err.split('\n')[0].length < 120, err);
  }
  for (const tolerance of ['nan', 'inf', '-1']) {
    assert.equal(run(['verify', 'ball.obj', '--tol', tolerance]).code, 2, tolerance);
  }
  assert.equal(run(['inspect', 'ball.obj', '--max-triangles', '288']).code, 0);
});

test('what only glTF has is refused for other formats, before anything is solved', () => {
  for (const [option, pattern] of [
    [['--uv-set', '1'], /--uv-set is for glTF/],
    ['--embed', /--embed is for glTF/],
  ]) {
    const { code, err } = run(['param', 'ball.obj', '-o', 'other.obj', option].flat());
    assert.equal(code, 2);
    assert.match(err, pattern);
    assert.ok(!existsSync(at('other.obj')));
  }
  assert.equal(run(['param', 'ball.obj', '-o', 'other.glb', '--uv-set', '1', '--embed']).code, 0);
});

test('a mesh that vanishes in single precision is refused as glTF alone', () => {
  put(
    'far_off.obj',
    'v 1e9 1e9 0\nv 1000000001 1e9 0\nv 1000000001 1000000001 0\nv 1e9 1000000001 0\nf 1 2 3\nf 1 3 4\n',
  );
  const { code, err } = run(['param', 'far_off.obj', '-o', 'far_off.glb']);
  assert.equal(code, 4);
  assert.match(err, /single precision, no triangle of 2 has an area .* -o x\.obj/);
  assert.equal(run(['param', 'far_off.obj', '-o', 'far_mapped.obj']).code, 0);
});

/** Files of a hostile neighbour, each with its exit code and what is said. */
const hostile = {
  'nan.obj': ['v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 3, /line 1/],
  'inf.obj': ['v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 3, /finite/],
  'far.obj': ['v 0 0 0\nv 1e19 0 0\nv 0 1e19 0\nf 1 2 3\n', 4, /too large or too small/],
  'near.obj': ['v 0 0 0\nv 1e-310 0 0\nv 0 1e-310 0\nf 1 2 3\n', 4, /too large or too small/],
  'point.obj': ['v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n', 4, /nothing is left to parametrize/],
  'zero.obj': ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n', 3, /line 4/],
  'early.obj': ['v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0\n', 3, /line 3/],
  'comma.obj': ['v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 3, /line 1/],
  'long.obj': [`v 0 0 0\nf ${'1 '.repeat(600_000)}\n`, 3, /longer than 1 MiB/],
  'null_byte.obj': ['v 0 0 0\0\n', 3, /NUL/],
  'utf16.obj': [Buffer.from('\ufeffv 0 0 0\n', 'utf16le'), 3, /UTF-16; save the file as UTF-8/],
  'nul.obj': ['v 0 0 0\nv 1 \0 0\n', 3, /NUL/],
  'count.off': ['OFF\n2000000000 2000000000 0\n', 3, /counts/],
  'negative.off': ['OFF\n-1 -5 0\n', 3, /counts/],
  'count.ply': [
    'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n',
    3,
    /count/,
  ],
  'count.stl': [Buffer.concat([Buffer.alloc(80), Buffer.alloc(4, 255)]), 3, /announced/],
  'deep.gltf': [`{"a":${'['.repeat(200_000)}`, 3, /nested/],
  'escape.gltf': [
    JSON.stringify({ ...toGltf([cubeMesh(2)], { buffer: '../../../../etc/passwd' }).json }),
    3,
    /leaves the folder/,
  ],
  'encoded.gltf': [
    JSON.stringify({ ...toGltf([cubeMesh(2)], { buffer: '..%2f..%2fetc%2fpasswd' }).json }),
    3,
    /leaves the folder/,
  ],
  'network.gltf': [
    JSON.stringify({ ...toGltf([cubeMesh(2)], { buffer: 'http://localhost/x.bin' }).json }),
    3,
    /http/,
  ],
  'linked.gltf': [
    JSON.stringify({ ...toGltf([cubeMesh(2)], { buffer: 'linked.bin' }).json }),
    3,
    /outside its folder/,
  ],
  'waiting.gltf': [
    JSON.stringify({ ...toGltf([cubeMesh(2)], { buffer: 'waiting.bin' }).json }),
    3,
    /not a regular file/,
  ],
};
test('hostile files end with their exit codes, without delay', () => {
  symlinkSync('/etc/passwd', at('linked.bin'));
  spawnSync('mkfifo', [at('waiting.bin')]);
  for (const [name, [text, exit, message]] of Object.entries(hostile)) {
    // Under Wine a program sees what such a link leads to, and not the link; and pipes not at all.
    if (['linked.gltf', 'waiting.gltf'].includes(name) && !hasDevices) continue;
    put(name, text);
    const { code, err } = run(['param', name, '-o', 'x.obj'], { timeout: 20_000 });
    assert.equal(code, exit, `${name}: ${err}`);
    assert.match(err, message, name);
  }
  put('\u001b[31mred.obj', 'v 0 0 x\n');
  assert.ok(!run(['inspect', '\u001b[31mno such file']).err.includes('\u001b'));
});

test('an OBJ may ask for any material file: none is opened', () => {
  put(
    'mtl.obj',
    `mtllib /etc/shadow\nmtllib ../../x.mtl\nmtllib http://localhost/a.mtl\n${sphere(3)}`,
  );
  assert.equal(run(['param', 'mtl.obj', '-o', 'mtl.out.obj']).code, 0);
  assert.match(read('mtl.out.obj'), /^mtllib \/etc\/shadow\nmtllib \.\.\/\.\.\/x\.mtl\n/);
});

/** A long strip per turn count, mapped around the origin: locally injective, on top of itself from one turn on. */
function strips(...turns) {
  const lines = [];
  const faces = [];
  const [length, width] = [60, 3];
  turns.forEach((turn, component) => {
    const id = (i, j) => 1 + component * (length + 1) * (width + 1) + i * (width + 1) + j;
    for (let i = 0; i <= length; i++) {
      for (let j = 0; j <= width; j++) {
        const angle = (2 * Math.PI * turn * i) / length;
        const radius = 2 - j / width;
        lines.push(`v ${i} ${j} ${10 * component}`);
        lines.push(`vt ${radius * Math.cos(angle)} ${radius * Math.sin(angle)}`);
        if (i === length || j === width) continue;
        const quad = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
        for (const [a, b, c] of [
          [0, 1, 2],
          [0, 2, 3],
        ]) {
          faces.push(`f ${[quad[a], quad[b], quad[c]].map((v) => `${v}/${v}`).join(' ')}`);
        }
      }
    }
  });
  return [...lines, ...faces, ''].join('\n');
}

test('verify measures maps of other programs, component by component, and reports overlaps', () => {
  const verify = (name, ...args) => {
    const { code, out, err } = run(['verify', name, '--json', '-', ...args]);
    return { code, err, ...isValid('hgp-certificate', out) };
  };
  put('strips.obj', strips(0.75, 1.5));
  const good = verify('strips.obj');
  assert.equal(good.code, 0, good.err);
  assert.deepEqual(
    good.components.map(({ overlap }) => overlap.layers),
    [1, 2],
  );
  assert.equal(good.components[0].overlap.share, 0);
  assert.ok(Math.abs(good.components[1].overlap.share - 0.5) < 0.02);
  assert.match(run(['verify', 'strips.obj']).out, /overlap +\d+\.\d % of the covered area/);

  const folded = read('strips.obj').split('\n');
  const last = folded.findLastIndex((line) => line.startsWith('vt '));
  folded[last - 10] = 'vt 0 0';
  put('folded.obj', folded.join('\n'));
  const bad = verify('folded.obj');
  assert.equal(bad.code, 6);
  assert.deepEqual(
    bad.components.map(({ certified }) => certified),
    [true, false],
  );
  assert.ok(bad.components[1].reasons.some(({ rule }) => rule === 'orientation'));
});

test('verify reports a component that it cannot measure as not measured', () => {
  const lines = strips(0.75, 1.5).split('\n');
  const first = lines.findIndex((line) => line.startsWith('vt '));
  put('one.obj', lines.with(first, 'vt nan 0').join('\n'));
  const one = run(['verify', 'one.obj']);
  assert.equal(one.code, 6);
  assert.match(one.out, /no +measured +1 of 2 components/);
  const [, positive, all] = /ok +positive triangles +(\d+) of (\d+)/.exec(one.out);
  const faces = lines.filter((line) => line.startsWith('f ')).length;
  assert.ok(positive === all && all < faces, one.out);
  assert.match(one.out, /component 0 +not measured/);

  put('none.obj', lines.map((line) => line.replace(/^vt .*/, 'vt 0 inf')).join('\n'));
  const none = run(['verify', 'none.obj']);
  assert.equal(none.code, 6);
  assert.match(none.out, /no +measured +0 of 2 components/);
  assert.doesNotMatch(none.out, /^ +ok /m);
});

test('verify --tol is for files printed with few digits', () => {
  assert.equal(run(['param', 'ball.obj', '--cones', 'cones.json', '-o', 'exact.obj']).code, 0);
  const rounded = read('exact.obj').replace(
    /^vt (\S+) (\S+)/gm,
    (_, u, v) => `vt ${Number(u).toFixed(5)} ${Number(v).toFixed(5)}`,
  );
  put('rounded.obj', rounded);
  const args = ['verify', 'rounded.obj', '--cones', 'cones.json'];
  assert.equal(run(args).code, 6);
  assert.equal(run([...args, '--tol', '1e-4']).code, 0, run([...args, '--tol', '1e-4']).out);
});
