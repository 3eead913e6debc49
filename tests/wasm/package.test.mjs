// The package as its users have it: build/package, in Node.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { Worker } from 'node:worker_threads';
import { problems } from '../cli/schema.mjs';
import { blocks, ring } from '../support/blocks.mjs';
import { bumpyDisk } from '../support/disk.mjs';
import { cubeCrosses, cubeMesh, toGlb, toGltf, toObj, toOff } from '../support/meshes.mjs';
import {
  built,
  bytesOf,
  createClient,
  createCore,
  HgpError,
  native,
  scratch,
  withClient,
} from './support.mjs';

const bytes = bytesOf;
const disk = (n) => bytes(bumpyDisk(n));
const isValid = (schema, value) =>
  assert.deepEqual(problems(schema, value).slice(0, 5), [], schema);

test('declarations say exactly which values are exported', async () => {
  for (const entry of ['index', 'core', 'lite', 'three', 'gltf-transform']) {
    const text = readFileSync(path.join(built, `${entry}.d.ts`), 'utf8');
    const own = text.matchAll(/^export declare (?:function|class|const) (\w+)/gm);
    const passedOn = text.matchAll(/^export \{ ([^}]*) \} from/gm);
    const names = [...passedOn].flatMap(([, list]) => list.split(', '));
    const declared = [...new Set([...own].map(([, name]) => name)), ...names]; // overloads count once
    const exported = Object.keys(await import(path.join(built, `${entry}.js`)));
    const values = declared.filter((name) => !name.startsWith('type '));
    assert.deepEqual(values.sort(), exported.sort(), entry);
  }
  const inNode = Object.keys(await import(path.join(built, 'node/core.js'))).sort();
  assert.deepEqual(inNode, Object.keys(await import(path.join(built, 'core.js'))).sort());
});

test('every document follows the schema that the command line uses', () =>
  withClient(async (client) => {
    const model = await client.load(bytes(toObj(blocks(ring))), { name: 'ring.obj' });
    isValid('hgp-inspect', model.info);
    const cones = await model.suggestCones({ q: 4 });
    isValid('hgp-cones', cones);
    isValid('hgp-check', await model.check(cones));
    isValid('hgp-check', await model.check({ ...cones, cones: [{ vertex: 0, k: 1 }] }));
    const map = await model.parametrize({ cones });
    const { report, certificate } = map;
    isValid('hgp-report', report);
    isValid('hgp-certificate', certificate);
    isValid('hgp-cones', report.cones);
    const { bytes: mapped, name } = await map.write();
    const again = await client.load(mapped, { name });
    isValid('hgp-certificate', await again.verify({ cones }));
    const failure = await client.load(bytes('v 1'), { name: 'x.obj' }).catch((error) => error);
    const { code, message, details } = failure;
    isValid('hgp-error', { format: 'hgp-error', version: 1, code, message, ...details });
  }));

test('a mode of the grid alone gives the quads that the command line gives without --cells', () =>
  withClient(async (client) => {
    const folder = scratch('quads');
    const [input, output] = ['in.obj', 'out.obj'].map((name) => path.join(folder, name));
    writeFileSync(input, toObj(blocks(ring, { n: 4 })));
    const improved = ['--improve', 'isometric', '--align', '--method', 'harmonic'];
    const words = ['quads', input, '-o', output, '-q', '--reproducible', ...improved];
    assert.equal(spawnSync(native, words).status, 0);
    const lines = readFileSync(output, 'utf8').split('\n');
    const model = await client.load(readFileSync(input), { name: 'in.obj' });
    const options = { improve: 'isometric', alignToCurvature: true, method: 'harmonic' };
    const map = await model.parametrize({ ...options, grid: { mode: 'quad' } });
    const made = await map.quads();
    assert.equal(made.quads, lines.filter((line) => line.startsWith('f ')).length);
    assert.equal(made.vertices, lines.filter((line) => line.startsWith('v ')).length);
  }));

