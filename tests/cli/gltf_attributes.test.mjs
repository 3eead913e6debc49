// What the triangles of a glTF have, quads and split triangles have as well: computed here a second time from what is known.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { Document, NodeIO } from '@gltf-transform/core';
import validator from 'gltf-validator';
import { sentenceOf } from '../support/notes.mjs';
import { colorOf, cross, cubeFaces, dot, facesWith, isClose, minus, normalOf, uvOf } from '../support/painted.mjs'; // prettier-ignore
import { inFolder } from '../support/program.mjs';

const { at, good } = inFolder('gltf-attributes');

const morphOf = ([x, y, z]) => [0.5 * x, 0.25 * y + 0.5 * z, -x];
/** Weights of joints 0 to 3, linear in the position: at most three of them on a face. */
const weightsOf = ([x, y]) => [(1 - x) / 2, x / 2, (1 - y) / 2, y / 2];

/** The joints and weights that count, filled with zeros. */
function bonesOf(p) {
  const used = weightsOf(p).map((w, joint) => [joint, w]).filter(([, w]) => w > 0); // prettier-ignore
  while (used.length < 4) used.push([0, 0]);
  return { joints: used.map(([joint]) => joint), weights: used.map(([, w]) => w) };
}

/** Triangles of cube face f in n × n squares. */
function faceOf(f, n) {
  const [corner, a, b] = cubeFaces[f];
  const points = [];
  for (let i = 0; i <= n; i++)
    for (let j = 0; j <= n; j++)
      points.push(corner.map((x, k) => Math.fround(x + (a[k] * i + b[k] * j) / n)));
  const id = (i, j) => i * (n + 1) + j;
  const triangles = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < n; j++)
      triangles.push([id(i, j), id(i + 1, j), id(i + 1, j + 1)], [id(i, j), id(i + 1, j + 1), id(i, j + 1)]); // prettier-ignore
  return { points, triangles };
}

/**
 * The cube with a material per three faces, each a primitive, with all that a glTF can have at its vertices, and another
 * mesh beside it.
 * @param kind  'float', or 'integers' where these may be normalized
 */
async function painted(name, n, kind) {
  const document = new Document();
  const buffer = document.createBuffer();
  const add = (type, rows, make = Float32Array, largest = 0) => {
    const accessor = document.createAccessor().setType(type).setBuffer(buffer);
    const numbers = rows.flat();
    return accessor
      .setNormalized(largest > 0)
      .setArray(make.from(numbers, (x) => (largest ? Math.round(x * largest) : x)));
  };
  const small = kind === 'integers' ? [Uint8Array, 255] : [Float32Array, 0];
  const short = kind === 'integers' ? [Uint16Array, 65535] : [Float32Array, 0];
  const mesh = document.createMesh('cube').setWeights([0.25]);
  for (const part of [0, 1]) {
    const [points, faces, triangles] = [[], [], []];
    for (const f of [0, 1, 2].map((k) => 3 * part + k)) {
      const face = faceOf(f, n);
      triangles.push(...face.triangles.map((t) => t.map((v) => v + points.length)));
      points.push(...face.points);
      faces.push(...face.points.map(() => f));
    }
    const primitive = document
      .createPrimitive()
      .setMaterial(document.createMaterial(`paint ${part}`))
      .setIndices(add('SCALAR', triangles, Uint16Array))
      .setAttribute('POSITION', add('VEC3', points))
      .setAttribute('NORMAL', add('VEC3', faces.map(normalOf)))
      .setAttribute(
        'TEXCOORD_0',
        add(
          'VEC2',
          points.map((p, v) => uvOf(faces[v], p)),
          ...short,
        ),
      )
      .setAttribute('COLOR_0', add('VEC3', points.map(colorOf), ...small))
      .setAttribute(
        'JOINTS_0',
        add(
          'VEC4',
          points.map((p) => bonesOf(p).joints),
          Uint8Array,
        ),
      )
      .setAttribute(
        'WEIGHTS_0',
        add(
          'VEC4',
          points.map((p) => bonesOf(p).weights),
          ...short,
        ),
      );
    primitive.addTarget(
      document.createPrimitiveTarget().setAttribute('POSITION', add('VEC3', points.map(morphOf))),
    );
    mesh.addPrimitive(primitive);
  }
  for (const accessor of document.getRoot().listAccessors())
    if (kind === 'integers' && accessor.getType() === 'VEC4' && accessor.getNormalized()) {
      const array = accessor.getArray(); // sums stay whole
      for (let v = 0; v < array.length; v += 4)
        array[v] += 65535 - array[v] - array[v + 1] - array[v + 2] - array[v + 3];
    }
  const joints = [0, 1, 2, 3].map((k) => document.createNode(`joint ${k}`));
  const skin = document.createSkin();
  for (const joint of joints) skin.addJoint(joint);
  const beside = document.createMesh('beside').addPrimitive(
    document
      .createPrimitive()
      .setIndices(add('SCALAR', [[0, 1, 2]], Uint16Array))
      .setAttribute('POSITION', add('VEC3', [[0, 0, 0], [1, 0, 0], [0, 1, 0]])), // prettier-ignore
  );
  const scene = document.createScene();
  scene.addChild(document.createNode('cube').setMesh(mesh).setSkin(skin));
  scene.addChild(document.createNode('beside').setMesh(beside).setTranslation([3, 0, 0]));
  const bones = document.createNode('bones');
  for (const joint of joints) bones.addChild(joint);
  scene.addChild(bones);
  writeFileSync(at(name), await new NodeIO().writeBinary(document));
}

