// Recorded: what functions of the page answer that need no page: sentences, names, addresses, budgets, stores. Each line is a
// call and its answer.

import test from 'node:test';
import { blocks } from '../../support/blocks.mjs';
import { cubeMesh, packGlb, toGltf, toPly } from '../../support/meshes.mjs';
import { database } from './database_stand_in.mjs';
import { plainFacts } from './plain_facts.mjs';
import { Recording, valueText } from '../../support/recording.mjs';
import { EdgeMap, countRuns, edgesOf, featuresText, followedLines, sameFeatures, withChain } from '../../../web/src/model/features.ts'; // prettier-ignore
import { computeBudget, largestK, leftAt, suggestedK, waysToSpend } from '../../../web/src/model/gauss_bonnet.ts'; // prettier-ignore
import { gridOutcome, gridTilesPerUnit, hasSteps, isTurnedBy, sameGrid, sameTiles, tilesPerUnit, turnedSeams } from '../../../web/src/model/grid.ts'; // prettier-ignore
import { History } from '../../../web/src/model/history.ts';
import { niceLength } from '../../../web/src/model/nice_length.ts';
import { angleText, emptyPrescription, fromCones, indexText, isSilent, samePrescription, toCones, withOrder } from '../../../web/src/model/prescription.ts'; // prettier-ignore
import { cornerNear } from '../../../web/src/model/snapping.ts';
import { curvatureAround, defectDegrees, neighbourhood, scaleAt } from '../../../web/src/model/surface.ts'; // prettier-ignore
import { chosenSet, textureFate } from '../../../web/src/model/texture_fate.ts';
import { bendOf, readQuads, valencesOf } from '../../../web/src/model/quad_shape.ts';
import { findMissing, coneFileOf, hasDirections, meshesOf, nameStem, safeName, unpack } from '../../../web/src/formats/file_set.ts'; // prettier-ignore
import { parseGltf, relativeName, splitGlb, surfaceMeshes } from '../../../web/src/formats/glb.ts';
import { readHash, writeHash } from '../../../web/src/formats/hash_state.ts';
import { summarizePreserved } from '../../../web/src/formats/preserved_content.ts';
import { readPly } from '../../../web/src/formats/read_ply.ts';
import { formatFor, setHint, targets, textureHint } from '../../../web/src/formats/targets.ts';
import { forgetRecent, keepRecent, recentFiles } from '../../../web/src/services/recent_files.ts';
import { restorable, saveCones } from '../../../web/src/services/cone_storage.ts';
import { answer, openStore } from '../../../web/src/services/storage.ts';
import { locatedSurface } from '../../../web/src/services/geometry/placed_surface.ts';
import { Mirror } from '../../../web/src/services/geometry/mirror_plane.ts';
import { cliCommand, quoted } from '../../../web/src/text/cli_command.ts';
import { draggedNote, liveText } from '../../../web/src/text/dragged.ts';
import {
  describeError,
  messageForPage,
  whyUnusable,
} from '../../../web/src/text/error_messages.ts';
import { estimate, tooMany } from '../../../web/src/text/estimate.ts';
import * as format from '../../../web/src/text/format.ts';
import { defectsInWords, gzipNote, noteForPage, weldIn } from '../../../web/src/text/notes.ts';
import { askedFor, quadFaults, quadsSaved } from '../../../web/src/text/quads.ts';
import { remarksOn } from '../../../web/src/text/remarks.ts';
import { repairsMade } from '../../../web/src/text/repairs.ts';
import { stageName, stepIndex, wholeFraction } from '../../../web/src/text/stages.ts';
import { TimeLeft } from '../../../web/src/text/time_left.ts';
import { describeTransfer } from '../../../web/src/text/transfer.ts';

const recording = new Recording('functions', import.meta.dirname);

/** The answers of a function to lists of arguments. */
async function table(name, call, ...rows) {
  for (const row of rows) {
    let text;
    try {
      text = valueText(await call(...row), 6);
    } catch (error) {
      text = `fails: ${error.constructor === Error ? error.message : error.name}`; // engines word theirs in their own way
    }
    const given = row.map((one) => valueText(one, 3)).join(', ');
    // The test has what is given.
    recording.add(`${name}(${given.length > 60 ? `${given.slice(0, 60)}…` : given}) = ${text}`);
  }
}
const each = (...values) => values.map((one) => [one]);
const note = (code, numbers = {}, where = []) => ({ code, numbers, words: {}, where });

