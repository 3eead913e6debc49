// Processor time of whole runs, from the bytes of a file to the bytes of the mapped file: of the package in a Node
// process of its own, and of the native program. Processor time, because other programs make wall times useless.

import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

/**
 * Seconds of user and system time of `hgp param`, the start of the process included, and the printed report.
 * @param options  further ones; by default all processors compute, and a second thread adds the time in which it waits
 */
export function runNative(program, file, out, options = []) {
  const report = `${out}.json`;
  // Without --norc bash reads ~/.bashrc where its input is a socket, as Node's is, and counts that, too.
  const script = `"$@" >/dev/null || [ $? = 6 ] || exit; times`;
  const args = ['param', file, '-o', out, '--json', report, '--quiet', '--force', ...options];
  const printed = execFileSync('bash', ['--norc', '-c', script, 'bash', program, ...args], {
    encoding: 'utf8',
    env: { ...process.env, LC_ALL: 'C' },
  });
  // The second line of `times` is that of the children: "0m1.234s 0m0.056s".
  const [user, system] = printed.trim().split('\n').at(-1).split(' ');
  const seconds = (text) => Number(text.split('m')[0]) * 60 + parseFloat(text.split('m')[1]);
  return { seconds: seconds(user) + seconds(system), report };
}

/**
 * The same run by the package, `runs` times in one process that has called nothing before: the seconds of each, the
 * certificate and cones of the last, and the process's peak memory in bytes. The engine's compilers run on threads of
 * the process, so that their time is part of the first run.
 */
export function runPackage(folder, file, runs) {
  const script = `
    import { readFileSync } from 'node:fs';
    import { createCore } from ${JSON.stringify(pathToFileURL(path.join(folder, 'node/core.js')).href)};
    const file = ${JSON.stringify(file)};
    const core = await createCore();
    const seconds = [];
    let result;
    for (let i = 0; i < ${runs}; i++) {
      const before = process.cpuUsage();
      const files = new Map([[file, new Uint8Array(readFileSync(file))]]);
      const model = core.load({ main: file, files });
      result = model.parametrize();
      result.write();
      result.free();
      model.free();
      const { user, system } = process.cpuUsage(before);
      seconds.push((user + system) / 1e6);
    }
    const { certified, cones } = result.report;
    const peak = process.resourceUsage().maxRSS * 1024;
    console.log(JSON.stringify({ seconds, certified, cones: cones.cones, peak }));`;
  const flags = ['--input-type=module', '-e', script];
  return JSON.parse(execFileSync('node', flags, { encoding: 'utf8', maxBuffer: 1e8 }));
}
