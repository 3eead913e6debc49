// What goes wrong around the program: disks that are full, files that vanish, signals, memory. Each ends with
// its exit code and message, leaves no half-written file, and the next run works.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import test from 'node:test';
import { cubeMesh, toGltf, toObj } from '../support/meshes.mjs';
import { hasPosix, hgp, inFolder } from '../support/program.mjs';

const { folder, at, put, run } = inFolder('faults');

const bash = (line) =>
  spawnSync('bash', ['-c', line], { encoding: 'utf8', cwd: folder, env: { ...process.env, hgp } });

put('cube.obj', toObj(cubeMesh(12)));
const files = () => readdirSync(folder).sort();

/** `act` leaves the folder as it was, and the run that follows does its work. */
async function leavesNothing(act) {
  const before = files();
  await act();
  assert.deepEqual(files(), before);
  const { code, err } = run(['param', 'cube.obj', '-o', 'next.obj']);
  assert.equal(code, 0, err);
  rmSync(at('next.obj'));
}

test('a full disk: 7, what is there stays, nothing half-written', () =>
  leavesNothing(() => {
    const device = run(['param', 'cube.obj', '-o', '/dev/full']);
    assert.equal(device.code, 7, device.err);
    assert.match(device.err, /cannot write \/dev\/full: No space left on device/);
    const report = run(['inspect', 'cube.obj', '--json', '/dev/full']);
    assert.equal(report.code, 7, report.err);
    const piped = bash('"$hgp" inspect cube.obj --json - > /dev/full');
    assert.equal(piped.status, 7, piped.stderr);
    assert.match(piped.stderr, /cannot write standard output: No space left/);
    const help = bash('"$hgp" --help > /dev/full');
    assert.equal(help.status, 7, help.stderr);
  }));

test('no larger file is allowed (RLIMIT_FSIZE): 7, and the old file is still there', () =>
  leavesNothing(() => {
    put('old.obj', 'the old one');
    // The signal that comes with it (SIGXFSZ) ended the program, and left a half-written file.
    const { status, stderr } = bash('ulimit -f 2; "$hgp" param cube.obj -o old.obj');
    assert.equal(status, 7, stderr);
    assert.match(stderr, /cannot write old\.obj: File too large/);
    assert.equal(readFileSync(at('old.obj'), 'utf8'), 'the old one');
    rmSync(at('old.obj'));
  }));

test('places where nothing can be written: 7', () =>
  leavesNothing(() => {
    for (const [output, message] of [
      ['no/such/folder/x.obj', /No such file or directory/],
      ['cube.obj/x.obj', /Not a directory/],
      ['/proc/x.obj', /cannot write/],
      [`${'x'.repeat(300)}.obj`, /File name too long/],
    ]) {
      const { code, err } = run(['param', 'cube.obj', '-o', output]);
      assert.equal(code, 7, `${output}: ${err}`);
      assert.match(err, message);
    }
    mkdirSync(at('closed'), { mode: 0o555 });
    if (process.getuid() !== 0) {
      assert.equal(run(['param', 'cube.obj', '-o', 'closed/x.obj']).code, 7);
      put('secret.obj', 'v');
      chmodSync(at('secret.obj'), 0);
      const { code, err } = run(['inspect', 'secret.obj']);
      assert.equal(code, 3);
      assert.match(err, /Permission denied/);
      rmSync(at('secret.obj'));
    }
    rmSync(at('closed'), { recursive: true });
  }));

test('input that vanishes while it is read: 3, or all of it where it was open already', async () => {
  await leavesNothing(async () => {
    // A pipe whose writer dies in the middle of a line.
    const text = readFileSync(at('cube.obj'), 'utf8');
    const cut = text.slice(0, text.indexOf('\nf ') + 4);
    const piped = run(['param', '-', '-o', 'x.obj'], { input: cut });
    assert.equal(piped.code, 3, piped.err);
    const { json, bin } = toGltf([cubeMesh(4)]);
    put('cube.gltf', JSON.stringify(json));
    put('cube.bin', bin.subarray(0, bin.length / 2));
    const short = run(['param', 'cube.gltf', '-o', 'x.gltf']);
    assert.equal(short.code, 3, short.err);
    rmSync(at('cube.bin'));
    const missing = run(['param', 'cube.gltf', '-o', 'x.gltf']);
    assert.equal(missing.code, 3);
    assert.match(missing.err, /cube\.bin is missing/);
    rmSync(at('cube.gltf'));
    // The file goes away behind a program that has it open.
    assert.equal(spawnSync('mkfifo', [at('slow.obj')]).status, 0);
    const child = spawn(hgp, ['inspect', 'slow.obj', '--quiet'], { cwd: folder });
    const ended = new Promise((resolve) => child.once('close', resolve));
    const half = Math.floor(text.length / 2);
    const writer = spawn('bash', [
      '-c',
      `exec 3> "$1"; head -c ${half} "$2" >&3; rm "$1"; sleep 0.2; tail -c +${half + 1} "$2" >&3`,
      'bash',
      at('slow.obj'),
      at('cube.obj'),
    ]);
    await new Promise((resolve) => writer.once('close', resolve));
    assert.equal(await ended, 0);
  });
});

