// Files of several meshes, with defects, with parts missing, with creases and rims: what the page makes of them.

import assert from 'node:assert/strict';
import test from 'node:test';
import { beside, blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, packGlb, toGlb, toGltf, toObj, toOff } from '../../support/meshes.mjs';
import { flatSquare } from '../shapes.mjs';
import { $, $$, choose, click, drawn, openFiles, openPage, runNow, saved, skip, textOf, until } from './whole_page.mjs'; // prettier-ignore

const { runJob } = await import('../../../web/src/actions/job.ts');
const { rewrite } = await import('../../../web/src/actions/solve.ts');
const { undo } = await import('../../../web/src/actions/undo.ts');
const status = () => textOf($('#status'));
const buttonOf = (pattern, within = 'hgp-status-bar') => $$(`${within} button`).find((one) => pattern.test(one.textContent)); // prettier-ignore
async function pageWith(t, files) {
  const app = await openPage(t);
  await openFiles(app, files);
  return app;
}

test(
  'meshes that no node uses are not part of the scene, unless all are like that',
  { skip },
  async (t) => {
    const { json, bin } = toGltf([cubeMesh(3), cubeMesh(5)]);
    const openWith = async (nodes) => {
      const scenes = [{ nodes: nodes.map((_, i) => i) }];
      const text = JSON.stringify({ ...json, nodes, scenes: nodes.length > 0 ? scenes : [] });
      const app = await pageWith(t, { 'two.gltf': text, 'cube.bin': bin });
      return app.doc.parts.toSorted((a, b) => a.mesh - b.mesh).map(({ isPlaced }) => isPlaced);
    };
    assert.deepEqual(await openWith([{ mesh: 1 }]), [false, true]);
    assert.deepEqual(await openWith([{ mesh: 0 }, { mesh: 1 }]), [true, true]);
  },
);

test(
  'a scene: the largest mesh is open, each keeps its work, Run all runs all, one file has all maps',
  { skip },
  async (t) => {
    // prettier-ignore
    const app = await pageWith(t, { 'two.glb': toGlb([cubeMesh(3), cubeMesh(5)]) });
    const { doc } = app;
    const buttons = () => $$('[data-mesh]');
    assert.equal(buttons().length, 2);
    assert.equal(doc.model.info.surface, 1, 'the largest');
    assert.deepEqual(
      buttons().map((one) => one.getAttribute('aria-current')),
      ['false', 'true'],
    );
    assert.deepEqual(
      buttons().map(({ dataset }) => dataset.meshState),
      ['waiting', 'open'],
    );
    assert.deepEqual(doc.parts.map(({ mesh }) => mesh).sort(), [0, 1]);
    for (const { cornerPositions, mesh } of doc.parts) assert.equal(cornerPositions.length / 9, doc.model.info.surfaces[mesh].triangles); // prettier-ignore
    assert.deepEqual([...doc.thumbnails.keys()].sort(), [0, 1]);
    const { watchThumbnails } = await import('../../../web/src/actions/thumbnails.ts');
    t.after(watchThumbnails(app));
    const before = [0, 1].map((mesh) => doc.thumbnails.get(mesh));
    await runNow(app);
    await until(() => doc.thumbnails.get(1) !== before[1], 'the picture of the map');
    assert.equal(doc.thumbnails.get(0), before[0], 'others stay');
    const second = doc.current;
    assert.deepEqual(
      buttons().map(({ dataset }) => dataset.meshState),
      ['waiting', 'certified'],
    );
    await click('[data-mesh="0"]');
    await until(() => !doc.isBusy && doc.model.info.surface === 0);
    assert.equal(doc.displayed, undefined, 'a mesh has no map of another');
    assert.equal(doc.prescription.cones.length, 0);
    await click('[data-mesh="1"]');
    await until(() => !doc.isBusy && doc.model.info.surface === 1);
    assert.equal(doc.current, second, 'its work is kept');
    await click('#download');
    assert.match(textOf($('#downloads')), /One mesh of the file has no map yet/);
    await click(buttonOf(/Close/, '#downloads'));
    await click('#run-all');
    await until(() => !doc.isBusy && /2 meshes certified/.test(status()), 'the end of all runs');
    assert.equal(doc.model.info.surface, 1, 'back where it began');
    assert.deepEqual(
      buttons().map(({ dataset }) => dataset.meshState),
      ['certified', 'certified'],
    );
    await click('#download');
    assert.match(textOf($('#downloads')), /coordinates of 2 meshes/);
    await click('#downloads .primary.big');
    await until(() => saved.length > 0 && saved[0].name);
    assert.match(status(), /2 meshes in one file, all certified/);
    const bytes = new Uint8Array(await saved[0].blob.arrayBuffer());
    for (const surface of [0, 1]) {
      const model = await app.client.load({ main: 'a.glb', files: new Map([['a.glb', bytes]]) }, { surface }); // prettier-ignore
      const certificate = await model.verify();
      assert.deepEqual([certificate.certified, certificate.triangles], [true, doc.model.info.surfaces[surface].triangles]); // prettier-ignore
    }
  },
);

