// Recorded: files of several meshes, with defects, with parts missing, with rims, creases and handles; a phone; the films and
// pictures, examples, links, and the pieces of the browser that may be missing.

import test from 'node:test';
import { beside, blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, packGlb, toGlb, toGltf, toObj, toOff } from '../../support/meshes.mjs';
import { $, $$, begin, buttonOf, choose, chosen, click, drop, finish, placeOf, point, press, resized, rest, served, setScreen, skip, step, tap, viewSize } from './recorded_session.mjs'; // prettier-ignore

const scaled = ({ vertices, triangles }, [x, y, z]) => ({ vertices: vertices.map((p) => [x * p[0] + 0.02 * p[1], y * p[1] + 0.03 * p[2] * p[2], z * p[2]]), triangles }); // prettier-ignore
const small = scaled(cubeMesh(2), [1, 1.4, 0.8]);
const large = scaled(cubeMesh(3), [0.7, 1.2, 1]);
const onePixel = 'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg=='; // prettier-ignore

/** Two meshes, the first of them twice and turned, with an image and coordinates of its own. */
function scene() {
  const parts = toGltf([small, large], { image: onePixel, uv: { 0: ([x, y]) => [x / 3, y / 3] } });
  parts.json.nodes = [{ mesh: 0, translation: [4, 0, 0] }, { mesh: 1 }, { mesh: 0, translation: [-4, 0, 0], rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2], scale: [1, -1, 1] }]; // prettier-ignore
  parts.json.scenes[0].nodes = [0, 1, 2];
  parts.json.meshes[1].name = 'body';
  return packGlb(parts);
}

class Recorder extends EventTarget {
  static isTypeSupported = (kind) => kind === 'video/webm';
  start() {}
  stop() {
    const data = new Blob(['a film']);
    this.dispatchEvent(Object.assign(new NodeEvent('dataavailable'), { data }));
    this.dispatchEvent(new NodeEvent('stop'));
  }
}
const NodeEvent = Event;

