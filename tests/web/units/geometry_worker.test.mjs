// Laws of the geometry worker: it answers from copies of its own, as the functions do of which it is made, until it is told to
// forget; and it gives away what it has made.

import assert from 'node:assert/strict';
import test from 'node:test';
import { MeshoptEncoder } from 'meshoptimizer';
import { BufferAttribute, BufferGeometry, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { randomFrom } from '../../mutation/draw.mjs';
import { packGlb, toGltf, toObj } from '../../support/meshes.mjs';
import { flatPositions } from '../../../web/src/services/geometry/flat_positions.ts';
import { Mirror } from '../../../web/src/services/geometry/mirror_plane.ts';
import { bvhAtOnce, bvhFrom, pickGeometry } from '../../../web/src/views/corner_geometry.ts';
import { cubeSolution, cubeSurface, mesh } from './cube_view.mjs';
import { plainFacts } from './plain_facts.mjs';
import { certificate, measuresOf } from './square_solution.mjs';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const facts = plainFacts(mesh);
const arrays = () => ({
  positions: Float64Array.from(mesh.vertices.flat()),
  triangles: Uint32Array.from(mesh.triangles.flat()),
});
let receive;

/** Runs with the worker in this thread; `ask` returns its answer and what was transferred with it. */
async function withWorker(act) {
  const own = ['addEventListener', 'postMessage'].map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)]); // prettier-ignore
  const waiting = new Map();
  globalThis.postMessage = (answer, { transfer = [] } = {}) => {
    const moved = transfer.length > 0 ? structuredClone(answer, { transfer }) : answer;
    waiting.get(answer.call)({ ...moved, transfer: transfer.length });
  };
  globalThis.addEventListener = (_, listener) => (receive = listener);
  let last = 0;
  const ask = (method, ...args) =>
    new Promise((resolve) => {
      waiting.set(++last, resolve);
      receive({ data: structuredClone({ call: last, method, args }) });
    });
  try {
    await import('../../../web/src/services/geometry_worker.ts');
    await act(async (...all) => {
      const { result, error, transfer } = await ask(...all);
      if (error !== undefined) throw new Error(error);
      return { result, transfer };
    });
  } finally {
    for (const [name, one] of own) {
      if (one) Object.defineProperty(globalThis, name, one);
      else delete globalThis[name];
    }
  }
}
const solution = cubeSolution(cubeSurface());
const request = () => {
  const { uv, cornerToUv, uvToVertex } = solution.result;
  const map = { ...arrays(), uv, cornerToUv, uvToVertex, seams: solution.seams };
  const bytes = new TextEncoder().encode(toObj(mesh));
  return {
    map,
    measures: measuresOf(map),
    files: [{ name: 'a.obj', bytes }],
    mesh: 0,
    certificate,
  };
};
/** What two trees find along the same rays. */
function sameHits(one, other, rays, what) {
  let found = 0;
  for (const ray of rays) {
    const [a, b] = [one, other].map((tree) => tree.raycastFirst(ray, 2));
    assert.equal(a?.faceIndex, b?.faceIndex, what);
    if (a) found += 1;
  }
  assert.ok(found > 0.2 * rays.length, `${what}: ${found} of ${rays.length}`);
}

test('trees for picking find what trees find that are built of the surface and of its map', () =>
  withWorker(async (ask) => {
    const random = randomFrom(6);
    await ask('surface', 1, arrays(), facts, identity);
    await ask('analyse', 5, 1, request());
    const surface = cubeSurface();
    const geometry = pickGeometry(surface);
    const { result } = await ask('surfaceBvh', 1);
    const rays = Array.from({ length: 200 }, () => {
      const eye = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).setLength(5);
      const at = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5);
      return new Ray(eye, at.sub(eye).normalize());
    });
    sameHits(bvhFrom(result, geometry), bvhAtOnce(geometry), rays, 'surface');
    const flat = new BufferGeometry().setAttribute('position', new BufferAttribute(flatPositions(solution.cornerUv), 3)); // prettier-ignore
    const { x, y, width, height } = solution.box;
    const down = Array.from({ length: 200 }, () => new Ray(new Vector3(x + width * random(), y + height * random(), 5), new Vector3(0, 0, -1))); // prettier-ignore
    const { result: tree } = await ask('mapBvh', 5);
    sameHits(bvhFrom(tree, flat), new MeshBVH(flat, { indirect: true }), down, 'map');
  }));