test('a defect is told, shown and repaired, as a step that undo reverts', { skip }, async (t) => {
  const mesh = cubeMesh(4);
  const [a, b, c] = mesh.triangles[40];
  const broken = { vertices: mesh.vertices, triangles: [...mesh.triangles.with(40, [a, c, b]), [3, 3, 5]] }; // prettier-ignore
  const app = await pageWith(t, { 'broken.off': toOff(broken) });
  const { doc } = app;
  assert.equal(doc.stateName, 'invalid');
  assert.equal($('#run'), null);
  const outlined = [];
  app.views = { model: { highlight: (triangles, edges) => outlined.push({ triangles, edges }), lookAt() {}, draw() {} }, uv: { highlight() {} } }; // prettier-ignore
  const kinds = $$('[data-show]')
    .map(({ dataset }) => dataset.show)
    .sort();
  assert.deepEqual(kinds, doc.model.info.defects.map(({ kind }) => kind).sort());
  for (const kind of kinds) {
    await click(`[data-show="${kind}"]`);
    const { where } = doc.model.info.defects.find((one) => one.kind === kind);
    const { triangles, edges } = outlined.at(-1);
    assert.ok(triangles.length + edges.length >= where.length, kind);
    assert.match(status(), /[Ss]hown|outlined/);
  }
  await click('[data-fix="degenerate"]');
  await until(() => !doc.isBusy && doc.settings.fix.degenerate);
  assert.equal(doc.stateName, 'invalid', 'the turned triangle is left');
  assert.deepEqual($$('.defects li.fatal').length, 1);
  await click('[data-fix="orient"]');
  await until(() => !doc.isBusy && doc.usableModel !== undefined);
  assert.deepEqual(doc.settings.fix, { degenerate: true, orient: true });
  assert.equal(doc.stateName, 'ready');
  await runNow(app);
  assert.equal(doc.stateName, 'certified');
  assert.match(status(), /repaired first/);
  assert.match(textOf($('#repairs')), /Repaired first/);
  const cones = doc.prescription.cones.length;
  await click('#undo'); // the suggested cones
  await click('#undo');
  await until(() => !doc.isBusy && doc.usableModel === undefined);
  assert.deepEqual(doc.settings.fix, { degenerate: true });
  await click('#redo');
  await until(() => !doc.isBusy && doc.usableModel !== undefined);
  await click('#redo');
  await until(() => doc.prescription.cones.length === cones);
  assert.equal(doc.stateName, 'certified', 'the map of these repairs and cones is there still');
  await click(buttonOf(/Leave repairs out/, '#repairs'));
  await until(() => !doc.isBusy && doc.usableModel === undefined);
  assert.equal($('#repair-and-run') !== null, true);
  await click('#repair-and-run');
  await until(() => !doc.isBusy && doc.current !== undefined);
  assert.equal(doc.settings.hasAllRepairs, true);
});

