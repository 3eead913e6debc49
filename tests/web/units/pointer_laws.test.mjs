// Laws of mouse, pen and touch on both views: what a click, a drag and a hover do, and what they leave as it was. The views
// are those of the page on a graphics card that draws nothing.

import assert from 'node:assert/strict';
import test from 'node:test';
import { withCanvases } from './canvases.mjs';
import { faceOf, mesh } from './cube_view.mjs';
import { besideInMap, center, inMap, isInFront, onModel, opened, surface, uvOf } from './pointed_page.mjs'; // prettier-ignore

const isOutlined = (view) => view.scene.children[6].visible;

test('hovering the map names the vertex at the pointer inside a chart, and at its edge the seam, outlined on both sides', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest });
    const { solution, ui, hover, uv } = page;
    const { seamAt, seams, result } = solution;
    const lit = [];
    const { highlight } = uv;
    uv.highlight = (...all) => (lit.push(all), highlight.apply(uv, all));
    const onRim = [];
    for (let t = 0; t < mesh.triangles.length; t += 5) {
      const corner = (c) => uvOf(page, result.cornerToUv[c]);
      await hover(uv, inMap(page, center(t, corner)));
      const sides = [0, 1, 2].map((k) => [0, 1].map((end) => mesh.triangles[t][(k + end) % 3]));
      const own = sides.map(([v, w]) => seamAt.get(Math.min(v, w) * surface.vertexCount + Math.max(v, w))); // prettier-ignore
      const seam = own.find((one) => one !== undefined);
      const [triangles, edges] = lit.pop();
      assert.deepEqual(triangles, [t]);
      if (seam === undefined) {
        assert.match(ui.hover, /\d+ · valence [3-8] · curvature /);
        assert.ok(mesh.triangles[t].includes(Number(ui.hover.match(/v (\d+)/)[1])));
        assert.equal(edges.length, 0);
      } else {
        onRim.push(faceOf(t));
        const { a, b, r } = seams[seam];
        assert.deepEqual(edges, [a, b]);
        assert.ok(ui.hover.startsWith(`Seam: turns by ${r}·360°/4 = ${90 * r}°, shifts by (`), ui.hover); // prettier-ignore
      }
    }
    assert.equal(new Set(onRim).size, 6, 'seams of all charts');
    page.doc.look = { ...page.doc.look, seams: 'off' };
    const [, t] = [...Array(mesh.triangles.length).keys()];
    await hover(
      uv,
      inMap(
        page,
        center(t, (c) => uvOf(page, result.cornerToUv[c])),
      ),
    );
    assert.match(ui.hover, /valence/, 'seams that are not shown are not told');
    await hover(uv, [3, 3]);
    assert.equal(ui.hover, '', 'beside the map');
    assert.deepEqual([isOutlined(uv), isOutlined(page.model)], [false, false]);
  }));

test('the shift of a seam takes the points of one side to those of the other', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest });
    const { solution, ui, hover, uv } = page;
    // A side that is the other one turned and moved, by halves and by whole numbers.
    for (const [r, dx, dy, text] of [
      [0, 2, -3, '(2, −3)'],
      [1, 0.25, 4, '(0.250, 4.00)'],
      [2, 1, 1, '(1, 1)'],
      [3, 0, -1, '(0, −1)'],
    ]) {
      // prettier-ignore
      const t = mesh.triangles.findIndex((_, i) => i > 40 * r && [0, 1, 2].some((k) => seamOf(page, i, k) !== undefined)); // prettier-ignore
      const place = inMap(
        page,
        center(t, (c) => uvOf(page, solution.result.cornerToUv[c])),
      );
      const seam = [0, 1, 2].map((k) => seamOf(page, t, k)).find((one) => one !== undefined);
      const one = solution.seams[seam];
      const [x, y] = uvOf(page, one.a[0]);
      const [turnedX, turnedY] = [
        [x, y],
        [-y, x],
        [-x, -y],
        [y, -x],
      ][r];
      const kept = solution.result.uv;
      solution.result.uv = kept.slice();
      solution.result.uv.set([turnedX + dx, turnedY + dy], 2 * one.b[0]);
      const before = one.r;
      one.r = r;
      await hover(uv, [3, 3]);
      await hover(uv, place);
      assert.ok(ui.hover.endsWith(`shifts by ${text}`), ui.hover);
      one.r = before;
      solution.result.uv = kept;
    }
  }));
function seamOf({ solution }, t, k) {
  const [v, w] = [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]];
  return solution.seamAt.get(Math.min(v, w) * surface.vertexCount + Math.max(v, w));
}

