// Laws of the UV view: what is in the picture after it is fitted, moved and resized, what is under a pointer, where
// cones and outlines are. The map is that of a cube in six charts.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Vector3 } from 'three';
import { ConeMarkers } from '../../../web/src/views/cone_markers.ts';
import { flatCrosses } from '../../../web/src/services/geometry/cross_lines.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { withCanvases } from './canvases.mjs';
import { cubeSolution, look, mesh } from './cube_view.mjs';
import { ends, inWindow, near, palette, segments, solution, surface, viewOf } from './map_view.mjs'; // prettier-ignore

const { uv, cornerToUv, uvToVertex } = solution.result;
const plain = { q: 4, cones: [], turnings: [], handles: [] };

const placesOf = (markers) => {
  const [{ geometry }] = markers.children;
  const { array, count } = geometry.getAttribute('position');
  return Array.from({ length: count / 4 }, (_, m) => [...array.subarray(12 * m, 12 * m + 3)]);
};

test('a new map fills the narrower side of the picture and is in its middle, in every shape of window', () =>
  withCanvases(({ rest, resized }) => {
    for (const size of [[600, 400], [300, 700], [1200, 100]]) {
      const { view, canvas, drawn } = viewOf(rest, { size });
      const check = () => {
        const [left, right, bottom, top] = ends(view);
        const { x, y, width, height } = solution.box;
        near((left + right) / 2, x + width / 2, 'across');
        near((bottom + top) / 2, y + height / 2, 'up');
        near(Math.max(width / (right - left), height / (top - bottom)), 1 / 1.1, 'with a margin');
        near((right - left) / (top - bottom), canvas.clientWidth / canvas.clientHeight, 'square pixels'); // prettier-ignore
      };
      check();
      Object.assign(canvas, { clientWidth: 500, clientHeight: 450 });
      resized(canvas);
      rest();
      check();
      view.zoom(0.5);
      const before = ends(view);
      Object.assign(canvas, { clientWidth: 600 });
      resized(canvas);
      rest();
      const after = ends(view);
      for (const i of [2, 3]) near(after[i], before[i], 'what the user has chosen stays');
      view.fit();
      drawn();
      check();
    }
    const flat = viewOf(rest, { of: cubeSolution(surface, { box: { x: 2, y: 3, width: 0, height: 0 } }) }); // prettier-ignore
    near(ends(flat.view)[3] - ends(flat.view)[2], 1.2, 'a map without a size');
  })); // prettier-ignore

test('panning and zooming are undone by their opposites and go by shares of the height', () =>
  withCanvases(({ rest }) => {
    const { view, drawn } = viewOf(rest);
    let told;
    view.onScale = (pixels) => (told = pixels);
    drawn();
    const start = ends(view);
    const high = start[3] - start[2];
    near(told, 400 / high, 'pixels per unit');
    view.pan(0.25, -0.5);
    [0.25, 0.25, -0.5, -0.5].forEach((part, i) => near(ends(view)[i], start[i] + part * high, 'panned')); // prettier-ignore
    view.pan(-0.25, 0.5);
    view.zoom(0.4);
    drawn();
    near(ends(view)[3] - ends(view)[2], 0.4 * high, 'nearer');
    near(told, 1000 / high, 'pixels per unit');
    view.zoom(1 / 0.4);
    ends(view).forEach((x, i) => near(x, start[i], 'back'));
    const place = inWindow(view, 3, 0.5);
    view.centre(place);
    const now = ends(view);
    near((now[0] + now[1]) / 2, 3, 'in the middle');
    near((now[2] + now[3]) / 2, 0.5, 'in the middle');
    near(now[3] - now[2], high / 2, 'twice as large');
    // Every one of them is a movement of the user: another shape of the window does not fit anew.
    for (const move of [() => view.pan(0.1, 0), () => view.zoom(0.9), () => view.centre(place)]) {
      view.fit();
      move();
      const moved = ends(view)[3];
      view.onResize(640, 400);
      near(ends(view)[3], moved, 'stays');
      view.onResize(600, 400);
    }
  }));

