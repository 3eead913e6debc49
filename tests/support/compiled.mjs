// Which Debian packages the files of a build come from: headers that were compiled in, and shared libraries.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync, realpathSync } from 'node:fs';
import path from 'node:path';

const root = path.resolve(import.meta.dirname, '../..');
const run = (command, ...args) =>
  execFileSync(command, args, { encoding: 'utf8', maxBuffer: 2 ** 28 });

export const { components, toolchain } = JSON.parse(
  readFileSync(path.join(root, 'packaging/components.json'), 'utf8'),
);

/** The headers from outside this checkout that the objects of a build in `folders` include, as Ninja recorded them. */
export function headersOf(build, folders) {
  const found = new Set();
  let isAsked = false;
  for (const line of run('ninja', '-C', build, '-t', 'deps').split('\n')) {
    if (/^\S/.test(line)) isAsked = folders.test(line);
    else if (isAsked && line.trim()) found.add(path.resolve(build, line.trim()));
  }
  const places = new Set([...found].filter(existsSync).map((name) => realpathSync(name)));
  return [...places].filter((name) => !name.startsWith(`${root}/`));
}

/** The folders in which Debian's packages have files, and their packages. */
function ownersOf(names) {
  const wanted = new Set(names);
  const owners = new Map();
  const info = '/var/lib/dpkg/info';
  for (const list of readdirSync(info).filter((name) => name.endsWith('.list'))) {
    const text = readFileSync(path.join(info, list), 'utf8');
    for (const line of text.split('\n'))
      if (wanted.has(line)) owners.set(line, list.replace(/(:\w+)?\.list$/, ''));
  }
  return owners;
}

/** The package of each file. Emscripten's own headers are in its cache, which no package owns. */
export function packagesOf(files) {
  const plain = files.filter((name) => !name.includes('/emscripten'));
  // /lib is a link to /usr/lib, and packages name either.
  const owners = ownersOf(plain.flatMap((name) => [name, name.replace(/^\/usr\/lib\//, '/lib/')]));
  const of = (name) => owners.get(name) ?? owners.get(name.replace(/^\/usr\/lib\//, '/lib/'));
  const found = new Map();
  if (plain.length < files.length) found.set('emscripten', 'emscripten');
  for (const name of plain) found.set(of(name) ?? `no package has ${name}`, name);
  return found;
}

/** What is compiled in or linked, but neither listed for any of `parts` nor part of the toolchain: package → file. */
export function unlisted(packages, parts) {
  const listed = new Set(
    components
      .filter((one) => one.parts.some((part) => parts.includes(part)))
      .map(({ source }) => source.replace(/^debian:/, '')),
  );
  return Object.fromEntries(
    [...packages].filter(([name]) => !listed.has(name) && !(name in toolchain)),
  );
}

/** The names of the shared libraries that a program or module is linked to. */
export const librariesOf = (file) =>
  [...run('readelf', '-d', file).matchAll(/\(NEEDED\).*\[(.*)\]/g)].map(([, name]) => name);