/** Ends a run by a signal when its output on standard error matches. */
function interrupted(args, signal, moment) {
  return new Promise((resolve) => {
    const child = spawn(hgp, args, { cwd: folder });
    let err = '';
    let isSent = false;
    child.stderr.setEncoding('utf8').on('data', (chunk) => {
      err += chunk;
      if (isSent || !moment.test(err)) return;
      isSent = true;
      child.kill(signal);
    });
    child.on('close', (code, by) => resolve({ code, by, err, isSent }));
  });
}

test('SIGINT, SIGTERM and SIGHUP in every stage: 130, and nothing is left', async () => {
  // A stage of a small surface may be over before anybody sees it: then a larger one is taken.
  const sizes = [30, 60, 90];
  for (const n of sizes) put(`cube${n}.obj`, toObj(cubeMesh(n)));
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
    for (const stage of ['prepare', 'cones', 'cut', 'solve', 'improve']) {
      await leavesNothing(async () => {
        for (const n of sizes) {
          const args = ['param', `cube${n}.obj`, '-o', 'never.obj', '--improve', 'isometric'];
          const ended = await interrupted(args, signal, new RegExp(` s  ${stage}`));
          const { code, err, isSent } = ended;
          if (n !== sizes.at(-1) && (!isSent || code === 0)) {
            rmSync(at('never.obj'), { force: true });
            continue;
          }
          assert.ok(isSent, `${stage} came up in\n${err}`);
          assert.equal(code, 130, `${signal} in ${stage}: ${code}`);
          if (hasPosix) assert.match(err, /hgp: interrupted\n/);
          assert.ok(!existsSync(at('never.obj')));
          break;
        }
      });
    }
  }
  for (const n of sizes) rmSync(at(`cube${n}.obj`));
});

test('a signal while the output is written: 130 or done, and never half a file', async () => {
  assert.equal(run(['param', 'cube.obj', '-o', 'whole.obj']).code, 0);
  const whole = readFileSync(at('whole.obj'), 'utf8');
  for (let i = 0; i < 6; i++) {
    rmSync(at('whole.obj'), { force: true });
    const args = ['param', 'cube.obj', '-o', 'whole.obj', '--color', 'never'];
    const { code, by } = await interrupted(args, 'SIGTERM', /certified/);
    assert.equal(by, null);
    assert.ok(code === 0 || code === 130, `${code}`);
    if (existsSync(at('whole.obj'))) assert.equal(readFileSync(at('whole.obj'), 'utf8'), whole);
    assert.deepEqual(
      files().filter((name) => /\.obj\.\w+$/.test(name)),
      [],
    );
  }
  rmSync(at('whole.obj'), { force: true });
});

test('too little memory (ulimit -v): 8, and nothing is left', (t) => {
  put('large.obj', toObj(cubeMesh(90)));
  const within = (kilobytes, ...args) =>
    bash(`ulimit -v ${kilobytes}; "$hgp" ${args.map((a) => `'${a}'`).join(' ')}`);
  if (within(100_000, '--version').status !== 0) {
    return t.skip('this build does not start with so little memory');
  }
  return leavesNothing(() => {
    let least = 100_000;
    while (within(least, 'inspect', 'cube.obj', '--quiet').status !== 0) least += 5_000;
    let seen = 0;
    for (const more of [0, 5_000, 15_000, 30_000, 45_000]) {
      const { status, stderr } = within(least + more, 'param', 'large.obj', '-o', 'never.obj');
      if (status === 0) {
        rmSync(at('never.obj'));
        continue;
      }
      seen += 1;
      assert.equal(status, 8, `${least + more} kB: ${status} ${stderr}`);
      assert.match(stderr, /memory/);
    }
    assert.ok(seen > 0, 'some run had too little');
  }).finally(() => rmSync(at('large.obj')));
});
