// The directions in which modules may include one another. This table is the law; a change of it is a
// change of the design and wants a page in docs/decisions.

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { filesOf, moduleOf, textOf } from './source_tree.mjs';

// The verifier shares no code with what it verifies: verify sees mesh and base and nothing else.
// io speaks of meshes and prescriptions and nothing else; only api, the API boundary, sees everything.
const mayInclude = {
  base: [],
  linalg: ['base'],
  mesh: ['base'],
  verify: ['mesh', 'base'],
  text: ['base'],
  prescription: ['text', 'mesh', 'base'],
  io: ['prescription', 'text', 'mesh', 'base'],
  field: ['linalg', 'mesh', 'base'],
  cones: ['field', 'linalg', 'mesh', 'base'],
  features: ['field', 'linalg', 'mesh', 'base'],
  seams: ['mesh', 'base'],
  cut: ['seams', 'field', 'linalg', 'mesh', 'base'],
  system: ['cut', 'seams', 'field', 'socp', 'linalg', 'mesh', 'base'],
  socp: ['linalg', 'base'],
  optimize: ['system', 'cut', 'features', 'seams', 'field', 'socp', 'linalg', 'mesh', 'base'],
  grid: ['system', 'cut', 'features', 'seams', 'field', 'verify', 'socp', 'linalg', 'mesh', 'base'],
  quads: ['mesh', 'base'],
};
mayInclude.improve = ['optimize', ...mayInclude.optimize, 'verify'];
mayInclude.parametrize = [...new Set([...Object.keys(mayInclude), 'verify'])].filter(
  (module) => !['io', 'prescription', 'text'].includes(module),
);
mayInclude.api = [...Object.keys(mayInclude)];
// Headers of the library as a whole, beside the modules; no sources.
mayInclude.hgp = [...Object.keys(mayInclude)];

const sources = filesOf('core/hgp', '.h', '.cpp', '.inc');