test('a click places one cone near the pointer, a second one there selects it; elsewhere nothing happens', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false });
    const { doc, model, click } = page;
    const seen = mesh.vertices.map((_, v) => v).filter((v) => isInFront(page, v));
    for (const v of seen.filter((_, i) => i % 6 === 0)) {
      const count = doc.prescription.cones.length;
      const isTaken = doc.prescription.cones.some(({ vertex }) => vertex === v);
      await click(model, onModel(page, v), { altKey: true });
      const { cones } = doc.prescription;
      assert.equal(cones.length, count + (isTaken ? 0 : 1));
      assert.equal(cones[doc.selected].vertex, v);
      await click(model, onModel(page, v), { altKey: true });
      assert.equal(doc.prescription.cones, cones, 'selected, not placed again');
      assert.equal(cones[doc.selected].vertex, v);
    }
    const { prescription } = doc;
    const [x, y] = onModel(page, seen[1]);
    page.point(model, 'pointerdown', [x - 40, y], { buttons: 1 });
    page.point(model, 'pointermove', [x, y], { buttons: 1 });
    page.point(model, 'pointerup', [x, y]);
    page.point(page.uv, 'pointerdown', [x, y], { buttons: 1 });
    page.point(model, 'pointerup', [x, y]);
    await page.settle();
    assert.equal(doc.prescription, prescription, 'a drag, and a press elsewhere, are no click');
    await click(model, [2, 2]);
    await click(model, onModel(page, seen[1]), { button: 2 });
    await click(model, onModel(page, seen[1]), { isPrimary: false });
    assert.equal(doc.prescription, prescription);
    page.ui.tool = 'orbit';
    await click(model, [2, 2]);
    assert.deepEqual([doc.prescription, doc.selected], [prescription, -1], 'nothing is selected');
    await click(model, onModel(page, prescription.cones[0].vertex));
    assert.equal(doc.selected, 0, 'selected with any tool');
  }));

test('a cone follows the pointer as one step of undo, on both views; the camera stands still meanwhile', () =>
  withCanvases(async ({ rest }) => {
    for (const name of ['model', 'uv']) {
      const page = opened({ rest, cones: [{ vertex: 1, k: 3 }, { vertex: 7, k: 3 }] }); // prettier-ignore
      const { doc, point, settle } = page;
      const view = page[name];
      const controls = name === 'model' ? view.orbit.controls : view.controls;
      const at = (v) => (name === 'model' ? onModel(page, v) : besideInMap(page, v));
      const start = doc.prescription;
      const path = mesh.vertices.map((_, v) => v).filter((v) => v > 8 && isInFront(page, v));
      point(view, 'pointerdown', at(7), { buttons: 1 });
      assert.equal(controls.enabled, false);
      const [x, y] = at(7);
      point(view, 'pointermove', [x + 1, y], { buttons: 1 });
      await settle();
      assert.equal(doc.prescription, start, 'a hand that trembles');
      for (const v of [path[0], path[9], path[4]]) {
        point(view, 'pointermove', at(v), { buttons: 1 });
        await settle();
        assert.deepEqual(doc.prescription.cones, [start.cones[0], { vertex: v, k: 3 }]);
        assert.equal(doc.selected, 1);
        assert.equal(controls.enabled, false);
      }
      point(view, 'pointermove', [1, 1], { buttons: 1 });
      await settle();
      assert.equal(doc.prescription.cones[1].vertex, path[4], 'beside the model it stays');
      point(view, 'pointerup', at(path[4]));
      await settle();
      assert.equal(controls.enabled, true);
      assert.equal(doc.prescription.cones[1].vertex, path[4]);
      point(view, 'pointermove', at(path[9]));
      await settle();
      assert.equal(doc.prescription.cones[1].vertex, path[4], 'released');
      doc.history = doc.history.undo();
      assert.equal(doc.prescription, start, 'one step');
    }
  }));

test('a drag that is taken back, or ends elsewhere, leaves the cone where it was and the controls on', () =>
  withCanvases(async ({ rest }) => {
    for (const end of ['stopDrag', 'pointercancel']) {
      const page = opened({ rest, cones: [{ vertex: 7, k: 3 }] });
      const { doc, ui, model, point, settle } = page;
      const start = doc.prescription;
      assert.equal(ui.stopDrag(), false, 'nothing is dragged');
      point(model, 'pointerdown', onModel(page, 7), { buttons: 1 });
      assert.equal(ui.stopDrag(), false, 'it was only pressed');
      const v = mesh.vertices.findIndex((_, i) => i > 12 && isInFront(page, i));
      point(model, 'pointermove', onModel(page, v), { buttons: 1 });
      await settle();
      assert.equal(doc.prescription.cones[0].vertex, v);
      if (end === 'stopDrag') {
        assert.equal(ui.stopDrag(), true);
        await settle();
        assert.deepEqual(doc.prescription.cones, start.cones);
        assert.equal(ui.stopDrag(), false, 'once');
      } else point(model, end, [0, 0]);
      await settle();
      assert.deepEqual([model.orbit.controls.enabled, page.uv.controls.enabled], [true, true]);
      assert.equal(ui.holdsCone, false);
      const now = doc.prescription;
      point(model, 'pointermove', onModel(page, 7), { buttons: 1 });
      await settle();
      assert.equal(doc.prescription, now, 'nothing is dragged any more');
    }
  }));

