// Test programs with another text in the place of one source: compiled alone and linked before the
// libraries, whose own definitions of the same functions then give way (--allow-multiple-definition).

import { execFile } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { contentOf } from '../support/results.mjs';

// Of the processor, as a busy machine says nothing about a test.
const testSeconds = 150;
const nodeSeconds = 600;
/** All tests but the one that measures time, which fails at random on a busy machine. */
const untimed = '-Obj.ReadingAndWritingGrowsWithTheFile';

/** The tests under Node that run hgp, without those that measure time or memory or need other builds. */
const nodeSuites = {
  'node:cli': ['cli', 'also', 'compress', 'features_cones', 'files', 'harmonic', 'measures', 'quads', 'repairs', 'symmetric', 'symmetric_cones', 'writers'].map((name) => `cli/${name}`), // prettier-ignore
};

/** @param {string} root  of the checkout @param {string} preset  whose build is there */
export function planter(root, preset) {
  const build = path.join(root, 'build', preset);
  const scratch = path.join(root, 'build/mutation', preset);
  rmSync(scratch, { recursive: true, force: true });
  const compilations = JSON.parse(readFileSync(path.join(build, 'compile_commands.json'), 'utf8'));

  /** Runs a shell command; resolves to its exit code (null when it was stopped) and its output. */
  function run(command, { cwd = build, seconds = 600 } = {}) {
    const env = { ...process.env, ASAN_OPTIONS: 'detect_odr_violation=0', HGP_MUTATION: '1' };
    const limits = { maxBuffer: 1 << 28 };
    return new Promise((resolve) =>
      execFile(
        'sh',
        ['-c', `ulimit -t ${seconds}; exec ${command}`],
        { cwd, env, ...limits },
        (error, stdout, stderr) =>
          resolve({
            code: error ? error.code : 0,
            signal: error?.signal,
            output: stdout + stderr,
          }),
      ),
    );
  }

  const ninja = async (...words) => {
    const { code, output } = await run(`ninja ${words.join(' ')}`);
    if (code !== 0) throw new Error(`ninja ${words.join(' ')}: ${output}`);
    return output;
  };

  /** How the build compiles a file, alone or as part of its module's unit. */
  function compilationOf(file) {
    const own = ({ file: name }) => path.relative(root, name) === file;
    const isUnit = ({ file: name }) =>
      name.endsWith('.cxx') && readFileSync(name, 'utf8').includes(`"${path.join(root, file)}"`);
    const entry = compilations.find(own) ?? compilations.find(isUnit);
    if (!entry) throw new Error(`${file} is not compiled by ${preset}`);
    return entry;
  }

  /** The same with `from` in its place, unoptimized: one test runs, and compiling is most of the time. */
  function compileCommand(file, from, object) {
    const entry = compilationOf(file);
    const command = entry.command
      .replace(/ -o \S+/, ` -o ${object}`)
      .replace(/ -c \S+/, ` -w -c ${from}`)
      .replace(/ -O[13]\b/g, ' -O0');
    return { command, cwd: entry.directory };
  }

  /** The program that tests run: their own or, for tests under Node ("node:cli"), hgp. */
  const binaryOf = (program) => (program.startsWith('node:') ? 'hgp' : `tests_${program}`);

  const linkLines = new Map();
  /** How the build links a program of tests. */
  async function linkOf(program) {
    if (!linkLines.has(program)) {
      const name = binaryOf(program);
      const link = (await ninja('-t commands', `bin/${name}`)).trim().split('\n').at(-1);
      const body = link.match(/^: && (.*) && :$/)?.[1];
      if (!body) throw new Error(`no way to link ${name}: ${link}`);
      linkLines.set(program, body);
    }
    return linkLines.get(program);
  }

  const headers = new Map();
  /** Our own files that the object of a file's compilation is made of, from ninja's record. */
  async function dependenciesOf(file) {
    const object = compilationOf(file).command.match(/ -o (\S+)/)[1];
    if (!headers.has(object)) {
      const lines = (await ninja('-t deps', object)).split('\n').slice(1);
      const files = lines.map((line) => path.resolve(build, line.trim()));
      headers.set(object, files.filter((name) => name.startsWith(root + path.sep) && existsSync(name) && statSync(name).isFile())); // prettier-ignore
    }
    return headers.get(object);
  }

  /** What the tests of tests/<folder> say about the program `out`. */
  async function underNode(program, out) {
    const suites = nodeSuites[program].map((name) => `tests/${name}.test.mjs`).join(' ');
    const ran = await run(`env HGP_BIN=${out} node --test ${suites}`, { cwd: root, seconds: nodeSeconds }); // prettier-ignore
    if (ran.code === 0) return { kind: 'passed' };
    const [, test] = ran.output.match(/^not ok \d+ - (.*)$/m) ?? ran.output.match(/✖ (.*)/) ?? [];
    return { kind: 'failed', by: `${program}: ${test ?? ran.output.trim().slice(-200)}` };
  }

  return {
    has: (program) => existsSync(path.join(build, 'bin', binaryOf(program))),

    /** Everything that the outcome of a fault depends on, but the data of the tests. */
    async inputsOf({ file, programs }) {
      const { command, cwd } = compileCommand(file, 'fault.cpp', 'fault.o');
      const links = await Promise.all(programs.map(linkOf));
      const linked = links.flatMap((link) =>
        link
          .split(/\s+/)
          .filter((word) => /\.(a|o)$/.test(word) && existsSync(path.join(build, word))),
      );
      const files = [
        path.join(root, file),
        ...(await dependenciesOf(file)),
        ...[...new Set(linked)].map((word) => path.join(build, word)),
        ...programs.filter((name) => name.startsWith('node:')).map((name) => path.join(root, 'tests', name.slice(5))), // prettier-ignore
      ];
      return [command, cwd, ...links, ...files.map(contentOf)];
    },

    /**
     * What a program's tests say with `text` in the place of a file.
     * @param {string} filter  of GoogleTest: which tests
     * @returns kind 'passed', 'failed' or 'endless', and by which test
     */
    async outcome(file, text, program, id, filter = untimed) {
      const folder = path.join(scratch, id);
      mkdirSync(folder, { recursive: true });
      const at = (name) => path.join(folder, name);
      if (!existsSync(at('fault.o'))) {
        writeFileSync(at('fault.cpp'), text);
        const { command, cwd } = compileCommand(file, at('fault.cpp'), at('fault.o'));
        const compiled = await run(command, { cwd });
        if (compiled.code !== 0)
          throw new Error(`does not compile:\n${compiled.output.slice(0, 1500)}`);
      }
      const out = at(binaryOf(program));
      if (!existsSync(out)) {
        const first = `${at('fault.o')} -Wl,--allow-multiple-definition -o ${out}`;
        const linked = await run(
          (await linkOf(program)).replace(` -o bin/${binaryOf(program)}`, ` ${first}`),
        );
        if (linked.code !== 0) throw new Error(`does not link:\n${linked.output.slice(0, 1500)}`);
      }
      if (program.startsWith('node:')) return await underNode(program, out);
      const ran = await run(`${out} --gtest_brief=1 --gtest_fail_fast '--gtest_filter=${filter}'`, {
        cwd: root,
        seconds: testSeconds,
      });
      if (ran.code === 0) {
        // A filter that meets no test proves nothing.
        const isNone = /\[ {2}PASSED {2}\] 0 tests/.test(ran.output);
        return { kind: isNone ? 'none' : 'passed' };
      }
      if (ran.signal === 'SIGXCPU' || ran.signal === 'SIGKILL')
        return { kind: 'endless', by: `${program} does not end` };
      const [, test] = ran.output.match(/\[ {2}FAILED {2}\] (\S+)/) ?? [];
      return { kind: 'failed', test, by: test ?? `${program} stops: ${ran.output.trim().slice(-200)}` }; // prettier-ignore
    },

    forget: (id) => rmSync(path.join(scratch, id), { recursive: true, force: true }),
  };
}
