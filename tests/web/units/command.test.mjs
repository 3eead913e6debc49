// The command that the page copies does the run of the page: executed by a shell, it writes the same bytes.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { loadOptionsOf, plainOutput } from '../../../web/src/model/plain.ts';
import { fromCones, toCones } from '../../../web/src/model/prescription.ts';
import { cliCommand } from '../../../web/src/text/cli_command.ts';
import { randomFrom } from '../../mutation/draw.mjs';
import { bumpyDisk } from '../../support/disk.mjs';
import { cubeCrosses, cubeMesh, toGlb, toObj } from '../../support/meshes.mjs';
import { torusMesh } from '../shapes.mjs';

const root = path.resolve(import.meta.dirname, '../../..');
const built = path.join(root, 'build/package/node/core.js');
const program = process.env.HGP_BIN ?? path.join(root, 'build/native-release/bin/hgp');
const absent = [built, program].filter((file) => !existsSync(file));
const skip = absent.length > 0 ? `${absent} is not there` : false;
const { createCore } = skip ? {} : await import(built);
const folder = path.join(root, 'build/command-tests');

const bytesOf = (content) =>
  typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content);
const plain = { fix: {} };
const all = { fix: {}, hasAllRepairs: true };
const fin = () => {
  const { vertices, triangles } = cubeMesh(3);
  const [a, b] = triangles[0];
  return {
    vertices: [...vertices, [-2, -2, -2]],
    triangles: [...triangles, [a, b, vertices.length]],
  };
};
const field = { name: 'cube.rosy', text: cubeCrosses(cubeMesh(4)) };

/** name: [file, content, load settings, options of the run, output settings] */
const cases = {
  'the page as it opens': ['cube.obj', toObj(cubeMesh(5)), plain, { rounds: 12 }],
  'the rounds of the command line': ['disk.obj', bumpyDisk(7), plain, { rounds: 24 }],
  'average edge 1': ['cube.obj', toObj(cubeMesh(4)), plain, { scale: 'unit' }],
  fitted: ['cube.glb', toGlb([cubeMesh(4)]), plain, { scale: 'fit' }],
  'a grid': ['cube.obj', toObj(cubeMesh(8)), plain, { cells: 500 }],
  'a quad mesh': ['cube.obj', toObj(cubeMesh(8)), plain, { cells: 700, gridMode: 'quad' }],
  'less distortion': ['torus.obj', toObj(torusMesh(12, 8)), plain, { improve: 0 }],
  'between angles and areas': ['disk.obj', bumpyDisk(6), plain, { improve: -0.35 }],
  'the second mesh': ['two.glb', toGlb([cubeMesh(4), cubeMesh(3)]), plain, {}, {}, 1],
  'no cones in the file': ['cube.obj', toObj(cubeMesh(3)), plain, {}, { embedCones: false }],
  'another set of uv': [
    'cube.glb',
    toGlb([cubeMesh(3)]),
    plain,
    {},
    { uvSet: 0, usesNewSet: true },
  ],
  'a GLB that is named .obj': ['cube.obj', toGlb([cubeMesh(4)]), plain, {}],
  'a grid as the material': ['cube.glb', toGlb([cubeMesh(3)]), plain, {}, { gridTiles: 2.7182 }],
  'repairs chosen one by one': [
    'fin.obj',
    toObj(fin()),
    { fix: { split: true, degenerate: true } },
    {},
  ],
  'all repairs': ['fin.obj', toObj(fin()), all, {}],
  welded: ['cube.obj', toObj(cubeMesh(4)), { ...plain, weld: 0 }, {}],
  'welded within a length': ['disk.obj', bumpyDisk(6), { ...plain, weld: 1e-5 }, {}],
  'frames of a field': ['cube.obj', toObj(cubeMesh(4)), plain, { field }],
  'a name for the shell': ["it's $HOME; -x.obj", toObj(cubeMesh(3)), plain, {}],
};

for (const [what, [main, content, loaded, asked, written = {}, surface]] of Object.entries(cases))
  test(`the copied command writes the same bytes: ${what}`, { skip }, async () => {
    const options = { rounds: 12, scale: 'solved', gridMode: 'tile', ...asked };
    const output = { ...plainOutput, isUncertified: false, ...written };
    const core = await createCore();
    const files = new Map([[main, bytesOf(content)]]);
    const model = core.load({ main, files }, { name: main, surface, ...loadOptionsOf(loaded) });
    const { info } = model;
    // As the page does: automatic cones become the prescription, with everything that they leave open.
    const { field: given, cells, improve, scale, gridMode } = options;
    const found = given ? model.readCones(given) : model.suggestCones({ q: 4 });
    const prescription = fromCones(found, info.boundaryLoops ?? 0, 2 * (info.genus ?? 0));
    const map = model.parametrize({
      ...{ cones: toCones(prescription), maxRounds: options.rounds, improve, scale },
      ...{ keepGoing: (info.components?.length ?? 1) > 1 },
      ...(given ? { field: given, frames: 'file' } : {}),
      ...(cells === undefined ? {} : { grid: { cells, mode: gridMode } }),
    });
    assert.equal(map.certificate.certified, true);
    const { embedCones, uvSet, usesNewSet, gridTiles } = output;
    const file = map.write({
      ...{ allowUncertified: true, embedCones, use: usesNewSet, gridMaterial: gridTiles },
      ...(uvSet === undefined ? {} : { uvSet }),
    });

    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    writeFileSync(path.join(folder, main), bytesOf(content));
    if (given) writeFileSync(path.join(folder, given.name), given.text);
    const command = cliCommand({ main, info, loaded }, prescription, options, output);
    assert.match(command, /^hgp param /);
    // Few meshes need many rounds; the number is that of the run all the same.
    assert.ok(command.includes(` --rounds ${options.rounds} `), command);
    const inShell = command.replace(/^hgp /, `${program} `);
    const { status, stderr } = spawnSync('sh', ['-c', inShell], { cwd: folder, encoding: 'utf8' });
    assert.equal(status, 0, `${command}\n${stderr}`);
    const name = `${main.replace(/\.[^.]*$/, '')}.mapped.${info.file.format}`;
    const bytes = readFileSync(path.join(folder, name));
    assert.ok(bytes.equals(file.bytes), `${command}: other bytes (${bytes.length})`);
  });

