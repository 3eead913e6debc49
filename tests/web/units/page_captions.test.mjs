// What stands beside the pictures: the legend of colours, the length of a bar, how a pattern continues at seams, the meshes.

import assert from 'node:assert/strict';
import test from 'node:test';
import { signal } from '@preact/signals-core';
import { isTurnedBy } from '../../../web/src/model/grid.ts';
import { overlayColours } from '../../../web/src/services/geometry/overlay_colours.ts';
import { thumbnailSize } from '../../../web/src/services/geometry/thumbnail.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { $, $$, drawn, skip, textOf } from './whole_page.mjs';

const random = randomFrom(5);

/** A panel of an application that has only what is given. */
async function panelOf(t, name, { doc = {}, ui = {}, views }) {
  const state = signal({ doc, ui });
  const app = { get doc() { return state.value.doc; }, get ui() { return state.value.ui; }, views }; // prettier-ignore
  const panel = document.createElement(name);
  panel.app = app;
  document.body.replaceChildren(panel);
  t.after(() => panel.remove());
  await drawn();
  const set = async (next) => {
    state.value = { ...state.value, ...next };
    await drawn();
  };
  return { panel, set };
}

const quantiles = (p99) => ({ min: 0, p5: 0.1, median: 0.2, p95: 0.3, p99, max: 99 });

test(
  'the legend names the values that have the first, the middle and the last colour',
  { skip },
  async (t) => {
    const { panel, set } = await panelOf(t, 'hgp-legend', {});
    const triangles = Uint32Array.of(0, 1, 2);
    for (let i = 0; i < 25; i++) {
      const size = 10 ** (3 * random() - 2);
      const distortion = { stretch: quantiles(1 + size), areaSize: quantiles(size), seamDistance: quantiles(size), flipped: Uint32Array.from({ length: i % 3 }, (_, f) => f) }; // prettier-ignore
      /** The colours of one triangle. */
      const colour = (overlay, x) => {
        const one = Float32Array.of(x);
        const values = { stretch: one, area: one, areaSize: one, seamDistance: new Float32Array(3).fill(x), flipped: new Uint32Array(0) }; // prettier-ignore
        return [...overlayColours(overlay, values, distortion, triangles).subarray(0, 3)];
      };
      const near = (a, b, what) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) <= 12, `${what}: ${a} and ${b}`)); // prettier-ignore
      const number = (text) => Number(text.replace(/[^\d.e-]/g, ''));
      const shown = async (overlay) => {
        await set({ doc: { displayed: { distortion }, look: { overlay } } });
        return { title: textOf($('b', panel)), kind: $('i', panel)?.className, ends: $$('.ends span', panel).map(textOf) }; // prettier-ignore
      };
      for (const [overlay, first] of [
        ['angle', 1],
        ['seams', 0],
      ]) {
        // prettier-ignore
        const { kind, ends } = await shown(overlay);
        assert.equal(kind, 'sequential');
        assert.equal(number(ends[0]), first);
        const [low, middle, high] = ends.map(number);
        // Written in few digits, the ends of a short range differ a little.
        if (size < 0.1 && overlay === 'angle') continue;
        near(colour(overlay, high), colour(overlay, high * 100), `${overlay} ends at ${high}`);
        near(colour(overlay, low), colour(overlay, -1), `${overlay} begins at ${low}`);
        near(colour(overlay, middle), [125, 124, 120], `${overlay} is half at ${middle}`);
        assert.notDeepEqual(colour(overlay, 0.85 * high + 0.15 * low), colour(overlay, high));
      }
      const { kind, ends } = await shown('area');
      assert.equal(kind, 'diverging');
      assert.ok(/^÷/.test(ends[0]) && ends[1] === '1' && /^×/.test(ends[2]), `${ends}`);
      const factor = number(ends[2]);
      assert.equal(number(ends[0]), factor);
      assert.ok(Math.abs(factor / 2 ** size - 1) < 0.05, `${factor}, not ${2 ** size}`);
      await shown('flips');
      const count = distortion.flipped.length;
      assert.match(textOf($('span', panel)), count === 0 ? /^none/ : new RegExp(`^${count}\\b`));
      await shown('none');
      assert.equal(textOf(panel), '');
    }
    await set({ doc: { displayed: undefined, look: { overlay: 'angle' } } });
    assert.equal(textOf(panel), '');
  },
);

/** As much of a solution as alignment depends on. */
const mapOf = (isAligned, more = {}) => ({
  result: { certificate: { integerSeams: isAligned ? 2 : 1, seamEdges: 2 }, report: { components: [{ grid: { aligned: isAligned } }] }, ...more.result }, // prettier-ignore
  ...more.map,
});

test(
  'the bar under the map is as long as it says, one round number of cells or uv, and neither too long nor too short',
  { skip },
  async (t) => {
    const { panel, set } = await panelOf(t, 'hgp-map-scale', {});
    for (let i = 0; i < 80; i++) {
      const isAligned = i % 2 === 0;
      const mapScale = 10 ** (7 * random() - 3); // pixels for one unit
      await set({ doc: { displayed: mapOf(isAligned) }, ui: { mapScale } });
      const [, digits, unit] = textOf(panel).match(/^([\d.e -]+?) (cells?|uv)$/) ?? assert.fail(textOf(panel)); // prettier-ignore
      const length = Number(digits.replaceAll(/\s/g, ''));
      assert.equal(unit, isAligned ? (length === 1 ? 'cell' : 'cells') : 'uv');
      assert.match(length.toExponential(), /^[125]e/);
      const pixels = parseFloat($('i', panel).style.width);
      assert.ok(Math.abs(pixels - length * mapScale) <= 0.051, `${pixels} for ${length} at ${mapScale}`); // prettier-ignore
      assert.ok(pixels <= 110.05 && pixels > 110 / 2.51, `${pixels} pixels`);
    }
    for (const mapScale of [0, -1, NaN]) {
      await set({ ui: { mapScale } });
      assert.equal(textOf(panel), '');
    }
    await set({ doc: { displayed: undefined }, ui: { mapScale: 1 } });
    assert.equal(textOf(panel), '');
  },
);

