// Laws of what a pointer takes: which cone or corner is near enough, on the side of the surface that is seen.

import assert from 'node:assert/strict';
import test from 'node:test';
import { withCanvases } from './canvases.mjs';
import { mesh } from './cube_view.mjs';
import { facingOf, isInFront, onModel, opened, surface } from './pointed_page.mjs';

test('a click near a corner places the cone at the corner, unless Alt is held', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false });
    const { doc, model, click } = page;
    const seen = mesh.vertices.map((_, v) => v).filter((v) => isInFront(page, v));
    const corner = 7; // of the cube
    assert.ok(seen.includes(corner));
    const around = [...surface.neighbours.subarray(surface.neighbourStart[corner], surface.neighbourStart[corner + 1])]; // prettier-ignore
    model.orbit.move(0, 0, 5); // an edge is a few pixels long
    const from = onModel(page, corner);
    const beside = onModel(
      page,
      around.find((v) => seen.includes(v)),
    );
    // Nearer to the neighbour, and still near the corner.
    const place = [0, 1].map((i) => 0.6 * beside[i] + 0.4 * from[i]);
    await click(model, place, { altKey: true });
    assert.notEqual(doc.prescription.cones[0].vertex, corner);
    doc.begin({ ...doc.prescription, cones: [] });
    await click(model, place);
    assert.equal(doc.prescription.cones[0].vertex, corner);
  }));

test('cones that the surface turns towards the camera are taken by a click, those behind it never', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false, tool: 'orbit' });
    const { doc, model, click } = page;
    let [front, back] = [0, 0];
    for (let v = 0; v < mesh.vertices.length; v++) {
      doc.begin({ ...doc.prescription, cones: [{ vertex: v, k: 3 }] });
      doc.selected = -1;
      await click(model, onModel(page, v));
      const [least, most] = facingOf(page, v);
      if (least < 0.1 && most > -0.1) continue; // at the rim of the picture
      assert.equal(doc.selected, least > 0 ? 0 : -1, `vertex ${v}`);
      if (least > 0) front += 1;
      else back += 1;
    }
    assert.ok(front > 15 && back > 15, `${front} in front, ${back} behind`);
  }));

test('the place at which a cone is taken is a disk around it, larger for fingers; of two cones the nearer one is taken', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false, tool: 'orbit' });
    const { doc, model, click } = page;
    const v = mesh.vertices.findIndex((_, i) => facingOf(page, i)[0] > 0.55);
    doc.begin({ ...doc.prescription, cones: [{ vertex: v, k: 3 }] });
    const [x, y] = onModel(page, v);
    const reaches = [];
    for (const pointerType of ['mouse', 'pen', 'touch']) {
      const along = [];
      for (const [dx, dy] of [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
        [0.6, 0.8],
        [-0.6, -0.8],
      ]) {
        // prettier-ignore
        let far = 0;
        for (doc.selected = 0; doc.selected === 0 && far < 60; far++) {
          doc.selected = -1;
          await click(model, [x + far * dx, y + far * dy], { pointerType });
        }
        along.push(far);
      }
      assert.ok(Math.max(...along) - Math.min(...along) <= 1, `${pointerType}: ${along}`);
      reaches.push(along[0]);
    }
    assert.ok(reaches[0] >= 10 && reaches[0] < reaches[1] && reaches[1] < reaches[2] && reaches[2] < 40, `${reaches}`); // prettier-ignore
    model.orbit.move(0, 0, 3); // so that both are within reach
    const [w] = surface.neighbours.subarray(surface.neighbourStart[v]);
    for (const cones of [
      [v, w],
      [w, v],
    ]) {
      // prettier-ignore
      doc.begin({ ...doc.prescription, cones: cones.map((vertex) => ({ vertex, k: 3 })) });
      const [from, to] = cones.map((one) => onModel(page, one));
      for (const part of [0.2, 0.8]) {
        await click(
          model,
          [0, 1].map((i) => from[i] + part * (to[i] - from[i])),
        );
        assert.equal(doc.selected, part < 0.5 ? 0 : 1);
      }
    }
  }));

test('a click beside all cones selects none, with every tool that places none, whichever was selected', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false, tool: 'orbit', cones: [{ vertex: 0, k: 3 }, { vertex: 7, k: 3 }] }); // prettier-ignore
    for (const selected of [0, 1]) {
      page.doc.selected = selected;
      await page.click(page.model, [2, 2]);
      assert.equal(page.doc.selected, -1);
    }
  }));

