// hgp/three and hgp/gltf-transform: what goes in comes out with one more attribute, cut where it must
// be, and nothing else changed.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Document, NodeIO } from '@gltf-transform/core';
import * as THREE from 'three';
import { randomFrom } from '../mutation/draw.mjs';
import { withClient } from './support.mjs';
import { parametrizeGeometry } from '../../build/package/three.js';
import { seamless } from '../../build/package/gltf-transform.js';

/** The corners of a geometry as values of an attribute, whatever the index. */
const corners = (geometry, attribute) => {
  const count = geometry.index ? geometry.index.count : attribute.count;
  return Array.from({ length: count }, (_, i) => {
    const v = geometry.index ? geometry.index.getX(i) : i;
    return Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(v, k));
  });
};

/** Twice the smallest signed area of the map's triangles, from the attribute as it is stored. */
function smallestArea(uv) {
  let least = Infinity;
  for (let i = 0; i < uv.length; i += 3) {
    const [[a, b], [c, d], [e, f]] = uv.slice(i, i + 3);
    least = Math.min(least, (c - a) * (f - b) - (d - b) * (e - a));
  }
  return least;
}

/** Connected parts of the map: corners that share place and texture coordinates are one. */
const geometries = {
  box: () => new THREE.BoxGeometry(1, 2, 3, 4, 4, 4),
  icosahedron: () => new THREE.IcosahedronGeometry(1, 3),
  sphere: () => new THREE.SphereGeometry(1, 24, 12),
  knot: () => new THREE.TorusKnotGeometry(1, 0.3, 96, 8),
  cylinder: () => new THREE.CylinderGeometry(1, 1, 2, 24, 3),
};

test("three.js's own geometries are one surface each, with one certified map", () =>
  withClient(async (client) => {
    for (const [name, make] of Object.entries(geometries)) {
      const given = make();
      const { geometry, certificate, seams } = await parametrizeGeometry(client, given);
      assert.equal(certificate.certified, true, name);
      assert.equal(certificate.precision, 'float32', name);
      assert.equal(certificate.components.length, 1, name);
      const uv = corners(geometry, geometry.attributes.uv);
      assert.ok(smallestArea(uv) > 0, name);
      assert.deepEqual(
        corners(geometry, geometry.attributes.position),
        corners(given, given.attributes.position),
        name,
      );
      assert.deepEqual(
        corners(geometry, geometry.attributes.normal),
        corners(given, given.attributes.normal),
        name,
      );
      assert.deepEqual(geometry.groups, given.groups, name);
      assert.ok(seams.isLineSegments && seams.geometry.attributes.position.count > 0, name);
    }
  }));

test('skins, morph targets, interleaved and normalized attributes are kept', () =>
  withClient(async (client) => {
    const given = new THREE.BoxGeometry(1, 1, 1, 3, 3, 3).deleteAttribute('uv');
    const count = given.attributes.position.count;
    const bytes = Uint8Array.from({ length: 4 * count }, (_, i) => (37 * i) % 256);
    given.setAttribute('color', new THREE.BufferAttribute(bytes, 4, true));
    const mixed = new THREE.InterleavedBuffer(
      Float32Array.from({ length: 8 * count }, (_, i) => Math.sin(i)),
      8,
    );
    given.setAttribute('skinWeight', new THREE.InterleavedBufferAttribute(mixed, 4, 2));
    const moved = Float32Array.from({ length: 3 * count }, (_, i) => Math.cos(i));
    given.morphAttributes.position = [new THREE.BufferAttribute(moved, 3)];
    given.morphTargetsRelative = true;
    const { geometry } = await parametrizeGeometry(client, given, { attribute: 'uv1', q: 2 });
    assert.equal(geometry.attributes.uv, undefined);
    assert.equal(geometry.attributes.uv1.itemSize, 2);
    assert.ok(geometry.attributes.color.array instanceof Uint8Array);
    assert.equal(geometry.attributes.color.normalized, true);
    for (const name of ['color', 'skinWeight']) {
      assert.deepEqual(
        corners(geometry, geometry.attributes[name]),
        corners(given, given.attributes[name]),
        name,
      );
    }
    assert.deepEqual(
      corners(geometry, geometry.morphAttributes.position[0]),
      corners(given, given.morphAttributes.position[0]),
    );
    assert.equal(geometry.morphTargetsRelative, true);
  }));

