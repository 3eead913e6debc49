// The law of the patch writer: everything but the new uv set is the same.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import validator from 'gltf-validator';
import { rawElements, rawMembers } from './container.mjs';
import { readIndependently } from './independent.mjs';

/** Corners of a primitive, three per triangle; strips lose the triangles that only join pieces. */
function corners(primitive) {
  const count = primitive.getAttribute('POSITION').getCount();
  const indices =
    primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: count }, (_, i) => i);
  const mode = primitive.getMode();
  if (mode === 4) return indices;
  const out = [];
  for (let i = 0; i + 2 < indices.length; i += 1) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    const triangle = mode === 6 ? [b, c, indices[0]] : i % 2 === 0 ? [a, b, c] : [a, c, b];
    if (new Set(triangle).size === 3) out.push(...triangle);
  }
  return out;
}

/** One value per corner, bit for bit. */
function atCorners(accessor, list) {
  const size = accessor.getElementSize();
  const array = accessor.getArray();
  const out = new array.constructor(list.length * size);
  for (let i = 0; i < list.length; i += 1) {
    for (let k = 0; k < size; k += 1) out[i * size + k] = array[list[i] * size + k];
  }
  return new Uint8Array(out.buffer);
}

const sameBytes = (a, b, message) => assert.equal(Buffer.compare(a, b), 0, message);
const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
const isTriangles = (primitive) =>
  primitive.getMode() >= 4 && primitive.getAttribute('POSITION') !== null;

/** Tangents go when the uv of their normal map are replaced. */
function comparePrimitive(before, after, allowed, where) {
  const ignored = new Set([...allowed.newSets, ...(allowed.lostTangents ? ['TANGENT'] : [])]);
  const names = (list) => list.filter((name) => !ignored.has(name)).sort();
  assert.deepEqual(names(before.listSemantics()), names(after.listSemantics()), where);
  if (!isTriangles(before)) {
    for (const name of before.listSemantics()) {
      sameBytes(
        bytesOf(before.getAttribute(name).getArray()),
        bytesOf(after.getAttribute(name).getArray()),
        `${where} ${name}`,
      );
    }
    return null;
  }
  const [from, to] = [corners(before), corners(after)];
  assert.equal(from.length, to.length, `${where}: corners`);
  const compare = (a, b, name) => {
    assert.equal(a.getNormalized(), b.getNormalized(), `${where} ${name}`);
    assert.equal(a.getComponentType(), b.getComponentType(), `${where} ${name}`);
    sameBytes(atCorners(a, from), atCorners(b, to), `${where} ${name}`);
  };
  for (const name of names(before.listSemantics())) {
    compare(before.getAttribute(name), after.getAttribute(name), name);
  }
  const targets = before.listTargets();
  assert.equal(targets.length, after.listTargets().length, where);
  targets.forEach((target, index) => {
    for (const name of names(target.listSemantics())) {
      const other = after.listTargets()[index].getAttribute(name);
      compare(target.getAttribute(name), other, `target ${index} ${name}`);
    }
  });
  // The copies come behind: old vertices keep their numbers and all their data.
  const old = before.getAttribute('POSITION');
  const now = after.getAttribute('POSITION').getArray();
  sameBytes(bytesOf(old.getArray()), bytesOf(now.slice(0, old.getArray().length)), where);
  return to;
}

function compareDocuments(before, after, target, allowed, expectedUv) {
  const [a, b] = [before.getRoot(), after.getRoot()];
  const arrays = (root) => [
    ...root
      .listAnimations()
      .flatMap((animation) =>
        animation
          .listSamplers()
          .flatMap((s) => [s.getInput().getArray(), s.getOutput().getArray()]),
      ),
    ...root.listSkins().flatMap((skin) => skin.getInverseBindMatrices()?.getArray() ?? []),
    ...root.listTextures().map((texture) => texture.getImage() ?? new Uint8Array()),
  ];
  const [oldArrays, newArrays] = [arrays(a), arrays(b)];
  assert.equal(oldArrays.length, newArrays.length);
  oldArrays.forEach((array, i) => sameBytes(bytesOf(array), bytesOf(newArrays[i]), 'array'));
  a.listMeshes().forEach((mesh, m) => {
    const other = b.listMeshes()[m];
    const isTarget = m === target;
    let at = 0;
    mesh.listPrimitives().forEach((primitive, p) => {
      const where = `mesh ${m} primitive ${p}`;
      const now = other.listPrimitives()[p];
      const none = { newSets: [], lostTangents: false };
      const list = comparePrimitive(primitive, now, isTarget ? allowed : none, where);
      if (!isTarget || list === null || !expectedUv) return;
      const whole = list.slice(0, Math.floor(list.length / 3) * 3);
      const uv = atCorners(now.getAttribute(`TEXCOORD_${allowed.set}`), whole);
      const expected = expectedUv.subarray(at, at + uv.length);
      at += uv.length;
      sameBytes(uv, expected, `${where} TEXCOORD_${allowed.set}`);
    });
    if (isTarget && expectedUv) assert.equal(at, expectedUv.length, 'uv of every triangle');
  });
}

