// Recorded: surfaces and files that are less plain, maps that fail, what happens while the solver runs, and keys in toolbars
// and tables.

import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { cubeCrosses, cubeMesh, packGlb, toGlb, toGltf, toObj } from '../../support/meshes.mjs';
import { $, $$, begin, buttonOf, choose, chosen, click, copied, drag, drop, finish, placeOf, point, press, rest, saved, setScreen, skip, solver, step, waits } from './recorded_session.mjs'; // prettier-ignore

const box = (n) => {
  const { vertices, triangles } = cubeMesh(n);
  return { vertices: vertices.map(([x, y, z]) => [1.3 * x + 0.03 * y, y + 0.02 * z * z, 0.8 * z]), triangles }; // prettier-ignore
};
/** With one corner drawn out. */
const horn = () => {
  const { vertices, triangles } = box(4);
  const far = ([x, y, z], i) => (i === 0 ? [6 * x, 6 * y, 6 * z] : [x, y, z]);
  return { vertices: vertices.map(far), triangles };
};
/** In quads, as far as two triangles in turn share an edge. */
const inQuads = ({ vertices, triangles }) => {
  const lines = vertices.map((p) => `v ${p.join(' ')}`);
  for (let t = 0; t < triangles.length; t += 2) {
    const [first, second] = [triangles[t], triangles[t + 1]];
    const tip = first.findIndex((v) => !second.includes(v));
    const [a, b, c] = [2, 0, 1].map((i) => first[(tip + i) % 3]);
    const d = second.find((v) => !first.includes(v));
    lines.push(`f ${[a, b, c, d].map((v) => v + 1).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
};

test('what is less plain', { skip }, async () => {
  const app = await begin('trouble');
  const { doc, ui } = app;
  ui.setAutomatic(false);
  await step('a cube', () => drop({ 'cube.obj': toObj(cubeMesh(4)) }));
  await step('its command before a run', () => click('#copy-command'));
  await step('run', () => click('#run'));
  for (const i of [0, 3]) {
    await step(`cone ${i}`, () => click(`#cones [data-cone="${i}"] th button`));
    await step('mirrored', () => click('#mirror-cone'));
  }
  await step('one deleted and the other mirrored', async () => {
    click('#cones [data-cone="2"] [aria-label$="delete"]');
    await rest();
    for (let i = 0; i < doc.prescription.cones.length; i++) {
      click(`#cones [data-cone="${i}"] th button`);
      await rest();
      click('#mirror-cone');
      await rest();
    }
  });
  await step('k that is none', () => choose('#cones [data-cone="0"] input', '0'));
  const focused = () => { const { id, dataset, ariaLabel } = document.activeElement; doc.say(`at ${id} ${ariaLabel} ${dataset.sort ?? ''}`); }; // prettier-ignore
  for (const place of [
    '#cones [data-cone="1"] input',
    '#cones [data-cone="1"] th button',
    '[data-sort="k"]',
    '#frame',
    '#tab-map',
    '#pattern',
  ]) {
    // prettier-ignore
    for (const key of ['ArrowDown', 'ArrowUp', 'ArrowRight', 'ArrowLeft', 'Home', 'End']) {
      await step(`${key} at ${place}`, () => {
        for (const one of $$('button, select, input')) Object.defineProperty(one, 'offsetParent', { configurable: true, get: () => document.body }); // prettier-ignore
        $(place).focus();
        press(place, key);
        focused();
      }, 20); // prettier-ignore
    }
  }
  await step('a field', () => drop({ 'cube.rosy': cubeCrosses(cubeMesh(4)) }));
  await step('its frames', () => choose('#frames', 'file'));
  await step('run with them', () => click('#run'));
  await step('no frames', () => choose('#frames', 'auto'));
  chosen.file = new File([JSON.stringify({ format: 'hgp-cones', version: 1, q: 6, cones: [{ vertex: 0, k: 5 }] })], 'six.json'); // prettier-ignore
  await step('cones of order six', () => click('#field-file'));
  await step('no quads for them', () => perform('download-quads'));
  await step('cones that are none', () => drop({ 'no.cones.json': '{}' }));

  await step('a horn', () => drop({ 'horn.obj': toObj(horn()) }));
  await step('of order four', () => choose('#q', '4'));
  await step('with few cones', () => choose('#cone-step', '0'));
  await step('run on it', () => click('#run'));
  await step('extreme sizes', () => {
    const free = (v) => doc.prescription.cones.every(({ vertex }) => vertex !== v);
    const [v, w] = [...doc.model.surface.angle.keys()].filter(free).slice(9);
    const sizes = { ...doc.current.sizes, spread: 40, range: 90, larger: { share: 0.2, triangles: [5, 6], vertices: [v, w] }, smaller: { share: 0.01, triangles: [9], vertices: [] } }; // prettier-ignore
    doc.solutions = [{ ...doc.current, sizes, overlaps: { pairs: 2, triangles: [4, 7], isMore: true } }]; // prettier-ignore
  });
  await step('shown', () => $('#sizes-differ button')?.click());
  await step('overlaps shown', () => $('#overlaps button')?.click());
  await step('evened out', () => buttonOf(/Add/, '#sizes-differ')?.click());
  await step('hardly any cells', () => choose('#cells', '0'));
  await step('denser', () => ($('#denser') ?? buttonOf(/cells/, 'hgp-status-bar'))?.click());
  await step('for quads', () => choose('#grid-mode', 'quad'));
  await step('its quads', () => $('#preview-quads')?.click());

  solver.isHeld = waits.isOff = true;
  await step('running', () => click('#run'));
  await step('an edit meanwhile', () => press('#view', 'n'));
  await step('another', () => click('#clear-cones'));
  const { repairAll } = await import('../../../web/src/actions/repair.ts');
  await step(`a repair meanwhile: ${await repairAll(app)}`);
  await step('and cancel', () => buttonOf(/Cancel and edit/)?.click());
  solver.held = [];
  solver.isHeld = waits.isOff = false;
  solver.change = (answer) => {
    const certificate = answer.result?.certificate;
    if (!certificate) return;
    const reasons = [{ message: 'Two triangles are folded.', where: [{ kind: 'triangle', id: 3 }] }, { message: 'So it is.' }]; // prettier-ignore
    Object.assign(certificate, { certified: false, flipped: 2, reasons });
    for (const one of certificate.components) Object.assign(one, { certified: false, reasons });
  };
  await step('a map that is not certified', () => click('#run'));
  await step('why', () => $('#panel-result .note.bad button')?.click());
  await step('downloaded all the same', () => click('#download'));
  await step('and closed', () => (ui.dialog = ''));
  solver.change = undefined;

  await step('in quads', () => drop({ 'quads.obj': inQuads(box(3)) }));
  await step('run on quads', () => click('#run'));
  await step('saved with its cones', async () => {
    click('#download');
    await rest();
    click('#downloads .primary.big');
  });
  const copy = async () => new Uint8Array(await saved.at(-1).blob.arrayBuffer());
  await step('opened with its cones', async () => drop({ 'again.obj': await copy() }));
  await step('opened as before', () => drop({ 'quads.obj': inQuads(box(3)) }));
  await step('with the cones of then', () => buttonOf(/cone/i, 'hgp-status-bar')?.click());
  await step('a link to it', () => perform('copy-link'));
  await step('followed', async () => {
    const { followLink } = await import('../../../web/src/actions/follow_link.ts');
    const { readHash } = await import('../../../web/src/formats/hash_state.ts');
    click('#clear-cones');
    await rest();
    followLink(app, readHash(new URL(copied.at(-1)).hash));
  });
  const packed = gzipSync(toObj(box(2)));
  await step('compressed', () =>
    drop({ 'box.obj.gz': Buffer.concat([packed, Buffer.from('more')]) }),
  );
  await step('damaged', () => drop({ 'box.obj.gz': packed.subarray(0, 50) }));
  await step('a glTF of one mesh', () => drop({ 'one.glb': toGlb([box(2)]) }));
  await step('run on it', () => click('#run'));
  await step('as seen in the file', () => choose('#pattern', 'material'));
  await step('quads in it', () => click('#preview-quads'));
  const twice = toGltf([box(2)]);
  twice.json.nodes = [{ mesh: 0 }, { mesh: 0, translation: [3, 0, 0] }];
  twice.json.scenes[0].nodes = [0, 1];
  await step('one mesh twice', () => drop({ 'twice.glb': packGlb(twice) }));
  await step('many triangles', () => drop({ 'many.obj': toObj(box(30)) }));
  await step('over them', () => point('view', 'pointermove', 300, 200));
  await step('a small screen', () => setScreen({ width: 800 }));
  await step('the menu of the view', () => press('#view', 'o'));
  await step('a smaller one', () => setScreen({ width: 500 }));
  await step('a cone at a finger', () =>
    drag('view', placeOf(0), placeOf(1), { pointerType: 'touch' }),
  );
  await step('let go', () => point('view', 'pointercancel', 0, 0));
  await step('no table', () => setScreen({ width: 1400 }));
  finish();

  async function perform(id) {
    press(document.body, 'k', { ctrlKey: true });
    await rest();
    const button = $(`[data-action="${id}"]`);
    if (button.disabled) ui.dialog = '';
    else button.click();
  }
});