test('a geometry that is not a surface is an error', () =>
  withClient(async (client) => {
    await assert.rejects(parametrizeGeometry(client, {}), { code: 'usage' });
    const line = new THREE.BufferGeometry().setFromPoints([
      new THREE.Vector3(),
      new THREE.Vector3(),
    ]);
    await assert.rejects(parametrizeGeometry(client, line), /2 corners/);
  }));

/** A document with two meshes; the first has two primitives that share an edge, the second a morph. */
function sampleDocument() {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = (geometry) =>
    document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', geometry.attributes.position.array))
      .setAttribute('NORMAL', accessor('VEC3', geometry.attributes.normal.array))
      .setAttribute('TEXCOORD_0', accessor('VEC2', geometry.attributes.uv.array))
      .setIndices(accessor('SCALAR', geometry.index.array));
  const half = (from, length) =>
    primitive(new THREE.SphereGeometry(1, 16, 8, from, length)).setMaterial(
      document.createMaterial(`half ${from}`),
    );
  const sphere = document.createMesh('sphere');
  sphere.addPrimitive(half(0, Math.PI)).addPrimitive(half(Math.PI, Math.PI));
  const box = primitive(new THREE.BoxGeometry(1, 1, 1, 3, 3, 3));
  const count = box.getAttribute('POSITION').getCount();
  box.addTarget(
    document
      .createPrimitiveTarget()
      .setAttribute('POSITION', accessor('VEC3', new Float32Array(3 * count).fill(0.25))),
  );
  document.createMesh('box').addPrimitive(box);
  document.createMesh('empty');
  return document;
}

test('a glTF-Transform document gets a new set in every mesh', () =>
  withClient(async (client) => {
    const document = sampleDocument();
    const before = document.getRoot().listMeshes()[1].listPrimitives()[0];
    const indexCount = before.getIndices().getCount();
    const seen = [];
    const fix = { degenerate: true };
    await document.transform(
      seamless({
        client,
        fix,
        onMesh: (mesh, { certificate }) =>
          seen.push([mesh.getName(), certificate.certified, certificate.components.length]),
      }),
    );
    assert.deepEqual(seen, [
      ['sphere', true, 1],
      ['box', true, 1],
    ]);
    for (const mesh of document.getRoot().listMeshes()) {
      for (const primitive of mesh.listPrimitives()) {
        const set = primitive.getAttribute('TEXCOORD_1');
        const count = primitive.getAttribute('POSITION').getCount();
        assert.equal(set.getCount(), count);
        assert.ok(set.getArray() instanceof Float32Array);
        for (const semantic of primitive.listSemantics()) {
          assert.equal(primitive.getAttribute(semantic).getCount(), count, semantic);
        }
      }
    }
    const box = document.getRoot().listMeshes()[1].listPrimitives()[0];
    assert.equal(box.getIndices().getCount(), indexCount);
    const [target] = box.listTargets();
    assert.equal(
      target.getAttribute('POSITION').getCount(),
      box.getAttribute('POSITION').getCount(),
    );
  }));

test('what the adapters write is the certified map: verified in a file, and corner by corner', () =>
  withClient(async (client) => {
    const document = sampleDocument();
    const results = new Map();
    const onMesh = (mesh, result) => results.set(mesh, result);
    await document.transform(seamless({ client, fix: { degenerate: true }, onMesh }));
    assert.equal(results.size, 2);
    for (const [mesh, { uv, cornerToUv }] of results) {
      let corner = 0;
      for (const primitive of mesh.listPrimitives()) {
        const set = primitive.getAttribute('TEXCOORD_1').getArray();
        for (const v of primitive.getIndices().getArray()) {
          const i = cornerToUv[corner++];
          const expected = [Math.fround(uv[2 * i]), Math.fround(1 - uv[2 * i + 1])];
          assert.deepEqual([set[2 * v], set[2 * v + 1]], expected, `${mesh.getName()} ${corner}`);
        }
      }
      assert.equal(corner, cornerToUv.length);
    }
    document.getRoot().listMeshes()[2].dispose(); // it is empty, which glTF does not allow
    const bytes = await new NodeIO().writeBinary(document);
    for (const surface of [0, 1]) {
      const model = await client.load(bytes, { name: 'both.glb', surface });
      const certificate = await model.verify({ uvSet: 1 });
      assert.equal(certificate.certified, true, `mesh ${surface}`);
      assert.equal(certificate.precision, 'float32');
    }
    const { geometry, result } = await parametrizeGeometry(client, geometries.box());
    const set = geometry.attributes.uv.array;
    geometry.index.array.forEach((v, corner) => {
      const i = result.cornerToUv[corner];
      assert.deepEqual(
        [set[2 * v], set[2 * v + 1]],
        [uv32(result, 2 * i), uv32(result, 2 * i + 1)],
      );
    });
  }));