test(
  'vertices at equal places are joined by a click where a note recommends it',
  { skip },
  async (t) => {
    // prettier-ignore
    const mesh = cubeMesh(3);
    const soup = { vertices: mesh.triangles.flat().map((v) => mesh.vertices[v]), triangles: mesh.triangles.map((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]) }; // prettier-ignore
    const app = await pageWith(t, { 'soup.obj': toObj(soup) });
    const { doc } = app;
    assert.equal(doc.model.info.components.length, soup.triangles.length);
    await click('#weld-now');
    await until(() => !doc.isBusy && doc.settings.weld === 0);
    assert.equal(doc.model.info.components.length, 1);
    assert.equal($('#weld-now'), null);
    assert.match(textOf($('#panel-model')), /→ 56/);
    await choose('#weld', '0.001');
    await until(() => !doc.isBusy && doc.settings.weld === 0.001);
    await choose('#weld', '-1');
    assert.deepEqual([doc.settings.weld, $('#weld').value], [0.001, '0.001'], 'no length');
    // While something else goes on nothing is read again, and the field shows what holds.
    let end;
    const running = runJob(app, { kind: 'run', title: '', onFailure: assert.fail }, () => new Promise((resolve) => (end = resolve))); // prettier-ignore
    await choose('#weld', '0.2');
    end();
    await running;
    assert.deepEqual([doc.settings.weld, $('#weld').value], [0.001, '0.001']);
    await choose('#weld', '0');
    await until(() => !doc.isBusy && doc.settings.weld === 0, 'equal places alone');
    await choose('#weld', '');
    await until(() => !doc.isBusy && doc.settings.weld === undefined);
  },
);

test(
  'files that are missing are asked for; images may be left out, buffers not',
  { skip },
  async (t) => {
    // prettier-ignore
    const app = await openPage(t);
    const { doc } = app;
    const glb = new Uint8Array(toGlb([cubeMesh(3)]));
    const { splitGlb } = await import('../../../web/src/formats/glb.ts');
    const { json, bin } = splitGlb(glb);
    const gltf = JSON.parse(new TextDecoder().decode(json));
    gltf.buffers[0].uri = 'cube.bin';
    gltf.images = [{ uri: 'skin.png' }];
    const text = JSON.stringify(gltf);
    await openFiles(app, { 'cube.gltf': text });
    assert.equal(doc.stateName, 'needs-files');
    assert.deepEqual(
      $$('#needs-files code').map((one) => textOf(one)),
      ['cube.bin', 'skin.png'],
    );
    assert.deepEqual(
      $$('#needs-files small').map((one) => textOf(one)),
      ['needed', 'image'],
    );
    assert.equal($('#without-images'), null);
    await openFiles(app, { 'cube.bin': bin });
    assert.deepEqual(
      $$('#needs-files code').map((one) => textOf(one)),
      ['skin.png'],
    );
    await click('#without-images');
    await until(() => doc.usableModel !== undefined && !doc.isBusy);
    await runNow(app);
    assert.equal(doc.stateName, 'certified');
    await openFiles(app, { 'cube.gltf': text });
    await click(buttonOf(/Cancel/, '#needs-files'));
    assert.deepEqual([doc.stateName, $('dialog')], ['empty', null]);
    await openFiles(app, { 'a.obj': toObj(cubeMesh(2)), 'b.obj': toObj(cubeMesh(3)) });
    assert.equal(doc.stateName, 'pick-model');
    assert.deepEqual(
      $$('#pick-model .wide-button').map((one) => textOf(one)),
      ['a.obj', 'b.obj'],
    );
    await click(buttonOf(/b\.obj/, '#pick-model'));
    await until(() => doc.usableModel?.main === 'b.obj' && !doc.isBusy);
    await openFiles(app, { 'readme.txt': 'no mesh' });
    assert.match(status(), /“readme\.txt” holds no mesh/);
    assert.equal(doc.stateName, 'empty');
    await openFiles(app, { 'bad.obj': 'f 1 2 3\n' });
    assert.equal(doc.message.kind, 'error');
    assert.equal(doc.model?.info.usable ?? false, false);
  },
);

