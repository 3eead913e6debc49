// How the program behaves among others: help, colours, pipes, standard input, the manual page and the
// completions of shells.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';
import { cubeMesh, toGlb, toGltf } from '../support/meshes.mjs';
import { hasPosix, hgp, inFolder } from '../support/program.mjs';

const env = { ...process.env };
delete env.NO_COLOR;
delete env.TERM;
const { folder, at, put, run } = inFolder('manners', env);

const shell = (line, more = {}) =>
  spawnSync('bash', ['-c', line], {
    encoding: 'utf8',
    cwd: folder,
    env: { ...env, PATH: `${path.dirname(hgp)}:${env.PATH}`, ...more },
  });

/** An n × n grid over each side of a box: vertices and quads as 0-based ids. */
function box(n) {
  const ids = new Map();
  const points = [];
  const quads = [];
  const vertex = (p) => {
    const key = p.join(' ');
    if (!ids.has(key)) {
      ids.set(key, points.length);
      points.push(p);
    }
    return ids.get(key);
  };
  for (const [axis, side] of [0, 1, 2].flatMap((a) => [
    [a, 0],
    [a, n],
  ])) {
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        const corner = (di, dj) => {
          const p = [0, 0, 0];
          p[axis] = side;
          p[(axis + 1) % 3] = i + di;
          p[(axis + 2) % 3] = j + dj;
          return vertex(p);
        };
        const quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        quads.push(side === 0 ? quad.reverse() : quad);
      }
    }
  }
  return { points, quads };
}
const cube = box(4);
const cubeObj = [
  ...cube.points.map((p) => `v ${p.join(' ')}`),
  ...cube.quads.map((q) => `f ${q.map((v) => v + 1).join(' ')}`),
  '',
].join('\n');
const cubeOff = `OFF\n${cube.points.length} ${cube.quads.length} 0\n${cube.points
  .map((p) => p.join(' '))
  .join('\n')}\n${cube.quads.map((q) => `4 ${q.join(' ')}`).join('\n')}\n`;
const cubePly = `ply\nformat ascii 1.0\nelement vertex ${cube.points.length}
property float x\nproperty float y\nproperty float z\nelement face ${cube.quads.length}
property list uchar int vertex_indices\nend_header\n${cube.points
  .map((p) => p.join(' '))
  .join('\n')}\n${cube.quads.map((q) => `4 ${q.join(' ')}`).join('\n')}\n`;
const facets = cube.quads.flatMap(([a, b, c, d]) => [
  [a, b, c],
  [a, c, d],
]);
const cubeStlText = `solid cube\n${facets
  .map(
    (f) =>
      `facet normal 0 0 0\nouter loop\n${f
        .map((v) => `vertex ${cube.points[v].join(' ')}\n`)
        .join('')}endloop\nendfacet\n`,
  )
  .join('')}endsolid cube\n`;
const cubeStl = (() => {
  const bytes = Buffer.alloc(84 + 50 * facets.length);
  bytes.write('made by a test');
  bytes.writeUInt32LE(facets.length, 80);
  facets.forEach((f, t) =>
    f.forEach((v, c) =>
      cube.points[v].forEach((x, k) => bytes.writeFloatLE(x, 84 + 50 * t + 12 + 12 * c + 4 * k)),
    ),
  );
  return bytes;
})();
put('mesh.obj', cubeObj);
const commands = ['inspect', 'check', 'cones', 'param', 'quads', 'verify'];