/** Everything in the text that the patch has no business with is spelled as it was. */
function compareTexts(before, after, target, allowed) {
  const [a, b] = [rawMembers(before.text), rawMembers(after.text)];
  const lists = ['accessors', 'bufferViews', 'buffers', 'meshes'];
  const names = ['extensionsUsed', 'extensionsRequired'];
  for (const [key, raw] of a) {
    if (!lists.includes(key) && !names.includes(key)) assert.equal(b.get(key), raw, key);
  }
  for (const key of b.keys()) assert.ok(a.has(key) || lists.includes(key), `new member ${key}`);
  for (const key of names) {
    const lost = (before.json[key] ?? []).filter((name) => !(after.json[key] ?? []).includes(name));
    assert.ok(
      lost.every((name) => allowed.lostExtensions.includes(name)),
      `${key} lost ${lost}`,
    );
  }
  const meshes = [rawElements(a.get('meshes')), rawElements(b.get('meshes'))];
  meshes[0].forEach((raw, m) => m === target || assert.equal(meshes[1][m], raw, `mesh ${m}`));
  compareMesh(meshes[0][target], meshes[1][target], allowed);

  // Accessors that anybody but the patched primitives reads must not change at all.
  const own = new Set();
  const others = new Set();
  before.json.meshes.forEach((mesh, m) =>
    mesh.primitives.forEach((primitive) => {
      const isOwn = m === target && (primitive.mode ?? 4) >= 4;
      const used = [
        primitive,
        ...(primitive.targets ?? []).map((t) => ({ attributes: t })),
      ].flatMap(({ attributes, indices }) => [...Object.values(attributes), indices]);
      for (const accessor of used) (isOwn ? own : others).add(accessor);
    }),
  );
  const manifold = before.json.meshes[target].extensions?.EXT_mesh_manifold;
  for (const used of [
    manifold?.mergeIndices,
    manifold?.mergeValues,
    manifold?.manifoldPrimitive.indices,
  ]) {
    own.add(used);
  }
  const changing = ['bufferView', 'byteOffset', 'count', 'sparse', 'componentType', 'min', 'max'];
  const accessors = [rawElements(a.get('accessors')), rawElements(b.get('accessors'))];
  accessors[0].forEach((raw, i) => {
    if (accessors[1][i] === raw) return;
    assert.ok(own.has(i) && !others.has(i), `accessor ${i} is not the patch's to change`);
    const [old, now] = [rawMembers(raw), rawMembers(accessors[1][i])];
    for (const [key, value] of old) {
      if (!changing.includes(key)) assert.equal(now.get(key), value, `accessor ${i} ${key}`);
    }
  });
  const views = [rawElements(a.get('bufferViews')), rawElements(b.get('bufferViews'))];
  const readers = new Map();
  accessors[0].forEach((raw, i) => {
    const { bufferView, sparse } = JSON.parse(raw);
    for (const view of [bufferView, sparse?.indices.bufferView, sparse?.values.bufferView]) {
      readers.set(view, [...(readers.get(view) ?? []), i]);
    }
  });
  const images = new Set((before.json.images ?? []).map((image) => image.bufferView));
  views[0].forEach((raw, v) => {
    if (views[1][v] === raw) return;
    assert.ok(!images.has(v), `view ${v} holds an image`);
    for (const accessor of readers.get(v) ?? []) {
      assert.ok(own.has(accessor) && !others.has(accessor), `view ${v} is still read`);
    }
  });
  const buffers = [rawElements(a.get('buffers')), rawElements(b.get('buffers'))];
  buffers[0].forEach((raw, i) => {
    const [old, now] = [rawMembers(raw), rawMembers(buffers[1][i])];
    for (const [key, value] of old) if (key !== 'byteLength') assert.equal(now.get(key), value);
  });
  assert.deepEqual(before.others, after.others, 'other chunks');
}