test('quads of a .gltf as GLB contain its pictures, as they were when it was loaded', () =>
  withClient(async (client) => {
    const { json, bin } = toGltf([cubeMesh(4)], { image: 'a picture.png', uv: { 0: ([x, y]) => [x, y] } }); // prettier-ignore
    json.images[0].uri = 'a%20picture.png';
    const picture = Uint8Array.from({ length: 1000 }, (_, i) => (i * i) % 251);
    const sides = { 'cube.bin': new Uint8Array(bin), 'a picture.png': picture.slice() };
    const files = { 'cube.gltf': bytes(JSON.stringify(json)), ...sides };
    const model = await client.load({ main: 'cube.gltf', files });
    files['a picture.png'].fill(0);
    const map = await model.parametrize({ grid: { mode: 'quad' } });
    const inside = (made) => Buffer.from(made.bytes).indexOf(picture) > 0;
    const made = await map.quads({ name: 'q.glb' });
    assert.ok(inside(made));
    assert.deepEqual(made.notes, [], 'nothing is missing');
    assert.equal(inside(await map.quads({ name: 'q.obj' })), false);
    // Without the picture the rest is written, and its absence said.
    const { 'a picture.png': _, ...without } = files;
    const bare = await client.load({ main: 'cube.gltf', files: without });
    const { notes } = await (await bare.parametrize({ grid: { mode: 'quad' } })).quads({ name: 'q.glb' }); // prettier-ignore
    assert.equal(notes.length, 1);
    assert.equal(notes[0].code, 'read-file-refused');
  }));

test('of the files beside a .gltf a model keeps copies of those that may be pictures, until it is freed', async () => {
  const core = await createCore();
  const { json, bin } = toGltf([cubeMesh(2)]);
  const picture = Uint8Array.of(1, 2, 3);
  const given = { 'cube.gltf': bytes(JSON.stringify(json)), 'cube.bin': new Uint8Array(bin), 'more.bin': Uint8Array.of(7), 'a.png': picture, 'b/c.jpg': Uint8Array.of(9), 'bin.webp': Uint8Array.of(8) }; // prettier-ignore
  const model = core.load({ main: 'cube.gltf', files: new Map(Object.entries(given)) });
  assert.deepEqual([...model.sides.keys()], ['a.png', 'b/c.jpg', 'bin.webp']);
  picture.fill(0);
  assert.deepEqual([...model.sides.get('a.png')], [1, 2, 3]);
  model.free();
  assert.equal(model.sides.size, 0);
  // Other formats name no files that are kept in memory.
  for (const [main, content] of [
    ['cube.glb', new Uint8Array(toGlb([cubeMesh(2)]))],
    ['cube.obj', bytes(toObj(cubeMesh(2)))],
  ]) {
    // prettier-ignore
    const one = core.load({ main, files: new Map(Object.entries({ [main]: content, 'a.png': Uint8Array.of(1) })) }); // prettier-ignore
    assert.equal(one.sides.size, 0, main);
    one.free();
  }
});

test('what is written has the name of the file, with the extension of what it is', async () => {
  const core = await createCore();
  const contents = { obj: bytes(toObj(cubeMesh(2))), glb: new Uint8Array(toGlb([cubeMesh(2)])), off: bytes(toOff(cubeMesh(2))) }; // prettier-ignore
  for (const [main, kind, name, target] of [
    ['cube.obj', 'obj', 'cube.obj'],
    ['Cube.OBJ', 'obj', 'Cube.OBJ'],
    ['a/b.c/cube.obj', 'obj', 'cube.obj'],
    ['cube.obj.obj', 'obj', 'cube.obj.obj'],
    ['cube.v2.obj', 'obj', 'cube.v2.obj'],
    ['cube.glb', 'glb', 'cube.glb'],
    ['cube.GLB', 'glb', 'cube.GLB'],
    ['cube.vrm', 'glb', 'cube.glb'],
    ['.glb', 'glb', 'mesh.glb'],
    ['a/.obj', 'obj', 'mesh.obj'],
    ['cube.off', 'off', 'cube.obj'],
    ['glb.off', 'off', 'glb.obj'],
    ['cube.off', 'off', 'cube.obj', 'obj'],
    ['cube.obj', 'obj', 'cube.glb', 'glb'],
    ['cube.glb', 'glb', 'cube.obj', 'obj'],
  ]) {
    const model = core.load({ main, files: new Map([[main, contents[kind]]]) }, { target });
    assert.equal(model.defaultName, name, `${main} as ${target}`);
    model.free();
  }
});