test('a pointer finds the triangle of the map that it is in, and its nearest corner with the distance in pixels', () =>
  withCanvases(({ rest }) => {
    const random = randomFrom(4);
    const { view } = viewOf(rest);
    for (let i = 0; i < 120; i++) {
      if (i === 60) view.centre(inWindow(view, 5, 1));
      const t = Math.floor(random() * mesh.triangles.length);
      const ends = [0, 1, 2].map((k) => cornerToUv[3 * t + k]);
      const weights = [0, 1, 2].map(() => 0.1 + random());
      const sum = weights[0] + weights[1] + weights[2];
      const [x, y] = [0, 1].map((k) => ends.reduce((all, end, j) => all + (weights[j] / sum) * uv[2 * end + k], 0)); // prettier-ignore
      const place = inWindow(view, x, y);
      const far = ends.map((end) => {
        const at = inWindow(view, uv[2 * end], uv[2 * end + 1]);
        return Math.hypot(at.clientX - place.clientX, at.clientY - place.clientY);
      });
      const hit = view.pick(place);
      assert.equal(hit.triangle, t);
      near(hit.pixels, Math.min(...far), 'distance', 1e-3);
      near(far[ends.findIndex((end) => uvToVertex[end] === hit.vertex)], hit.pixels, 'corner', 1e-3); // prettier-ignore
    }
    assert.equal(view.pick(inWindow(view, 1.3, -5)), undefined, 'beside the map');
    view.setModel(surface, undefined);
    assert.equal(view.pick(inWindow(view, 5, 1)), undefined);
  }));

test('under the hand a pointer finds the triangles where the map that is shown has them, and afterwards where they were', () =>
  withCanvases(({ rest }) => {
    const { view } = viewOf(rest);
    const triangles = [...mesh.triangles.keys()].filter((t) => t % 7 === 0);
    /** The middle of each triangle of a map of corners. */
    const finds = (corners, what) => {
      for (const t of triangles) {
        const [x, y] = [0, 1].map((k) => (corners[6 * t + k] + corners[6 * t + 2 + k] + corners[6 * t + 4 + k]) / 3); // prettier-ignore
        assert.equal(view.pick(inWindow(view, x, y))?.triangle, t, what);
      }
    };
    const maps = [[1, 40, -9], [-3, 0, 2], [0.2, -70, 70]].map(([scale, x, y]) => solution.cornerUv.map((z, c) => scale * z + (c % 2 ? y : x))); // prettier-ignore
    for (const isLooked of [false, true]) {
      if (isLooked) finds(solution.cornerUv, 'stored');
      for (const cornerUv of maps) {
        view.setLive({ state: 'certified', cornerUv, heat: [], notPositive: new Uint32Array(0) });
        finds(cornerUv, 'under the hand');
      }
      view.setLive(undefined);
      finds(solution.cornerUv, 'stored again');
    }
  }));

test('a cone is marked at each of its images in the map, and under the hand where its map has it', () =>
  withCanvases(({ rest }) => {
    const { view, markers } = viewOf(rest);
    const cones = [{ vertex: 0, k: 3 }, { vertex: 30, k: 5 }]; // prettier-ignore
    view.setCones({ ...plain, cones }, [false, true], 1);
    const images = (at) => [...uvToVertex.keys()].filter((i) => at.includes(uvToVertex[i]));
    const expected = images([0, 30]).map((i) => [uv[2 * i], uv[2 * i + 1]].map(Math.fround).join());
    const seen = () => placesOf(markers).map(([x, y]) => `${x},${y}`);
    assert.deepEqual(seen().sort(), expected.sort());
    for (const [, , z] of placesOf(markers)) assert.ok(z > 0, 'above the map');
    // Small, and translucent, as one cone has several images; in the 3D view they are neither.
    const { pixels, opacity } = markers.children[0].material.uniforms;
    const usual = new ConeMarkers(false).children[0].material.uniforms;
    assert.ok(pixels.value > 0 && pixels.value < usual.pixels.value);
    assert.ok(opacity.value > 0.5 && opacity.value < 1 && usual.opacity.value === 1);
    assert.ok(images([0]).length === 3, 'three faces meet at a corner');
    const sizes = () => {
      const look = markers.children[0].geometry.getAttribute('look').array;
      return seen().map((_, m) => look[12 * m + 2]);
    };
    const at30 = images([30]).length;
    assert.equal(sizes().filter((size) => size > 1).length, at30, 'the selected one is larger');
    const cornerUv = solution.cornerUv.map((x) => x + 1);
    view.setLive({ state: 'certified', cornerUv, heat: [], notPositive: new Uint32Array(0) });
    view.setCones({ ...plain, cones }, [], -1);
    const moved = images([0, 30]).map((i) => [uv[2 * i], uv[2 * i + 1]].map((x) => Math.fround(Math.fround(x) + 1)).join()); // prettier-ignore
    assert.deepEqual(seen().sort(), moved.sort());
    view.setLive(undefined);
    view.setCones({ ...plain, cones: [{ vertex: 999, k: 3 }] }, [], -1);
    assert.equal(markers.visible, false, 'a vertex that the map does not have');
    view.setCones({ ...plain, cones }, [], -1);
    view.setModel(surface, undefined);
    assert.equal(markers.visible, false);
    view.setCones({ ...plain, cones }, [], -1);
    assert.equal(markers.visible, false, 'no map, no cones');
  }));

