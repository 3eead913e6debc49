// One file of several meshes: the choice of texture coordinates in Download holds for all of them, and what the page
// says of the file is what `hgp verify` says of its bytes.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { Document, NodeIO } from '@gltf-transform/core';
import { cubeMesh } from '../support/meshes.mjs';
import { torusMesh } from './shapes.mjs';
import { commandLine, openFiles, saveAs, state, statusSays, useBrowser } from './support.mjs';

const it = useBrowser({ acceptDownloads: true });
const { test } = it;

/** A GLB of meshes with two sets of coordinates each, both used by the mesh's material; not a map of anything. */
async function withTwoSets(meshes) {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  const image = document.createTexture().setMimeType('image/png').setImage(onePixel);
  for (const [i, { vertices, triangles }] of meshes.entries()) {
    const array = (type, values) =>
      document.createAccessor().setBuffer(buffer).setType(type).setArray(values);
    const uv = () => array('VEC2', new Float32Array(vertices.flatMap(([x, y, z]) => [x + z, y])));
    const material = document.createMaterial(`material ${i}`);
    material.setBaseColorTexture(image).setEmissiveTexture(image);
    material.getBaseColorTextureInfo().setTexCoord(0);
    material.getEmissiveTextureInfo().setTexCoord(1);
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', array('VEC3', new Float32Array(vertices.flat())))
      .setAttribute('TEXCOORD_0', uv())
      .setAttribute('TEXCOORD_1', uv())
      .setIndices(array('SCALAR', new Uint32Array(triangles.flat())))
      .setMaterial(material);
    const mesh = document.createMesh(`mesh ${i}`).addPrimitive(primitive);
    scene.addChild(document.createNode().setMesh(mesh));
  }
  return Buffer.from(await new NodeIO().writeBinary(document));
}
const onePixel = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==',
  'base64',
);

/** What the materials of the meshes read: the sets of their colour and of their emission. */
const setsRead = (root) =>
  root.listMaterials().map((material) => {
    const colour = material.getBaseColorTextureInfo().getTexCoord();
    return [colour, material.getEmissiveTextureInfo().getTexCoord()];
  });

const setsOf = (root) =>
  root.listMeshes().map((mesh) => {
    const names = mesh.listPrimitives()[0].listSemantics();
    return names.filter((name) => name.startsWith('TEXCOORD')).join(' ');
  });

test('the choice of coordinates in Download holds for every mesh of the file, and `hgp verify` certifies all', async (t) => {
  const { page } = it;
  const program = commandLine(t);
  const folder = mkdtempSync(path.join(tmpdir(), 'hgp-page-'));
  t.after(() => rmSync(folder, { recursive: true }));
  await openFiles(it, { 'two.glb': await withTwoSets([cubeMesh(3), torusMesh(16, 8)]) });
  await page.click('header #run-all');
  await statusSays(it, /2 meshes certified/);
  const three = 'TEXCOORD_0 TEXCOORD_1 TEXCOORD_2';
  const wanted = {
    keep: { sets: three, read: [0, 1] },
    use: { sets: three, read: [2, 2] },
    0: { sets: 'TEXCOORD_0 TEXCOORD_1', read: [0, 1] },
    1: { sets: 'TEXCOORD_0 TEXCOORD_1', read: [0, 1] },
  };
  for (const choice of ['use', '0', '1', 'keep']) {
    await page.click('#download');
    await page.selectOption('#uv-set', choice);
    await page.waitForFunction(
      (value) =>
        document.querySelector('#uv-set')?.value === value && !document.querySelector('#cancel'),
      choice,
    );
    await page.keyboard.press('Escape');
    await state(page, 'certified');
    const { bytes } = await saveAs(it, 'same');
    await statusSays(it, /2 meshes in one file, all certified/);
    const root = (await new NodeIO().readBinary(new Uint8Array(bytes))).getRoot();
    const { sets, read } = wanted[choice];
    assert.deepEqual(setsOf(root), [sets, sets], choice);
    assert.deepEqual(setsRead(root), [read, read], choice);
    const file = path.join(folder, `two-${choice}.glb`);
    writeFileSync(file, bytes);
    if (!program) continue;
    const { status, stdout } = spawnSync(program, ['verify', file], { encoding: 'utf8' });
    assert.equal(status, 0, `${choice}: ${stdout}`);
  }
});
