import assert from 'node:assert/strict';
import test from 'node:test';
import { nameOf, packed, writeOptionsFor } from '../../../web/src/formats/exports.ts';
import { filesOfDrop, filesOfInput, findMissing, safeName, unpack } from '../../../web/src/formats/file_set.ts'; // prettier-ignore
import { gltfOf, relativeName, splitGlb } from '../../../web/src/formats/glb.ts';
import { cubeMesh, toGlb } from '../../support/meshes.mjs';

const bytes = (text) => new TextEncoder().encode(text);
const gltf = (json) => bytes(JSON.stringify(json));

test('a file name must be relative, inside the folder and decoded once', () => {
  assert.equal(relativeName('./a%20b/c.bin'), 'a b/c.bin');
  assert.equal(relativeName('%2525.bin'), '%25.bin');
  const refused = [
    '../a',
    'a/../../b',
    '/a',
    '\\a',
    'a\\b',
    'http://x/a',
    'file:a',
    'C:a',
    '%2e%2e/a',
    '%00',
    '%',
  ];
  for (const uri of refused) assert.equal(relativeName(uri), undefined, uri);
});

test('a download has a harmless name', () => {
  assert.equal(safeName('a/b c.glb'), 'b_c.glb');
  assert.equal(safeName('..'), 'model');
  assert.equal(safeName(`${'x'.repeat(100)}.obj`).length, 80);
});

test('a download has the type of its name; one file is saved as it is, several and a .gltf as a ZIP', async () => {
  const types = { 'a.glb': 'model/gltf-binary', 'b.c.obj': 'text/plain', 'D.SVG': 'image/svg+xml', 'e.json': 'application/json', 'f.flat.Zip': 'application/zip', 'g.ply': 'application/octet-stream', glb: 'model/gltf-binary', 'h.': 'application/octet-stream' }; // prettier-ignore
  const own = bytes('own');
  const zipped = bytes('zipped');
  const zip = async (files) => (assert.ok(files.length > 0), zipped);
  for (const [name, type] of Object.entries(types))
    assert.deepEqual(await packed(name, [{ name, bytes: own }], zip), { name, bytes: own, type });
  const named = (files, hasGrid = false) => ({ model: { main: 'x/the mesh.GLTF' }, solution: { files, output: { hasGrid } } }); // prettier-ignore
  for (const [files, isZip] of [
    [['a.glb'], false],
    [['a.GLTF'], true],
    [['a.obj', 'a.mtl'], true],
    [['a.glb', 'b.png'], true],
  ]) {
    const all = files.map((name) => ({ name, bytes: own }));
    assert.equal((await packed('a', all, zip)).bytes, isZip ? zipped : own, `${files}`);
    assert.equal(nameOf(named(all), 'same'), isZip ? 'the_mesh.zip' : files[0]);
  }
  const asked = { glb: 'glb', zip: 'gltf', obj: 'obj', flat: 'flat-obj', svg: 'svg' };
  const endings = { ...asked, flat: 'flat.obj' };
  for (const [format, word] of Object.entries(asked))
    for (const hasGrid of [false, true])
      assert.deepEqual(writeOptionsFor({ ...named([], hasGrid), tiles: 7 }, format), { format: word, name: `the_mesh.${endings[format]}`, gridMaterial: hasGrid && 7 }); // prettier-ignore
  for (const [format, plain, withGrid = plain] of [
    ['glb', 'the_mesh.glb'],
    ['zip', 'the_mesh.zip'],
    ['obj', 'the_mesh.obj', 'the_mesh.zip'],
    ['flat', 'the_mesh.flat.obj'],
    ['cones', 'the_mesh.cones.json'],
    ['report', 'the_mesh.report.json'],
    ['svg', 'the_mesh.svg'],
  ])
    assert.deepEqual([nameOf(named([]), format), nameOf(named([], true), format)], [plain, withGrid]); // prettier-ignore
});

test('missing files that a glTF names are listed, and matched by name where folders are lost', async () => {
  const json = {
    buffers: [{ uri: 'geo/a.bin' }, { uri: 'b.bin' }, { uri: 'data:,' }, {}],
    images: [{ uri: 'c.png' }, { uri: '../d.png' }],
  };
  const files = new Map([
    ['m/x.gltf', gltf(json)],
    ['elsewhere/a.bin', bytes('a')],
  ]);
  const { missing, refused } = await findMissing(files, 'm/x.gltf');
  assert.deepEqual(missing, [
    { name: 'b.bin', isNeeded: true },
    { name: 'c.png', isNeeded: false },
  ]);
  assert.deepEqual(refused, ['../d.png']);
  assert.deepEqual(files.get('geo/a.bin'), bytes('a'));
});