test('outlines are the sides of triangles and the edges that are given, above the map', () =>
  withCanvases(({ rest }) => {
    const { view, light } = viewOf(rest);
    assert.equal(light.visible, false);
    view.highlight([3, 10 ** 6], [[1, 2]]);
    assert.equal(light.visible, true);
    const [a, b, c] = cornerToUv.subarray(9, 12);
    const at = (i) => [uv[2 * i], uv[2 * i + 1]].map(Math.fround);
    const expected = [[a, b], [b, c], [c, a], [1, 2]].map((side) => side.map(at)); // prettier-ignore
    assert.deepEqual(segments(light), expected);
    for (const name of ['from', 'to']) assert.ok(light.geometry.getAttribute(name).array[2] > 0);
    rest();
    view.highlight([], []);
    assert.equal(light.visible, false);
    assert.equal(rest(), 1, 'the picture without it');
    view.highlight([]);
    assert.equal(rest(), 0, 'nothing was outlined');
    view.highlight([], [[1, 2]]);
    assert.equal(segments(light).length, 1);
    view.highlight(Array.from({ length: 10 ** 4 }, () => 0));
    assert.ok(segments(light).length <= 6000, 'not more than can be seen');
    view.setModel(surface, cubeSolution(surface));
    assert.equal(light.visible, false, 'those of another map are gone');
    view.setModel(surface, undefined);
    view.highlight([3]);
    assert.equal(light.visible, false);
  }));

test('what is drawn above the map is above it, the more the later it is drawn, and markers above all', () =>
  withCanvases(({ rest }) => {
    const { view, seams, ticks, crosses, light, markers } = viewOf(rest);
    const samples = [{ triangle: 3, s: 0.3, r: 0.3 }];
    view.setCrosses(flatCrosses({ samples, cornerUv: solution.cornerUv, arm: 0.1, q: 4 }), palette);
    view.highlight([3], [[1, 2]]);
    view.setCones({ ...plain, cones: [{ vertex: 0, k: 3 }] }, [], -1);
    /** The height of all that one of them draws. */
    const heightOf = ({ geometry }) => {
      const all = ['from', 'to'].flatMap((name) => [...geometry.getAttribute(name).array].filter((_, i) => i % 3 === 2)); // prettier-ignore
      assert.equal(new Set(all).size, 1, 'flat');
      return all[0];
    };
    const [[, , marked]] = placesOf(markers);
    const heights = [seams, crosses, light].map(heightOf);
    for (const [i, z] of [...heights, marked].entries()) assert.ok(z > (i > 0 ? heights[i - 1] : 0) && z <= 0.0101, `${heights} ${marked}`); // prettier-ignore
    const strokes = heightOf(ticks);
    assert.ok(strokes > heights[0] && strokes < heights[2], `${strokes}`);
    // All of it is in the picture from far and near.
    for (const z of [0, marked]) {
      const { z: depth } = new Vector3(0, 0, z).project(view.camera);
      assert.ok(Math.abs(depth) < 0.9, `${depth}`);
    }
  }));