const uv32 = ({ uv }, i) => Math.fround(uv[i]);

/** A client that solves nothing: every corner has any of some places that its vertex has in the map. */
function anyMap(random, { certified = true, most = 3 } = {}) {
  const asked = [];
  const parametrizeRendered = async ({ positions, triangles }, ...options) => {
    const uv = Float64Array.from({ length: 2 * most * (positions.length / 3) }, random);
    const cornerToUv = Uint32Array.from(triangles, (v) => most * v + Math.floor(most * random()));
    asked.push({ positions: [...positions], triangles: [...triangles], options });
    const vertices = positions.length / 3;
    const uvToVertex = Uint32Array.from({ length: most * vertices }, (_, i) => Math.floor(i / most)); // prettier-ignore
    const seams = Array.from({ length: 5 }, () => ({ a: [0, 0].map(() => Math.floor(uvToVertex.length * random())) })); // prettier-ignore
    return { uv, cornerToUv, seams, uvToVertex, positions, certificate: { certified } };
  };
  return { parametrizeRendered, asked };
}

/** A document of one mesh: parts of any kind with attributes of any type, indexed or not, some of them no triangles. */
function anyDocument(random, sets) {
  const document = new Document();
  const buffer = document.createBuffer();
  const some = (n) => Math.floor(n * random());
  const accessor = (type, array, isNormalized = false) =>
    document.createAccessor(`of ${type}`).setType(type).setArray(array).setBuffer(buffer).setNormalized(isNormalized); // prettier-ignore
  const mesh = document.createMesh('any');
  const isEverywhere = random() < 0.5;
  for (let p = 0; p < 4; p++) {
    const count = 3 + 3 * some(4);
    const primitive = document
      .createPrimitive()
      .setMode(p === 2 ? 0 : 4)
      .setAttribute('POSITION', accessor('VEC3', Float32Array.from({ length: 3 * count }, random)))
      .setAttribute('COLOR_0', accessor('VEC4', Uint8Array.from({ length: 4 * count }, () => some(256)), true)) // prettier-ignore
      .setAttribute('JOINTS_0', accessor('VEC4', Uint16Array.from({ length: 4 * count }, () => some(9)))); // prettier-ignore
    // A set is one of all parts, or of a single one.
    for (const set of sets.filter((one) => isEverywhere || one % 4 === p)) primitive.setAttribute(`TEXCOORD_${set}`, accessor('VEC2', Float32Array.from({ length: 2 * count }, random))); // prettier-ignore
    if (p % 2 === 0) primitive.setIndices(accessor('SCALAR', Uint8Array.from({ length: 12 + some(3) }, () => some(count)))); // prettier-ignore
    primitive.addTarget(document.createPrimitiveTarget().setAttribute('POSITION', accessor('VEC3', Float32Array.from({ length: 3 * count }, random)))); // prettier-ignore
    mesh.addPrimitive(primitive);
  }
  return { document, mesh };
}

/** What an attribute has at each corner of the triangles, in its own type. */
function cornersIn(primitive, owner, semantic) {
  const attribute = owner.getAttribute(semantic);
  const indices = primitive.getIndices()?.getArray() ?? Array.from({ length: attribute.getCount() }, (_, i) => i); // prettier-ignore
  const [array, size] = [attribute.getArray(), attribute.getElementSize()];
  const whole = primitive.getMode() === 4 ? indices.length - (indices.length % 3) : indices.length;
  return { type: array.constructor.name, isNormalized: attribute.getNormalized(), name: attribute.getName(), values: [...indices].slice(0, whole).map((v) => [...array.slice(size * v, size * v + size)]) }; // prettier-ignore
}