test('help is the same by every name, and goes to standard output', () => {
  const all = run(['--help']);
  assert.equal(all.code, 0);
  for (const args of [['help'], ['-h']]) assert.equal(run(args).out, all.out, args.join(' '));
  for (const command of commands) assert.match(all.out, new RegExp(`^  ${command} `, 'm'));
  assert.match(all.out, /^ +6 +no certified map, or none within --time-limit$/m);
  for (const command of [...commands, 'completion', 'manual', 'help']) {
    const one = run([command, '--help']);
    assert.equal(one.code, 0, command);
    assert.match(one.out, new RegExp(`^Usage: hgp ${command}`, 'm'));
    assert.match(one.out, /^Examples:\n {2}hgp /m, command);
    assert.equal(run(['help', command]).out, one.out, command);
    assert.equal(run([command, '-h']).out, one.out, command);
    assert.doesNotMatch(one.out, /TEXT|INT in|UINT|FLOAT|\{/, command);
  }
  const wrong = run(['help', 'parm']);
  assert.equal(wrong.code, 2);
  assert.match(wrong.err, /did you mean param\?/);
});

test('an option is no value of the option before it', () => {
  for (const [option, next] of [
    ['-o', '--force'],
    ['--json', '--creases'],
    ['--cones', '--quiet'],
  ]) {
    // prettier-ignore
    const rest = option === '-o' ? [] : ['-o', 'out.obj'];
    const { code, err } = run(['param', 'mesh.obj', ...rest, option, next]);
    assert.equal(code, 2, option);
    assert.ok(err.includes(`'${next}'`), err);
    assert.ok(!existsSync(at(next)), 'no file of that name');
  }
  assert.equal(run(['param', 'mesh.obj', '-o', 'out.obj', '--json', './--creases']).code, 0);
  assert.ok(existsSync(at('--creases')));
});

test('a word that is not understood is named', () => {
  const mesh = ['x.obj', '-o', 'y.obj'];
  for (const [word, args] of [
    ['parametrise', ['parametrise', 'x.obj']],
    ['2.5', ['param', ...mesh, '--improve', '2.5']],
    ['nan', ['param', ...mesh, '--improve', 'nan']],
    ['1e300', ['param', ...mesh, '--cells', '1e300']],
    ['0.5', ['quads', ...mesh, '--cells', '0.5']],
  ]) {
    const { code, err } = run(args);
    assert.equal(code, 2, word);
    assert.ok(err.includes(`'${word}'`), err);
  }
});

test('placeholders say what an option wants', () => {
  const { out } = run(['param', '--help']);
  for (const expected of [
    '--cone V:K',
    '--turning L:J',
    '--handle G:R',
    '--cones FILE',
    '--mesh all|largest|N',
    '--time-limit SECONDS',
    '-o,--output FILE',
    '-q,--quiet',
    '-f,--force',
    '--color auto|always|never',
  ])
    assert.ok(out.includes(expected), expected);
  assert.match(out, /^Usage: hgp param \[OPTIONS\] MESH$/m);
});

test('the version by both names', () => {
  const { version } = JSON.parse(
    readFileSync(path.join(import.meta.dirname, '../../wasm/package/package.json'), 'utf8'),
  );
  for (const name of ['-V', '--version']) {
    assert.deepEqual(run([name]), { code: 0, out: `hgp ${version}\n`, err: '', signal: null });
  }
});

test('every example of --help runs as printed', () => {
  writeFileSync(at('model.glb'), toGlb([cubeMesh(4)]));
  assert.equal(run(['cones', 'mesh.obj', '-o', 'cones.json']).code, 0);
  const { cones } = JSON.parse(readFileSync(at('cones.json'), 'utf8'));
  put('mesh.cones', `q 4\ncones ${cones.length}\n${cones.map((c) => `${c.vertex} ${c.k}\n`).join('')}`); // prettier-ignore
  const mine = JSON.parse(readFileSync(at('cones.json'), 'utf8'));
  put('mine.json', JSON.stringify({ ...mine, cones: mine.cones.slice(0, 6) }));
  for (const name of ['old.obj', 'new.obj']) put(name, readFileSync(at('mesh.obj'), 'utf8'));
  const corner = (p) => cube.points.findIndex((q) => q.every((x, k) => x === p[k]));
  // The two cones of the example's check are there to be refused: they leave six missing.
  const expected = { 'hgp check mesh.obj --q 4 --cone 0:3 --cone 5:3': 5 };
  assert.ok(corner([0, 0, 0]) >= 0);
  let count = 0;
  for (const name of ['param', ...commands.filter((c) => c !== 'param'), 'completion', 'manual']) {
    const examples = run([name, '--help']).out.split('Examples:\n')[1].split('\n');
    for (const line of examples.map((l) => l.trim()).filter(Boolean)) {
      const { status, stderr } = shell(`set -o pipefail; ${line}`);
      assert.equal(status, expected[line] ?? 0, `${line}\n${stderr}`);
      count += 1;
    }
  }
  assert.ok(count >= 15, `${count}`);
});

test('only one file can come from standard input', () => {
  const commands = [
    'check - --cones -',
    'param - -o x.obj --field -',
    'param - -o x.obj --features -',
  ];
  for (const command of commands) {
    const { code, err } = run(command.split(' '), { input: cubeObj });
    assert.equal(code, 2, err);
    assert.match(err, /standard input/);
  }
});

test('the format of standard input is recognised from its bytes', () => {
  const inputs = {
    obj: cubeObj,
    off: cubeOff,
    ply: cubePly,
    stl: cubeStlText,
    'binary stl': cubeStl,
    'binary stl with bytes behind it': Buffer.concat([cubeStl, Buffer.alloc(7)]),
    glb: toGlb([cubeMesh(4)]),
    'packed obj': gzipSync(cubeObj),
    'packed stl': gzipSync(cubeStl),
  };
  for (const [name, input] of Object.entries(inputs)) {
    const { code, out, err } = run(['inspect', '-', '--json', '-'], { input });
    assert.equal(code, 0, `${name}: ${err}`);
    assert.equal(JSON.parse(out).triangles, 192, name);
  }
  assert.equal(run(['inspect', '-', '--format', 'obj'], { input: cubeObj }).code, 0);
  assert.equal(run(['inspect', '-', '--format', 'fbx'], { input: cubeObj }).code, 2);
  assert.equal(run(['inspect', '-'], { input: '' }).code, 3);
});

const escape = '\u001b';

/** With `script` both streams are a terminal, but for what `line` redirects. */
const onTerminal = (line, more = {}) =>
  spawnSync('script', ['-qec', line, '/dev/null'], {
    encoding: 'utf8',
    cwd: folder,
    env: { ...env, TERM: 'xterm', PATH: `${path.dirname(hgp)}:${env.PATH}`, ...more },
  }).stdout;

if (hasPosix) {
  test('colour is decided for each stream', () => {
    const colour = new RegExp(`${escape}\\[\\d+m`);
    assert.match(onTerminal('hgp inspect mesh.obj'), colour);
    assert.match(onTerminal('hgp inspect mesh.obj 2>/dev/null'), colour);
    onTerminal('hgp inspect mesh.obj >text.txt');
    assert.doesNotMatch(readFileSync(at('text.txt'), 'utf8'), colour);
    // The report of param goes to standard error: what standard output is does not matter.
    const param = 'hgp param mesh.obj -o colour.obj --no-progress';
    assert.match(onTerminal(`${param} >/dev/null`), colour);
    onTerminal(`${param} 2>text.txt`);
    assert.match(readFileSync(at('text.txt'), 'utf8'), /certified/);
    assert.doesNotMatch(readFileSync(at('text.txt'), 'utf8'), colour);
    assert.doesNotMatch(onTerminal('hgp inspect mesh.obj', { NO_COLOR: '1' }), colour);
    assert.match(onTerminal('hgp inspect mesh.obj', { NO_COLOR: '' }), colour);
    assert.match(onTerminal('hgp inspect mesh.obj --color always', { NO_COLOR: '1' }), colour);
    assert.doesNotMatch(onTerminal('hgp inspect mesh.obj --color never'), colour);
    assert.match(run(['inspect', 'mesh.obj', '--color', 'always']).out, colour);
  });

  test('a dumb terminal gets plain text and plain lines of progress', () => {
    assert.match(onTerminal('hgp param mesh.obj -o dumb.obj'), new RegExp(`\\r${escape}\\[K\\[`));
    const plain = onTerminal('hgp param mesh.obj -o dumb.obj', { TERM: 'dumb' });
    assert.ok(!plain.includes(escape));
    assert.match(plain, /^hgp: +\d\.\d s /m);
  });
} else {
  test('without POSIX a terminal gets plain text and plain lines of progress', () => {
    const plain = onTerminal(`${path.basename(hgp)} param mesh.obj -o dumb.obj`);
    assert.ok(!plain.includes(escape));
    assert.match(plain, /^hgp: +\d\.\d s /m);
    assert.ok(run(['inspect', 'mesh.obj', '--color', 'always']).out.includes(escape));
  });
}

test('a closed standard output ends the program silently, as by SIGPIPE', () => {
  for (const line of [
    'hgp inspect mesh.obj --json -',
    'hgp cones mesh.obj --quiet',
    'hgp param mesh.obj -o - --quiet',
    'hgp --help',
    'hgp manual',
  ]) {
    // The reader is gone before anything is written.
    const { stderr } = shell(`(sleep 0.2; ${line}; echo "status $?" >status.txt) | true`);
    assert.equal(readFileSync(at('status.txt'), 'utf8'), 'status 141\n', `${line}: ${stderr}`);
    assert.equal(stderr, '', line);
  }
  const head = shell('hgp inspect mesh.obj | head -1; echo "${PIPESTATUS[0]}"');
  assert.equal(head.stderr, '');
  assert.match(head.stdout, /\n(0|141)\n$/);
  // Messages that nobody reads are lost; the map is not.
  rmSync(at('kept.obj'), { force: true });
  shell('(sleep 0.2; hgp param mesh.obj -o kept.obj 2>&1; echo "status $?" >status.txt) | true');
  assert.equal(readFileSync(at('status.txt'), 'utf8'), 'status 0\n');
  assert.ok(existsSync(at('kept.obj')));
});

test('the time limit ends with 6, with the number, and writes nothing', () => {
  const limited = ['param', 'mesh.obj', '-o', 'late.obj', '--time-limit', '0.000001'];
  const { code, err } = run(limited);
  assert.equal(code, 6, err);
  assert.match(err, /no certified map within 1e-06 s \(--time-limit\)/);
  assert.ok(!existsSync(at('late.obj')));
  const docs = readFileSync(path.join(import.meta.dirname, '../../docs/cli.md'), 'utf8');
  assert.match(docs, /^\| 6 \| no certified map, or none within `--time-limit` \|$/m);
});

/** Long names of a command's options as --help prints them. */
const longNames = (command) => [
  ...new Set(
    run([command, '--help'])
      .out.split('\n')
      .map((line) => line.match(/^ {2}(?:-\w,)?(--[\w-]+)/)?.[1])
      .filter(Boolean),
  ),
];

test('the manual page names every option, and groff reports no error', (t) => {
  const page = run(['manual']);
  assert.equal(page.code, 0);
  for (const command of commands) {
    assert.ok(page.out.includes(`.SH HGP ${command.toUpperCase()}`), command);
    for (const name of longNames(command).filter((n) => n !== '--help'))
      assert.ok(page.out.includes(name.replaceAll('-', '\\-')), `${command} ${name}`);
  }
  assert.match(page.out, /^\.SH EXIT STATUS$/m);
  const groff = spawnSync('groff', ['-man', '-Kutf8', '-Tutf8', '-ww', '-z'], {
    input: page.out,
    encoding: 'utf8',
  });
  if (groff.error) return t.diagnostic('groff is not there: the page is not set');
  assert.equal(groff.stderr, '');
});

test('bash completes commands, options, words and files', () => {
  put('hgp.bash', run(['completion', 'bash']).out);
  const complete = (...words) => {
    const list = words.map((w) => `'${w}'`).join(' ');
    const line = `. ./hgp.bash; COMP_WORDS=(hgp ${list}); COMP_CWORD=${words.length}; _hgp; printf '%s\\n' "\${COMPREPLY[@]}"`;
    const { stdout, stderr } = shell(line);
    assert.equal(stderr, '');
    return stdout.trim().split('\n');
  };
  assert.deepEqual(complete('pa'), ['param']);
  for (const command of commands) {
    assert.deepEqual(complete(command, '--').sort(), longNames(command).sort(), command);
  }
  assert.deepEqual(complete('param', 'mesh.obj', '--cones-for', 'l'), ['low-distortion']);
  assert.deepEqual(complete('param', 'mesh.obj', '--mesh', 'la'), ['largest']);
  assert.deepEqual(complete('param', 'mesh.o'), ['mesh.obj']);
  assert.deepEqual(complete('check', 'mesh.obj', '--cones', 'hgp.b'), ['hgp.bash']);
  assert.deepEqual(complete('help', 'ver'), ['verify']);
  assert.deepEqual(complete('completion', 'z'), ['zsh']);
});

test('zsh and fish report no error in their completions', (t) => {
  for (const name of ['zsh', 'fish']) {
    const { code, out } = run(['completion', name]);
    assert.equal(code, 0);
    for (const command of commands)
      for (const option of longNames(command).filter((n) => n !== '--help'))
        assert.ok(
          out.includes(name === 'fish' ? ` -l ${option.slice(2)}` : `'${option}[`),
          `${name} ${command} ${option}`,
        );
    const checked = spawnSync(name, ['-n'], { input: out, encoding: 'utf8' });
    if (checked.error) t.diagnostic(`${name} is not there: its completions are not read by it`);
    else assert.equal(checked.status, 0, checked.stderr);
  }
  assert.equal(run(['completion', 'tcsh']).code, 2);
});

test('messages begin with the file they are about, and hgp-error names it', () => {
  put('broken here.obj', 'v 0 0 zero\n');
  const { code, err } = run(['param', 'broken here.obj', '-o', 'x.obj', '--json', 'why.json']);
  assert.equal(code, 3);
  assert.match(err, /^hgp: broken here\.obj: line 1: /);
  assert.equal(JSON.parse(readFileSync(at('why.json'), 'utf8')).file, 'broken here.obj');
  const piped = shell('printf "v 0 0 zero\\n" | hgp inspect - --format obj');
  assert.match(piped.stderr, /^hgp: standard input: line 1: /);
});

test('an output that cannot be written is found before anything is solved', () => {
  put('cube.obj', cubeObj);
  for (const more of [
    ['-o', 'nowhere/a.obj'],
    ['-o', '.'],
    ['-o', 'a.obj', '--json', 'nowhere/a.json'],
    ['-o', 'a.obj', '--also', 'nowhere/a.glb'],
    ['-o', 'a.obj', '--xref', 'nowhere/a.txt'],
    ['-o', 'a.obj', '--faces', 'nowhere/a.csv'],
  ]) {
    const { code, err } = run(['param', 'cube.obj', ...more]);
    assert.equal(code, 7, err);
    assert.match(err, /^hgp: cube\.obj: cannot write (nowhere\/|\.: )/);
    assert.doesNotMatch(err, /triangles|solve/);
    assert.ok(!existsSync(at('a.obj')));
  }
  const packed = shell('hgp param cube.obj --compress -o - | wc -c');
  assert.match(packed.stderr, /^hgp: cube\.obj: --compress is for glTF/);
  assert.equal(packed.stdout.trim(), '0');
});

test('what the side files of the input forbid is found before anything is solved', () => {
  const { json, bin } = toGltf([cubeMesh(1)], { image: 'wood.png' });
  put('apart/in.gltf', JSON.stringify(json));
  put('apart/cube.bin', bin);
  put('apart/wood.png', 'a picture');
  put('there/wood.png', 'another picture');
  const other = run(['param', 'apart/in.gltf', '-o', 'there/out.gltf']);
  assert.equal(other.code, 2, other.err);
  assert.match(other.err, /^hgp: apart\/in\.gltf: .*wood\.png is another file than the one the/);
  assert.doesNotMatch(other.err, /certified/);
  assert.equal(run(['param', 'apart/in.gltf', '-o', 'there/out.gltf', '--force']).code, 0);
  // More files than are replaced together.
  json.images = Array.from({ length: 600 }, (_, i) => ({ uri: `${i}.png` }));
  put('apart/many.gltf', JSON.stringify(json));
  const many = run(['param', 'apart/many.gltf', '-o', 'there/many.gltf']);
  assert.equal(many.code, 8, many.err);
  assert.match(many.err, /60\d side files; --embed needs none/);
  assert.doesNotMatch(many.err, /certified/);
  const set = run(['param', 'apart/in.gltf', '-o', 'there/out.gltf', '--uv-set', '16']);
  assert.equal(set.code, 2);
  assert.match(set.err, /--uv-set: must be 'next' or a number from 0 to 15/);
});

test('two inputs are refused with what to do instead', () => {
  put('cube.obj', cubeObj);
  const { code, err } = run(['verify', 'cube.obj', 'other.obj']);
  assert.equal(code, 2);
  assert.match(err, /one mesh per call, and 'other\.obj' is another one.*batch\.md/);
});