test(
  'the note on seams: what continues, how many turn, and just those are shown',
  { skip },
  async (t) => {
    const said = [];
    const shown = [];
    const views = { model: { highlight: (_, edges) => void shown.push(edges), lookAt() {}, draw() {} }, uv: { highlight() {} } }; // prettier-ignore
    const { panel, set } = await panelOf(t, 'hgp-seam-note', { views });
    const rotations = [0, 1, 2, 3, 1, 0];
    const chains = Uint32Array.of(0, 1, 2, 3, 1, 0);
    const seams = rotations.map((r, i) => ({ r, a: [i + 1, i], b: [i, i + 1] }));
    const uvToVertex = Uint32Array.from({ length: 7 }, (_, i) => 10 - i);
    const model = { surface: { vertexCount: 11, triangles: new Uint32Array(0) } };
    const whole = (isAligned, some = seams) =>
    mapOf(isAligned, { result: { uvToVertex }, map: { seams: some, chains: some === seams ? chains : [], prescription: { q: 4 }, seamAt: new Map() } }); // prettier-ignore
    const say = async (displayed, pattern) => {
      await set({ doc: { displayed, look: { pattern }, model, say: (text) => said.push(text) } });
      return textOf(panel);
    };
    const texts = new Set();
    for (const pattern of [
      'checker',
      'grid',
      'plaid',
      'circles',
      'brick',
      'hex',
      'wood',
      'image',
      'cross',
    ]) {
      // prettier-ignore
      const turned = pattern === 'cross' ? [] : seams.filter(({ r }) => isTurnedBy(pattern, r, 4));
      const text = await say(whole(true), pattern);
      assert.equal(panel.querySelector('#show-turned') !== null, turned.length > 0, pattern);
      const count = new Set(turned.map((one) => chains[seams.indexOf(one)])).size;
      if (count > 0) assert.match(text, new RegExp(`\\b${count} of 4\\b`));
      else texts.add(text);
      if (count > 0) {
        shown.length = 0;
        panel.querySelector('#show-turned').click();
        await drawn();
        const expected = turned.map(({ a }) => a.map((end) => uvToVertex[end]));
        assert.deepEqual([shown, said.length > 0], [[expected], true]);
      }
      // Whether or not lines meet is another sentence.
      const apart = await say(whole(false), pattern);
      assert.ok(apart !== '' && !text.startsWith(apart) && panel.querySelector('button') === null);
      const none = await say(whole(true, []), pattern);
      assert.ok(none !== '' && none !== apart && none !== text);
      assert.equal(await say(whole(false, []), pattern), none);
      assert.equal(await say(undefined, pattern), '');
    }
    assert.equal(texts.size, 1, 'where nothing turns');
    for (const pattern of ['plain', 'material'])
      assert.deepEqual(
        [await say(whole(true), pattern), await say(whole(false), pattern)],
        ['', ''],
      );
  },
);

test(
  'the picture of a mesh is drawn in its own button, once for each that is made',
  { skip },
  async (t) => {
    const painted = [];
    t.mock.method(HTMLCanvasElement.prototype, 'getContext', function getContext(kind) {
      return { putImageData: ({ data, size }, x, y) => painted.push([kind, this.dataset.thumbnail, [...data.subarray(0, 2)], size, x, y]) }; // prettier-ignore
    });
    const before = globalThis.ImageData;
    globalThis.ImageData = class {
      constructor(data, size) {
        Object.assign(this, { data, size });
      }
    };
    t.after(() => (globalThis.ImageData = before));
    const surfaces = [0, 1, 2].map((index) => ({ index, name: '', triangles: 4 }));
    const model = {
      info: { surface: 1, surfaces, usable: true, defects: [] },
      loaded: { fix: {} },
    };
    const { panel, set } = await panelOf(t, 'hgp-mesh-strip', { doc: { isBusy: true } });
    const picture = (n) => new Uint8ClampedArray(4 * thumbnailSize ** 2).fill(n);
    const [a, b, c] = [1, 2, 3].map(picture);
    const show = async (...thumbnails) => {
      painted.length = 0;
      await set({ doc: { isBusy: true, model, meshes: new Map(), summaries: [], thumbnails: new Map(thumbnails) } }); // prettier-ignore
      assert.equal($$('canvas', panel).length, thumbnails.length);
      return painted.map(([kind, mesh, data, ...rest]) => {
        assert.deepEqual([kind, ...rest], ['2d', thumbnailSize, 0, 0]);
        return [Number(mesh), ...data];
      });
    };
    assert.deepEqual(await show(), []);
    assert.deepEqual(await show([2, a]), [[2, 1, 1]]);
    assert.deepEqual(await show([2, a]), [], 'it is there already');
    assert.deepEqual(await show([0, b], [2, a]), [[0, 2, 2]]);
    assert.deepEqual(await show([0, b], [2, c]), [[2, 3, 3]]);
    assert.deepEqual(await show([0, c], [2, b]), [[0, 3, 3], [2, 2, 2]]); // prettier-ignore
  },
);
