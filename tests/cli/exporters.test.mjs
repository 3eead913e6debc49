// Files as programs write them are mapped without an option; what is written holds a map, decided by code of its own,
// and nothing else in a glTF has changed.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { checkFile } from '../support/check_file.mjs';
import { assertLaw } from '../gltf/law.mjs';
import { gltfFiles, objFiles, offFiles, plyFiles, stlFiles } from '../support/exporters.mjs';
import { openFile } from '../gltf/container.mjs';
import { inFolder } from '../support/program.mjs';
import { sentenceOf } from '../support/notes.mjs';

const { at, run } = inFolder('exporters');
let count = 0;

/** Vertices that are not finite are said where they are, and only there. */
const saysNotFinite = (err, name) =>
  assert.equal(/no finite position/.test(err), /^vertices .*numbers/.test(name), err);

/** Writes the files into a folder of their own, and runs `hgp param` on the first. */
function mapped(files, output) {
  const place = `${count++}`;
  mkdirSync(at(path.join(place, 'out')), { recursive: true });
  for (const [name, bytes] of Object.entries(files))
    writeFileSync(at(path.join(place, name)), bytes);
  const main = path.join(place, Object.keys(files)[0]);
  const written = path.join(place, 'out', output ?? Object.keys(files)[0]);
  const json = path.join(place, 'report.json');
  const { code, err } = run(['param', main, '-o', written, '--json', json]);
  assert.equal(code, 0, err);
  const report = JSON.parse(readFileSync(at(json), 'utf8'));
  return { err, report, original: at(main), written: at(written) };
}

/** The mesh with triangles, and the set behind the last that it has. */
function placeOfMap(file) {
  const { meshes } = JSON.parse(openFile(readFileSync(file)).text);
  const listed = (mesh) => mesh.primitives.filter(({ mode = 4 }) => mode >= 4);
  const sets = (mesh) =>
    listed(mesh).flatMap(({ attributes }) =>
      Object.keys(attributes).flatMap((name) => name.match(/^TEXCOORD_(\d+)$/)?.[1] ?? []),
    );
  const target = meshes.findIndex((mesh) => listed(mesh).length > 0);
  return { target, set: Math.max(-1, ...sets(meshes[target]).map(Number)) + 1 };
}

function outsideOf(report) {
  const { duplicates, zeroArea, reversed } = report.certificate.stored;
  return duplicates + zeroArea + reversed;
}

for (const [name, files] of Object.entries(gltfFiles)) {
  test(`glTF: ${name}`, async () => {
    const { original, written, report, err } = mapped(files);
    const reports = report.meshes ? report.meshes.map(({ document }) => document) : [report];
    for (const one of reports) assert.equal(one.certificate.stored.triangles, 108);
    const checked = await checkFile(written, 'gltf', { outside: 0 });
    assert.ok(checked.good, checked.why);
    // A missing image, which does not matter for the map, is reported.
    assert.equal(sentenceOf('read-file-refused').test(err), /picture|texture/.test(name), err);
    saysNotFinite(err, name);
    if (reports.length > 1) return;
    await assertLaw(original, written, { ...placeOfMap(original), hasUv: false });
  });
}

const polygons = { ply: plyFiles, obj: objFiles, off: offFiles, stl: stlFiles };
for (const [kind, all] of Object.entries(polygons)) {
  for (const [name, bytes] of Object.entries(all)) {
    test(`${kind.toUpperCase()}: ${name}`, async () => {
      const { written, report, err } = mapped(
        { [`a.${kind}`]: bytes },
        kind === 'obj' ? 'a.obj' : 'b.obj',
      );
      const checked = await checkFile(written, 'polygon', { outside: outsideOf(report) });
      assert.ok(checked.good, checked.why);
      const { stored } = report.certificate;
      saysNotFinite(err, name);
      assert.equal(stored.verified, 108, 'every triangle that has a surface');
    });
  }
}