test('cones embedded in a file are found again', () =>
  withClient(async (client) => {
    for (const [name, file] of [
      ['cube.glb', new Uint8Array(toGlb([cubeMesh(4)]))],
      ['cube.obj', bytes(toObj(cubeMesh(4)))],
    ]) {
      const model = await client.load(file, { name });
      assert.equal(await model.embeddedCones(), null, name);
      const first = await model.parametrize({ q: 4 });
      const { cones } = first;
      const written = await first.write({ embedCones: true });
      const reread = await client.load(written.bytes, { name });
      const found = await reread.embeddedCones();
      isValid('hgp-cones', found);
      assert.deepEqual(found.cones, cones.cones, name);
      assert.equal((await reread.verify({ cones: found })).certified, true, name);
      const again = await reread.parametrize();
      assert.deepEqual(again.uv, first.uv, `${name}: its own cones give its own map`);
    }
  }));

test('load, inspect, parametrize, write, verify', () =>
  withClient(async (client) => {
    const model = await client.load(disk(12), { name: 'disk.obj' });
    assert.deepEqual(await model.inspect(), model.info);
    const result = await model.parametrize({ boundary: 'convex' });
    assert.equal(result.certificate.certified, true);
    assert.equal(result.triangles.length, 3 * 6 * 12 * 12);
    assert.equal(result.cornerToUv.length, result.triangles.length);
    assert.equal(result.uvToVertex.length, result.uv.length / 2);
    assert.ok(result.memory >= 32 * 2 ** 20 && result.memory % 65536 === 0, `${result.memory}`);
    for (let c = 0; c < result.triangles.length; c++) {
      assert.equal(result.uvToVertex[result.cornerToUv[c]], result.triangles[c]);
    }
    const written = await result.write();
    const again = await client.load(written.bytes, { name: written.name });
    assert.equal((await again.verify()).certified, true);
  }));

test('a field brings its cones, and on request its directions as frames', () =>
  withClient(async (client) => {
    const mesh = cubeMesh(4);
    const field = { name: 'cube.rosy', text: cubeCrosses(mesh) };
    const model = await client.load(bytes(toObj(mesh)), { name: 'cube.obj' });
    for (const frames of ['auto', 'file']) {
      const map = await model.parametrize({ field, frames });
      const { certificate, cones, report } = map;
      assert.equal(certificate.certified, true, frames);
      assert.equal(report.options.frames, frames);
      isValid('hgp-report', report);
      assert.deepEqual(
        cones.cones.map(({ k }) => k),
        Array(8).fill(3),
      );
      const { bytes: mapped, name } = await map.write();
      const again = await client.load(mapped, { name });
      assert.equal((await again.verify({ field })).certified, true);
    }
    // A flat square whose crosses all stand at 0.3: the map turns them onto its axes.
    const square = {
      positions: new Float64Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
      triangles: new Uint32Array([0, 1, 2, 0, 2, 3]),
    };
    const arms = `${Math.cos(0.3)} ${Math.sin(0.3)} 0\n`;
    const turned = { name: 'square.rosy', text: `2\n4\n${arms}${arms}` };
    const { uv, uvToVertex } = await client.parametrizeMesh({
      ...square,
      field: turned,
      frames: 'file',
    });
    const at = (v) => uv.subarray(2 * uvToVertex.indexOf(v), 2 * uvToVertex.indexOf(v) + 2);
    const angle = Math.atan2(at(1)[1] - at(0)[1], at(1)[0] - at(0)[0]);
    assert.ok(Math.abs(angle + 0.3) < 1e-6, `${angle}`);
  }));