const surfaceOf = (mesh) => ({ ...locatedSurface({ positions: Float64Array.from(mesh.vertices.flat()), triangles: Uint32Array.from(mesh.triangles.flat()) }, plainFacts(mesh)), ...plainFacts(mesh), triangles: Uint32Array.from(mesh.triangles.flat()), positions: Float64Array.from(mesh.vertices.flat()), places: Float64Array.from(mesh.vertices.flat()), vertexCount: mesh.vertices.length }); // prettier-ignore
const cube = surfaceOf(cubeMesh(3));
const tray = surfaceOf(blocks(['##'], { n: 2, open: ['0 0 +z'] }));

test('sentences', async () => {
  const sizes = [0, 1, 0.96, 9.94, 9.96, 12, 999, 1000, 1048575, 1048576, 12345678, 2 ** 30 - 1, 2 ** 30, 5e9]; // prettier-ignore
  for (const name of ['megabytes', 'memoryText', 'count', 'percentText', 'timesText', 'signed', 'wholeDegrees']) await table(name, format[name], ...each(...sizes, -0.004, -2.5)); // prettier-ignore
  await table('count', format.count, [undefined]);
  await table('plural', format.plural, [0, 'mesh', 'meshes'], [1, 'mesh', 'meshes'], [2, 'cone'], [1234, 'cone']); // prettier-ignore
  await table('listed', format.listed, [[]], [['a']], [['a', 'b']], [['a', 'b', 'c']]);
  await table('bytesOfAll', format.bytesOfAll, [new Map([['a', new Uint8Array(3)], ['b', new Blob(['four'])]])]); // prettier-ignore
  await table('estimate', estimate, [0], [8000, 100], [9000], [700_000], [748_000], [750_500], [2_000_000], [100, 1.1e9]); // prettier-ignore
  await table('tooMany', tooMany, ['a b.obj', 2_345_678]);
  const counts = { quads: 100, clipped: 0, cuts: 0, replaced: 0, halvings: 0, foldedInSpace: 0, foldedQuads: 0 }; // prettier-ignore
  const kinds = [{}, { clipped: 1 }, { clipped: 3 }, { cuts: 1 }, { replaced: 2 }, { halvings: 1 }, { foldedInSpace: 4 }, { foldedQuads: 1 }, { clipped: 2, cuts: 2, replaced: 1, halvings: 2, foldedInSpace: 1, foldedQuads: 3 }]; // prettier-ignore
  for (const kind of kinds) {
    await table('quadFaults', quadFaults, [{ ...counts, ...kind }]);
    await table('quadsSaved', quadsSaved, [{ ...counts, ...kind }, 'a.obj']);
    await table('askedFor', askedFor, ...[undefined, 90, 90.9, 91, 112, 130, 60].map((asked) => [{ ...counts, ...kind }, asked, 8])); // prettier-ignore
  }
  await table('liveText', liveText, ...['heat', 'certified', 'storing', 'fails'].flatMap((state) => [[{ state, notPositive: [], reasons: ['why'] }], [{ state, notPositive: [1, 2], reasons: [] }, true]])); // prettier-ignore
  await table('draggedNote', draggedNote, ...[[true, 4], [false, 4], [true, 6]].map(([isOn, q]) => [{ grid: { isOn }, prescription: { q } }])); // prettier-ignore
  await table('stageName', stageName, ...each('read', 'prepare', 'improve', 'verify', 'other'));
  await table('stepIndex', stepIndex, ...each('read', 'cut', 'assemble', 'improve', 'align', 'verify', 'write', 'other')); // prettier-ignore
  await table('wholeFraction', wholeFraction, ['solve', 0.5, 0], ['solve', 2, 0], ['solve', -1, 0], ['solve', 0.1, 0.7], ['other', 0.5, 0.3], ['write', 1, 0.2]); // prettier-ignore
  for (const pace of [1, 1.2, 3]) {
    const clock = new TimeLeft();
    let now = 0;
    for (const [stage, parts] of Object.entries({ field: [0, 0.5, 0.6, 1], solve: [0, 0.5, 0.9], verify: [0, 0.4, 1] })) for (const part of parts) await table(`TimeLeft at ${pace}`, (...all) => clock.update(...all), [stage, part, wholeFraction(stage, part, 0), 0, (now += part > 0.5 ? pace * 2 : 2)]); // prettier-ignore
  }
  const lost = Array.from({ length: 6 }, (_, i) => note('x', { i }));
  await table('describeTransfer', describeTransfer, [0, []], [1, []], [3, lost.slice(1)], [2, lost.slice(0, 4)], [0, lost]); // prettier-ignore
  const surfaces = [{ uvSets: [] }, { uvSets: [0, 2] }];
  for (const surface of [0, 1]) await table('remarksOn', remarksOn, ...[undefined, { count: 1 }, { count: 3, isMirrored: true }].map((one) => [{ surfaces, surface }, one])); // prettier-ignore
  const repairs = [note('defect-zero-area', { count: 2 }), note('repair-turned', { faces: 1 }), note('repair-split', { vertices: 3, edges: 1 }), note('repair-copies', { faces: 2 })]; // prettier-ignore
  await table('repairsMade', repairsMade, [{ notes: repairs }, { fix: {} }], [{ notes: repairs }, { fix: { orient: true } }], [{ notes: repairs.slice(1) }, { fix: {}, hasAllRepairs: true }], [{ notes: [] }, { fix: { split: true } }], [{ notes: repairs.slice(0, 1) }, { fix: { split: true } }]); // prettier-ignore
  await table('defectsInWords', defectsInWords, [[]], [[{ kind: 'zero-area', fatal: true, count: 1 }, { kind: 'extent', fatal: false, count: 2 }, { kind: 'not-finite', fatal: true, count: 3 }]]); // prettier-ignore
  await table('weldIn', weldIn, [[]], [[note('crack', { weld: 0.1 }), note('crack', { weld: 0.3 })]], [[note('weld-would-join')]], [[note('crack')]]); // prettier-ignore
  await table('noteForPage', noteForPage, [gzipNote(7)], [note('nobody')], [note('a'), { a: 'an {own}' }]); // prettier-ignore
  await table('whyUnusable', whyUnusable, [{ defects: [] }], [{ defects: [], error: { message: 'So.', advice: [note('repair-by-hand')] } }]); // prettier-ignore
  await table('describeError', describeError, [new Error('plain'), 'a.obj'], ['text', 'a.obj']);
  await table('messageForPage', messageForPage, ['So.', []], ['So.', [note('repair-with')]], ['So', [note('repair-by-hand'), note('write-obj')]]); // prettier-ignore
  await table(
    'quoted',
    quoted,
    ...each('plain.obj', 'a b', "it's", '', '-x', 'a"b', '$x', 'ä.obj'),
  );
  const one = { index: 0, name: '', triangles: 1 };
  const model = { main: 'a b.obj', info: { surface: 1, surfaces: [one, one], components: [], file: { format: 'obj' } }, loaded: { fix: { orient: true, split: false }, weld: 0.1 } }; // prettier-ignore
  const models = [model, { main: 'm.GLB', info: { ...model.info, surface: 0, surfaces: [one], components: [1, 2], file: { format: 'glb' } }, loaded: { fix: {} } }, { ...model, loaded: { fix: {}, hasAllRepairs: true } }]; // prettier-ignore
  const prescription = {
    q: 4,
    cones: [{ vertex: 1, k: 3 }],
    turnings: [2, null],
    handles: [1, null],
  };
  const options = [{ rounds: 12, scale: 'solved', gridMode: 'tile' }, { rounds: 5, improve: 0.5, scale: 'fit', cells: 'auto', gridMode: 'quad', field: { name: 'a b.rosy' }, timeLimit: 9 }, { rounds: 1, improve: -1, scale: 'unit', cells: 20, gridMode: 'tile', features: { hasRims: true, edges: [[1, 2]] } }, { rounds: 2, improve: 1, scale: 'solved', gridMode: 'tile', features: { hasRims: false, edges: [] } }]; // prettier-ignore
  const outputs = [{ embedCones: true }, { uvSet: 2, usesNewSet: false, gridTiles: 3, isUncertified: true }, { usesNewSet: true }]; // prettier-ignore
  for (const about of models) await table('cliCommand', cliCommand, ...options.map((each, i) => [about, i === 3 ? emptyPrescription(6, 1, 0) : prescription, each, outputs[i % 3]])); // prettier-ignore
  const many = { ...prescription, cones: Array.from({ length: 300 }, (_, vertex) => ({ vertex, k: 3 })) }; // prettier-ignore
  await table('cliCommand', cliCommand, [model, many, options[0], outputs[0]]);
});

