// A quantity has one definition: what the command line verifies of a file, what the package says of the same file, and
// what the page writes beside it are the same numbers.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after } from 'node:test';
import { compareRuns } from '../../../web/src/model/compare.ts';
import { verdictRows } from '../../../web/src/model/verdict.ts';
import { analyse } from '../../../web/src/services/geometry/analyse.ts';
import { beside, blocks, eight } from '../../support/blocks.mjs';
import { cubeMesh, toGlb, toObj } from '../../support/meshes.mjs';

const root = path.resolve(import.meta.dirname, '../../..');
const core = path.join(root, 'build/package/node/core.js');
const hgp = process.env.HGP_BIN ?? path.join(root, 'build/native-release/bin/hgp');
const absent = [core, hgp].filter((file) => !existsSync(file));
const skip = absent.length > 0 && `not there, build it first: ${absent.join(', ')}`;
const folder = mkdtempSync(path.join(os.tmpdir(), 'hgp-one-definition-'));
after(() => rmSync(folder, { recursive: true }));

const meshes = {
  'a rounded cube': ['cube.obj', toObj(cubeMesh(6))],
  'two handles, with overlaps': ['eight.glb', toGlb([blocks(eight, { n: 3 })])],
  'two components': ['two.obj', toObj(beside(cubeMesh(4), blocks(eight)))],
};

const near = (a, b, what, within = 1e-9) =>
  assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${what}: ${a} and ${b}`);

const sameNumbers = ['seamEdges', 'brokenSeams', 'exactSeams', 'integerSeams', 'flipped'];
const areas = ['rmsLogArea', 'p95LogArea', 'minLogArea', 'maxLogArea'];

for (const [what, [name, content]] of Object.entries(meshes))
  test(
    `${what}: least and most area, overlaps and seams are the same numbers in all programs`,
    { skip },
    async () => {
      const { createCore } = await import(core);
      const solver = await createCore();
      const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
      const model = solver.load({ main: name, files: new Map([[name, new Uint8Array(bytes)]]) });
      const map = model.parametrize({});
      const written = map.write();
      const file = path.join(folder, written.name);
      writeFileSync(file, written.bytes);
      const { status, stderr } = spawnSync(hgp, ['verify', file, '--json', `${file}.json`]);
      assert.equal(status, 0, `${stderr}`);
      const native = JSON.parse(readFileSync(`${file}.json`, 'utf8'));
      const again = solver.load({
        main: written.name,
        files: new Map([[written.name, written.bytes]]),
      });
      // Of what is in the file, command line and package; of the map, what was said when it was made.
      for (const [who, certificate] of [
        ['verify', again.verify()],
        ['param', map.certificate],
      ]) {
        for (const key of sameNumbers) assert.equal(certificate[key], native[key], `${who} ${key}`);
        assert.equal(certificate.overlap.layers, native.overlap.layers, who);
        near(certificate.overlap.share, native.overlap.share, `${who} overlap`);
        certificate.components.forEach(({ distortion }, at) => {
          for (const key of areas)
            near(distortion[key], native.components[at].distortion[key], `${who} ${key}`, 1e-6);
        });
      }
      // What the page computes and writes.
      const surface = { ...model.facts(), vertexCount: map.positions.length / 3 };
      const measures = map.measure();
      const { analysis } = analyse({ map, measures, files: written.files, mesh: 0 }, surface);
      const prescription = { q: 4, cones: map.cones.cones, turnings: [], handles: [] };
      const solution = { ...analysis, prescription, written, files: written.files, result: map };
      const all = native.components.map((one) => one.distortion);
      near(analysis.distortion.area.min, Math.min(...all.map((d) => d.minLogArea)), 'least', 1e-5);
      near(analysis.distortion.area.max, Math.max(...all.map((d) => d.maxLogArea)), 'most', 1e-5);
      if (all.length === 1) near(analysis.distortion.areaSize.p95, all[0].p95LogArea, 'p95', 1e-5);
      const cells = new Map(compareRuns([solution]).map((row) => [row.name, row.cells[0].text]));
      const share = 100 * native.overlap.share;
      assert.equal(cells.get('Overlaps'), share > 0 && share < 0.05 ? 'under 0.1 %' : `${share.toFixed(1)} %`); // prettier-ignore
      const seams = verdictRows(solution).find((row) => row.name === 'Seams');
      assert.equal(seams.value, `0 broken of ${native.seamEdges}`);
      assert.equal(map.seams.length, native.seamEdges, 'seams that the page draws');
      assert.equal(share > 0, what !== 'a rounded cube', `${share} % overlap`);
    },
  );