test('frames that are not there, or contradict the cones, are refused', () =>
  withClient(async (client) => {
    const mesh = cubeMesh(2);
    const model = await client.load(bytes(toObj(mesh)), { name: 'cube.obj' });
    const field = { name: 'cube.rosy', text: cubeCrosses(mesh) };
    const nowhere = { q: 4, cones: [8, 9].map((vertex) => ({ vertex, k: 3 })) };
    const bare = { name: 'bare.cones', text: 'q 4\ncones 0\nmatchings 0\n' };
    for (const [options, code, text] of [
      [{ field, frames: 'yes' }, 'usage', /'auto' or 'file', not 'yes'/],
      [{ frames: 'file' }, 'usage', /needs the field/],
      [{ field: { name: 'cube.rosy' }, frames: 'file' }, 'usage', /field is \{ name, text \}/],
      [{ field: bare, frames: 'file' }, 'prescription', /./],
      [
        { field, frames: 'file', cones: nowhere },
        'prescription',
        /k = 4 where the list of cones says 3/,
      ],
    ]) {
      const failure = await model.parametrize(options).catch((error) => error);
      assert.ok(failure instanceof HgpError);
      assert.equal(failure.code, code, failure.message);
      assert.match(failure.message, text);
    }
  }));

test('the surface is available before any solve, and cone files of other programs are read for it', () =>
  withClient(async (client) => {
    const model = await client.load(disk(6), { name: 'disk.obj' });
    const surface = await model.surface();
    assert.equal(surface.positions.length, 3 * model.info.vertices);
    assert.equal(surface.triangles.length, 3 * 6 * 6 * 6);
    const cones = await model.readCones({
      name: 'cones.obj',
      text: `${bumpyDisk(6)}c 1 1.5\n`,
      q: 4,
    });
    assert.deepEqual(
      cones.cones.map(({ vertex, k }) => [vertex, k]),
      [[0, 3]],
    );
  }));

test('the repaired surface is reported, and nothing where there was no repair', () =>
  withClient(async (client) => {
    const { vertices, triangles } = cubeMesh(3);
    const fin = [...triangles, [triangles[0][0], triangles[0][1], vertices.length]];
    const mesh = { vertices: [...vertices, [-2, -2, -2]], triangles: fin };
    const file = bytes(toObj(mesh));
    const asItIs = await client.load(file, { name: 'fin.obj', strict: true });
    assert.equal((await asItIs.surface()).repaired, undefined);
    assert.equal((await client.load(file, { name: 'fin.obj' })).info.usable, true);
    const model = await client.load(file, { name: 'fin.obj', fix: { split: true } });
    const { repaired } = await model.surface();
    assert.equal(repaired.triangles.length, 3 * fin.length);
    assert.ok(repaired.vertexOrigin.length > mesh.vertices.length);
    assert.equal(repaired.vertexImage.length, mesh.vertices.length);
    repaired.triangles.forEach((m, c) => assert.equal(repaired.vertexOrigin[m], fin.flat()[c]));
    repaired.vertexImage.forEach((m, v) => assert.equal(repaired.vertexOrigin[m], v));
  }));

test('repairs are written into the file where that is asked for', () =>
  withClient(async (client) => {
    const { vertices, triangles } = cubeMesh(3);
    const turned = triangles.map((t, f) => (f % 9 === 2 ? [t[0], t[2], t[1]] : t));
    const file = bytes(toObj({ vertices, triangles: turned }));
    const model = await client.load(file, { name: 'turned.obj', writeRepairs: true });
    const map = await model.parametrize();
    const { report } = map;
    assert.equal(report.repairsWritten.facesTurned, turned.filter((_, f) => f % 9 === 2).length);
    const { files } = await map.write();
    const again = await client.load(files[0].bytes, { name: 'out.obj', strict: true });
    assert.equal((await again.verify()).certified, true);
  }));