test('of files that have the same name, that beside the document counts, wherever it lies and in whichever order they come', async () => {
  for (const folder of ['', 'x/', 'x/y/', 'xy/'])
    for (const uri of ['b.bin', 'sub/b.bin', './b.bin'])
      for (const isFirst of [false, true]) {
        const name = uri.replace('./', '');
        const own = [`${folder}${name}`, bytes('own')];
        const others = ['z/b.bin', 'x/z/b.bin', 'y/sub/b.bin'].map((one) => [one, bytes(one)]);
        const all = isFirst ? [own, ...others] : [...others, own];
        const main = `${folder}a.gltf`;
        const files = new Map([[main, gltf({ buffers: [{ uri }] })], ...all]);
        assert.deepEqual(await findMissing(files, main), { missing: [], refused: [] });
        assert.equal(files.get(name), own[1], `${uri} of ${main}`);
      }
  // Elsewhere it is found by its last name alone, and by no part of that.
  const files = new Map([['a.gltf', gltf({ buffers: [{ uri: 'b.bin' }, { uri: 'c/d.bin' }] })], ['e/ab.bin', bytes('x')], ['e/d.bin', bytes('d')]]); // prettier-ignore
  const { missing } = await findMissing(files, 'a.gltf');
  assert.deepEqual([missing, files.get('c/d.bin')], [[{ name: 'b.bin', isNeeded: true }], files.get('e/d.bin')]); // prettier-ignore
});

test('a document that is named otherwise asks for its files all the same; an OBJ has none', async () => {
  const json = new TextDecoder().decode(gltf({ buffers: [{ uri: 'b.bin' }] }));
  for (const [text, names] of [
    [json, ['b.bin']],
    [`\ufeff \n${json}`, ['b.bin']],
    [json.replace('{', '{"Title":"",'), ['b.bin']], // one letter is where a GLB has it
    ['v 0 0 0\n', []],
  ]) {
    const { missing } = await findMissing(new Map([['x.obj', bytes(text)]]), 'x.obj');
    assert.deepEqual(missing.map(({ name }) => name), names); // prettier-ignore
  }
});

test('a file that is not a glTF yields no JSON; the solver gives the reason', async () => {
  for (const [name, text] of [
    ['x.glb', ''],
    ['x.glb', 'glTF and then nothing of use to anybody'],
    ['x.gltf', '{'],
    ['x.gltf', ''],
    ['x.gltf', 'null'],
    ['x.gltf', '[1]'],
  ]) {
    assert.deepEqual(await gltfOf(new Map([[name, bytes(text)]]), name), {}, text);
  }
});

test('a common top folder and system files are removed', async () => {
  const names = ['top/a.obj', 'top/b/c.mtl', '__MACOSX/top/._a.obj', 'top/.DS_Store'];
  const found = await unpack(new Map(names.map((name) => [name, bytes('')])));
  assert.deepEqual([...found.keys()], ['a.obj', 'b/c.mtl']);
});

test('lists of a glTF with arbitrary contents: nothing is reported missing, nothing throws', async () => {
  for (const json of [
    { buffers: [null] },
    { images: [null, 3, 'x', []] },
    { buffers: 'x', images: {} },
    { buffers: [{ uri: 3 }] },
    { meshes: [null], nodes: [null, 3, { mesh: 0, children: [0, 'a'], matrix: ['x'], skin: 9 }] },
    {
      meshes: [{}],
      nodes: [{ mesh: 0, extensions: { EXT_mesh_gpu_instancing: null } }],
      skins: null,
    },
  ]) {
    const files = new Map([['x.gltf', gltf(json)]]);
    const text = JSON.stringify(json);
    assert.deepEqual(await findMissing(files, 'x.gltf'), { missing: [], refused: [] }, text);
  }
});

test('a GLB is split into its chunks; a truncated one is refused', () => {
  const glb = new Uint8Array(toGlb([cubeMesh(1)]));
  const { json, bin, rest } = splitGlb(glb);
  const { asset, buffers } = JSON.parse(String.fromCharCode(...json));
  assert.equal(asset.version, '2.0');
  assert.ok(bin.length >= buffers[0].byteLength && bin.length < buffers[0].byteLength + 4);
  assert.equal(rest.length, 0);
  for (const length of [0, 10, 19, 22]) assert.equal(splitGlb(glb.subarray(0, length)), undefined);
});

test('wherever a GLB ends, its chunks are what is there of them; it needs a whole one of JSON, which may be empty', () => {
  const chunk = (of, type) => {
    const head = new Uint8Array(8);
    new DataView(head.buffer).setUint32(0, of.length, true);
    head.set(bytes(type), 4);
    return [...head, ...of];
  };
  const filled = (length, value) => new Array(length).fill(value);
  for (const json of [0, 4, 12]) {
    for (const bin of [0, 8]) {
      for (const rest of [0, 4]) {
        const others = rest > 0 ? chunk(filled(rest, 9), 'MORE') : [];
        const all = Uint8Array.from([...bytes('glTF'), ...filled(8, 0), ...chunk(filled(json, 7), 'JSON'), ...chunk(filled(bin, 8), 'BIN\0'), ...others]); // prettier-ignore
        for (let length = 0; length <= all.length; length++) {
          const found = splitGlb(all.subarray(0, length));
          assert.equal(found !== undefined, length >= 20 + json, `${length} of ${all.length}`);
          if (!found) continue;
          const isThere = length >= 28 + json; // the head of the second chunk
          const part = (from, to) => (isThere ? [...all.subarray(from, Math.min(to, length))] : []);
          const end = 28 + json + bin;
          assert.deepEqual([found.json, found.bin, found.rest].map((one) => [...one]), [filled(json, 7), part(28 + json, end), part(end, Infinity)]); // prettier-ignore
        }
      }
    }
  }
  assert.equal(splitGlb(new Uint8Array(64)), undefined, 'it is none');
});