function compareMesh(before, after, allowed) {
  const [a, b] = [rawMembers(before), rawMembers(after)];
  for (const [key, raw] of a) {
    if (key === 'primitives' || key === 'extensions') continue;
    if (key !== 'extras') assert.equal(b.get(key), raw, `mesh ${key}`);
    else if (raw.startsWith('{')) {
      const now = rawMembers(b.get(key));
      for (const [name, value] of rawMembers(raw)) {
        if (name !== 'hgp') assert.equal(now.get(name), value, `extras ${name}`);
      }
    } else assert.equal(b.get(key), raw);
  }
  const primitives = [rawElements(a.get('primitives')), rawElements(b.get('primitives'))];
  assert.equal(primitives[0].length, primitives[1].length);
  primitives[0].forEach((raw, p) => {
    const [old, now] = [rawMembers(raw), rawMembers(primitives[1][p])];
    for (const [key, value] of old) {
      if (['attributes', 'indices', 'targets', 'mode'].includes(key)) continue;
      if (key !== 'extensions') assert.equal(now.get(key), value, `primitive ${p} ${key}`);
      else {
        const kept = now.has(key) ? rawMembers(now.get(key)) : new Map();
        for (const [name, extension] of rawMembers(value)) {
          if (!allowed.lostExtensions.includes(name)) assert.equal(kept.get(name), extension);
        }
      }
    }
  });
}

/** Issues by code, errors and warnings only. */
async function issues(file, bytes) {
  // The validator stops at a byte order mark, which we carry through; it shall see what follows.
  const hasMark = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
  const report = await validator.validateBytes(hasMark ? bytes.subarray(3) : bytes, {
    maxIssues: 0,
    externalResourceFunction: async (uri) =>
      new Uint8Array(readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))),
  });
  const counts = new Map();
  for (const { code, severity, message, pointer } of report.issues.messages) {
    if (severity > 1) continue;
    const known = counts.get(code) ?? { count: 0, text: `${code} ${pointer}: ${message}` };
    counts.set(code, { ...known, count: known.count + 1 });
  }
  return counts;
}

/**
 * Asserts the law for a written file.
 * @param {object} options  set: the uv set written · target: index of the mesh in the file ·
 *   replaced: the set was there before · lostTangents · lostExtensions ·
 *   hasUv: false where the uv that were asked for are not beside the written file
 */
export async function assertLaw(original, written, options) {
  const [before, after] = await Promise.all([original, written].map(readIndependently));
  const newSets = Array.from({ length: options.set + 1 }, (_, set) => `TEXCOORD_${set}`).filter(
    (name) =>
      (options.replaced && name === `TEXCOORD_${options.set}`) ||
      before.json.meshes[options.target].primitives.some(
        (p) => (p.mode ?? 4) >= 4 && !(name in p.attributes),
      ),
  );
  const allowed = { newSets, lostTangents: false, lostExtensions: [], ...options };
  const hasUv = options.hasUv ?? true;
  const uv = hasUv ? new Uint8Array(readFileSync(`${written}.uv`)) : undefined;
  compareDocuments(before.document, after.document, options.target, allowed, uv);
  compareTexts(before, after, options.target, allowed);
  const [old, now] = [await issues(original, before.bytes), await issues(written, after.bytes)];
  if (options.isClean) {
    // A chunk of an unknown type is one of the things that must be carried through.
    const faults = [...old.keys()].filter((code) => code !== 'GLB_UNKNOWN_CHUNK_TYPE');
    assert.deepEqual(faults, [], 'the original itself is without fault');
  }
  for (const [code, { count, text }] of now) {
    const isExpected = options.lostTangents && code === 'MESH_PRIMITIVE_GENERATED_TANGENT_SPACE';
    assert.ok(isExpected || count <= (old.get(code)?.count ?? 0), `validator: ${text}`);
  }
  return { before, after };
}