test('the raw-array path gives the same map as the file', () =>
  withClient(async (client) => {
    const model = await client.load(disk(6), { name: 'disk.obj' });
    const fromFile = await model.parametrize({ boundary: 'convex' });
    const { positions, triangles } = fromFile;
    const fromArrays = await client.parametrizeMesh({ positions, triangles, boundary: 'convex' });
    assert.deepEqual(fromArrays.uv, fromFile.uv);
    const loaded = await client.loadMesh({ positions, triangles });
    const map = await loaded.parametrize({ boundary: 'convex' });
    assert.deepEqual(map.uv, fromFile.uv);
    assert.equal((await map.write()).name, 'mesh.obj');
  }));

test('every triangle as solved is positive, whatever repairs turned over or left out', () =>
  withClient(async (client) => {
    const { vertices, triangles } = blocks(ring);
    const positions = vertices.flat();
    const healthy = await client.parametrizeMesh({ positions, triangles: triangles.flat() });
    assert.deepEqual(healthy.solved.triangles, healthy.triangles);
    assert.deepEqual(healthy.solved.uvTriangles, healthy.cornerToUv);
    assert.deepEqual([...healthy.solved.origin], [...triangles.keys()]);
    const isTurned = (f) => f % 37 === 5;
    const given = [
      [4, 4, 9],
      ...triangles.map(([a, b, c], f) => (isTurned(f) ? [b, a, c] : [a, b, c])),
      [triangles[2][1], triangles[2][2], triangles[2][0]],
    ];
    const result = await client.parametrizeMesh({ positions, triangles: given.flat() });
    assert.equal(result.certificate.certified, true);
    assert.deepEqual([...result.triangles], given.flat());
    const { solved, uv, uvToVertex, cornerToUv } = result;
    assert.deepEqual(
      [...solved.origin],
      [...triangles.keys()].map((f) => f + 1),
    );
    triangles.forEach(([a, b, c], row) => {
      const rotations = [[a, b, c].join(), [b, c, a].join(), [c, a, b].join()];
      assert.ok(rotations.includes(solved.triangles.subarray(3 * row, 3 * row + 3).join()));
    });
    const area = (corners) => {
      const [a, b, c] = [...corners].map((n) => [uv[2 * n], uv[2 * n + 1]]);
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    solved.origin.forEach((f, row) => {
      const corners = solved.uvTriangles.subarray(3 * row, 3 * row + 3);
      assert.ok(area(corners) > 0, `row ${row}`);
      corners.forEach((n, k) => assert.equal(uvToVertex[n], solved.triangles[3 * row + k]));
      // In the given order of corners, a triangle that was turned over is negative.
      assert.equal(
        area(cornerToUv.subarray(3 * f, 3 * f + 3)) > 0,
        !isTurned(row),
        `triangle ${f}`,
      );
    });
  }));

test('a file that is no mesh is an HgpError with the code of the command line', () =>
  withClient(async (client) => {
    await assert.rejects(client.load(bytes('not a mesh'), { name: 'x.obj' }), (error) => {
      assert.ok(error instanceof HgpError);
      assert.match(error.code, /malformed|unsupported/);
      return true;
    });
    await client.load(disk(3), { name: 'disk.obj' }); // and the client goes on
  }));

test('cancel in the middle of a solve: AbortError, and the next call works', () =>
  withClient(async (client) => {
    const model = await client.load(disk(60), { name: 'disk.obj' });
    const controller = new AbortController();
    const seen = [];
    let isRejected = false;
    let isRejectedAtOnce;
    const onProgress = (progress) => {
      seen.push(progress);
      if (progress.iteration < 0 || controller.signal.aborted) return; // until the solver itself is at work
      controller.abort();
      setImmediate(() => (isRejectedAtOnce = isRejected));
    };
    const solving = model.parametrize({ q: 4 }, { signal: controller.signal, onProgress });
    solving.catch(() => (isRejected = true));
    await assert.rejects(solving, { name: 'AbortError' });
    await new Promise((done) => setTimeout(done));
    assert.equal(isRejectedAtOnce, true);
    const begin = performance.now();
    const last = seen.at(-1);
    assert.ok(last.iteration >= 0 && last.residual >= 0 && last.stage.length > 0);
    assert.ok(last.round >= 1 && last.maxRounds >= last.round);
    assert.deepEqual(await model.inspect(), model.info); // a fresh worker has the model again
    assert.ok(performance.now() - begin < 5000);
    const small = await client.load(disk(4), { name: 'disk.obj' });
    assert.equal((await small.parametrize({ boundary: 'convex' })).certificate.certified, true);
  }));

test('a worker that is killed in the middle of a solve: worker-lost, and the next call works', async () => {
  const workers = [];
  const createWorker = () => {
    workers.push(new Worker(path.join(built, 'node/worker.js'), { execArgv: [] }));
    return workers.at(-1);
  };
  await withClient(
    async (client) => {
      const model = await client.load(disk(60), { name: 'disk.obj' });
      let isKilled = false;
      const onProgress = ({ iteration }) => {
        if (iteration < 0 || isKilled) return;
        isKilled = true;
        void workers[0].terminate();
      };
      const lost = { code: 'worker-lost', message: /stopped unexpectedly \(exit code 1\)/ };
      await assert.rejects(model.parametrize({ q: 4 }, { onProgress }), lost);
      assert.deepEqual(await model.inspect(), model.info); // a fresh worker has the model again
      const { certificate } = await model.parametrize({ q: 4 });
      assert.deepEqual([certificate.certified, workers.length], [true, 2]);
    },
    { createWorker },
  );
});

test('progress goes through the stages, at most ten times a second', () =>
  withClient(async (client) => {
    const model = await client.load(disk(50), { name: 'disk.obj' });
    const times = [];
    const stages = new Set();
    const begin = performance.now();
    await model.parametrize(
      { q: 4 },
      {
        onProgress: ({ stage, fraction }) => {
          assert.ok(fraction >= 0 && fraction <= 1, `${fraction}`);
          stages.add(stage);
          times.push(performance.now());
        },
      },
    );
    assert.ok(stages.size >= 2, [...stages].join());
    assert.ok(times.length <= 2 + (performance.now() - begin) / 100, `${times.length} reports`);
  }));

test('ready starts a worker in advance, with the models', () =>
  withClient(async (client) => {
    const model = await client.load(disk(8), { name: 'disk.obj' });
    const controller = new AbortController();
    const solving = model.parametrize({ q: 4 }, { signal: controller.signal });
    controller.abort();
    await assert.rejects(solving, { name: 'AbortError' });
    await client.ready();
    assert.equal((await model.inspect()).usable, true);
    client.terminate();
    await client.ready();
    await assert.rejects(model.inspect(), { code: 'usage', message: /terminated/ });
  }));

test('terminate rejects what is pending', async () => {
  const client = await createClient();
  const loading = client.load(disk(60), { name: 'disk.obj' });
  await new Promise((resolve) => setTimeout(resolve, 5));
  client.terminate();
  await assert.rejects(loading, { name: 'AbortError' });
});

test('two clients at once do not mix', async () => {
  const [a, b] = await Promise.all([createClient(), createClient()]);
  const [ma, mb] = await Promise.all([
    a.load(disk(4), { name: 'a.obj' }),
    b.load(disk(9), { name: 'b.obj' }),
  ]);
  const [ra, rb] = await Promise.all([
    ma.parametrize({ boundary: 'convex' }),
    mb.parametrize({ boundary: 'convex' }),
  ]);
  assert.equal(ra.triangles.length, 3 * 6 * 16);
  assert.equal(rb.triangles.length, 3 * 6 * 81);
  a.terminate();
  b.terminate();
});

test('an idle client does not keep a script alive', () => {
  const script = `import { createClient } from ${JSON.stringify(path.join(built, 'node/index.js'))};
    await createClient(); console.log('done');`;
  const { stdout, status } = spawnSync('node', ['--input-type=module', '-e', script], {
    encoding: 'utf8',
    timeout: 20000,
  });
  assert.equal(status, 0);
  assert.equal(stdout, 'done\n');
});