test('a finger that rests places a cone; one that moves or is lifted early does not', (t) =>
  withCanvases(async ({ rest }) => {
    t.mock.timers.enable({ apis: ['setTimeout'] });
    const page = opened({ rest, hasMap: false, tool: 'orbit' });
    const { doc, model, point, settle } = page;
    const v = mesh.vertices.findIndex((_, i) => i > 12 && isInFront(page, i));
    const touch = { pointerType: 'touch' };
    const at = onModel(page, v);
    const count = () => doc.prescription.cones.length;
    point(model, 'pointerdown', at, { buttons: 1, ...touch });
    t.mock.timers.tick(150);
    await settle();
    assert.equal(count(), 0, 'a tap');
    t.mock.timers.tick(850);
    await settle();
    assert.equal(count(), 1);
    point(model, 'pointerup', at, touch);
    await settle();
    assert.deepEqual([count(), doc.selected], [1, 0], 'lifting it is no tap any more');
    const other = onModel(
      page,
      mesh.vertices.findLastIndex((_, i) => isInFront(page, i)),
    );
    for (const leave of [
      () => point(model, 'pointerup', other, touch),
      () => point(model, 'pointercancel', other, touch),
      () => point(model, 'pointermove', [other[0] + 30, other[1]], { buttons: 1, ...touch }),
    ]) {
      point(model, 'pointerdown', other, { buttons: 1, ...touch });
      leave();
      t.mock.timers.tick(1000);
      await settle();
      assert.equal(count(), 1);
      point(model, 'pointercancel', other, touch);
    }
    model.orbit.move(0, 0, 0.5);
    rest();
    let far = { pixels: 0 };
    for (let px = 200; px < 400; px += 10) {
      const hit = model.pick({ clientX: 20 + px, clientY: 210 });
      if (hit?.pixels > far.pixels) far = { ...hit, px };
    }
    assert.ok(far.pixels > 62, `${far.pixels} pixels from every vertex`);
    point(model, 'pointerdown', [far.px, 200], { buttons: 1, ...touch });
    t.mock.timers.tick(1000);
    await settle();
    assert.equal(count(), 1, 'far from every vertex');
    point(model, 'pointerdown', other, { buttons: 1 });
    t.mock.timers.tick(1000);
    assert.equal(count(), 1, 'a mouse is no finger');
    point(model, 'pointerup', [2, 2]);
  }));

test('with the tool for cones the pointer shows the cone that a click would place, and none where one is', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false });
    const { doc, ui, model, uv, hover, click, point, settle } = page;
    const ghost = model.scene.children[6];
    const v = mesh.vertices.findIndex((_, i) => i > 12 && isInFront(page, i));
    const at = onModel(page, v);
    await hover(model, at, { altKey: true });
    assert.equal(ghost.visible, true);
    assert.match(ui.hover, new RegExp(`^v ${v} · valence ${surface.valence[v]} `));
    const [{ geometry }] = ghost.children;
    assert.deepEqual([...geometry.getAttribute('position').array.subarray(0, 3)], mesh.vertices[v].map(Math.fround)); // prettier-ignore
    const shown = Number(model.canvas.dataset.ghost);
    await click(model, at, { altKey: true });
    assert.deepEqual(doc.prescription.cones, [{ vertex: v, k: shown }], 'and it is the one');
    await hover(model, at, { altKey: true });
    assert.equal(ghost.visible, false);
    assert.ok(ui.hover.startsWith('Cone 1 · v'), ui.hover);
    ui.tool = 'orbit';
    const w = mesh.vertices.findLastIndex((_, i) => isInFront(page, i));
    await hover(model, onModel(page, w));
    assert.equal(ghost.visible, false);
    assert.ok(ui.hover.startsWith('v '));
    ui.tool = 'place';
    await hover(model, onModel(page, w), { altKey: true });
    assert.equal(ghost.visible, true);
    point(model, 'pointerleave', [0, 0]);
    await settle();
    assert.deepEqual([ghost.visible, ui.hover], [false, '']);
    await hover(model, onModel(page, w), { pointerType: 'touch' });
    assert.equal(ui.hover, '', 'a finger does not hover');
    doc.job = { kind: 'run' };
    await hover(model, onModel(page, w));
    assert.equal(ui.hover, '', 'not during a run');
    doc.job = undefined;
    await hover(uv, [300, 200]);
    assert.equal(ui.hover, '', 'no map');
  }));