async function isValid(name) {
  const { issues } = await validator.validateBytes(readFileSync(at(name)));
  const bad = issues.messages.filter(({ severity }) => severity < 2);
  assert.deepEqual(bad, [], name);
}

/** Checks everything that is known at every vertex of the cube's triangles; they are those, and nothing is missing. */
async function checkPainted(name, kind) {
  await isValid(name);
  const root = (await new NodeIO().readBinary(readFileSync(at(name)))).getRoot();
  const cube = root.listMeshes().find((m) => m.getName() === 'cube');
  const beside = root.listMeshes().find((m) => m.getName() === 'beside');
  assert.equal(beside.listPrimitives()[0].getAttribute('POSITION').getCount(), 3);
  assert.deepEqual(cube.getWeights(), [0.25]);
  const node = root.listNodes().find((n) => n.getMesh() === cube);
  assert.equal(node.getSkin().listJoints().length, 4);
  const e = kind === 'integers' ? { uv: 1e-5, color: 2 / 255, weight: 2e-5 } : { uv: 1e-6, color: 1e-6, weight: 1e-6 }; // prettier-ignore
  let count = 0;
  let area = 0;
  cube.listPrimitives().forEach((primitive, part) => {
    assert.equal(primitive.getMaterial().getName(), `paint ${part}`);
    const get = (attribute, v) => attribute.getElement(v, []);
    const [position, normal, uv, color, joints, weights] = ['POSITION', 'NORMAL', 'TEXCOORD_0', 'COLOR_0', 'JOINTS_0', 'WEIGHTS_0'].map((s) => primitive.getAttribute(s)); // prettier-ignore
    const moved = primitive.listTargets()[0].getAttribute('POSITION');
    const index = primitive.getIndices().getArray();
    for (let i = 0; i < index.length; i += 3) {
      const corners = [0, 1, 2].map((k) => get(position, index[i + k]));
      const common = facesWith(corners, 1e-6).filter((f) => Math.floor(f / 3) === part);
      if (common.length !== 1) continue; // across an edge of the cube
      count++;
      const [f] = common;
      const axis = normalOf(f).findIndex((x) => x !== 0);
      const [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
      const [a, b, c] = corners;
      area += Math.abs((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
      corners.forEach((p, corner) => {
        const v = index[i + corner];
        assert.ok(
          isClose(get(normal, v), normalOf(f), 1e-6),
          `normal ${get(normal, v)} of ${f} at ${p}: ${JSON.stringify(corners)} part ${part}`,
        );
        assert.ok(isClose(get(uv, v), uvOf(f, p), e.uv), `uv ${get(uv, v)} at ${p} of ${f}`);
        assert.ok(isClose(get(color, v), colorOf(p), e.color));
        assert.ok(isClose(get(moved, v), morphOf(p), 1e-6));
        const of = [0, 0, 0, 0];
        get(joints, v).forEach((joint, n) => (of[joint] += get(weights, v)[n]));
        assert.ok(isClose(of, weightsOf(p), e.weight), `weights ${of} at ${p}`);
        assert.ok(Math.abs(dot(of, [1, 1, 1, 1]) - 1) < 1e-6);
      });
    }
  });
  return { count, area };
}

for (const kind of ['float', 'integers']) {
  test(`quads of a skinned glTF with morphs and two materials keep them all: ${kind}`, async () => {
    await painted('cube.glb', 6, kind);
    await isValid('cube.glb');
    good('quads', 'cube.glb', '--mesh', '0', '--creases', '--cells', '150', '-o', 'quads.glb');
    const { count, area } = await checkPainted('quads.glb', kind);
    assert.ok(count >= 200);
    assert.ok(Math.abs(area - 6) < 1e-5, `area ${area}`);
    good('quads', 'cube.glb', '--mesh', '0', '--cells', '200', '-o', 'loose.glb');
    await isValid('loose.glb');
  });
}

test('corners of quads have what their own primitive has there; those that are not on it are counted', async () => {
  await painted('cube.glb', 6, 'float');
  const { err } = good('quads', 'cube.glb', '--mesh', '0', '--cells', '200', '-o', 'loose.glb');
  const root = (await new NodeIO().readBinary(readFileSync(at('loose.glb')))).getRoot();
  const cube = root.listMeshes().find((m) => m.getName() === 'cube');
  let elsewhere = 0;
  cube.listPrimitives().forEach((primitive, part) => {
    const [position, uv] = ['POSITION', 'TEXCOORD_0'].map((s) => primitive.getAttribute(s));
    const index = primitive.getIndices().getArray();
    for (let i = 0; i < index.length; i += 6)
      for (const v of [0, 1, 2, 5].map((k) => index[i + k])) {
        const p = position.getElement(v, []);
        const own = facesWith([p], 1e-6).filter((f) => Math.floor(f / 3) === part);
        elsewhere += own.length === 0;
        assert.ok(own.length === 0 || own.some((f) => isClose(uv.getElement(v, []), uvOf(f, p), 1e-5))); // prettier-ignore
      }
  });
  assert.ok(elsewhere > 0);
  const note = err.split('\n').find((line) => sentenceOf('quads-nearest').test(line));
  assert.equal(Number(/\d+/.exec(note)[0]), elsewhere);
});

test('quads of one material in two primitives have what the surface has everywhere', async () => {
  await painted('cube.glb', 6, 'float');
  const io = new NodeIO();
  const document = await io.readBinary(readFileSync(at('cube.glb')));
  const primitives = document.getRoot().listMeshes()[0].listPrimitives();
  primitives[1].setMaterial(primitives[0].getMaterial());
  writeFileSync(at('one.glb'), await io.writeBinary(document));
  const { err } = good('quads', 'one.glb', '--mesh', '0', '--cells', '200', '-o', 'one-quads.glb');
  assert.doesNotMatch(err, sentenceOf('quads-nearest'));
  await isValid('one-quads.glb');
  const root = (await io.readBinary(readFileSync(at('one-quads.glb')))).getRoot();
  for (const primitive of root.listMeshes()[0].listPrimitives()) {
    const [position, uv] = ['POSITION', 'TEXCOORD_0'].map((s) => primitive.getAttribute(s));
    for (const v of primitive.getIndices().getArray()) {
      const p = position.getElement(v, []);
      assert.ok(facesWith([p], 1e-6).some((f) => isClose(uv.getElement(v, []), uvOf(f, p), 1e-5)));
    }
  }
});

test('images beside a .gltf are taken into the GLB of its quads', async () => {
  await painted('cube.glb', 6, 'float');
  const io = new NodeIO();
  const document = await io.readBinary(readFileSync(at('cube.glb')));
  const picture = Buffer.from('\x89PNG a picture', 'latin1');
  const texture = document.createTexture('wood').setURI('wood.png').setMimeType('image/png').setImage(picture); // prettier-ignore
  document.getRoot().listMaterials()[0].setBaseColorTexture(texture);
  await io.write(at('cube.gltf'), document);
  const { err } = good('quads', 'cube.gltf', '--mesh', '0', '--creases', '--cells', '150', '-o', 'wood.glb'); // prettier-ignore
  assert.doesNotMatch(err, sentenceOf('read-file-refused'));
  assert.doesNotMatch(err, sentenceOf('write-keep-beside'));
  const [image] = (await io.read(at('wood.glb'))).getRoot().listTextures();
  assert.deepEqual(Buffer.from(image.getImage()), picture);
});

/** Prisms over a triangle, whose ends are one triangle each between three creases: the edges of these are split. */
async function paintedPrism(name, isShared) {
  const document = new Document();
  const buffer = document.createBuffer();
  const add = (type, rows, make = Float32Array) =>
    document.createAccessor().setType(type).setBuffer(buffer).setArray(make.from(rows.flat()));
  const base = [[0, 0], [1, 0], [0.25, 0.75]]; // prettier-ignore
  const quads = base.map((p, i) => [p, base[(i + 1) % 3]]);
  const parts = [[], []]; // the ends, the sides
  parts[0].push([base[0], base[2], base[1]].map((p) => [...p, 0]));
  parts[0].push(base.map((p) => [...p, 2]));
  for (const [p, q] of quads) {
    parts[1].push([[...p, 0], [...q, 0], [...q, 2]]); // prettier-ignore
    parts[1].push([[...p, 0], [...q, 2], [...p, 2]]); // prettier-ignore
  }
  const mesh = document.createMesh('prism');
  const accessorsOf = (points, part) => ({
    POSITION: add('VEC3', points),
    TEXCOORD_0: add(
      'VEC2',
      points.map((p, v) => prismUv(part[v], p)),
    ),
    COLOR_0: add(
      'VEC3',
      points.map((p) => p.map((x) => x / 2)),
    ),
    JOINTS_0: add(
      'VEC4',
      points.map(([, , z]) => (z ? [1, 0, 0, 0] : [0, 0, 0, 0])),
      Uint16Array,
    ),
    WEIGHTS_0: add(
      'VEC4',
      points.map(() => [1, 0, 0, 0]),
    ),
  });
  const all = isShared ? accessorsOf(parts.flat(2), parts.flatMap((list, k) => list.flat().map(() => k))) : null; // prettier-ignore
  let first = 0;
  parts.forEach((list, part) => {
    const points = list.flat();
    const primitive = document.createPrimitive().setMaterial(document.createMaterial(`part ${part}`)); // prettier-ignore
    const attributes =
      all ??
      accessorsOf(
        points,
        points.map(() => part),
      );
    for (const [semantic, accessor] of Object.entries(attributes))
      primitive.setAttribute(semantic, accessor);
    primitive.setIndices(
      add(
        'SCALAR',
        points.map((_, v) => v + first),
        Uint16Array,
      ),
    );
    if (isShared) first += points.length;
    mesh.addPrimitive(primitive);
  });
  const root = document.createNode('root');
  const skin = document.createSkin();
  for (const k of [0, 1]) {
    const joint = document.createNode(`joint ${k}`);
    root.addChild(joint);
    skin.addJoint(joint);
  }
  const scene = document.createScene().addChild(root);
  scene.addChild(document.createNode('prism').setMesh(mesh).setSkin(skin));
  writeFileSync(at(name), await new NodeIO().writeBinary(document));
}
const prismUv = (part, [x, y, z]) => (part ? [x + 2 * y, z - x] : [y, 4 + x]);

for (const isShared of [false, true]) {
  test(`edges split for features keep a glTF's attributes, vertices ${isShared ? 'shared' : 'apart'}`, async () => {
    await paintedPrism('prism.glb', isShared);
    await isValid('prism.glb');
    const { err } = good(
      'param',
      'prism.glb',
      '--creases',
      '-o',
      'split.glb',
      '--json',
      'split.json',
    );
    const notes = JSON.stringify(JSON.parse(readFileSync(at('split.json'), 'utf8')));
    assert.match(notes, /features-split/, err);
    assert.doesNotMatch(notes, /split-as-polygons/);
    await isValid('split.glb');
    const root = (await new NodeIO().readBinary(readFileSync(at('split.glb')))).getRoot();
    const [mesh] = root.listMeshes();
    assert.equal(
      root
        .listNodes()
        .find((n) => n.getMesh())
        .getSkin()
        .listJoints().length,
      2,
    );
    let area = 0;
    let between = 0;
    mesh.listPrimitives().forEach((primitive, part) => {
      assert.equal(primitive.getMaterial().getName(), `part ${part}`);
      const get = (semantic, v) => primitive.getAttribute(semantic).getElement(v, []);
      const index = primitive.getIndices().getArray();
      for (const v of index) {
        const p = get('POSITION', v);
        assert.ok(isClose(get('TEXCOORD_0', v), prismUv(part, p), 1e-6));
        assert.ok(isClose(get('COLOR_0', v), p.map((x) => x / 2), 1e-6)); // prettier-ignore
        const upper = get('JOINTS_0', v).reduce((sum, joint, k) => sum + joint * get('WEIGHTS_0', v)[k], 0); // prettier-ignore
        assert.ok(Math.abs(upper - p[2] / 2) < 1e-6, `${upper} at ${p}`);
        between += ![0, 0.25, 1].includes(p[0]) ? 1 : 0;
      }
      for (let i = 0; i < index.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => get('POSITION', index[i + k]));
        const n = cross(minus(b, a), minus(c, a));
        area += Math.sqrt(dot(n, n)) / 2;
      }
    });
    assert.ok(between > 0);
    const rim = 1 + Math.hypot(0.75, 0.75) + Math.hypot(0.25, 0.75); // prettier-ignore
    assert.ok(Math.abs(area - (0.75 + 2 * rim)) < 1e-5, `area ${area}`);
    good('verify', 'split.glb');
  });
}