test('files of every kind, on screens of every kind', { skip }, async () => {
  served.set('hero.bin', heroFile());
  for (const id of ['cube', 'sphere']) served.set(`examples/${id}.glb`, toGlb([cubeMesh(3)]));
  globalThis.MediaRecorder = Recorder;
  globalThis.HTMLCanvasElement.prototype.captureStream = () => ({ getTracks: () => [] });
  setScreen({ still: false });
  const app = await begin('files', '#q=4&pattern=grid&tiles=30&grid=quad&improve=0.5');
  const { doc, ui } = app;
  ui.setAutomatic(false);
  await step('the first screen, with a link');
  setScreen({ still: true });
  await step('an example', () => click('[data-card="cube"]'));
  await step('run', () => click('#run'));
  await step('an example that is not there', () => click('[data-example="torus"]'));

  await step('a scene', () => drop({ 'scene.glb': scene() }));
  await step('over another mesh', () => point('view', 'pointermove', 520, 200));
  await step('a mesh chosen by a click', () => tap('view', 520, 200));
  await step('chosen in the strip', () => click('[data-mesh="1"]'));
  await step('run this one', () => click('#run'));
  await step('its own materials', () => choose('#pattern', 'material'));
  await step('before and after', () => choose('#wipe', '30'));
  await step('run all', () => click('#run-all'));
  await step('download', () => click('#download'));
  await step('which coordinates its textures use', () => choose('#uv-set', 'use'));
  await step('replaced', () => choose('#uv-set', '0'));
  await step('validated', () => click('#validate'));
  await step('all saved', () => click('#downloads .primary.big'));
  chosen.file = new File(['an image'], 'tiles.png');
  await step('an image as pattern', () => choose('#pattern', 'image'));
  await step('a film of one turn', async () => {
    click('#turntable');
    for (let i = 0; i < 12; i++) await rest(700);
  });
  await step('closed', () => click('#close'));

  const mesh = large;
  const [a, b, c] = mesh.triangles[20];
  const broken = { vertices: mesh.vertices, triangles: [...mesh.triangles.with(20, [a, c, b]), [3, 3, 5]] }; // prettier-ignore
  await step('defects', () => drop({ 'broken.off': toOff(broken) }));
  for (const kind of ['degenerate', 'orientation']) if ($(`[data-show="${kind}"]`)) await step(`shown: ${kind}`, () => click(`[data-show="${kind}"]`)); // prettier-ignore
  await step('one repaired', () => click('[data-fix="degenerate"]'));
  await step('repaired and run', () => click('#repair-and-run'));
  await step('a look at them', () => click($('#repairs .link') ?? buttonOf(/./, '#repairs')));
  await step('repaired again', () => $('#repair-and-run')?.click());
  await step('left out', () => click(buttonOf(/Leave/, '#repairs')));
  await step('undone', () => click('#undo'));
  const tiny = scaled(cubeMesh(1), [1, 1.4, 0.8]);
  const soup = { vertices: tiny.triangles.flat().map((v) => tiny.vertices[v]), triangles: tiny.triangles.map((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]) }; // prettier-ignore
  await step('triangles that are not joined', () => drop({ 'soup.obj': toObj(soup) }));
  await step('joined', () => click('#weld-now'));
  await step('within a length', () => choose('#weld', '0.001'));
  await step('not a length', () => choose('#weld', '-2'));

  const { json, bin } = toGltf([small], { image: 'skin.png' });
  await step('files that are missing', () => drop({ 'm.gltf': JSON.stringify(json) }));
  await step('one of them', () => drop({ 'cube.bin': bin }));
  await step('without the image', () => click('#without-images'));
  await step('missing again', () => drop({ 'm.gltf': JSON.stringify(json) }));
  await step('given up', () => click(buttonOf(/Cancel/, '#needs-files')));
  await step('two models', () => drop({ 'a/a.obj': toObj(small), 'a/b.obj': toObj(large) }));
  await step('the second', () => click(buttonOf(/b\.obj/, '#pick-model')));
  await step('no model', () => drop({ 'notes.txt': 'nothing' }));
  await step('not a mesh', () => drop({ 'bad.obj': 'f 1 2 3\n' }));
  await step('dragged over', () => document.dispatchEvent(new Event('dragenter')));
  await step('and away', () => document.dispatchEvent(new Event('dragleave')));

  const tray = blocks(['##'], { n: 3, open: ['0 0 +z', '1 0 +z'] });
  await step('a tray', () => drop({ 'tray.obj': toObj(tray) }));
  await step('along its rims', () => choose('#follow-rims', true));
  await step('along its creases', () => choose('#follow-creases', true));
  await step('run along them', () => click('#run'));
  await step('exported', () => click('#features-export'));
  await step('the tool for edges', () => press('#view', 'e'));
  const edge = () => { const [v, w] = doc.features?.edges[0] ?? [0, 1]; const [p, r] = [placeOf(v), placeOf(w)]; return [(p[0] + r[0]) / 2, (p[1] + r[1]) / 2]; }; // prettier-ignore
  await step('over an edge', () => point('view', 'pointermove', ...edge()));
  await step('a chain taken out', () => tap('view', ...edge(), { altKey: true }));
  await step('a chain chosen', () => tap('view', 300, 200));
  await step('a loop looked at', () => click('[data-loop="0"] button'));
  await step('a turn more', () => click('[data-loop="0"] [aria-label$="larger"]'));
  await step('three turns', () => choose('[data-loop="0"] input', '3'));
  await step('no features', () => click('#features-clear'));

  await step('an eight', () => drop({ 'eight.obj': toObj(blocks(eight, { n: 1, open: ['0 0 +z'] })) })); // prettier-ignore
  await step('loops around handles', () => click('[data-handle="0"] button'));
  await step('a rotation', () => click('[data-handle="1"] [aria-label$="larger"]'));
  await step('another', () => choose('[data-handle="2"] input', '-1'));
  await step('none', () => choose('[data-handle="2"] input', ''));
  await step('run with them', () => click('#run'));
  await step('turned seams', () => $('#show-turned')?.click());
  await step('extreme sizes', () => $('#sizes-differ button')?.click());
  await step('evened out', () => buttonOf(/cone/i, '#sizes-differ')?.click());

  await step('two components', () => drop({ 'two.obj': toObj(beside(small, large)) }));
  await step('run both', () => click('#run'));
  await step('one without a cone', () => click('#cones [data-cone="0"] [aria-label$="delete"]'));
  await step('cones of a file', () => drop({ 'two.cones.json': JSON.stringify({ format: 'hgp-cones', version: 1, q: 4, cones: [{ vertex: 0, k: 3 }, { vertex: 99_999, k: 3 }] }) })); // prettier-ignore

  await step('a phone', () => setScreen({ width: 600 }));
  await step('the sheet', () => click('#sheet'));
  await step('the map', () => click('#tab-map'));
  await step('the model', () => click('#tab-surface'));
  await step('a long press', async () => {
    point('view', 'pointerdown', 300, 200, { pointerType: 'touch', buttons: 1 });
    await rest(500);
    point('view', 'pointerup', 300, 200, { pointerType: 'touch' });
  });
  await step('a tablet', () => setScreen({ width: 800 }));
  await step('a desk', () => setScreen({ width: 1400 }));
  await step('a larger window', () => { Object.assign(viewSize, { width: 900, height: 300 }); resized(); }); // prettier-ignore
  await step('the divider', () => press('#splitter', 'ArrowRight'));
  for (const [name, id] of [['lost', 'webglcontextlost'], ['back', 'webglcontextrestored']]) await step(`the card is ${name}`, () => $('#view').dispatchEvent(new Event(id, { cancelable: true }))); // prettier-ignore
  await step('an error of nobody', () => dispatchEvent(Object.assign(new Event('error'), { error: new Error('unforeseen') }))); // prettier-ignore
  await step('a promise of nobody', () => dispatchEvent(Object.assign(new Event('unhandledrejection'), { reason: 'unforeseen' }))); // prettier-ignore
  await step('leaving', () => {
    const event = new Event('beforeunload', { cancelable: true });
    dispatchEvent(event);
    doc.say(`held back: ${event.defaultPrevented}, ${$$('button').length} buttons`);
  });
  finish();
});

/** The model of the first screen: counts, positions, normals, coordinates, triangles. */
function heroFile() {
  const { vertices, triangles } = cubeMesh(1);
  const head = Uint32Array.of(vertices.length, 3 * triangles.length);
  const floats = Float32Array.from([...vertices.flat(), ...vertices.flat(), ...vertices.flatMap(([x, y]) => [x, y])]); // prettier-ignore
  return Buffer.concat([head, floats, Uint32Array.from(triangles.flat())].map((one) => Buffer.from(one.buffer))); // prettier-ignore
}