test('names, files and addresses', async () => {
  await table('relativeName', relativeName, ...each('a.bin', './a/b.png', 'a%20b.bin', '../x', 'http://x/y', 'C:x', '/abs', 'a\\b', '%', 'a/../b', 'data:x')); // prettier-ignore
  await table(
    'safeName',
    safeName,
    ...each('a/b c.obj', '..hidden', '', 'ö.obj', `${'x'.repeat(100)}.obj`),
  );
  await table('nameStem', nameStem, ...each('a/b.c.obj', '.obj', 'x'));
  await table('hasDirections', hasDirections, ...each('a.rosy', 'a.FFIELD', 'a.sing'));
  const named = (...names) => new Map(names.map((name) => [name, new Uint8Array(2)]));
  await table('meshesOf', meshesOf, [named('a.OBJ', 'b.txt', 'c.glb', 'obj')]);
  await table('coneFileOf', coneFileOf, [named('a.sing')], [named('cone.json')], [named('my-cones.json')], [named('a.sing', 'b')], [named('x.json')]); // prettier-ignore
  await table('unpack', unpack, [named('f/a.obj', 'f/b.mtl')], [named('f/a.obj', 'g/b.mtl')], [named('f/.x', 'f/a.obj', '__MACOSX/q')], [named('a.obj.gz')]); // prettier-ignore
  const gltf = (json) => new TextEncoder().encode(JSON.stringify(json));
  const asked = { buffers: [{ uri: 'a.bin' }, { uri: 'data:x' }, {}, 3], images: [{ uri: 'i/p.png' }, { uri: '../q.png' }, { uri: 'p%20q.png' }] }; // prettier-ignore
  for (const files of [[], ['a.bin'], ['m/a.bin', 'p.png'], ['other/p q.png']]) await table('findMissing', async (all) => { const map = new Map([['m/x.gltf', gltf(asked)], ...named(...all)]); return [await findMissing(map, 'm/x.gltf'), [...map.keys()]]; }, [files]); // prettier-ignore
  const glb = new Uint8Array(packGlb(toGltf([cubeMesh(1)])));
  for (const end of [glb.length, glb.length - 4, 30, 19, 700]) await table('splitGlb', (to) => splitGlb(glb.subarray(0, to)), [end]); // prettier-ignore
  await table('splitGlb', splitGlb, [Uint8Array.from([...glb, 1, 2, 3])], [new Uint8Array(40)]);
  await table('parseGltf', parseGltf, [{ name: 'a.glb', bytes: glb }], [{ name: 'a.gltf', bytes: gltf([1]) }], [{ name: 'a.gltf', bytes: new Uint8Array(3) }]); // prettier-ignore
  await table('surfaceMeshes', surfaceMeshes, [{ meshes: [{ primitives: [{ mode: 1, attributes: { POSITION: 0 } }] }, { primitives: [{ attributes: { POSITION: 0 } }] }, { primitives: [{ mode: 5, attributes: {} }, { mode: 6, attributes: { POSITION: 1 } }] }, 3] }], [{}]); // prettier-ignore
  await table('summarizePreserved', summarizePreserved, [{}], [{ materials: [1], textures: [1, 2], skins: 3, animations: [1], meshes: [{ primitives: [{ targets: [1, 2] }, { targets: [1] }] }], cameras: [1], extensionsUsed: ['a'] }]); // prettier-ignore
  await table(
    'readPly',
    readPly,
    [new TextEncoder().encode(toPly(cubeMesh(1)))],
    [new Uint8Array(3)],
  );
  for (const { id } of targets) {
    await table('setHint', setHint, [id, 0], [id, 1], [id, 4]);
    await table(
      'formatFor',
      formatFor,
      ...['a.glb', 'a.gltf', 'a.obj', 'a.ply'].map((name) => [id, name]),
    );
  }
  await table('textureHint', textureHint, ...each('kept', 'moved', 'unseen'));
  const look = { pattern: 'checker', overlay: 'angle', tiles: 24.4 };
  const prescription = { q: 4, cones: [{ vertex: 3, k: 2 }], turnings: [null, 2], handles: [1] };
  const solve = { grid: { isOn: true, mode: 'tile' }, rounds: 12 };
  const written = [{ look, prescription, solve }, { look: { ...look, overlay: 'none' }, prescription: emptyPrescription(6, 0, 0), solve: { grid: { isOn: false, mode: 'tile', cells: 9 }, improve: -0.5, rounds: 3, timeLimit: 10 }, example: 'cube', camera: '1,2', model: '00000000.0' }, { look, prescription, solve: { ...solve, grid: { isOn: true, mode: 'quad' } }, features: { hasCreases: true, hasRims: true, edges: [[1, 2]] }, model: '0123abcd.2' }, { look, prescription: { ...prescription, cones: Array.from({ length: 2000 }, (_, vertex) => ({ vertex, k: 3 })) }, solve }]; // prettier-ignore
  await table('writeHash', writeHash, ...each(...written));
  await table('readHash', readHash, ...each(...written.map((one) => writeHash(one).hash)));
  await table('readHash', readHash, ...each('', '#q=0&tiles=0&improve=2&rounds=0&limit=-1', '#q=65&tiles=1001&improve=x&rounds=1001&pattern=image&overlay=no', '#q=64&tiles=1000&improve=-1&rounds=1000&limit=1000000&cells=1&grid=tile', '#q=2.5&grid=quad&cells=1000001', '#cones=%25&edges=W10&example=A', '#cones=W1stMSwzXV0&turnings=W1swLC0xXV0&model=1.1', '#edges=W1sxLDJdXQ&creases=1&rims=1&handles=W1sxXV0')); // prettier-ignore
});