test(
  'lines follow creases and rims that are chosen; the map has them straight',
  { skip },
  async (t) => {
    // prettier-ignore
    const open = blocks(['##'], { n: 3, open: ['0 0 +z', '1 0 +z'] });
    const app = await pageWith(t, { 'tray.obj': toObj(open) });
    const { doc, ui } = app;
    ui.setAutomatic(false);
    assert.equal(doc.prescription.turnings.length, 1);
    assert.match(textOf($('#panel-turnings')), /Boundary 1/);
    await choose('#follow-rims', true);
    assert.deepEqual([doc.features.hasRims, doc.features.edges.length], [true, 0]);
    assert.match(textOf($('#features-note')), /After Run, lines follow 1 rim\./);
    await choose('#follow-creases', true);
    await until(() => doc.features.hasCreases);
    assert.ok(doc.features.edges.length > 8);
    assert.equal($('#follow-creases').checked, true);
    await runNow(app);
    assert.equal(doc.stateName, 'certified');
    assert.match(textOf($('#features-note')), /^Lines follow \d+ creases and 1 rim/);
    assert.match(status(), /lines follow/);
    // Straight in the map: along each chosen edge one coordinate stays.
    const { cornerUv } = doc.current;
    const { triangles } = doc.model.surface;
    const chosen = new Set(
      doc.features.edges.map((edge) => [...edge].sort((a, b) => a - b).join()),
    );
    let seen = 0;
    for (let c = 0; c < triangles.length; c++) {
      const next = c % 3 === 2 ? c - 2 : c + 1;
      if (!chosen.has([triangles[c], triangles[next]].sort((a, b) => a - b).join())) continue;
      const [du, dv] = [0, 1].map((i) => Math.abs(cornerUv[2 * c + i] - cornerUv[2 * next + i]));
      assert.ok(Math.min(du, dv) < 1e-5 * Math.max(du, dv) + 1e-6, `${du}, ${dv}`);
      seen += 1;
    }
    assert.equal(seen, 2 * chosen.size, 'each from both sides');
    await click('#features-export');
    await until(() => saved.length > 0 && saved[0].name);
    assert.equal(saved[0].name, 'tray.features.json');
    const { edgesOf } = await import('../../../web/src/model/features.ts');
    const written = edgesOf(await saved[0].blob.text()).map((edge) => [...edge].sort((a, b) => a - b).join()); // prettier-ignore
    const rims = doc.features.rims.map((edge) => [...edge].sort((a, b) => a - b).join());
    assert.deepEqual(written.toSorted(), [...chosen, ...rims].toSorted());
    // Turnings are those of the field, whatever the cones; what is placed after the run is kept until the box is unticked.
    assert.deepEqual(doc.prescription.turnings, [null]);
    const { prescription } = doc;
    const { setPrescription } = await import('../../../web/src/actions/edit_cones.ts');
    assert.equal($('#keep-cones').checked, false);
    assert.match(textOf($('#panel-solve')), /Run chooses cones that fit/);
    setPrescription(app, { ...prescription, cones: prescription.cones.slice(1) }, 'delete cone');
    await drawn();
    assert.equal($('#keep-cones').checked, true);
    assert.match(textOf($('#panel-solve')), /Run keeps the cones that are placed/);
    await choose('#keep-cones', false);
    assert.deepEqual([doc.features.keepsCones, doc.stateName], [false, 'stale']);
    assert.match(status(), /previous cones/);
    await runNow(app);
    assert.deepEqual([doc.prescription, doc.stateName], [prescription, 'certified']);
    // After an edit that is undone, the map that is shown is made again as it was made.
    setPrescription(app, { ...prescription, cones: prescription.cones.slice(1) }, 'delete cone');
    await undo(app);
    assert.deepEqual([doc.stateName, doc.features.keepsCones], ['certified', true]);
    const bytes = doc.current.files[0].bytes;
    await doc.current.map.dispose();
    await rewrite(app, { embedCones: true });
    assert.equal(doc.current.features.keepsCones, false);
    assert.deepEqual([doc.current.files[0].bytes, doc.current.prescription], [bytes, prescription]);
    await choose('#follow-rims', false);
    assert.deepEqual([doc.features.hasRims, doc.stateName], [false, 'stale']);
    await choose('#follow-creases', false);
    await until(() => doc.features === undefined);
    await choose('#follow-rims', true);
    await click('#features-clear');
    assert.deepEqual([doc.features, $('#features-note')], [undefined, null]);
  },
);