test('of a map on the same mesh only the map is sent back, and of one on another mesh that mesh, too', () =>
  withWorker(async (ask) => {
    await ask('surface', 4, arrays(), facts, identity);
    const mapOn = async (more) => {
      const own = request();
      const { result } = await ask('analyse', 7, 4, { ...own, map: { ...own.map, ...more } });
      return [result.map.positions, result.map.triangles];
    };
    const { positions, triangles } = arrays();
    assert.deepEqual(await mapOn({}), [undefined, undefined]);
    // One coordinate is enough, wherever it is.
    for (const i of [0, 1, 17, positions.length - 1]) {
      const moved = positions.with(i, positions[i] + 1e-9);
      assert.deepEqual(await mapOn({ positions: moved }), [moved, undefined]);
    }
    // As is one vertex more, which no triangle has.
    const longer = Float64Array.from([...positions, 1, 2, 3]);
    assert.deepEqual(await mapOn({ positions: longer }), [longer, undefined]);
    const [a, b, c] = triangles;
    const turned = triangles.slice();
    turned.set([b, c, a]);
    const [same, other] = await mapOn({ triangles: turned });
    assert.equal(same, undefined);
    assert.deepEqual(other, turned);
  }));

test('answers are given away, and others do not depend on them', () =>
  withWorker(async (ask) => {
    const { result: surface, transfer } = await ask('surface', 2, arrays(), facts, identity);
    assert.ok(transfer > 0);
    await ask('analyse', 6, 2, request());
    const calls = [['overlay', 6, 'seams'], ['overlay', 6, 'area'], ['crosses', 6, 8, 4], ['thumbnail', 2], ['thumbnail', 2, 6, 9], ['loopSegments', 2, [Uint32Array.of(0, 9, 9, 20, 20, 0)]], ['opposite', 2, 3], ['surfaceBvh', 2], ['mapBvh', 6]]; // prettier-ignore
    const answers = async () => {
      const all = [];
      for (const call of calls) all.push(structuredClone((await ask(...call)).result));
      return all;
    };
    const before = await answers();
    for (const array of [surface.positions, surface.places, surface.triangles]) array.fill(7);
    assert.deepEqual(await answers(), before);
    for (const name of ['overlay', 'crosses', 'thumbnail', 'mapBvh']) assert.ok((await ask(...calls.find(([one]) => one === name))).transfer > 0, name); // prettier-ignore
    // A copy of the surface that is placed elsewhere has its own answers.
    await ask('surface', 3, arrays(), facts, [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]);
    const [plain] = (await ask('loopSegments', 2, [Uint32Array.of(0, 9, 9, 20)])).result;
    const [moved] = (await ask('loopSegments', 3, [Uint32Array.of(0, 9, 9, 20)])).result;
    moved.forEach((x, i) => assert.ok(Math.abs(x - (i % 3 === 0 ? 2 * plain[i] + 5 : plain[i])) < 1e-5)); // prettier-ignore
  }));

test('the opposite of a vertex is that of the mirror, and whether there is a plane', () =>
  withWorker(async (ask) => {
    await ask('surface', 4, arrays(), facts, identity);
    const mirror = new Mirror(cubeSurface());
    for (let v = 0; v < mesh.vertices.length; v += 7) {
      const { result } = await ask('opposite', 4, v);
      assert.deepEqual(result, {
        vertex: mirror.opposite(v),
        hasPlane: mirror.plane !== undefined,
      });
    }
  }));

test('a mesh beside others has the corners and normals of its triangles, a picture, and is not kept', () =>
  withWorker(async (ask) => {
    const { result } = await ask('part', arrays(), identity);
    const { cornerPositions, cornerNormals } = result.shape;
    mesh.triangles.flat().forEach((v, c) => {
      assert.deepEqual([...cornerPositions.subarray(3 * c, 3 * c + 3)], mesh.vertices[v].map(Math.fround)); // prettier-ignore
      const n = [0, 1, 2].map((i) => cornerNormals[4 * c + i]);
      assert.ok(Math.abs(Math.hypot(...n) - 127) < 2, 'of length one');
      assert.equal(cornerNormals[4 * c + 3], 0, 'what fills four bytes');
      assert.ok(n.reduce((sum, x, i) => sum + x * mesh.vertices[v][i], 0) > 0, 'outwards');
    });
    const { result: turned } = await ask('part', arrays(), [0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 0, 0, 1]); // prettier-ignore
    assert.deepEqual(turned.shape.cornerPositions, cornerPositions, 'not placed yet');
    assert.notDeepEqual(turned.picture, result.picture, 'the picture is of the placed mesh');
  }));