test('cones, grids and lines', async () => {
  await table('largestK', largestK, [4, 3], [4, 6], [6, 5], [1, 3], [3, 3]);
  for (const q of [1, 2, 4, 6]) await table('waysToSpend', waysToSpend, ...[0, 1, 2, 3, 7, 8, 12, 13, 24, 60, -1, -4, -13].map((left) => [left, q])); // prettier-ignore
  const infoOf = (characteristic, loops) => ({ components: [{ component: 0, eulerCharacteristic: characteristic, boundaryLoops: loops }] }); // prettier-ignore
  const plain = { q: 4, cones: [], turnings: [], handles: [] };
  const cones = (...list) => ({ ...plain, cones: list.map(([vertex, k]) => ({ vertex, k })) });
  const eight = cones(...[0, 1, 2, 3, 4, 5, 6, 7].map((vertex) => [vertex, 3]));
  await table('computeBudget', (one) => computeBudget(one, cube, infoOf(2, [])), ...each(plain, eight, cones([0, 3], [0, 3]), cones([0, 0]), cones([0, 99]), cones([-1, 3]), cones([999, 3]), cones([0, 4]), cones([0, 3], [cube.neighbours[0], 3]), cones([20, 1], [30, 9]))); // prettier-ignore
  const rim = [...tray.isBoundary.keys()].find((v) => tray.isBoundary[v]);
  for (const turning of [null, 0, 4]) await table('computeBudget with a rim', (one) => computeBudget({ ...one, turnings: [turning] }, tray, infoOf(1, [{ loop: 0 }])), [plain], [cones([rim, 3])], [cones([1, 3])]); // prettier-ignore
  const budget = computeBudget(plain, cube, infoOf(2, []));
  await table('leftAt', leftAt, [budget, cube, 0], [undefined, cube, 0], [computeBudget({ ...plain, turnings: [null] }, tray, infoOf(1, [{ loop: 0 }])), tray, 0]); // prettier-ignore
  for (const vertex of [0, 9, 20, 40]) for (const left of [-9, -1, 0, 1, 2, 8]) await table('suggestedK', (v, q, n) => suggestedK(cube, v, q, n), [vertex, 4, left], [vertex, 6, left]); // prettier-ignore
  for (const surface of [cube, tray]) {
    const all = [0, 3, 11, 20, 31];
    await table('defectDegrees', (v) => defectDegrees(surface, v), ...each(...all));
    await table('neighbourhood', (v) => neighbourhood(surface, v), ...each(...all));
    await table('curvatureAround', (v) => curvatureAround(surface, v), ...each(...all));
    for (const reach of [0, 0.5, 1.2, 9]) await table('cornerNear', (v) => cornerNear(surface, v, (w) => Math.hypot(...[0, 1, 2].map((i) => surface.positions[3 * v + i] - surface.positions[3 * w + i])) < reach), ...each(...all)); // prettier-ignore
    const mirror = new Mirror(surface);
    await table('opposite', (v) => mirror.opposite(v), ...each(...all));
    const uv = Float32Array.from([...surface.triangles].flatMap((v) => [2 * surface.positions[3 * v], surface.positions[3 * v + 1]])); // prettier-ignore
    await table('scaleAt', (t) => scaleAt(surface, uv, t), ...each(0, 3, 7));
  }
  await table('indexText', indexText, [3, 4], [5, 4], [4, 4], [2, 4], [8, 6], [1, 6]);
  await table('angleText', angleText, [3, 4], [1, 7], [5, 6]);
  const whole = { q: 4, cones: [{ vertex: 1, k: 3 }], turnings: [2, null], handles: [null, 3] };
  await table('toCones', toCones, [whole], [whole, Float64Array.from([0, 0, 0, 1, 2, 3])]);
  await table('fromCones', fromCones, [toCones(whole), 2, 2], [{ q: 4, cones: [] }, 1, 0], [{ ...toCones(whole), boundaries: [{ loop: 5, l: 1 }] }, 2, 1]); // prettier-ignore
  await table(
    'withOrder',
    withOrder,
    ...[0, 1, 2, 3, 6, 8, 64, 65, 2.5, NaN].map((q) => [whole, q]),
  );
  await table('samePrescription', samePrescription, ...[{}, { q: 6 }, { cones: [] }, { turnings: [2, 0] }, { handles: [0, 3] }, { cones: [{ vertex: 1, k: 2 }] }].map((one) => [whole, { ...whole, ...one }])); // prettier-ignore
  await table('isSilent', isSilent, [plain], [whole], [{ ...plain, turnings: [null], handles: [null] }], [{ ...plain, handles: [0] }]); // prettier-ignore
  await table('niceLength', niceLength, ...each(0.0001, 0.3, 1, 1.9, 2, 4.9, 5, 9.9, 10, 1234));
  const grid = (aligned, workingCells, cells = 100.4) => ({ grid: { aligned, cells, spacing: 0.25, workingCells, reason: aligned ? undefined : note('grid-x') } }); // prettier-ignore
  const solutionOf = (components, integerSeams = 5) => ({ result: { report: { components }, certificate: { integerSeams, seamEdges: 5 }, cones: { cones: [1, 2, 3] } }, distortion: { uvArea: 9, surfaceArea: 4 } }); // prettier-ignore
  const solutions = [solutionOf([{}]), solutionOf([grid(true, 0)]), solutionOf([grid(true, 0)], 4), solutionOf([grid(true, 0), grid(false, 300)]), solutionOf([grid(false, 0)]), solutionOf([grid(false, 50, 20), grid(false, 130, 100)]), solutionOf([grid(true, 0), {}])]; // prettier-ignore
  await table('gridOutcome', gridOutcome, ...each(...solutions));
  for (const pattern of ['checker', 'grid', 'cross', 'wood']) {
    const one = { pattern, tiles: 20, steps: 3, seams: 'auto' };
    await table('hasSteps', hasSteps, [one, undefined], [one, solutions[0]], [one, solutions[1]]);
    await table('tilesPerUnit', tilesPerUnit, [one, { diagonal: 2 }, solutions[0]], [one, { diagonal: 2 }, solutions[1]]); // prettier-ignore
    await table('gridTilesPerUnit', gridTilesPerUnit, [one, { diagonal: 2 }, solutions[0]], [one, { diagonal: 2 }, solutions[1]]); // prettier-ignore
    await table('sameTiles', sameTiles, [one, { diagonal: 2 }, solutions[1], solutions[0]], [one, { diagonal: 2 }, solutions[0], solutions[1]]); // prettier-ignore
    await table('isTurnedBy', isTurnedBy, ...[0, 1, 2, 3].map((r) => [pattern, r, 4]), [
      pattern,
      1,
      6,
    ]);
    await table('turnedSeams', turnedSeams, [pattern, { seams: [{ r: 0 }, { r: 1 }, { r: 2 }], chains: [0, 0, 1], prescription: { q: 4 } }]); // prettier-ignore
  }
  const cells = { isOn: true, mode: 'tile', cells: 9 };
  await table('sameGrid', sameGrid, ...[{}, { cells: 8 }, { mode: 'quad' }, { isOn: false }].flatMap((one) => [[cells, { ...cells, ...one }, 4], [cells, { ...cells, ...one }, 6]]), [{ isOn: false, cells: 1 }, { isOn: false, cells: 2 }, 4]); // prettier-ignore
  const fate = (preserved, ...codes) => ({ preserved, notes: codes.map((code) => note(code)) });
  for (const one of [
    fate(''),
    fate('2 textures'),
    fate('1 texture', 'write-set-used'),
    fate('1 texture', 'write-set-replaced'),
    fate('1 texture', 'write-set-unseen'),
  ]) {
    // prettier-ignore
    await table('textureFate', textureFate, [one]);
    await table('chosenSet', chosenSet, [{}, one], [{ uvSet: 0 }, one], [{ usesNewSet: true }, one], [{ usesNewSet: false }, one]); // prettier-ignore
  }
  let history = History.of('a');
  for (const [value, kind, now] of [
    ['b', 'x: 1', 0],
    ['c', 'x: 1', 300],
    ['d', 'x: 2', 400],
    ['e', 'y', 1500],
    ['f', 'y', 2000],
    ['g', 'y', 2600],
  ]) {
    // prettier-ignore
    history = history.push(value, kind, now);
    recording.add(`history ${valueText([history.value, history.undoKind, history.canUndo, history.canRedo])}`); // prettier-ignore
  }
  for (const step of ['undo', 'undo', 'redo', 'undo', 'undo', 'undo', 'undo', 'undo']) {
    history = history[step]?.() ?? history;
    recording.add(`${step} ${valueText([history.value, history.undoKind, history.redoKind, history.canUndo, history.canRedo])}`); // prettier-ignore
  }
  const choice = { hasCreases: true, hasRims: false, edges: [[1, 2], [2, 3], [7, 8]], rims: [] }; // prettier-ignore
  await table('countRuns', countRuns, [choice.edges], [[]], [[[1, 2], [3, 2], [2, 4]]], [[[1, 2], [2, 3], [3, 1]]]); // prettier-ignore
  for (const one of [
    choice,
    { ...choice, hasRims: true },
    { ...choice, edges: [], hasRims: true },
    { ...choice, hasCreases: false },
  ])
    for (const rims of [0, 1, 3]) {
      // prettier-ignore
      await table('followedLines', followedLines, [one, rims]);
      await table('featuresText', featuresText, [one, rims]);
    }
  await table('sameFeatures', sameFeatures, [choice, choice], [choice, undefined], [undefined, undefined], [choice, { ...choice, edges: [[3, 2], [8, 7], [2, 1]] }], [choice, { ...choice, hasRims: true }]); // prettier-ignore
  await table('withChain', withChain, [choice, [[9, 1]], false], [choice, [[2, 1]], true], [choice, [[2, 1]], false]); // prettier-ignore
  await table('edgesOf', edgesOf, [JSON.stringify({ lines: [{ vertices: [1, 2, 3] }, { vertices: [4] }] })], ['{}'], ['x']); // prettier-ignore
  for (const [name, surface] of Object.entries({ cube, tray })) {
    const map = new EdgeMap(surface);
    const edges = [0, 4, 9, 17, 30].map((t) => [surface.triangles[3 * t], surface.triangles[3 * t + 1]]); // prettier-ignore
    await table(`chain on the ${name}`, (edge) => map.chainThrough(edge), ...each(...edges));
    await table(`sharp on the ${name}`, (edge) => [map.isSharp(edge), map.isRim(edge)], ...each(...edges)); // prettier-ignore
    recording.add(`rims of the ${name} ${valueText(map.rims())}`);
    const [from] = map.rims();
    if (from) await table(`chain on the rim`, (edge) => map.chainThrough(edge), [from]);
  }
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 2 1 1\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 2 5 6 3\n'; // prettier-ignore
  const shape = readQuads(new TextEncoder().encode(text));
  await table('readQuads', () => shape, []);
  await table('valencesOf', valencesOf, [shape]);
  await table('bendOf', (f) => bendOf(shape, f), [0], [1]);
});