test(
  'a file that carries cones and the edges that lines follow opens with both, and Run keeps them',
  { skip },
  async (t) => {
    const open = blocks(['##'], { n: 3, open: ['0 0 +z', '1 0 +z'] });
    const app = await pageWith(t, { 'tray.glb': toGlb([open]) });
    const { doc, ui } = app;
    ui.setAutomatic(false);
    await choose('#follow-rims', true);
    await choose('#follow-creases', true);
    await until(() => doc.features.hasCreases);
    await runNow(app);
    const { prescription, features } = doc;
    const [{ bytes }] = doc.current.files;
    const { clearFeatures } = await import('../../../web/src/actions/features.ts');
    const { importCones } = await import('../../../web/src/actions/edit_cones.ts');
    const sizes = ({ edges, rims, hasRims, keepsCones }) => [edges.length, rims.length, hasRims, keepsCones]; // prettier-ignore
    const kept = [features.edges.length, features.rims.length, true, true];
    await openFiles(app, { 'again.glb': bytes });
    await until(() => doc.model?.main === 'again.glb' && !doc.isBusy);
    assert.deepEqual(sizes(doc.features), kept);
    assert.equal(doc.prescription.cones.length, prescription.cones.length);
    assert.deepEqual(doc.prescription.turnings, [null]);
    assert.match(status(), /cones came with the file, with edges that lines follow\./);
    assert.equal($('#keep-cones').checked, true);
    const before = doc.prescription;
    await runNow(app);
    assert.deepEqual([doc.stateName, doc.prescription], ['certified', before]);
    assert.match(textOf($('#features-note')), /^Lines follow \d+ creases and 1 rim/);
    // As a file of cones, too; cones without edges leave the edges as they are.
    const cones = await doc.model.solver.embeddedCones();
    clearFeatures(app);
    await importCones(app, 'own.json', JSON.stringify(cones));
    assert.deepEqual(sizes(doc.features), kept);
    assert.deepEqual(doc.prescription.turnings, [null]);
    assert.match(status(), /imported from own\.json, with edges that lines follow\./);
    const { features: chosen } = doc;
    await importCones(app, 'plain.json', JSON.stringify({ ...cones, features: undefined }));
    assert.deepEqual([doc.features, doc.prescription.turnings], [chosen, [cones.boundaries[0].l]]);
    assert.match(status(), /imported from plain\.json\.$/);
    // Without a cone the edges are all that the file carries.
    await openFiles(app, { 'flat.glb': toGlb([flatSquare(4)]) });
    await until(() => doc.model?.main === 'flat.glb' && !doc.isBusy);
    await choose('#follow-rims', true);
    await runNow(app);
    const [flat] = doc.current.files;
    await openFiles(app, { 'rims.glb': flat.bytes });
    await until(() => doc.model?.main === 'rims.glb' && !doc.isBusy);
    assert.deepEqual(sizes(doc.features), [0, 16, true, true]);
    assert.match(status(), /^Edges that lines follow came with the file\./);
    await runNow(app);
    assert.equal(doc.stateName, 'certified');
  },
);

test(
  'turnings and rotations are prescribed in their panel, and the map has them',
  { skip },
  async (t) => {
    // prettier-ignore
    const app = await pageWith(t, { 'eight.obj': toObj(blocks(eight, { open: ['0 0 +z'] })) });
    const { doc, ui } = app;
    ui.setAutomatic(false);
    const { turnings, handles } = doc.prescription;
    assert.deepEqual([turnings.length, handles.length], [1, 4]);
    assert.equal($$('[data-loop]').length, 1);
    assert.equal($$('[data-handle]').length, 4);
    await runNow(app);
    assert.equal(doc.stateName, 'certified');
    const [{ l }] = doc.current.result.cones.boundaries;
    assert.deepEqual(doc.prescription.turnings, [l], 'the one that was chosen is taken');
    assert.match(textOf($('[data-loop="0"]')), new RegExp(` · ${String(90 * l).replace('-', '−')}°$`)); // prettier-ignore
    const plus = $('[data-handle="1"] [aria-label$="larger"]');
    await click(plus);
    const [first] = [doc.prescription.handles[1]];
    assert.ok(Number.isInteger(first));
    await click($('[data-handle="1"] [aria-label$="larger"]'));
    assert.equal(doc.prescription.handles[1], (first + 1) % 4);
    for (const back of [0, 3]) {
      await click($('[data-handle="1"] [aria-label$="smaller"]'));
      assert.equal(doc.prescription.handles[1], (first + back) % 4);
    }
    await choose($('[data-handle="1"] input'), '-1');
    assert.equal(doc.prescription.handles[1], 3, 'modulo q');
    await choose($('[data-handle="1"] input'), '');
    assert.equal(doc.prescription.handles[1], null);
    await choose($('[data-loop="0"] input'), '2');
    assert.deepEqual(doc.prescription.turnings, [2]);
    const { components } = doc.budget;
    assert.equal(components[0].openLoops, 0);
    assert.equal(components[0].need, 4 * doc.model.info.eulerCharacteristic);
    await choose($('[data-loop="0"] input'), '1.5');
    assert.deepEqual(doc.prescription.turnings, [2], 'a whole number');
  },
);