test('the command has what is prescribed, up to forty cones word by word, and of the rest what was chosen', () => {
  const random = randomFrom(9);
  const below = (n) => Math.floor(n * random());
  const perhaps = (make) => (random() < 0.5 ? undefined : make());
  for (let round = 0; round < 300; round++) {
    const count = [0, 1, below(40), 39, 40, 41, 42, 90][below(8)];
    const prescription = {
      q: 1 + below(8),
      cones: Array.from({ length: count }, () => ({ vertex: below(100), k: 1 + below(9) })),
      turnings: Array.from({ length: below(3) }, () => (random() < 0.4 ? null : below(5) - 2)),
      handles: Array.from({ length: below(3) }, () => (random() < 0.4 ? null : below(4))),
    };
    const surfaces = Array.from({ length: 1 + below(3) }, (_, index) => ({ index }));
    const components = perhaps(() => Array.from({ length: 1 + below(3) }, () => ({})));
    const info = { surface: below(surfaces.length), surfaces, components, file: { format: 'obj' } };
    const isOn = () => random() < 0.5;
    const loaded = { weld: perhaps(() => below(3) / 4), fix: { split: isOn(), orient: isOn() }, hasAllRepairs: isOn() }; // prettier-ignore
    const options = { rounds: 1 + below(99), scale: ['solved', 'unit', 'fit'][below(3)], improve: perhaps(() => below(9) / 4 - 1), cells: perhaps(() => below(9)), gridMode: ['tile', 'quad'][below(2)], field: perhaps(() => ({ name: 'a.rosy' })), timeLimit: perhaps(() => below(9)) }; // prettier-ignore
    const output = { uvSet: perhaps(() => below(3)), usesNewSet: perhaps(isOn), embedCones: isOn(), gridTiles: perhaps(() => below(3)), isUncertified: isOn() }; // prettier-ignore
    const words = cliCommand({ main: 'in/cube.obj', info, loaded }, prescription, options, output).split(' '); // prettier-ignore

    const { q, cones, turnings, handles } = prescription;
    const pairs = (name, values) => values.flatMap((x, i) => (x === null ? [] : [name, `${i}:${x}`])); // prettier-ignore
    const given = count > 40
      ? ['--cones', 'cube.cones.json']
      : [...cones.flatMap(({ vertex, k }) => ['--cone', `${vertex}:${k}`]), ...pairs('--turning', turnings), ...pairs('--handle', handles)]; // prettier-ignore
    const fixes = Object.keys(loaded.fix).filter((name) => loaded.fix[name]);
    const { improve, cells, field } = options;
    const word = new Map([[-1, 'conformal'], [0, 'isometric'], [1, 'area']]).get(improve) ?? improve; // prettier-ignore
    const when = (is, ...list) => (is ? list.map(String) : []);
    const expected = [
      ...['hgp', 'param', 'in/cube.obj', '--q', String(q)],
      ...given,
      ...when(surfaces.length > 1, '--mesh', info.surface),
      ...when(loaded.weld !== undefined, '--weld', loaded.weld === 0 ? 'exact' : loaded.weld),
      ...when(!loaded.hasAllRepairs && fixes.length > 0, '--fix', fixes.join(',')),
      ...when(!loaded.hasAllRepairs && fixes.length === 0, '--strict'),
      ...when(true, '--rounds', options.rounds),
      ...when(field, '--field', 'a.rosy', '--frames', 'file'),
      ...when(improve !== undefined, `--improve=${word}`),
      ...when(options.scale !== 'solved', '--scale', options.scale),
      ...when(cells !== undefined, '--cells', cells, '--grid-mode', options.gridMode),
      ...when(options.timeLimit !== undefined, '--time-limit', options.timeLimit),
      ...when(components?.length > 1, '--keep-going'),
      ...when(output.uvSet !== undefined, '--uv-set', output.uvSet),
      ...when(output.usesNewSet === true, '--use'),
      ...when(output.usesNewSet === false, '--use=false'),
      ...when(output.embedCones, '--embed-cones'),
      ...when(output.gridTiles !== undefined, `--grid-material=${output.gridTiles}`),
      ...when(output.isUncertified, '--allow-uncertified'),
      ...['--reproducible', '-o', 'cube.mapped.obj'],
    ];
    const grouped = (all) => all.join(' ').split(/ (?=-)/); // each option with what belongs to it
    assert.deepEqual(grouped(words).sort(), grouped(expected).sort());
    const placed = (all) => grouped(all).filter((one) => one.startsWith('--cone '));
    assert.deepEqual(placed(words), placed(expected), 'cones in their order');
  }
});