/** Until what the database does in turns of the event loop is done. */
async function calm() {
  for (let i = 0; i < 500; i++) await new Promise((resolve) => setImmediate(resolve));
}

test('what is kept in the browser', async () => {
  const kept = database((act) => setImmediate(act));
  const [dateNow, indexed] = [Date.now, globalThis.indexedDB];
  let now = 1000;
  Date.now = () => (now += 10);
  globalThis.indexedDB = kept;
  const place = (sha256, surface = 0) => ({ file: { sha256 }, surface });
  const good = { q: 4, cones: [{ vertex: 1, k: 3 }], turnings: [null, -2], handles: [1] };
  await table('restorable', restorable, [place('a')]);
  await saveCones(place('a'), good);
  await saveCones(place('a', 2), { ...good, q: 6 });
  await table('restorable', restorable, [place('a')], [place('a', 2)], [place('a', 1)]);
  const bad = [{ version: 1 }, { time: 'x' }, { prescription: undefined }, ...[{ q: 0 }, { q: 1 }, { q: 2.5 }, { q: -4 }, { cones: {} }, { cones: [{ vertex: -1, k: 3 }] }, { cones: [{ vertex: 1, k: 0.5 }] }, { cones: [{ vertex: 0, k: 3 }] }, { cones: [null] }, { turnings: 'x' }, { turnings: '' }, { turnings: [0.5] }, { turnings: [undefined] }, { handles: null }, { handles: ['1'] }].map((one) => ({ prescription: { ...good, ...one } }))]; // prettier-ignore
  for (const one of bad) {
    await table('restorable as stored', async () => {
      const store = await openStore({ database: 'hgp', name: 'cones', keyPath: 'sha256', indices: ['time'] }, 'readwrite'); // prettier-ignore
      store.put({ sha256: 'b', time: 5, version: 2, prescription: good, ...one });
      return restorable(place('b'));
    }, [one]); // prettier-ignore
  }
  for (let i = 0; i < 203; i++) await saveCones(place(`n${i}`), good);
  await calm();
  recording.add(`stored ${kept.all.get('hgp').get('cones').entries.size}`);
  await table('restorable, the oldest', restorable, [place('a')], [place('n0')], [place('n202')]);
  // Two who miss a store at the same time both get it, and what is stored stays.
  const other = { database: 'hgp', name: 'other', keyPath: 'x' };
  const both = await Promise.all([1, 2].map(() => openStore(other, 'readwrite')));
  both.forEach((store, x) => store.put({ x }));
  await table('openStore', async () => answer((await openStore(other, 'readonly')).getAll()), []);
  await table('restorable, beside another store', restorable, [place('n202')]);
  await table('answer', answer, [{}].map((request) => (setImmediate(() => request.onerror()), [request]))[0]); // prettier-ignore
  for (let i = 0; i < 8; i++) await keepRecent(`id${i}`, `m${i}.obj`, new Map([['m.obj', i % 2 ? new Blob(['abc']) : new Uint8Array(i)]])); // prettier-ignore
  await calm();
  await table('recentFiles', recentFiles, []);
  await keepRecent('large', 'l.obj', new Map([['l.obj', { size: 0 }], ['big', new Uint8Array(48 * 2 ** 20 + 1)]]).set('l.obj', new Uint8Array(1))); // prettier-ignore
  await keepRecent('most', 'most.obj', new Map([['big', new Uint8Array(48 * 2 ** 20)]]));
  await table('recentFiles', async () => (await recentFiles()).map(({ id }) => id), []);
  for (const one of [
    { main: 3 },
    { id: 'x', main: 3 },
    { time: 'x' },
    { files: 'x' },
    { files: [3] },
    { files: [['a', 'b']] },
    { files: [] },
  ]) {
    // prettier-ignore
    await table('recentFiles as stored', async () => {
      const store = await openStore({ database: 'hgp-recent', name: 'files', keyPath: 'id' }, 'readwrite'); // prettier-ignore
      await answer(store.clear());
      await answer(store.put({ id: 'i', main: 'm', time: 1, files: [['a', new Blob(['x'])]], ...one }));
      return recentFiles();
    }, [one]); // prettier-ignore
  }
  await forgetRecent();
  await table('recentFiles', recentFiles, []);
  globalThis.indexedDB = undefined;
  await table('recentFiles', recentFiles, []);
  await table('restorable', restorable, [place('n202')]);
  await table('saveCones', saveCones, [place('a'), good]);
  await table('keepRecent', keepRecent, ['a', 'b', new Map()]);
  await table('forgetRecent', forgetRecent, []);
  Date.now = dateNow;
  globalThis.indexedDB = indexed;
  recording.end();
});
