// A program with a decimal comma: every format is read and written with the same numbers as in the C locale.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import test, { before } from 'node:test';
import { root } from '../support/page.mjs';
import { cubeMesh, toGlb, toGltf, toObj, toOff, toPly, toStl } from '../support/meshes.mjs';

const folder = path.join(root, 'build/locale');
const prefix = path.join(folder, 'prefix');
const at = (name) => path.join(folder, name);
const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: 'pipe' });

const program = `
#include <hgp/api/session.h>

#include <clocale>
#include <cstdio>
#include <fstream>
#include <iterator>

static hgp::io::Bytes bytesOf(const char* name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// MESH CONES OUT
int main(int, char** words) {
  std::setlocale(LC_ALL, "");
  hgp::io::FileSet files;
  files.name = words[1];
  files.main = bytesOf(words[1]);
  hgp::api::Session session;
  const auto loaded = session.load(std::move(files), {});
  if (!loaded) return std::fprintf(stderr, "%s\\n", loaded.error().message.c_str()), 1;
  const hgp::io::Bytes text = bytesOf(words[2]);
  const auto cones = hgp::api::readPrescription(words[2], std::string(text.begin(), text.end()), 4);
  if (!cones) return std::fprintf(stderr, "%s\\n", cones.error().message.c_str()), 2;
  const auto solved = session.parametrize(*cones, {});
  if (!solved) return std::fprintf(stderr, "%s\\n", solved.error().message.c_str()), 3;
  hgp::api::WriteOptions options;
  options.embedCones = true;
  const auto written = session.write(options);
  if (!written) return std::fprintf(stderr, "%s\\n", written.error().message.c_str()), 4;
  std::ofstream out(words[3], std::ios::binary);
  const hgp::io::Bytes& bytes = written->files[0].bytes;
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out << session.certificateJson() << session.conesJson();
  std::printf("%.1f\\n", 0.5);
}
`;

before(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(at('locales'), { recursive: true });
  run('cmake', '--install', path.join(root, 'build/native-release'), '--prefix', prefix);
  writeFileSync(at('main.cpp'), program);
  writeFileSync(
    at('CMakeLists.txt'),
    `cmake_minimum_required(VERSION 3.22)
project(comma LANGUAGES CXX)
find_package(hgp REQUIRED)
add_executable(comma main.cpp)
target_link_libraries(comma PRIVATE hgp::hgp)
`,
  );
  run('cmake', '-G', 'Ninja', '-S', folder, '-B', at('build'), `-DCMAKE_PREFIX_PATH=${prefix}`);
  run('cmake', '--build', at('build'));
  // Made of Debian's sources (package locales): few machines have one ready.
  spawnSync('localedef', ['-i', 'de_DE', '-f', 'UTF-8', at('locales/de_DE.UTF-8')]);
});

const cube = cubeMesh(4);
const { json, bin } = toGltf([cube]);
const inside = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
json.buffers[0].uri = inside;
const meshes = {
  'cube.obj': toObj(cube),
  'cube.off': toOff(cube),
  'cube.ply': toPly(cube),
  'cube.stl': toStl(cube),
  'cube.glb': toGlb([cube]),
  'cube.gltf': JSON.stringify(json),
};
const eight = [0, 1, 2, 3, 4, 5, 6, 7];
const cones = {
  'cones.json': JSON.stringify({
    q: 4,
    cones: eight.map((vertex) => ({ vertex, k: 3, position: cube.vertices[vertex] })),
  }),
  'cones.txt': eight.map((v) => `${v} ${Math.PI / 2}\n`).join(''),
};

test('all formats give the same bytes in a locale with a decimal comma', () => {
  const result = (locale, mesh, file, out) => {
    const env = { PATH: process.env.PATH, LOCPATH: at('locales'), LC_ALL: locale };
    const args = [mesh, file, out];
    const done = spawnSync(at('build/comma'), args, { cwd: folder, env, encoding: 'utf8' });
    assert.equal(done.status, 0, `${locale} ${mesh} ${file}: ${done.stderr}`);
    assert.equal(done.stdout, locale === 'C' ? '0.5\n' : '0,5\n', 'the locale is in force');
    return readFileSync(at(out), 'latin1');
  };
  for (const [name, content] of Object.entries({ ...meshes, ...cones })) {
    writeFileSync(at(name), content);
  }
  for (const mesh of Object.keys(meshes)) {
    for (const file of Object.keys(cones)) {
      const plain = result('C', mesh, file, 'plain');
      assert.equal(result('de_DE.UTF-8', mesh, file, 'comma'), plain, `${mesh} ${file}`);
      assert.match(plain, /"certified": true/);
    }
  }
});