test('lines are shown as the look says; another map hides them all until they are made', () =>
  withCanvases(({ rest }) => {
    const { view, square, mapped, wire, crosses, seams, ticks } = viewOf(rest);
    const lines = { seams, ticks, wire, crosses, square };
    const shown = () => Object.keys(lines).filter((name) => lines[name].visible).join(' '); // prettier-ignore
    const setLook = (more, isStale = false) => view.setLook({ ...look, ...more }, 4, isStale, palette); // prettier-ignore
    assert.equal(shown(), 'seams ticks');
    assert.equal(segments(seams).length, 2 * solution.seams.length, 'both sides');
    setLook({ seams: 'off' });
    assert.equal(shown(), '');
    setLook({ seams: 'auto', hasWire: true });
    assert.equal(shown(), 'seams ticks wire');
    setLook({ pattern: 'cross' });
    view.setCrosses(new Float32Array(6).fill(0.5), palette);
    assert.equal(shown(), 'seams ticks crosses');
    setLook({ pattern: 'cross' });
    assert.equal(shown(), 'seams ticks crosses', 'they stay with their pattern');
    setLook({});
    assert.equal(shown(), 'seams ticks');
    const { uniforms } = mapped.material;
    assert.deepEqual([uniforms.dim.value, uniforms.q.value, uniforms.lit.value], [0, 4, 0]);
    setLook({}, true);
    assert.ok(uniforms.dim.value > 0.3 && uniforms.dim.value < 1, 'of earlier cones');
    assert.equal(uniforms.paper.value, palette.paper);
    near(uniforms.scale.value * 2 * surface.diagonal, 24, 'tiles along the diagonal, where lengths are doubled'); // prettier-ignore
    const image = { width: 2, height: 2 };
    const before = uniforms.image.value;
    setLook({ pattern: 'image', image });
    const texture = uniforms.image.value;
    assert.notEqual(texture, before);
    setLook({ pattern: 'image', image });
    assert.equal(uniforms.image.value, texture, 'uploaded once');
    view.setCrosses(new Float32Array(6), palette);
    view.setModel(surface, cubeSolution(surface, { output: { scale: 'fit' } }));
    assert.equal(shown(), '');
    setLook({});
    assert.equal(shown(), 'seams ticks square', 'the unit square where the map is to fit it');
    for (const [a, b] of segments(square)) near(Math.hypot(a[0] - b[0], a[1] - b[1]), 1, 'its side'); // prettier-ignore
    assert.equal(segments(square).length, 4);
    assert.equal(new Set(segments(square).flat().map(String)).size, 4);
    assert.equal(mapped.visible, true);
    view.setModel(surface, undefined);
    assert.deepEqual([mapped.visible, shown()], [false, '']);
    setLook({});
    assert.equal(shown(), '');
  }));

test('under the hand the view rests as long as the whole map is in it; a map that is dropped leaves it there', () =>
  withCanvases(({ rest }) => {
    const { view, seams, ticks } = viewOf(rest);
    const live = (cornerUv) => ({ state: 'certified', cornerUv, heat: [], notPositive: new Uint32Array(0) }); // prettier-ignore
    const start = ends(view);
    const stays = (what) => ends(view).forEach((x, i) => near(x, start[i], what));
    view.setLive(live(solution.cornerUv.map((x) => 0.99 * x)));
    stays('inside');
    assert.deepEqual([seams.visible, ticks.visible], [false, false]);
    // A step out of the picture on any of its sides: it fits anew.
    const [left, right, bottom, top] = start;
    for (const [i, at] of [
      [0, left - 0.1],
      [0, right + 0.1],
      [1, bottom - 0.1],
      [1, top + 0.1],
    ]) {
      // prettier-ignore
      view.setLive(live(solution.cornerUv.map((x, c) => (c === i ? at : x))));
      const now = ends(view);
      assert.ok(at > now[2 * i] && at < now[2 * i + 1], `${at} is in ${now}`);
      view.setLive(undefined);
      stays('the stored map again');
    }
    view.zoom(0.5);
    const chosen = ends(view);
    view.setLive(live(solution.cornerUv.map((x) => 9 * x)));
    ends(view).forEach((x, i) => near(x, chosen[i], 'what the user has chosen stays'));
    view.setLive(undefined);
    ends(view).forEach((x, i) => near(x, chosen[i], 'what the user has chosen stays'));
    const wide = { x: 0, y: 0, width: 90, height: 1 };
    view.setModel(surface, cubeSolution(surface, { box: wide, isDragged: true }));
    ends(view).forEach((x, i) => near(x, chosen[i], 'as the hand has left it'));
    view.setModel(surface, cubeSolution(surface, { box: wide }));
    assert.ok(ends(view)[1] > 90, 'a map of a run is fitted');
    rest();
    view.setLive(undefined);
    assert.equal(rest(), 0, 'nothing was under the hand');
  }));