/** A glTF whose buffers are compressed. */
function compressed({ json, bin }) {
  const parts = [];
  json.accessors.forEach(({ bufferView, count, type }) => {
    const { byteOffset, byteLength } = json.bufferViews[bufferView];
    const mode = type === 'SCALAR' ? 'INDICES' : 'ATTRIBUTES';
    const stride = byteLength / count;
    const part = MeshoptEncoder.encodeGltfBuffer(new Uint8Array(bin.subarray(byteOffset, byteOffset + byteLength)), count, stride, mode); // prettier-ignore
    const at = parts.reduce((sum, { length }) => sum + length, 0);
    const about = { buffer: 0, byteOffset: at, byteLength: part.length, byteStride: stride, count, mode }; // prettier-ignore
    json.bufferViews[bufferView] = { buffer: 1, byteLength, extensions: { EXT_meshopt_compression: about } }; // prettier-ignore
    parts.push(part);
  });
  json.extensionsUsed = ['EXT_meshopt_compression'];
  return { json, bin: Buffer.concat(parts) };
}

test('a map is found in a file whatever compresses its buffers, and another map is told from it', () =>
  withWorker(async (ask) => {
    await MeshoptEncoder.ready;
    await ask('surface', 8, arrays(), facts, identity);
    const { positions, triangles } = arrays();
    const uv = Float64Array.from(mesh.vertices.flatMap(([x, y, z]) => [x + 0.3 * z, y - 0.2 * z].map(Math.fround))); // prettier-ignore
    const map = { positions, triangles, uv, cornerToUv: triangles, uvToVertex: Uint32Array.from(mesh.vertices.keys()), seams: [] }; // prettier-ignore
    const ofVertex = (p) => mesh.vertices.indexOf(p);
    const gltf = () => toGltf([mesh], { uv: { 0: (p) => [uv[2 * ofVertex(p)], 1 - uv[2 * ofVertex(p) + 1]] } }); // prettier-ignore
    for (const content of [gltf(), compressed(gltf())]) {
      const files = [{ name: 'a.glb', bytes: new Uint8Array(packGlb(content)) }];
      const asked = { ...request(), map, files };
      const other = { ...asked, map: { ...map, uv: uv.with(3, uv[3] + 0.01) } };
      const found = [];
      for (const one of [asked, other]) {
        const { difference } = (await ask('compare', one)).result;
        const { analysis } = (await ask('analyse', 9, 8, one)).result;
        assert.equal(analysis.difference, difference);
        found.push(difference);
      }
      assert.equal(found[0], '');
      assert.ok(found[1].length > 0 && !found[1].includes('compressed'), found[1]);
    }
  }));

test('what is forgotten is not known any more, and the rest is', () =>
  withWorker(async (ask) => {
    for (const id of [11, 12]) {
      await ask('surface', id, arrays(), facts, identity);
      await ask('analyse', 10 + id, id, request());
      await ask('crosses', 10 + id, 8, 4);
    }
    const { result: before } = await ask('crosses', 22, 8, 4);
    await ask('forget', [11], [21]);
    for (const call of [['surfaceBvh', 11], ['thumbnail', 11], ['overlay', 21, 'area'], ['mapBvh', 21]]) await assert.rejects(ask(...call), /not known any more/); // prettier-ignore
    await ask('surfaceBvh', 12);
    assert.deepEqual((await ask('crosses', 22, 8, 4)).result, before);
    await ask('forget', [12], [22]);
    await assert.rejects(ask('crosses', 22, 8, 4), /not known any more/);
    // Another density has other crosses.
    await ask('surface', 12, arrays(), facts, identity);
    await ask('analyse', 22, 12, request());
    const { result: dense } = await ask('crosses', 22, 16, 4);
    assert.ok(dense.inMap.length > 2 * before.inMap.length);
    assert.equal(dense.inMap.length, dense.onSurface.length);
    assert.deepEqual((await ask('crosses', 22, 8, 4)).result, before, 'as often as it changes');
    assert.deepEqual((await ask('crosses', 22, 16, 4)).result, dense);
  }));