test('of a large GLB on disk only the head is read for its JSON', async () => {
  const glb = toGlb([cubeMesh(40)]);
  let most = 0;
  class Watched extends Blob {
    slice(from, to) {
      const part = super.slice(from, to);
      most = Math.max(most, part.size);
      return part;
    }
    arrayBuffer() {
      throw new Error('all of it is read');
    }
  }
  const json = await gltfOf(new Map([['cube.glb', new Watched([glb])]]), 'cube.glb');
  assert.equal(json.meshes.length, 1);
  assert.ok(most < 3000 && glb.length > 100_000, `${most} of ${glb.length}`);
  for (const length of [0, 12, 19, 30]) {
    const cut = new Blob([glb.subarray(0, length)]);
    assert.deepEqual(await gltfOf(new Map([['cube.glb', cut]]), 'cube.glb'), {});
  }
});

test('of a GLB the JSON is read and no byte behind it, of another document all; of each only once', async () => {
  let read = [];
  class Counted extends Blob {
    slice(...range) {
      return new Counted([super.slice(...range)]);
    }
    async arrayBuffer() {
      read.push(this.size);
      return super.arrayBuffer();
    }
  }
  const chunk = (type, content) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(content.length);
    head.write(type, 4, 'latin1');
    return Buffer.concat([head, content]);
  };
  for (const length of [60, 64, 1000, 20_000])
    for (const behind of [0, 4, 30_000]) {
      const json = Buffer.from(JSON.stringify({ extras: 'x'.repeat(length - 13) }));
      assert.equal(json.length, length);
      const parts = [Buffer.from('glTF\x02\0\0\0----'), chunk('JSON', json), ...(behind ? [chunk('BIN\0', Buffer.alloc(behind))] : [])]; // prettier-ignore
      for (const [content, all] of [
        [parts, 20 + length],
        [[json], length],
      ]) {
        const files = new Map([['a', new Counted(content)]]);
        read = [];
        const found = await gltfOf(files, 'a');
        assert.equal(found.extras?.length, length - 13);
        assert.deepEqual(read, [Math.min(64, files.get('a').size), all]);
        assert.equal(await gltfOf(files, 'a'), found);
        assert.equal(read.length, 2, 'not again');
      }
    }
});

/** Entries of a drop as browsers give them: a folder answers in parts, and with none at its end. */
const fileEntry = (name) => ({ fullPath: name, isDirectory: false, file: (done) => done({ name: name.replace(/^.*\//, ''), of: name }) }); // prettier-ignore
const folderEntry = (name, parts) => ({
  ...{ fullPath: name, isDirectory: true },
  createReader: () => {
    const left = [...parts, []];
    return { readEntries: (done) => done(left.shift() ?? assert.fail('asked after the end')) };
  },
});
const dropOf = (entries) => ({
  items: entries.map((entry) => ({ webkitGetAsEntry: () => entry })),
  files: entries.filter((one) => !one?.isDirectory).map((one) => ({ name: one.fullPath.slice(1) })),
});

test('of dropped folders every file is taken, with its path, in however many parts a browser lists them', async () => {
  const all = Array.from({ length: 7 }, (_, i) => fileEntry(`/a/${i}.obj`));
  for (const sizes of [[], [7], [1, 6], [1, 1, 1, 1, 1, 1, 1], [2, 5]]) {
    // prettier-ignore
    let at = 0;
    const parts = sizes.map((size) => all.slice(at, (at += size)));
    const inner = folderEntry('/a/b', [[fileEntry('/a/b/x.png')], [folderEntry('/a/b/c', [])]]);
    const found = await filesOfDrop(dropOf([folderEntry('/a', [...parts, [inner]]), fileEntry('/m.obj')])); // prettier-ignore
    const expected = [...all.slice(0, at).map(({ fullPath }) => fullPath.slice(1)), 'a/b/x.png', 'm.obj']; // prettier-ignore
    assert.deepEqual([...found.keys()].sort(), expected.sort());
    for (const [name, file] of found) assert.equal(file.of, `/${name}`);
  }
  const plain = await filesOfDrop(dropOf([fileEntry('/m.obj'), fileEntry('/m.mtl')]));
  assert.deepEqual([...plain.keys()], ['m.obj', 'm.mtl']);
  const chosen = [{ name: 'm.obj', webkitRelativePath: 'a/m.obj' }, { name: 'n.obj', webkitRelativePath: '' }]; // prettier-ignore
  assert.deepEqual([...filesOfInput(chosen).keys()], ['a/m.obj', 'n.obj']);
});