/** A gesture on a canvas: moves are seen by its document. */
function gesture({ canvas }, type, { clientX, clientY }, more = {}) {
  const event = new Event(type, { cancelable: true });
  const about = { clientX, clientY, pageX: clientX, pageY: clientY, pointerId: 1, pointerType: 'mouse', button: 0, ctrlKey: false, metaKey: false, shiftKey: false, deltaMode: 0, deltaY: 0, ...more }; // prettier-ignore
  for (const [key, value] of Object.entries(about)) Object.defineProperty(event, key, { value });
  const isMove = type === 'pointermove' || type === 'pointerup';
  (isMove ? canvas.ownerDocument : canvas).dispatchEvent(event);
}

test('what is under the pointer stays under it while the map is dragged or zoomed, and nothing turns the map', () =>
  withCanvases(({ rest }) => {
    const { view, drawn } = viewOf(rest);
    const under = (place) => {
      const { x, y } = view.pointer(place);
      const at = new Vector3(x, y, 0).unproject(view.camera);
      return [at.x, at.y];
    };
    const from = { clientX: 200, clientY: 150 };
    const to = { clientX: 330, clientY: 90 };
    for (const key of [{}, { shiftKey: true }, { ctrlKey: true }, { button: 2 }]) {
      view.fit();
      drawn();
      const before = under(from);
      gesture(view, 'pointerdown', from, key);
      gesture(view, 'pointermove', to, key);
      gesture(view, 'pointerup', to, key);
      drawn();
      const down = view.camera.getWorldDirection(new Vector3());
      near(down.z, -1, 'from above', 1e-9);
      if (!key.shiftKey && !key.ctrlKey) under(to).forEach((x, i) => near(x, before[i], 'dragged', 1e-3)); // prettier-ignore
    }
    view.fit();
    drawn();
    for (const deltaY of [-120, -120, 240]) {
      const [before, high] = [under(from), ends(view)[3] - ends(view)[2]];
      gesture(view, 'wheel', from, { deltaY });
      drawn();
      under(from).forEach((x, i) => near(x, before[i], 'zoomed', 1e-2));
      assert.equal(ends(view)[3] - ends(view)[2] < high, deltaY < 0);
    }
    // A view that was moved by hand stays where it is.
    const chosen = ends(view)[3];
    view.onResize(640, 400);
    near(ends(view)[3], chosen, 'stays');
  }));

test('the same map once more changes nothing; strokes are as long on a tall map as on a wide one', () =>
  withCanvases(({ rest }) => {
    const { view } = viewOf(rest);
    view.zoom(0.3);
    rest();
    const before = ends(view);
    view.setModel(surface, solution);
    assert.deepEqual([ends(view), rest()], [before, 0]);
    const { box } = solution;
    const lengths = [
      [box.width, box.height],
      [box.height, box.width],
    ].map(([width, height]) => {
      // prettier-ignore
      const { ticks } = viewOf(rest, { of: cubeSolution(surface, { box: { ...box, width, height } }) }); // prettier-ignore
      return segments(ticks).map(([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]));
    });
    assert.ok(lengths[0].length > 10);
    for (const one of lengths.flat()) near(one, 0.024 * box.width, 'a stroke');
  }));
