// hgp/three and hgp/gltf-transform: what goes in comes out with one more attribute, cut where it must
// be, and nothing else changed.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Document, NodeIO } from '@gltf-transform/core';
import * as THREE from 'three';
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