test('the triangle under the pointer is outlined in both views, unless the tool shows what it would do instead', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest });
    const { doc, ui, model, uv, hover } = page;
    const lit = [];
    for (const [name, view] of Object.entries({ model, uv })) view.highlight = (triangles, edges) => lit.push([name, triangles, edges ?? []]); // prettier-ignore
    const place = [300, 190];
    const { triangle } = model.pick({ clientX: 20 + place[0], clientY: 10 + place[1] });
    const seen = async (tool) => {
      [ui.tool, ui.hover] = [tool, ''];
      lit.length = 0;
      await hover(model, place);
      return Object.fromEntries(lit.map(([name, triangles]) => [name, triangles]));
    };
    assert.deepEqual(await seen('orbit'), { model: [triangle], uv: [triangle] });
    assert.deepEqual(await seen('place'), { model: [], uv: [triangle] });
    const { seams, ...look } = doc.look;
    doc.look = { ...look, seams: 'off' };
    assert.deepEqual(await seen('orbit'), { model: [triangle], uv: [triangle] }, seams);
    // The tool for edges outlines the chain, and tells how long it is.
    assert.deepEqual(await seen('edges'), { model: [] });
    const [[, , chain]] = lit;
    assert.ok(chain.length > 0);
    assert.match(ui.hover, new RegExp(`these ${chain.length} edges`));
    lit.length = 0;
    await hover(model, [2, 2]);
    assert.deepEqual(lit, [['model', [], []], ['uv', [], []]]); // prettier-ignore
    assert.equal(ui.hover, '');
  }));

test('another mesh under the pointer is named and chosen by a click, the open one is not', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest });
    const { doc, ui, model, hover, point } = page;
    doc.model.info.surfaces = [{ name: 'open' }, { name: 'second' }, {}];
    const pointed = [];
    model.pointAt = (mesh) => pointed.push(mesh);
    for (const [mesh, name] of [
      [1, 'second'],
      [2, 'Mesh 2'],
    ]) {
      // prettier-ignore
      model.pickPart = () => mesh;
      await hover(model, [300, 190]);
      assert.equal(pointed.at(-1), mesh);
      assert.ok(ui.hover.startsWith(`${name}: `), ui.hover);
    }
    for (const mesh of [0, -1]) {
      model.pickPart = () => mesh;
      await hover(model, [300, 190]);
      assert.equal(pointed.at(-1), -1);
      assert.ok(ui.hover.startsWith('v ') || ui.hover.startsWith('Seam'), ui.hover);
    }
    const { cones } = doc.prescription;
    model.pickPart = () => 1;
    point(model, 'pointerdown', [300, 190], { buttons: 1 });
    point(model, 'pointerup', [300, 190]);
    await page.settle();
    assert.equal(doc.prescription.cones, cones, 'no cone is placed on what is behind');
    assert.equal(ui.hover, '');
  }));

test('a cone is taken by what is nearer to it than 18 pixels with a mouse, 22 with a pen, 28 with a finger, in either view', () =>
  withCanvases(async ({ rest }) => {
    const page = opened({ rest, hasMap: false, tool: 'orbit' });
    const { doc, model, uv, click } = page;
    doc.begin({ ...doc.prescription, cones: [{ vertex: 5, k: 3 }, { vertex: 9, k: 3 }] }); // prettier-ignore
    for (const [pointerType, reach] of [
      ['mouse', 18],
      ['pen', 22],
      ['touch', 28],
      ['other', 18],
    ])
      // prettier-ignore
      for (const pixels of [0, 1, reach - 0.25, reach, reach + 0.25, 60]) {
        const isTaken = pixels < reach;
        for (const [cone, vertex] of [[0, 5], [1, 9], [-1, 3]]) { // prettier-ignore
          uv.pick = () => ({ vertex, pixels, triangle: 0 });
          doc.selected = -1;
          await click(uv, [100, 100], { pointerType });
          assert.equal(doc.selected, isTaken ? cone : -1, `map: ${pointerType}, ${pixels}`);
        }
        // In the 3D view it is the distance on the screen, here to the second cone; the first is elsewhere.
        model.pick = () => undefined;
        for (const [dx, dy] of [[pixels, 0], [0, -pixels], [-pixels * 0.6, pixels * 0.8]]) { // prettier-ignore
          model.toScreen = (v) => (v === 9 ? { x: 100 + dx, y: 100 + dy } : { x: 400, y: 300 });
          if (dx * dy !== 0 && pixels === reach) continue; // as sums of squares may round
          doc.selected = -1;
          await click(model, [100, 100], { pointerType });
          assert.equal(doc.selected, isTaken ? 1 : -1, `3D: ${pointerType}, ${pixels}`);
        }
      }
    uv.pick = () => undefined;
    await click(uv, [100, 100]);
    assert.equal(doc.selected, -1, 'beside the map');
  }));

test('a press is seen before the controls of the view see it, so that they do not turn what is dragged', (t) =>
  withCanvases(({ rest }) => {
    const added = [];
    const { addEventListener } = EventTarget.prototype;
    t.mock.method(EventTarget.prototype, 'addEventListener', function add(type, listener, how) {
      added.push({ target: this, type, isFirst: how === true || how?.capture === true });
      return addEventListener.call(this, type, listener, how);
    });
    const { model, uv } = opened({ rest });
    for (const { canvas } of [model, uv]) {
      const presses = added.filter(({ target, type }) => target === canvas && type === 'pointerdown'); // prettier-ignore
      assert.ok(presses.length > 1, 'that of the controls, too');
      assert.equal(presses.filter(({ isFirst }) => isFirst).length, 1);
    }
  }));