test('components: budgets are told apart, and balanced ones are one line', { skip }, async (t) => {
  const app = await pageWith(t, { 'two.obj': toObj(beside(cubeMesh(4), cubeMesh(3))) });
  const { doc, ui } = app;
  ui.setAutomatic(false);
  assert.match(textOf($('#panel-model')), /Components 2/);
  await runNow(app);
  assert.equal(doc.stateName, 'certified');
  assert.match(textOf($('#panel-cones')), /All 2 components balanced/);
  const { deleteCone } = await import('../../../web/src/actions/edit_cones.ts');
  deleteCone(app, 0);
  await drawn();
  const component = doc.budget.components.findIndex(({ isBalanced }) => !isBalanced);
  assert.match(textOf($('.budget.open')), new RegExp(`^Component ${component + 1}:`));
  assert.match(textOf($('#panel-cones')), /1 of 2 components balanced/);
  // One of them being balanced is no reason to leave the other as it is.
  await click('#balance');
  await until(() => doc.budget.components.every(({ isBalanced }) => isBalanced));
});

test('what is not used any more is freed; what undo can lead to is kept', { skip }, async (t) => {
  const { freeUnused } = await import('../../../web/src/actions/free_unused.ts');
  const app = await pageWith(t, { 'two.glb': toGlb([cubeMesh(3), cubeMesh(4)]) });
  const { doc } = app;
  freeUnused(app);
  const { solver } = doc.model;
  await runNow(app);
  freeUnused(app);
  const { map } = doc.current;
  assert.deepEqual([solver.isDisposed, map.isDisposed], [false, false]);
  await click('[data-mesh="0"]');
  await until(() => !doc.isBusy && doc.model.info.surface === 0);
  freeUnused(app);
  assert.deepEqual([solver.isDisposed, map.isDisposed], [false, false], 'a mesh that waits');
  const other = doc.model.solver;
  await openFiles(app, { 'one.obj': toObj(cubeMesh(2)) });
  freeUnused(app);
  assert.deepEqual([solver.isDisposed, map.isDisposed, other.isDisposed], [true, true, true]);
  assert.equal(doc.model.solver.isDisposed, false);
});

const onePixel = 'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg=='; // prettier-ignore

test(
  'the textures of a model: kept where they are seen, moved where they are not, and a sentence says which',
  { skip },
  async (t) => {
    // prettier-ignore
    const flat = ([x, y]) => [x / 3, y / 3];
    const cases = [
      { uv: { 0: flat }, asks: 0, uses: 0, says: /stay on the old coordinates/ },
      { uv: { 0: flat }, asks: 2, uses: 1, says: /missing from this mesh or have no area/ },
      {
        uv: { 0: () => [0.5, 0.5] },
        asks: 0,
        uses: 1,
        says: /missing from this mesh or have no area/,
      },
    ];
    const app = await openPage(t);
    const { doc } = app;
    for (const { uv, asks, uses, says } of cases) {
      const parts = toGltf([cubeMesh(3)], { image: onePixel, uv });
      parts.json.materials[0].pbrMetallicRoughness.baseColorTexture.texCoord = asks;
      await openFiles(app, { 'skin.glb': packGlb(parts) });
      await runNow(app);
      assert.equal(doc.stateName, 'certified');
      const setNow = async () => {
        const { parseGltf } = await import('../../../web/src/formats/glb.ts');
        const { materials, meshes } = parseGltf(doc.current.files[0]);
        assert.ok('TEXCOORD_0' in meshes[0].primitives[0].attributes, 'the old set is kept');
        return materials[0].pbrMetallicRoughness.baseColorTexture.texCoord ?? 0;
      };
      assert.equal(await setNow(), uses);
      await click('#download');
      assert.match(textOf($('#own-textures')), says);
      const chosen = () => $('#uv-set option[selected]').value;
      assert.equal(chosen(), uses === asks ? 'keep' : 'use');
      for (const [value, set] of [
        ['use', 1],
        ['keep', asks],
      ]) {
        // prettier-ignore
        await choose('#uv-set', value);
        await until(() => !doc.isBusy && !doc.pendingOutput);
        assert.deepEqual([await setNow(), chosen()], [set, value]);
      }
      assert.match(textOf($('#own-textures')), /stay on the old coordinates/);
      app.ui.dialog = '';
      await drawn();
    }
  },
);