const everythingIn = (mesh) =>
  mesh.listPrimitives().map((primitive) =>
    [primitive, ...primitive.listTargets()].map(
      (owner) =>
      Object.fromEntries(owner.listSemantics().map((semantic) => [semantic, cornersIn(primitive, owner, semantic)])), // prettier-ignore
    ),
  );

test('whatever a document has stays at every corner, next to the first free set or in place of the one that is asked for', async () => {
  const random = randomFrom(4);
  for (let round = 0; round < 24; round++) {
    const sets = [[], [0], [0, 1], [1], [2, 0], [0, 1, 2]][round % 6];
    const asked = round % 4 === 3 ? 1 : undefined;
    const { document, mesh } = anyDocument(random, sets);
    const before = everythingIn(mesh);
    const results = [];
    const client = anyMap(random);
    await document.transform(seamless({ client, texcoord: asked, weld: 0.5, q: 6, onMesh: (_, result) => results.push(result) })); // prettier-ignore
    assert.deepEqual(client.asked[0].options.map((one) => ({ ...one })), [{ weld: 0.5, fix: undefined, limits: undefined }, { q: 6 }]); // prettier-ignore
    const free = [0, 1, 2, 3].find((set) => !sets.includes(set));
    const name = `TEXCOORD_${asked ?? free}`;
    const after = everythingIn(mesh);
    const [{ uv, cornerToUv }] = results;
    let corner = 0;
    after.forEach(([own, ...targets], p) => {
      const { [name]: set, ...rest } = own;
      const { [name]: old, ...kept } = before[p][0];
      assert.deepEqual(rest, kept, 'all other attributes');
      assert.deepEqual(targets, before[p].slice(1), 'targets');
      if (p === 2) return assert.deepEqual(set, old, 'points have no map');
      assert.equal(set.type, 'Float32Array');
      for (const value of set.values) {
        const i = cornerToUv[corner++];
        assert.deepEqual(value, [Math.fround(uv[2 * i]), Math.fround(1 - uv[2 * i + 1])]);
      }
    });
    assert.equal(corner, cornerToUv.length);
    // The solver is asked for these triangles in these places.
    const { positions, triangles } = client.asked[0];
    const places = after.flatMap(([own], p) => (p === 2 ? [] : own.POSITION.values));
    assert.deepEqual(triangles.map((v) => positions.slice(3 * v, 3 * v + 3)), places); // prettier-ignore
  }
});

test('where the map splits no vertex, every attribute is the very one that was there', async () => {
  const random = randomFrom(12);
  const { document, mesh } = anyDocument(random, []);
  const before = mesh.listPrimitives().map((one) => one.listAttributes());
  await document.transform(seamless({ client: anyMap(random, { most: 1 }) }));
  mesh.listPrimitives().forEach((one, p) => {
    const kept = one.listAttributes().filter((attribute) => before[p].includes(attribute));
    assert.deepEqual(kept, before[p]);
  });
});

test('a map that is not certified is written only where that is allowed; a mesh without triangles is passed over', async () => {
  const random = randomFrom(6);
  for (const certified of [true, false])
    for (const allowUncertified of [undefined, false, true]) {
      const { document, mesh } = anyDocument(random, []);
      document.createMesh('empty');
      document.createMesh('points').addPrimitive(mesh.listPrimitives()[2].clone());
      const client = anyMap(random, { certified });
      const seen = [];
      const done = document.transform(seamless({ client, allowUncertified, onMesh: (one) => seen.push(one) })); // prettier-ignore
      if (certified || allowUncertified) await done;
      else await assert.rejects(done, { code: 'no-map', message: /'any'/ });
      assert.deepEqual([seen, client.asked.length], [[mesh], 1]);
      const isWritten = mesh.listPrimitives()[0].getAttribute('TEXCOORD_0') !== null;
      assert.equal(isWritten, certified || allowUncertified === true);
    }
});

test('indices have two bytes up to 65535 vertices, in a document as in a geometry', async () => {
  const random = randomFrom(8);
  for (const count of [65_534, 65_535, 65_536]) {
    const positions = new Float32Array(3 * count);
    const index = Uint32Array.of(0, 1, count - 1);
    const client = anyMap(random, { most: 1 });
    const given = new THREE.BufferGeometry();
    given.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    given.setIndex(new THREE.BufferAttribute(index, 1));
    const { geometry } = await parametrizeGeometry(client, given);
    const document = new Document();
    const accessor = (type, array) => document.createAccessor().setType(type).setArray(array);
    const primitive = document.createPrimitive().setAttribute('POSITION', accessor('VEC3', positions)).setIndices(accessor('SCALAR', index)); // prettier-ignore
    document.createMesh('large').addPrimitive(primitive);
    await document.transform(seamless({ client }));
    for (const array of [geometry.index.array, primitive.getIndices().getArray()])
      assert.deepEqual([array.BYTES_PER_ELEMENT, [...array]], [count > 65_535 ? 4 : 2, [...index]]);
  }
});

