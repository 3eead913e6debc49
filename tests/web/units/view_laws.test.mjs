// Laws of what the views draw, as far as it is numbers: buffers, lines, markers, the camera. No picture is made.

import assert from 'node:assert/strict';
import test from 'node:test';
import { BufferAttribute, BufferGeometry, Color, LinearMipmapLinearFilter, Matrix3, Matrix4, Mesh, PerspectiveCamera, Ray, RepeatWrapping, SRGBColorSpace, Vector3 } from 'three'; // prettier-ignore
import { MeshBVH } from 'three-mesh-bvh';
import { oneOfEach } from '../../../web/src/views/shader_warmup.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { cubeMesh } from '../../support/meshes.mjs';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { Canvas, painted as drawn, paper } from './canvases.mjs';
import { plainFacts } from './plain_facts.mjs';

// What the camera and the markers ask of a browser.
globalThis.matchMedia ??= () => ({ matches: true });
globalThis.document ??= paper;
const { Orbit } = await import('../../../web/src/views/camera.ts');
const { drawWhenUploaded } = await import('../../../web/src/views/sliced_uploads.ts');
const { ConeMarkers } = await import('../../../web/src/views/cone_markers.ts');
const { bvhAtOnce, flatGeometry, pickGeometry, setTint, surfaceGeometry } =
  await import('../../../web/src/views/corner_geometry.ts');
const { hiding } = await import('../../../web/src/views/hiding.ts');
const { highlightTargets } = await import('../../../web/src/views/highlight_targets.ts');
const { Lines, seamsInMap, seamsOnSurface, Wire } = await import('../../../web/src/views/lines.ts');
const { gatheredFor } = await import('../../../web/src/views/gathered_attribute.ts');
const { LiveGeometry } = await import('../../../web/src/views/live_geometry.ts');
const { setImage, surfaceMaterial } = await import('../../../web/src/views/pattern_material.ts');
const { QuadsView } = await import('../../../web/src/views/quads_view.ts');
const { chainColour, ticksInMap, ticksOnSurface } =
  await import('../../../web/src/views/seam_marks.ts');
const { SurfaceMarks } = await import('../../../web/src/views/surface_marks.ts');
const { shapeOf, WholeScene } = await import('../../../web/src/views/whole_scene.ts');