/** Modules that a source file includes, with the line that does it. */
function includedModules(file) {
  return [...textOf(file).matchAll(/^\s*#\s*include\s+["<](hgp\/[^">]+)[">]/gm)].map(
    ([line, header]) => ({ line: line.trim(), module: moduleOf(`core/${header}`) }),
  );
}

test('every folder of core/hgp is a module of the table', () => {
  const unknown = sources.filter((file) => !(moduleOf(file) in mayInclude));
  assert.deepEqual(unknown, []);
});

// The method is one namespace; what it rests on and what surrounds it has that of its folder (decision 084).
const ownNamespace = ['linalg', 'socp', 'text', 'prescription', 'io', 'api'];

test('namespaces follow the folders', () => {
  const wrong = sources
    .filter((file) => file.endsWith('.h'))
    .flatMap((file) => {
      const module = moduleOf(file);
      const rooms = file.split('/').slice(3, -1);
      const expected = ownNamespace.includes(module) ? `hgp::${module}` : 'hgp';
      return [
        ...textOf(file).matchAll(/^namespace (hgp[\w:]*) \{\n(?!(?:struct|class) \w+;\n\})/gm),
      ]
        .map((match) => match[1])
        .filter((name) => name !== expected && !rooms.some((room) => name === `hgp::${room}`))
        .map((name) => `${file}: ${name}`);
    });
  // Functions that stand for those of <cmath>.
  const exceptions = ['core/hgp/base/portable_math.h: hgp::portable'];
  assert.deepEqual(
    wrong.filter((one) => !exceptions.includes(one)),
    [],
  );
});

test('every header of the API says what threads may do', () => {
  const headers = sources.filter((file) => /^core\/hgp\/(?:api\/)?\w+\.h$/.test(file));
  assert.ok(headers.length > 8);
  assert.deepEqual(
    headers.filter((file) => !/thread/i.test(textOf(file))),
    [],
  );
});

test('only public headers lie beside the modules', () => {
  const beside = sources.filter((file) => moduleOf(file) === 'hgp');
  assert.deepEqual(
    beside.filter((file) => !file.endsWith('.h')),
    [],
  );
});

for (const [module, allowed] of Object.entries(mayInclude)) {
  test(`${module} includes only ${allowed.join(', ') || 'itself'}`, () => {
    const wrong = [];
    for (const file of sources.filter((name) => moduleOf(name) === module)) {
      for (const { line, module: other } of includedModules(file)) {
        if (other !== module && !allowed.includes(other)) wrong.push(`${file}: ${line}`);
      }
    }
    assert.deepEqual(wrong, []);
  });
}

test('targets link only what their module may include', () => {
  const wrong = [];
  for (const file of filesOf('core/hgp', 'CMakeLists.txt')) {
    const text = textOf(file).replace(/#.*/g, '');
    for (const [, body] of text.matchAll(/hgp_module\(([^)]*)\)/g)) {
      const words = body.split(/\s+/).filter(Boolean);
      const module = words[words.indexOf('NAME') + 1];
      assert.ok(module in mayInclude, `${file}: unknown module ${module}`);
      let inLinks = false;
      for (const word of words) {
        if (/^[A-Z_]+$/.test(word)) inLinks = word.endsWith('LINKS');
        else if (inLinks && word in mayInclude && !mayInclude[module].includes(word)) {
          wrong.push(`${module} links ${word}`);
        }
      }
    }
  }
  assert.deepEqual(wrong, []);
});

// Folders inside a module, lowest first: a folder includes itself and those before it. '' is the
// module's own folder; files of it that put the others together stand in `assembles`.
const folders = {
  mesh: { order: ['', 'repair'] },
  linalg: { order: ['graph', 'kernels', 'ordering', 'factor'] },
  io: {
    order: [
      '',
      'polygon',
      'gltf/json',
      'gltf/check',
      'gltf/decode',
      'gltf/patch',
      'gltf/pack',
      'gltf',
    ],
    apart: [['polygon', 'gltf']],
  },
  parametrize: {
    order: ['', 'after', 'strategy', 'strategy/moves', 'along', 'mirror', 'live'],
    apart: [['after', 'strategy', 'along', 'live']],
  },
  api: { order: ['', 'model', 'request', 'stored', 'json', 'session'] },
};
const assembles = [
  'core/hgp/io/open.cpp',
  'core/hgp/io/convert.h',
  'core/hgp/io/convert.cpp',
  'core/hgp/io/grid_material.cpp',
  'core/hgp/io/cone_files.h',
  'core/hgp/io/cone_files.cpp',
  'core/hgp/parametrize/along/along_features.cpp',
  'core/hgp/parametrize/live_edit.cpp',
  'core/hgp/parametrize/parametrize.cpp',
  'core/hgp/parametrize/strategy/loop.cpp',
];
const folderOf = (file) => path.posix.dirname(file).split('/').slice(3).join('/');

test('folders of a module include only those below them', () => {
  const wrong = [];
  for (const file of sources.filter((name) => !assembles.includes(name))) {
    const module = moduleOf(file);
    const { order = [''], apart = [] } = folders[module] ?? {};
    const own = order.indexOf(folderOf(file));
    if (own < 0) wrong.push(`${file}: a folder that the table does not know`);
    for (const [, header] of textOf(file).matchAll(/^\s*#\s*include\s+"(hgp\/[^"]+)"/gm)) {
      if (moduleOf(`core/${header}`) !== module || assembles.includes(`core/${header}`)) continue;
      const other = folderOf(`core/${header}`);
      const areApart = apart.some((two) => two.includes(other) && two.includes(folderOf(file)) && other !== folderOf(file)); // prettier-ignore
      if (order.indexOf(other) > own || areApart) wrong.push(`${file}: ${header}`);
    }
  }
  assert.deepEqual(wrong, []);
});

test('other modules see the public headers of linalg and no others', () => {
  const open = [
    'graph/graph.h',
    'ordering/ordering.h',
    'factor/factor.h',
    'factor/times_adjoint.h',
    'kernels/dense_kernels.h',
  ];
  const wrong = [];
  for (const file of [...sources, ...filesOf('bench', '.h', '.cpp')]) {
    if (moduleOf(file) === 'linalg') continue;
    for (const [, header] of textOf(file).matchAll(/^\s*#\s*include\s+"hgp\/linalg\/([^"]+)"/gm)) {
      if (!open.includes(header)) wrong.push(`${file}: ${header}`);
    }
  }
  assert.deepEqual(wrong, []);
});

/** Groups of nodes that lead back to one another (Tarjan). */
function circles(edges) {
  const found = [];
  const [index, low, stack] = [new Map(), new Map(), []];
  const visit = (node) => {
    index.set(node, index.size);
    low.set(node, index.get(node));
    stack.push(node);
    for (const next of edges.get(node) ?? []) {
      if (!index.has(next)) visit(next);
      if (stack.includes(next)) low.set(node, Math.min(low.get(node), low.get(next)));
    }
    if (low.get(node) !== index.get(node)) return;
    const group = stack.splice(stack.indexOf(node));
    if (group.length > 1) found.push(group.sort().join(' '));
  };
  for (const node of edges.keys()) if (!index.has(node)) visit(node);
  return found.sort();
}

test('cycles are found', () => {
  const edges = (list) => new Map(list.map(([from, ...to]) => [from, to]));
  assert.deepEqual(circles(edges([['a', 'b', 'c'], ['b', 'c'], ['c']])), []); // prettier-ignore
  assert.deepEqual(circles(edges([['d', 'a'], ['a', 'b'], ['b', 'c'], ['c', 'a']])), ['a b c']); // prettier-ignore
});

test('no include cycles between files: a source and its header count as one', () => {
  // x_state.h is what x.h hides.
  const unit = (file) => file.replace(/(_state)?\.(h|cpp|inc)$/, '').replace(/^core\/hgp\//, '');
  const edges = new Map();
  for (const file of sources) {
    const from = unit(file);
    if (!edges.has(from)) edges.set(from, new Set());
    for (const [, header] of textOf(file).matchAll(/^\s*#\s*include\s+"(hgp\/[^"]+)"/gm)) {
      if (unit(`core/${header}`) !== from) edges.get(from).add(unit(`core/${header}`));
    }
  }
  // Still to be cut; nothing may join them.
  const known = [
    'verify/certificate verify/verdict',
    'api/stored/snap_components api/stored/stored_map',
  ];
  assert.deepEqual(
    circles(edges).filter((circle) => !known.includes(circle)),
    [],
  );
});

test('only io reads files of other formats through tinygltf', () => {
  const users = sources.filter((file) => /#\s*include\s+[<"]tiny_gltf\.h/.test(textOf(file)));
  assert.deepEqual(
    users.filter((file) => moduleOf(file) !== 'io'),
    [],
  );
});

test('the core uses no file system and no console', () => {
  const wrong = sources.filter((file) =>
    /#\s*include\s+<(iostream|filesystem|fstream)>/.test(textOf(file)),
  );
  // tinygltf without its file system still needs <fstream> to be seen before it.
  const excused = (file) => /tiny_gltf\.h/.test(textOf(file)) && !/<iostream>/.test(textOf(file));
  assert.deepEqual(
    wrong.filter((file) => !excused(file)),
    [],
  );
});

test('the page imports the package and never the sources', () => {
  const wrong = [];
  for (const file of filesOf('web', '.ts', '.js', '.mjs')) {
    for (const [, from] of textOf(file).matchAll(/\bfrom\s+['"]([^'"]+)['"]/g)) {
      if (/(^|\/)(core\/hgp|wasm\/(?!package))/.test(from)) wrong.push(`${file}: ${from}`);
    }
  }
  assert.deepEqual(wrong, []);
});