test('a geometry keeps its name, data, groups, range, and every attribute in its own type, at every corner', async () => {
  const random = randomFrom(9);
  for (let round = 0; round < 12; round++) {
    const given = new THREE.BufferGeometry();
    const count = 9;
    const own = (size, Type) => new THREE.BufferAttribute(Type.from({ length: size * count }, () => 200 * random()), size, Type === Uint8Array); // prettier-ignore
    Object.assign(given, { name: `n${round}`, userData: { of: [round] }, morphTargetsRelative: round % 2 === 1 }); // prettier-ignore
    given.setAttribute('position', own(3, Float32Array));
    given.setAttribute('color', own(4, Uint8Array));
    const joints = own(4, Uint16Array);
    joints.gpuType = THREE.IntType;
    joints.name = 'joints';
    given.setAttribute('skinIndex', joints);
    if (round % 3 > 0) given.setAttribute('uv', own(2, Float32Array));
    const mixed = new THREE.InterleavedBuffer(Float32Array.from({ length: 5 * count }, random), 5);
    given.setAttribute('mixed', new THREE.InterleavedBufferAttribute(mixed, 2, 3, round % 4 === 0));
    given.morphAttributes.position = [own(3, Float32Array), own(3, Float32Array)];
    if (round % 2 === 0) given.setIndex([0, 1, 2, 2, 1, 3, 8, 0, 8, 4, 5, 6]);
    given.addGroup(0, 3, 1);
    given.addGroup(3, 6, 0);
    given.setDrawRange(3, 6);
    const attribute = ['uv', 'uv1'][round % 2];
    const client = anyMap(random);
    const { geometry, result, seams } = await parametrizeGeometry(client, given, { attribute, weld: 0.1, q: 2 }); // prettier-ignore
    const asked = client.asked[0];
    const place = (v) => asked.positions.slice(3 * v, 3 * v + 3);
    assert.deepEqual(asked.triangles.map(place), corners(given, given.attributes.position));
    const ends = seams.geometry.attributes.position;
    assert.deepEqual(corners(seams.geometry, ends), result.seams.flatMap(({ a }) => a.map((end) => place(result.uvToVertex[end])))); // prettier-ignore
    for (const member of ['name', 'userData', 'groups', 'drawRange', 'morphTargetsRelative'])
      assert.deepEqual(geometry[member], given[member], member);
    assert.notEqual(geometry.userData, given.userData, 'a copy');
    const names = new Set([...Object.keys(given.attributes), attribute]);
    assert.deepEqual(new Set(Object.keys(geometry.attributes)), names);
    const pairs = [...names].filter((name) => name !== attribute).map((name) => [geometry.attributes[name], given.attributes[name]]); // prettier-ignore
    given.morphAttributes.position.forEach((one, i) => pairs.push([geometry.morphAttributes.position[i], one])); // prettier-ignore
    for (const [now, old] of pairs) {
      assert.deepEqual(corners(geometry, now), corners(given, old));
      const { array, gpuType } = 'data' in old ? { array: old.data.array, gpuType: THREE.FloatType } : old; // prettier-ignore
      assert.deepEqual([now.array.constructor, now.normalized, now.name, now.gpuType, now.itemSize], [array.constructor, old.normalized, old.name, gpuType, old.itemSize]); // prettier-ignore
    }
    corners(geometry, geometry.attributes[attribute]).forEach((value, corner) => {
      const i = result.cornerToUv[corner];
      assert.deepEqual(value, [uv32(result, 2 * i), uv32(result, 2 * i + 1)]);
    });
    assert.deepEqual(client.asked[0].options.slice(0, 2).map((one) => ({ ...one })), [{ weld: 0.1, fix: undefined, limits: undefined }, { q: 2 }]); // prettier-ignore
  }
});