const near = (a, b, what, within = 1e-5) =>
  assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`);
const mesh = cubeMesh(3);
const surface = {
  id: 1,
  ...locatedSurface(
    {
      positions: Float64Array.from(mesh.vertices.flat()),
      triangles: Uint32Array.from(mesh.triangles.flat()),
    },
    plainFacts(mesh),
  ),
};
surface.places = surface.positions;
surface.packedNormals = Int8Array.from({ length: 4 * surface.vertexCount }, (_, i) => (i % 4 === 3 ? 0 : i)); // prettier-ignore
// Corners at a crease, among them the first and the last, and neighbours that slices may separate.
surface.creaseCorners = Uint32Array.of(0, 1, 2, 24, 25, 50, surface.triangles.length - 1);
surface.creaseNormals = Int8Array.from({ length: 28 }, (_, i) => 100 - i);
const corners = surface.triangles.length;

const flatTriangle = () =>
  new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 3),
  );

/** The segments that lines draw, from the corners of their triangles. */
function segmentsOf({ geometry }) {
  const [from, to, tint] = ['from', 'to', 'tint'].map((name) => geometry.getAttribute(name));
  const segments = [];
  for (let s = 0; s < from.count / 4; s++) {
    const [a, b] = [from, to].map((one) => [...one.array.subarray(12 * s, 12 * s + 3)]);
    for (let corner = 1; corner < 4; corner++) {
      const at = 12 * s + 3 * corner;
      assert.deepEqual([...from.array.subarray(at, at + 3)], a, 'the same in all corners');
      assert.deepEqual([...to.array.subarray(at, at + 3)], b);
      if (tint) assert.deepEqual([...tint.array.subarray(at, at + 3)], [...tint.array.subarray(12 * s, 12 * s + 3)]); // prettier-ignore
    }
    segments.push({ a, b, tint: tint && [...tint.array.subarray(12 * s, 12 * s + 3)] });
  }
  return segments;
}

test('a segment is two triangles over its four corners, with its own colour', () => {
  const random = randomFrom(1);
  const lines = new Lines(2, { bias: 2, order: 5 });
  assert.equal(lines.visible, false, 'before there are any');
  const points = Float32Array.from({ length: 6 * 5 }, () => random());
  const colours = Array.from({ length: 5 }, () => new Color(random(), random(), random()));
  lines.set(points, colours);
  assert.equal(lines.visible, true);
  assert.equal(lines.material.uniforms.isTinted.value, true);
  segmentsOf(lines).forEach(({ a, b, tint }, s) => {
    assert.deepEqual([...a, ...b], [...points.subarray(6 * s, 6 * s + 6)]);
    colours[s].toArray().forEach((x, i) => near(tint[i], x, 'colour'));
  });
  const index = [...lines.geometry.index.array];
  assert.equal(index.length, 30);
  for (let s = 0; s < 5; s++) {
    const own = index.slice(6 * s, 6 * s + 6);
    assert.deepEqual(
      [...new Set(own)].sort((a, b) => a - b),
      [0, 1, 2, 3].map((c) => 4 * s + c),
    );
    // Two triangles that share the diagonal, wound the same way.
    const sides = [0, 1, 2, 3, 4, 5].map((c) => [own[c], own[c % 3 === 2 ? c - 2 : c + 1]].join()); // prettier-ignore
    assert.equal(new Set(sides).size, 6);
    assert.equal(sides.filter((side) => sides.includes(side.split(',').reverse().join())).length, 2); // prettier-ignore
  }
  const one = new Color('#123456');
  lines.set(points, one);
  assert.equal(lines.material.uniforms.isTinted.value, false);
  assert.equal(lines.material.uniforms.colour.value, one);
  lines.set([], one);
  assert.equal(lines.visible, false);
  assert.deepEqual([lines.material.polygonOffset, lines.material.polygonOffsetFactor, lines.material.polygonOffsetUnits, lines.renderOrder], [true, -2, -2, 5]); // prettier-ignore
  const plain = new Lines(2, { depth: false });
  assert.deepEqual([plain.material.polygonOffset, plain.material.depthTest, plain.material.depthWrite], [false, false, false]); // prettier-ignore
  assert.equal(lines.material.depthTest, true);
});

test('what shaders move is drawn wherever its corners are stored', () => {
  const things = [new Lines(1), new Wire(1, true), new ConeMarkers(true), new ConeMarkers(false), new SurfaceMarks()]; // prettier-ignore
  let meshes = 0;
  for (const thing of things)
    thing.traverse((one) => {
      if (!one.geometry) return;
      assert.equal(one.frustumCulled, false);
      meshes += 1;
    });
  assert.ok(meshes > things.length, 'all of them draw');
});

test('lines that are lifted are nearer to the eye, at the same place of the picture', () => {
  const [eye, point] = [new Vector3(3, 4, 5), new Vector3(1, -1, 0.5)];
  for (const thing of [new Lines(1), new Wire(1, true)]) {
    thing.lift(eye, 0.01);
    thing.updateMatrix();
    const seen = point.clone().applyMatrix4(thing.matrix);
    near(seen.distanceTo(eye), 0.99 * point.distanceTo(eye), 'nearer');
    const [before, after] = [point, seen].map((p) => p.clone().sub(eye).normalize());
    near(before.dot(after), 1, 'the same direction');
  }
});

test('a wire has every side of every triangle, on the corners of the surface', () => {
  const geometry = surfaceGeometry(surface);
  const wire = new Wire(1, true);
  assert.equal(wire.visible, false);
  wire.set(geometry, new Color('#fff'));
  assert.equal(wire.visible, true);
  assert.equal(wire.geometry.getAttribute('position'), geometry.getAttribute('position'));
  // What is gathered for the card has no places from which it could be computed.
  assert.equal(wire.geometry.boundingSphere, geometry.boundingSphere);
  assert.ok(wire.geometry.boundingSphere.radius > 0);
  const sides = [];
  const { slice, byteLength } = gatheredFor(wire.geometry.index.array);
  assert.equal(wire.geometry.index.count, 2 * corners);
  const array = new Uint32Array(slice(0, byteLength).slice().buffer);
  for (let i = 0; i < array.length; i += 2) sides.push([array[i], array[i + 1]]);
  assert.equal(sides.length, corners);
  for (const [a, b] of sides) {
    assert.equal(Math.floor(a / 3), Math.floor(b / 3), 'within one triangle');
    assert.notEqual(a, b);
  }
  assert.equal(new Set(sides.map((side) => side.sort().join())).size, corners);
  const before = wire.geometry;
  wire.set(geometry, new Color('#000'));
  assert.equal(wire.geometry, before, 'not made twice');
});

/** Two chains of seams on the cube: one edge of length ≈ 1, and one of two edges. */
const edge = (v) => surface.neighbours[surface.neighbourStart[v]];
const ends = [[0, edge(0)], [5, edge(5)], [7, edge(7)]]; // prettier-ignore
const uv = Float64Array.from({ length: 24 }, (_, i) => ((i * 7919) % 13) / 3);
const solution = {
  seams: ends.map((_, i) => ({ a: [2 * i, 2 * i + 1], b: [6 + 2 * i, 7 + 2 * i], r: 1 })),
  chains: Uint32Array.from([0, 5, 5]),
  result: { uv, uvToVertex: Uint32Array.from([...ends.flat(), ...ends.flat()]) },
};
const place = (v) => mesh.vertices[v].map(Math.fround);

test('seams are drawn on the surface once and in the map on both sides, in the colour of their chain', () => {
  const { points, colours } = seamsOnSurface(surface, solution);
  assert.deepEqual(
    [...points],
    ends.flatMap(([v, w]) => [...place(v), ...place(w)]),
  );
  assert.deepEqual(colours, [0, 5, 5].map(chainColour));
  const flat = seamsInMap(solution);
  assert.equal(flat.colours.length, 6);
  solution.seams.forEach(({ a, b }, s) => {
    [a, b].forEach((side, k) => {
      assert.equal(flat.colours[2 * s + k], chainColour(solution.chains[s]));
      side.forEach((end, e) => {
        const at = 12 * s + 6 * k + 3 * e;
        near(flat.points[at], uv[2 * end], 'u');
        near(flat.points[at + 1], uv[2 * end + 1], 'v');
        assert.ok(flat.points[at + 2] > 0, 'above the map');
      });
    });
  });
  // Colours repeat, and neighbours differ.
  for (let c = 0; c < 20; c++) assert.notEqual(chainColour(c), chainColour(c + 1));
  assert.equal(chainColour(3), chainColour(11));
});

test('strokes cross the middle edge of their chain at a right angle; both sides have the same number', () => {
  const { points, colours } = ticksOnSurface(surface, solution);
  assert.equal(colours.length, points.length / 6);
  // Chain 0 has one stroke, chain 5 two: its number modulo four, and one more.
  assert.deepEqual(colours, [chainColour(0), chainColour(5), chainColour(5)]);
  const middle = [0, 1, 1].map((chain) => (chain === 0 ? ends[0] : ends[2]));
  const stroke = (s) => [0, 1].map((k) => new Vector3(...points.slice(6 * s + 3 * k, 6 * s + 3 * k + 3))); // prettier-ignore
  [0, 1, 2].forEach((s) => {
    const [p, q] = stroke(s);
    near(p.distanceTo(q), 0.024 * surface.radius, 'length');
    const [v, w] = middle[s].map((end) => new Vector3(...mesh.vertices[end]));
    near(p.clone().sub(q).normalize().dot(w.clone().sub(v).normalize()), 0, 'across');
  });
  const centre = (s) => stroke(s)[0].add(stroke(s)[1]).multiplyScalar(0.5);
  const between = (s, t) => centre(s).distanceTo(centre(t));
  near(between(1, 2), 0.9 * 0.012 * surface.radius, 'gap');
  const [v, w] = ends[2].map((end) => new Vector3(...mesh.vertices[end]));
  near(centre(1).add(centre(2)).multiplyScalar(0.5).distanceTo(v.clone().lerp(w, 0.5)), 0, 'centred'); // prettier-ignore
  near(centre(0).distanceTo(new Vector3(...mesh.vertices[ends[0][0]]).lerp(new Vector3(...mesh.vertices[ends[0][1]]), 0.5)), 0, 'centred'); // prettier-ignore

  const flat = ticksInMap(solution, 0.01);
  assert.equal(flat.colours.length, 2 * colours.length, 'on both sides');
  for (let s = 0; s < flat.colours.length; s++) {
    const [p, q] = [0, 3].map((k) => new Vector3(...flat.points.slice(6 * s + k, 6 * s + k + 3)));
    near(p.distanceTo(q), 0.02, 'length');
    assert.ok(p.z > 0);
  }
  // Chains that are too short for strokes have none.
  assert.deepEqual(ticksInMap(solution, 100), { points: [], colours: [] });
});

test('markers: four corners at the cone, the selected one larger, another picture for each kind', () => {
  const markers = new ConeMarkers(true);
  const plain = { q: 4, isSelected: false, isBad: false };
  const all = [
    { at: [1, 2, 3], k: 3, ...plain },
    { at: [4, 5, 6], k: 5, ...plain },
    { at: [7, 8, 9], k: 3, ...plain, isSelected: true },
    { at: [7, 8, 0], k: 3, ...plain, isBad: true },
    { at: [1, 1, 1], k: 3, ...plain },
    { at: [2, 2, 2], k: 3, ...plain, q: 3 },
    ...Array.from({ length: 20 }, (_, i) => ({ at: [0, 0, i], k: 6 + i, ...plain })),
  ];
  markers.show(all);
  assert.equal(markers.visible, true);
  const [faint, clear] = markers.children;
  assert.equal(faint.geometry, clear.geometry);
  assert.ok(faint.renderOrder < clear.renderOrder, 'what is hidden comes first');
  assert.deepEqual(
    [faint, clear].map(({ material }) => material.depthTest),
    [false, true],
  );
  near(faint.material.uniforms.opacity.value, 0.2 * clear.material.uniforms.opacity.value, 'faint'); // prettier-ignore
  const [position, corner, look] = ['position', 'corner', 'look'].map((name) => clear.geometry.getAttribute(name)); // prettier-ignore
  assert.equal(position.count, 4 * all.length);
  const pictures = all.map(({ at }, m) => {
    const seen = [0, 1, 2, 3].map((c) => {
      assert.deepEqual([...position.array.subarray(3 * (4 * m + c), 3 * (4 * m + c) + 3)], at);
      return [...corner.array.subarray(2 * (4 * m + c), 2 * (4 * m + c) + 2)];
    });
    assert.deepEqual(seen, [[-1, -1], [1, -1], [1, 1], [-1, 1]]); // prettier-ignore
    const looks = [0, 1, 2, 3].map((c) => [...look.array.subarray(3 * (4 * m + c), 3 * (4 * m + c) + 3)]); // prettier-ignore
    for (const one of looks) assert.deepEqual(one, looks[0]);
    const [column, row, size] = looks[0];
    assert.equal(size, all[m].isSelected ? 1.25 : 1);
    assert.ok(column >= 0 && column < 16 && row >= 0 && row < 16);
    return `${column} ${row}`;
  });
  assert.equal(pictures[0], pictures[4], 'the same kind has the same picture');
  assert.equal(new Set(pictures).size, all.length - 1, 'every other kind another one');
  const index = [...clear.geometry.index.array];
  for (let m = 0; m < all.length; m++) assert.deepEqual([...new Set(index.slice(6 * m, 6 * m + 6))].sort((a, b) => a - b), [0, 1, 2, 3].map((c) => 4 * m + c)); // prettier-ignore
  markers.setStyle(2, 0.5);
  near(clear.material.uniforms.pixels.value, 60, 'size');
  near(clear.material.uniforms.opacity.value, 0.5, 'opacity');
  markers.setLift(0.3);
  near(faint.material.uniforms.lift.value, 0.3, 'lift');
  const flat = new ConeMarkers(false);
  assert.equal(flat.children.length, 1);
  near(flat.children[0].material.uniforms.opacity.value, 1, 'all are clear');
  flat.show([]);
  assert.equal(flat.visible, false);
});

test('markers: a triangle up for less than a full turn, down for more, a disk for a full one', () => {
  const shapeFor = (k) => {
    const before = drawn.length;
    new ConeMarkers(true).show([{ at: [0, 0, 0], k, q: 64, isSelected: false, isBad: false }]);
    const calls = drawn.slice(before).filter(([name]) => name === 'arc' || name === 'lineTo');
    return [calls.map(([name]) => name).join(' '), calls[0][2]];
  };
  const triangle = 'lineTo lineTo lineTo';
  const [[below, top], [above, bottom], [full]] = [53, 75, 64].map(shapeFor);
  assert.deepEqual([below, above, full], [triangle, triangle, 'arc']);
  // Canvases count downwards: the first corner is the tip.
  assert.ok(top < 0 && bottom > 0);
});

test('markers: a rim and a dark line around all; around the selected one the line is on top', () => {
  const strokesOf = (isSelected) => {
    const before = drawn.length;
    new ConeMarkers(true).show([{ at: [0, 0, 0], k: 41, q: 50, isSelected, isBad: false }]);
    return drawn
      .slice(before)
      .map(([name]) => name)
      .filter((name) => name === 'stroke' || name === 'fill');
  };
  assert.deepEqual(strokesOf(false), ['stroke', 'stroke', 'fill']);
  assert.deepEqual(strokesOf(true), ['stroke', 'fill', 'stroke']);
});

test('quads: a bend of 20 degrees is smooth, one of 60 is sharp', () => {
  for (const [degrees, isSharp] of [
    [20, false],
    [60, true],
  ]) {
    const [x, z] = [Math.cos, Math.sin].map((f) => f((degrees / 180) * Math.PI));
    const p = [-1, 0, 0, 0, 0, 0, x, 0, z, -1, 1, 0, 0, 1, 0, x, 1, z];
    const shape = {
      positions: Float64Array.from(p),
      quads: Uint32Array.of(0, 1, 4, 3, 1, 2, 5, 4),
    };
    const view = new QuadsView({ elements: [1, 0, 0, 0, 1, 0, 0, 0, 1] });
    view.show(shape, new Matrix4().elements, { paper: new Color(), ink: new Color(), second: new Color() }); // prettier-ignore
    const normal = view.children[0].geometry.getAttribute('normal').array;
    const tilt = (c) => (Math.asin(-normal[3 * c]) * 180) / Math.PI;
    // Halves are the corners 0 1 2 and 0 2 3 of each quad; the quads share an edge.
    for (const c of [0, 3, 5]) near(tilt(c), 0, `${degrees}: far from the bend`);
    for (const c of [7, 8, 10]) near(tilt(c), degrees, `${degrees}: far from the bend`);
    for (const [one, other] of [
      [1, 6],
      [2, 11],
      [4, 11],
    ]) {
      if (isSharp)
        [[one, 0], [other, degrees]].forEach(([c, at]) => near(tilt(c), at, 'flat')); // prettier-ignore
      else near(tilt(one), tilt(other), 'smooth');
      assert.ok(isSharp || (tilt(one) > 0 && tilt(one) < degrees));
    }
  }
});

test('quads: two triangles each, every edge once, folded ones pink, markers where not four edges meet', () => {
  // A box of six quads, one of them with a corner turned over.
  const p = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1, (i >> 1) & 1, i >> 2]);
  const quads = Uint32Array.from([0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]); // prettier-ignore
  const palette = { paper: new Color(), ink: new Color('#123'), second: new Color() };
  const view = new QuadsView({ elements: [1, 0, 0, 0, 1, 0, 0, 0, 1] });
  assert.equal(view.visible, false);
  const matrix = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 0, 0, 1];
  const shape = { positions: Float64Array.from(p), quads };
  view.show(shape, matrix, palette);
  assert.equal(view.visible, true);
  assert.deepEqual(view.matrix.elements, matrix);
  const [faces, edges, markers] = view.children;
  const [position, normal, tint] = ['position', 'normal', 'tint'].map((name) => faces.geometry.getAttribute(name)); // prettier-ignore
  assert.equal(position.count, 36);
  for (let c = 0; c < 36; c++) {
    const at = [...position.array.subarray(3 * c, 3 * c + 3)];
    const n = [...normal.array.subarray(3 * c, 3 * c + 3)];
    near(Math.hypot(...n), 1, 'normal');
    // Faces of a box are flat, and their normals point away from its centre.
    const axis = n.findIndex((x) => Math.abs(x) > 0.999);
    assert.ok((at[axis] - 0.5) * n[axis] > 0, `corner ${c}`);
    const [first] = [...position.array.subarray(18 * Math.floor(c / 6), 18 * Math.floor(c / 6) + 3)].slice(axis); // prettier-ignore
    assert.equal(at[axis], first, `corner ${c}: its face is across its normal`);
    assert.equal(tint.array[4 * c + 3], 0, 'nothing is folded');
  }
  const area = (c) => {
    const [a, b, d] = [c, c + 1, c + 2].map((i) => new Vector3().fromArray(position.array, 3 * i));
    return b.sub(a).cross(d.sub(a)).length() / 2;
  };
  near(
    [...Array(12).keys()].reduce((sum, t) => sum + area(3 * t), 0),
    6,
    'area of the box',
  );
  const sides = segmentsOf(edges);
  assert.equal(sides.length, 12, 'every edge once');
  for (const { a, b } of sides) near(Math.hypot(...a.map((x, i) => x - b[i])), 1, 'an edge');
  assert.equal(markers.children[0].geometry.getAttribute('position').count, 32, 'eight markers');
  const places = new Set([...Array(8).keys()].map((m) => [...markers.children[0].geometry.getAttribute('position').array.subarray(12 * m, 12 * m + 3)].join())); // prettier-ignore
  assert.equal(places.size, 8);
  const bent = { positions: Float64Array.from(p), quads: Uint32Array.from([0, 2, 3, 1]) };
  bent.positions.set([1.4, 1.4, 0], 0); // beyond the opposite corner
  view.show(bent, matrix, palette);
  assert.equal(faces.geometry.getAttribute('tint').array[3], 255, 'folded');
  view.show(undefined, matrix, palette);
  assert.equal(view.visible, false);
});

test('the map under the hand takes the place of the stored one, and leaves it as it was', () => {
  for (const isFlat of [false, true]) {
    const geometry = new BufferGeometry();
    const uvNow = new BufferAttribute(new Float32Array(2 * corners), 2);
    geometry.setAttribute('uv', uvNow);
    const positionNow = new BufferAttribute(new Float32Array(3 * corners).fill(9), 3);
    geometry.setAttribute('position', positionNow);
    const live = new LiveGeometry(isFlat);
    assert.equal(live.isShown, false);
    const cornerUv = Float32Array.from({ length: 2 * corners }, (_, i) => i);
    const heat = Float32Array.from({ length: surface.vertexCount }, (_, v) => (v === 0 ? NaN : v % 2 ? 1 : -1)); // prettier-ignore
    const none = new Float32Array(0);
    const map = { state: 'certified', cornerUv, heat: none, notPositive: new Uint32Array(0) };
    live.show(geometry, map, surface);
    assert.equal(live.isShown, true);
    assert.deepEqual(geometry.getAttribute('uv').array, cornerUv);
    assert.notEqual(geometry.getAttribute('uv').array, cornerUv, 'a copy');
    const flat = geometry.getAttribute('position');
    assert.equal(flat === positionNow, !isFlat);
    if (isFlat)
      for (let c = 0; c < corners; c++) assert.deepEqual([flat.getX(c), flat.getY(c), flat.getZ(c)], [2 * c, 2 * c + 1, 0]); // prettier-ignore
    if (isFlat) assert.equal(flat, geometry.getAttribute('uv'), 'one buffer for both');
    const tint = () => geometry.getAttribute('tint').array;
    assert.ok(
      tint().every((x) => x === 0),
      'nothing over a map that passes',
    );
    // The next frame goes into the same buffers.
    const [own, before] = [geometry.getAttribute('uv'), geometry.getAttribute('uv').version];
    live.show(geometry, { ...map, state: 'fails', cornerUv: cornerUv.map((x) => -x), notPositive: Uint32Array.from([1]) }, surface); // prettier-ignore
    assert.equal(geometry.getAttribute('uv'), own);
    assert.ok(own.version > before && own.array[1] === -1);
    for (let c = 0; c < corners; c++) assert.equal(tint()[4 * c + 3] > 0, c >= 3 && c < 6, 'folded ones alone'); // prettier-ignore
    // Where there is no map, the scale: larger and smaller have different colours, and the unknown is in the middle.
    live.show(geometry, { ...map, state: 'heat', heat }, surface);
    const colours = new Map();
    for (let t = 0; t < corners / 3; t++) {
      const sum = [0, 1, 2].reduce((all, k) => all + heat[surface.triangles[3 * t + k]], 0);
      const colour = [...tint().subarray(12 * t, 12 * t + 4)];
      assert.ok(colour[3] > 0);
      const key = Number.isNaN(sum) ? 0 : Math.sign(Math.round(3 * sum));
      colours.set(key, [...(colours.get(key) ?? []), colour[0] - colour[2]]);
    }
    assert.ok(Math.min(...colours.get(1)) > 0 && Math.max(...colours.get(-1)) < 0);
    assert.ok(colours.get(0).every((x) => Math.abs(x) < 30));
    live.show(geometry);
    assert.equal(live.isShown, false);
    assert.equal(geometry.getAttribute('uv'), uvNow);
    assert.equal(geometry.getAttribute('position'), positionNow);
    assert.equal(geometry.getAttribute('tint'), undefined);
  }
});

test('geometries share what stays, and take colours of their own size only', () => {
  const cornerUv = new Float32Array(2 * corners).fill(0.5);
  const before = surfaceGeometry(surface);
  const { position, normal } = before.attributes;
  const plain = surfaceGeometry(surface, undefined, before);
  assert.deepEqual([plain.attributes.position, plain.attributes.normal], [position, normal]);
  assert.deepEqual(before.attributes, {}, 'what is taken is not disposed of with it');
  const mapped = surfaceGeometry(surface, { cornerUv });
  assert.equal(plain.getAttribute('uv'), undefined);
  assert.equal(mapped.getAttribute('uv').array, cornerUv);
  near(plain.boundingSphere.radius, surface.radius, 'sphere');
  const colours = new Uint8Array(4 * corners).fill(7);
  setTint(plain, colours.subarray(4));
  assert.equal(plain.getAttribute('tint'), undefined, 'colours of another model');
  setTint(plain, colours);
  const tint = plain.getAttribute('tint');
  assert.equal(tint.normalized, true);
  const { version } = tint;
  setTint(plain, colours.map(() => 9)); // prettier-ignore
  assert.equal(plain.getAttribute('tint'), tint);
  assert.ok(tint.version > version && tint.array[5] === 9);
  const box = { x: -1, y: 2, width: 4, height: 3 };
  const flat = flatGeometry({ cornerUv, box });
  assert.equal(flat.getAttribute('position'), flat.getAttribute('uv'), 'one buffer for both');
  assert.equal(flat.getAttribute('position').array, cornerUv);
  assert.equal(flat.getAttribute('position').getZ(3), 0);
  assert.deepEqual(flat.boundingSphere.center.toArray(), [1, 3.5, 0]);
  near(flat.boundingSphere.radius, 2.5, 'half the diagonal');
});

test('no tree for picking is built at once of more than ten thousand triangles', () => {
  for (const [triangles, isBuilt] of [[10_000, true], [10_001, false]]) {
    const flat = new BufferAttribute(new Float32Array(6 * triangles), 2);
    const solid = new BufferAttribute(new Float32Array(9 * triangles), 3);
    for (const position of [flat, solid]) assert.equal(bvhAtOnce(new BufferGeometry().setAttribute('position', position)) !== undefined, isBuilt); // prettier-ignore
    const places = new Float64Array(9);
    assert.equal(bvhAtOnce(pickGeometry({ places, triangles: new Uint32Array(3 * triangles) })) !== undefined, isBuilt); // prettier-ignore
  }
}); // prettier-ignore

test('positions and normals of corners are made only for the card, slice by slice', () => {
  const { position, normal } = surfaceGeometry(surface).attributes;
  for (const { array, count } of [position, normal]) assert.deepEqual([array.length, count], [0, corners]); // prettier-ignore
  const whole = (attribute, bytesAtOnce) => {
    const { byteLength, slice } = gatheredFor(attribute.array);
    const bytes = new Uint8Array(byteLength);
    for (let done = 0; done < byteLength;) {
      const piece = slice(done, bytesAtOnce);
      assert.ok(piece.length > 0 && piece.length <= bytesAtOnce);
      bytes.set(piece, done);
      done += piece.length;
    }
    return bytes.buffer;
  };
  for (const bytesAtOnce of [12, 100, 10 ** 6]) {
    const at = new Float32Array(whole(position, bytesAtOnce));
    const normals = new Int8Array(whole(normal, bytesAtOnce));
    surface.triangles.forEach((v, c) => {
      assert.deepEqual([...at.subarray(3 * c, 3 * c + 3)], mesh.vertices[v].map(Math.fround));
      const own = surface.creaseCorners.indexOf(c);
      const [from, i] = own < 0 ? [surface.packedNormals, v] : [surface.creaseNormals, own];
      assert.deepEqual(normals.slice(4 * c, 4 * c + 4), from.slice(4 * i, 4 * i + 4));
    });
  }
});

test('a large geometry is left out of the frame that makes its buffers, and drawn in the next', () => {
  for (const [count, isLarge] of [
    [300_000, false],
    [400_000, true],
  ]) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * count), 3));
    const one = new Mesh(geometry);
    drawWhenUploaded(one);
    assert.equal(geometry.drawRange.count, isLarge ? 0 : Infinity);
    one.onAfterRender();
    assert.equal(geometry.drawRange.count, Infinity);
  }
});

test('a mesh that no node uses is neither drawn beside others nor framed nor picked', () => {
  const part = (index, x, isPlaced) => {
    const geometry = flatTriangle();
    const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }));
    const cornerPositions = geometry.getAttribute('position').array;
    const matrices = [new Matrix4().makeTranslation(x, 0, 0).elements];
    return { mesh: index, isPlaced, cornerPositions, cornerNormals: new Int8Array(12), tree, matrices }; // prettier-ignore
  };
  const parts = [part(0, 0, true), part(1, 10, true), part(2, 20, false)];
  near(Math.max(...shapeOf(parts).places), 11, 'how far the scene goes');
  const scene = new WholeScene(new Matrix3());
  const palette = { paper: new Color(), ink: new Color(), second: new Color() };
  const shown = () => scene.children.filter((one) => one.visible).map((one) => one.userData.mesh);
  const show = (open) => scene.show({ parts, open, maps: new Map(), isOwnShown: false, palette });
  const under = (x) => scene.pick(new Ray(new Vector3(x + 0.2, 0.2, 5), new Vector3(0, 0, -1)), Infinity); // prettier-ignore
  show(0);
  assert.deepEqual(shown(), [1], 'the open one is drawn by the view');
  assert.deepEqual([0, 10, 20].map(under), [-1, 1, -1]);
  show(2);
  assert.deepEqual(shown(), [0, 1]);
  assert.deepEqual([0, 10, 20].map(under), [0, 1, -1]);
  // The same of its materials, but for the open one, which the view shows or not.
  const own = new Map(parts.map(({ mesh: index }) => [index, [{ visible: false, quiet: { value: 0 }, paper: { value: palette.paper } }]])); // prettier-ignore
  show(0);
  scene.setOwn(own);
  assert.deepEqual([...own.values()].map(([one]) => one.visible), [false, true, false]); // prettier-ignore
  const [open, beside] = [own.get(0)[0], own.get(1)[0]].map(({ quiet }) => quiet.value);
  assert.ok(open === 0 && beside > 0.1 && beside < 0.5, `a hint of what is not open: ${beside}`);
});

test('places are outlined where they are, and the first one is looked at', () => {
  const open = { triangles: Uint32Array.from([0, 1, 2, 0, 2, 3]), vertexCount: 4 };
  const of = (...where) => highlightTargets(where, open);
  assert.deepEqual(of({ kind: 'triangle', id: 1 }), { triangles: [1], edges: [], uvEdges: [], first: 0, text: 'triangle 1' }); // prettier-ignore
  assert.deepEqual(of({ kind: 'vertex', id: 2 }).triangles, [0, 1]);
  assert.deepEqual(of({ kind: 'vertex', id: 3 }).triangles, [1]);
  assert.equal(of({ kind: 'vertex', id: 3 }).first, 3);
  assert.deepEqual(of({ kind: 'vertex', id: 4 }).triangles, [], 'no such vertex');
  const edges = of({ kind: 'edge', id: 2, other: 0 });
  assert.deepEqual([edges.edges, edges.first, edges.text], [[[2, 0]], 2, 'edge 2–0']);
  const loop = of({ kind: 'loop', id: 0, other: 1 });
  assert.deepEqual(loop.edges, [[1, 2], [2, 3], [3, 0], [0, 1]]); // prettier-ignore
  assert.equal(loop.first, 1);
  assert.match(loop.text, /boundary 1/);
  assert.deepEqual(of({ kind: 'loop', id: 0, other: 9 }).edges, []);
  // Of several places the first counts, whatever it is, and also where it is the first vertex.
  for (const here of [3, 0]) {
    const kinds = [{ kind: 'vertex', id: here }, { kind: 'edge', id: here, other: 2 }, { kind: 'loop', id: 0, other: here }]; // prettier-ignore
    if (here === 0) kinds.push({ kind: 'triangle', id: 1 });
    const elsewhere = [{ kind: 'vertex', id: 1 }, { kind: 'edge', id: 1, other: 2 }, { kind: 'loop', id: 0, other: 1 }]; // prettier-ignore
    for (const one of kinds) for (const other of elsewhere) assert.equal(of(one, other).first, here, `${one.kind}, ${other.kind}`); // prettier-ignore
  }
  const second = { triangles: Uint32Array.from([1, 2, 3]), vertexCount: 4 };
  for (const kind of ['vertex', 'loop']) assert.equal(highlightTargets([{ kind, id: 0, other: 0 }, { kind: 'triangle', id: 0 }], second).first, 0); // prettier-ignore
  // Both sides of a seam are outlined in the map, whichever way round its ends are named.
  const seams = [{ a: [4, 5], b: [6, 7], r: 1 }];
  const seamAt = new Map([[0 * 4 + 2, 0]]);
  for (const [id, other] of [[0, 2], [2, 0]]) // prettier-ignore
    assert.deepEqual(highlightTargets([{ kind: 'edge', id, other }], open, { seams, seamAt }).uvEdges, [[4, 5], [6, 7]]); // prettier-ignore
  assert.deepEqual(highlightTargets([{ kind: 'edge', id: 1, other: 2 }], open, { seams, seamAt }).uvEdges, []); // prettier-ignore
});

test('marks on a surface: outlines of triangles, the ring of the cursor, features, and what is hidden when', () => {
  const marks = new SurfaceMarks();
  const [wire, crosses, features, seams, ticks, handles, light, cursor] = marks.children;
  assert.equal(marks.highlight(surface, [], []), false, 'nothing was outlined');
  assert.equal(marks.highlight(surface, [2, 10 ** 6], [[0, 9]]), true);
  const sides = segmentsOf(light).map(({ a, b }) => [a, b]);
  const [a, b, c] = surface.triangles.subarray(6, 9);
  const expected = [[a, b], [b, c], [c, a], [0, 9]].map((side) => side.map(place)); // prettier-ignore
  assert.deepEqual(sides, expected);
  assert.equal(marks.highlight(surface, [], []), true, 'the outline is gone');
  assert.equal(light.visible, false);

  marks.highlight(surface, Array(2500).fill(2), [[0, 9]]);
  assert.equal(segmentsOf(light).length, 3 * 2000 + 1, 'of very many triangles 2000');
  marks.highlight(surface, [], []);

  marks.setCursor(surface, 5);
  const ring = segmentsOf(cursor);
  const around = surface.neighbours.subarray(surface.neighbourStart[5], surface.neighbourStart[6]);
  assert.equal(ring.length, around.length);
  ring.forEach((segment, i) => {
    assert.deepEqual(segment.a, place(5));
    segment.b.forEach((x, k) => near(x, 0.6 * mesh.vertices[around[i]][k] + 0.4 * mesh.vertices[5][k], 'towards it')); // prettier-ignore
  });
  marks.setCursor(surface, -1);
  assert.equal(cursor.visible, false);

  marks.setFeatures(surface, [[0, 9]]);
  assert.deepEqual(segmentsOf(features), [{ a: place(0), b: place(9), tint: undefined }]);
  const loops = [Float32Array.from({ length: 12 }, (_, i) => i), new Float32Array(6).fill(2)];
  marks.setHandles(loops);
  const tints = segmentsOf(handles).map(({ tint }) => tint);
  assert.equal(tints.length, 3);
  assert.deepEqual(tints[0], tints[1]);
  assert.notDeepEqual(tints[1], tints[2], 'each loop has its colour');

  const geometry = surfaceGeometry(surface);
  const palette = { ink: new Color('#222') };
  const aligned = (isIt) => ({
    ...solution,
    result: { ...solution.result, certificate: { integerSeams: isIt ? 3 : 0, seamEdges: 3 }, report: { components: [{ grid: { aligned: isIt } }] } }, // prettier-ignore
  });
  const look = { pattern: 'cross', seams: 'auto', hasWire: true };
  marks.setCrosses(new Float32Array(6), palette);
  marks.setLook(look, palette, { surface, solution: aligned(false), geometry });
  assert.deepEqual([wire, crosses, seams, ticks].map((one) => one.visible), [true, true, true, true]); // prettier-ignore
  marks.setLook(look, palette, { surface, solution: aligned(true), geometry });
  assert.deepEqual([seams.visible, ticks.visible], [false, false], 'lines meet at every seam');
  marks.setLook({ ...look, seams: 'on', hasWire: false, pattern: 'grid' }, palette, { surface, solution: aligned(true), geometry }); // prettier-ignore
  assert.deepEqual(
    [wire, crosses, seams].map((one) => one.visible),
    [false, false, true],
  );
  marks.setLook({ ...look, seams: 'off' }, palette, { surface, solution: aligned(false), geometry }); // prettier-ignore
  assert.equal(seams.visible, false);
  marks.setCursor(surface, 5);
  marks.hide(false);
  assert.deepEqual(
    [wire, crosses, seams, light].some((one) => one.visible),
    false,
  );
  assert.deepEqual(
    [cursor, handles, features].map((one) => one.visible),
    [true, true, true],
  );
  marks.hide(true);
  assert.deepEqual(
    [cursor, handles, features].map((one) => one.visible),
    [false, false, false],
  );
});

function orbitIn(width, height) {
  const camera = new PerspectiveCamera(32, width / height, 0.01, 100);
  let changes = 0;
  const canvas = new Canvas();
  const orbit = new Orbit(camera, canvas, () => (changes += 1));
  return { camera, orbit, canvas, changes: () => changes };
}
const shape = () => ({ center: new Vector3(...surface.center), radius: surface.radius, places: surface.places }); // prettier-ignore
/** The box of the picture that points fill, from −1 to 1. */
function seenBox(camera, places) {
  camera.updateMatrixWorld(true);
  const all = [];
  for (let i = 0; i < places.length; i += 3) all.push(new Vector3(places[i], places[i + 1], places[i + 2]).project(camera)); // prettier-ignore
  const of = (key) => [Math.min(...all.map((p) => p[key])), Math.max(...all.map((p) => p[key]))];
  return { x: of('x'), y: of('y'), z: of('z') };
}

test('framing fills the narrower side of the picture up to the margin, centred, in every shape of window', () => {
  for (const [width, height] of [
    [900, 900],
    [1600, 700],
    [400, 900],
  ]) {
    // prettier-ignore
    for (const offset of [0, 1000]) {
      const { camera, orbit, changes } = orbitIn(width, height);
      const places = surface.places.map((x) => x + offset);
      orbit.frame({ center: new Vector3(...surface.center).addScalar(offset), radius: surface.radius, places }); // prettier-ignore
      const { x, y, z } = seenBox(camera, places);
      const most = Math.max(x[1] - x[0], y[1] - y[0]) / 2;
      assert.ok(most > 0.78 && most <= 0.95, `${width} × ${height}: ${most}`);
      near((x[0] + x[1]) / 2, 0, 'centred across', 0.03);
      near((y[0] + y[1]) / 2, 0, 'centred up', 0.03);
      assert.ok(z[0] > -1 && z[1] < 1, 'nothing is cut off');
      const from = camera.position.clone().sub(orbit.controls.target).normalize();
      assert.ok(from.z > 0.5 && from.x > 0.2 && from.y > 0.2, 'three quarters from the front');
      assert.ok(changes() >= 0);
    }
  }
});

test('the camera: the address brings it back; parallel keeps the size; moves are undone by their opposites', () => {
  const { camera, orbit } = orbitIn(800, 600);
  orbit.frame(shape());
  const start = orbit.toText();
  const size = () => {
    const { y } = seenBox(camera, surface.places);
    return y[1] - y[0];
  };
  const before = size();
  assert.equal(orbit.isParallel, false);
  near(orbit.lift, 0.003, 'lift');
  orbit.toggleParallel();
  assert.equal(orbit.isParallel, true);
  near(size(), before, 'apparent size', 0.15);
  assert.ok(orbit.lift < 0.0002 && orbit.lift > 0, 'the same depth from farther away');
  orbit.toggleParallel();
  near(size(), before, 'as before', 1e-3);
  orbit.move(0.3, 0.2, 1.5);
  const moved = orbit.toText();
  assert.notEqual(moved, start);
  orbit.move(-0.3, -0.2, 1 / 1.5);
  const numbers = (text) => text.split(',').map(Number);
  numbers(orbit.toText()).forEach((x, i) => near(x, numbers(start)[i], 'back', 2e-3));
  orbit.move(0.1, 0);
  const around = camera.position.clone().sub(orbit.controls.target);
  orbit.move(0, 99);
  assert.ok(camera.position.clone().sub(orbit.controls.target).y < 0 && around.y > 0, 'from below');
  orbit.fromText(moved);
  numbers(orbit.toText()).forEach((x, i) => near(x, numbers(moved)[i], 'of the address', 1e-3));
  for (const bad of ['1,2,3', '1,2,3,4,5,x', '']) orbit.fromText(bad);
  numbers(orbit.toText()).forEach((x, i) => near(x, numbers(moved)[i], 'nothing else', 1e-3));
  camera.updateMatrixWorld(true); // as every picture does
  orbit.pan(0.25, 0);
  camera.updateMatrixWorld(true);
  const [, , , tx, ty, tz] = numbers(moved);
  const at = new Vector3(tx, ty, tz).project(camera);
  near(at.x, (-0.5 * 600) / 800, 'a quarter of the height to the left', 1e-2);
  near(at.y, 0, 'not up', 1e-2);
  orbit.reset();
  numbers(orbit.toText()).forEach((x, i) => near(x, numbers(start)[i], 'reset', 2e-3));
});

test('a view that the user has not moved fits again when its shape changes; one that was moved stays', () => {
  const { camera, orbit } = orbitIn(900, 900);
  orbit.frame(shape());
  const text = orbit.toText();
  camera.aspect = 0.4;
  orbit.reshaped();
  assert.notEqual(orbit.toText(), text, 'farther away, as it is narrow');
  orbit.move(0.1, 0);
  const moved = orbit.toText();
  camera.aspect = 2;
  orbit.reshaped();
  assert.equal(orbit.toText(), moved);
  orbit.frame(shape());
  const framed = orbit.toText();
  camera.aspect = 0.4;
  orbit.reshaped();
  assert.notEqual(orbit.toText(), framed, 'a new model counts anew');
  // A part of the whole: the camera stays until it is asked to fit.
  const part = { center: new Vector3(...mesh.vertices[0]), radius: 0.1, places: mesh.vertices[0] };
  const there = orbit.toText();
  orbit.workOn(part);
  assert.equal(orbit.toText(), there);
  orbit.fit();
  near(orbit.controls.target.distanceTo(part.center), 0, 'at the part', 1e-3);
  orbit.reset();
  near(orbit.controls.target.distanceTo(new Vector3(...surface.center)), 0, 'at the whole', 0.1);
});

test('a place that is looked at is in the middle and towards the viewer', () => {
  const { camera, orbit } = orbitIn(800, 600);
  orbit.frame(shape());
  for (const v of [0, 1, 2, 3, 4, 5, 6, 7]) {
    const [point, normal] = [mesh.vertices[v], mesh.vertices[v]].map((x) => new Vector3(...x));
    orbit.lookAt(point, normal.normalize());
    camera.updateMatrixWorld(true);
    const at = point.clone().project(camera);
    near(at.x, 0, 'middle', 1e-3);
    near(at.y, 0, 'middle', 1e-3);
    assert.ok(normal.dot(camera.position.clone().sub(point).normalize()) > 0.1, `vertex ${v}`);
  }
});

test('a place that is shown leaves the view where it is if it is well in it, and is else in the middle', () => {
  const { camera, orbit } = orbitIn(800, 600);
  orbit.frame(shape());
  const target = orbit.controls.target.clone();
  const distance = camera.position.distanceTo(target);
  for (const v of [0, 1, 2, 3, 4, 5, 6, 7]) {
    const [point, normal] = [mesh.vertices[v], mesh.vertices[v]].map((x) => new Vector3(...x));
    orbit.lookAt(point, normal.normalize(), undefined, false);
    camera.updateMatrixWorld(true);
    const at = point.clone().project(camera);
    assert.ok(Math.hypot(at.x * camera.aspect, at.y) < 0.81, `vertex ${v} at ${at.x}, ${at.y}`);
    near(orbit.controls.target.distanceTo(target), 0, 'the model stays in the middle', 1e-9);
    near(camera.position.distanceTo(target) / distance, 1, 'as far away', 1e-9);
    assert.ok(normal.dot(camera.position.clone().sub(point).normalize()) > 0.1, `vertex ${v}`);
  }
  // Where it is hidden on all ways that leave the view alone, and where it is outside, it comes into the middle.
  const [point, normal] = [new Vector3(...mesh.vertices[0]), new Vector3(...mesh.vertices[0])];
  for (const [far, isHidden] of [
    [point, () => true],
    [point.clone().multiplyScalar(5), undefined],
  ]) {
    // prettier-ignore
    orbit.lookAt(far, normal, isHidden, false);
    near(orbit.controls.target.distanceTo(far), 0, 'in the middle', 1e-6);
    orbit.frame(shape());
  }
});

test('a place that is hidden is looked at from a side where it is seen, if there is one', () => {
  const { camera, orbit } = orbitIn(800, 600);
  orbit.frame(shape());
  const [point, normal] = [new Vector3(0, 0, 0.5), new Vector3(0, 0, 1)];
  const at = () => camera.position.clone().sub(orbit.controls.target).normalize();
  orbit.lookAt(point, normal);
  const plain = at();
  // A wall before the place hides it from half of the sides.
  const isWallBefore = (back) => back.dot(plain) > 0.9 * back.length();
  orbit.lookAt(point, normal, isWallBefore);
  assert.ok(!isWallBefore(at()) && at().dot(normal) > 0.3, at().toArray().join());
  orbit.lookAt(point, normal, () => true);
  assert.ok(Number.isFinite(at().x), 'hidden from everywhere');
  // Eight sides around any normal, all in front of the place.
  for (const up of [
    [1, 1, 1],
    [0, 1, 0],
    [0, 0, 1],
    [-1, 0, 0],
  ]) {
    const [sides, facing] = [new Set(), new Vector3(...up).normalize()];
    const note = (back) => !sides.add(back.clone().normalize().toArray().map((x) => x.toFixed(3)).join()); // prettier-ignore
    orbit.lookAt(point, facing, (back) => (assert.ok(back.dot(facing) > 0), note(back), true));
    assert.ok(sides.size >= 9, `${up}: ${sides.size}`);
  }
  // What hides: nearer than the camera, and not the triangles around the place itself.
  const rays = [];
  const hit = (distance) =>
    hiding(point, (ray) => (rays.push(ray), distance))(new Vector3(0, 0, 4));
  assert.deepEqual([hit(undefined), hit(5), hit(2)], [false, false, true]);
  assert.ok(rays[0].origin.z > point.z && rays[0].origin.z < 1);
  near(rays[0].direction.z, 1, 'towards the camera');
  const upTo = point.z + 4 - rays[0].origin.z;
  assert.deepEqual([hit(upTo - 1e-6), hit(upTo + 1e-6)], [true, false], 'up to the camera');
});

test('lines on the surface are between one and six pixels wide, what is outlined the widest', () => {
  const ofQuads = new QuadsView(new Matrix3()).children[1].material.uniforms.width.value;
  assert.ok(ofQuads >= 1 && ofQuads <= 3, `${ofQuads}`);
  const widths = new SurfaceMarks().children.filter((one) => one instanceof Lines).map(({ material }) => material.uniforms.width.value); // prettier-ignore
  const light = widths.at(-2);
  for (const width of widths) assert.ok(width >= 1 && width <= 6 && width <= light, `${width}`);
});

test('an image of the user repeats in both directions, in its colours, blurred by distance only; the one before is freed', () => {
  const material = surfaceMaterial(true);
  const { image } = material.uniforms;
  const freed = [];
  const pictures = [3, 5].map((width) => {
    image.value.addEventListener('dispose', ({ target }) => freed.push(target.image.width));
    setImage(material, { width, height: 1 });
    const { wrapS, wrapT, colorSpace, generateMipmaps, minFilter, anisotropy, version } = image.value; // prettier-ignore
    assert.deepEqual([wrapS, wrapT, colorSpace], [RepeatWrapping, RepeatWrapping, SRGBColorSpace]);
    assert.deepEqual([generateMipmaps, minFilter], [true, LinearMipmapLinearFilter]);
    assert.ok(anisotropy > 1 && version > 0, 'sharp where the surface is seen at an angle; uploaded');
    return image.value.image.width;
  });
  assert.deepEqual([pictures, freed], [[3, 5], [1, 3]]); // prettier-ignore
}); // prettier-ignore

test('what warms shaders up has one object of each kind that its view draws, the ground only where there is one', () => {
  for (const isLit of [false, true]) {
    const kinds = oneOfEach(isLit).map((one) => one.constructor.name);
    assert.deepEqual([...new Set(kinds)], ['Mesh', 'Lines', 'Wire', 'ConeMarkers', ...(isLit ? ['ContactShadow'] : [])]); // prettier-ignore
    const [bare, mapped] = oneOfEach(isLit);
    assert.deepEqual([bare.material.defines.PATTERN, mapped.material.defines.PATTERN > 0], [0, true]); // prettier-ignore
    assert.equal(bare.geometry.getAttribute('normal') !== undefined, isLit);
    for (const one of oneOfEach(isLit)) assert.equal(one.visible, true, 'what is hidden warms nothing up'); // prettier-ignore
  }
});
