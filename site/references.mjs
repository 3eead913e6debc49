// The API references: Doxygen and Sphinx for C++, Sphinx for Python, TypeDoc for the package. All of them give
// fragments, which get the site's own frame.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { render } from './markdown.mjs';

const root = path.resolve(import.meta.dirname, '..');
const scratch = path.join(root, 'build/site-references');
const native = path.join(root, process.env.HGP_BUILD ?? 'build/native-release');

function run(command, args, env = {}) {
  try {
    execFileSync(command, args, { cwd: root, stdio: 'pipe', env: { ...process.env, ...env } });
  } catch (error) {
    throw new Error(`${command} ${args.join(' ')}\n${error.stdout}\n${error.stderr}`, {
      cause: error,
    });
  }
}

const files = (folder, ending) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith(ending))
    .sort();

/** Headings of a page that Sphinx wrote. */
function headingsOf(html) {
  const headings = [];
  for (const [, id, level, text] of html.matchAll(
    /<section id="([^"]+)">\s*(?:<span[^>]*><\/span>)*<h(\d)>(.*?)<a class="headerlink"/gs,
  ))
    headings.push({ level: Number(level), id, text: text.replace(/<[^>]*>/g, '') });
  for (const [, id] of html.matchAll(/<dt class="sig sig-object (?:py|cpp)" id="([^"]+)"/g))
    if (!headings.some((one) => one.id === id)) headings.push({ level: 4, id, text: id });
  return headings;
}

/** Pages that Sphinx makes of a folder. */
function sphinx(from, name, out, env) {
  const folder = path.join(scratch, name);
  const config = path.join(root, 'site/sphinx');
  run('/usr/bin/python3', ['-m', 'sphinx', '-q', '-b', 'json', '-c', config, from, folder], env);
  return files(folder, '.fjson')
    .filter((file) => !/^(genindex|search|py-modindex|cpp-modindex)\.fjson$/.test(file))
    .map((file) => {
      const { title, body } = JSON.parse(readFileSync(path.join(folder, file), 'utf8'));
      // Sphinx links pages as folders.
      const html = body
        .replace(/<a class="reference external" href="tcp:[^"]*">(.*?)<\/a>/g, '$1') // an address in a sentence
        .replace(/href="\.\.\/([\w-]+)\/(#[^"]*)?"/g, 'href="$1.html$2"')
        .replace(/href="([\w-]+)\/(#[^"]*)?"/g, 'href="$1.html$2"')
        .replace(/href="\.\.\/(#[^"]*)?"/g, 'href="index.html$1"');
      return {
        file: `${out}/${file.replace(/fjson$/, 'html')}`,
        title: title.replace(/<[^>]*>/g, ''),
        html,
        headings: headingsOf(html),
      };
    });
}

const python = () =>
  sphinx(path.join(root, 'site/sphinx/python'), 'python', 'api/python', {
    PYTHONPATH: path.join(native, 'python'),
  });

/** The headers that `cmake --install` installs, as the build configured it. */
function publicHeaders() {
  const rules = readFileSync(path.join(native, 'cmake_install.cmake'), 'utf8');
  return [...rules.matchAll(/"([^"]*\/core\/hgp\/[\w/]+\.h)"/g)].map(([, file]) => file);
}

/** What the pages of the C++ reference say first. The other public headers are below their modules. */
const start = `C++ API
=======

A program includes \`\`hgp/eigen.h\`\` and links \`\`hgp::hgp\`\`: one call maps a mesh given as Eigen's matrices. A session (:doc:\`api\`)
does what the command line does, with files. :doc:\`verify\` has the certificate, :doc:\`base\` results and errors.

{{eigen}}
Modules
-------

.. toctree::
   :maxdepth: 1

`;
const modules = {
  api: 'Session, options and results',
  base: 'Results, errors, ids, progress',
  verify: 'Certificate',
  prescription: 'Cones, turnings, handles, features',
  mesh: 'Meshes',
  parametrize: 'One surface',
  grid: 'Grid options',
  improve: 'Improvement options',
  cones: 'Automatic cones',
  io: 'Files',
};

/** What a header declares outside of others, in its order, as directives of Breathe. */
function declarationsOf(xml, header) {
  const attribute = (tag, name) => tag.match(new RegExp(`${name}="([^"]*)"`))?.[1] ?? '';
  const found = [];
  for (const name of files(xml, '.xml')) {
    if (!/^(class|struct|namespace)/.test(name)) continue;
    const text = readFileSync(path.join(xml, name), 'utf8');
    const [, full] = text.match(/<compoundname>(.*?)<\/compoundname>/);
    if (/detail|@/.test(full)) continue;
    const place =
      text.match(/<location [^>]*\/>\s*(?:<listofallmembers>.*)?<\/compounddef>/s)?.[0] ?? '';
    if (!name.startsWith('namespace')) {
      const isInner = /::[A-Z]\w*::[A-Z]/.test(full);
      if (attribute(place, 'file').endsWith(header) && !isInner)
        found.push([
          Number(attribute(place, 'line')),
          name.startsWith('class') ? 'class' : 'struct',
          full,
        ]);
      continue;
    }
    for (const [whole, kind] of text.matchAll(
      /<memberdef kind="(enum|function|typedef)".*?<\/memberdef>/gs,
    )) {
      const [location] = whole.match(/<location [^>]*\/>/);
      const [, own] = whole.match(/<name>(.*?)<\/name>/);
      const args =
        kind === 'function' ? (whole.match(/<argsstring>(.*?)<\/argsstring>/)?.[1] ?? '') : '';
      if (attribute(location, 'file').endsWith(header))
        found.push([Number(attribute(location, 'line')), kind, `${full}::${own}${args}`]);
    }
  }
  return found
    .sort(([a], [b]) => a - b)
    .map(([, kind, name]) => {
      const plainName = name
        .replaceAll('&amp;', '&')
        .replaceAll('&lt;', '<')
        .replaceAll('&gt;', '>')
        .replace(/ ?=[^,)]*/g, '');
      const members =
        kind === 'class' || kind === 'struct' ? '\n   :members:\n   :undoc-members:' : '';
      return `.. doxygen${kind}:: ${plainName}${members}\n\n`;
    });
}

/** Writes a page for each module with public headers. */
function writeCppPages(folder, headers, xml) {
  mkdirSync(folder, { recursive: true });
  const moduleOf = (name) => name.match(/\/core\/hgp\/(?:(\w+)\/)?/)[1] ?? '';
  const of = (module) => headers.filter((name) => moduleOf(name) === module);
  // Modules that are not in the table come last, by their own names.
  const all = new Set([...Object.keys(modules), ...headers.map(moduleOf)]);
  const shown = [...all].filter((module) => module && of(module).length > 0);
  for (const module of shown) {
    const title = modules[module] ?? `Module ${module}`;
    const files = of(module).map((name) => {
      const short = name.replace(/.*\/core\//, '');
      return `${short}\n${'-'.repeat(short.length)}\n\n${declarationsOf(xml, short).join('')}`;
    });
    writeFileSync(
      path.join(folder, `${module}.rst`),
      `${title}\n${'='.repeat(title.length)}\n\n${files.join('')}`,
    );
  }
  const first = declarationsOf(xml, 'hgp/eigen.h').join('');
  writeFileSync(
    path.join(folder, 'index.rst'),
    start.replace('{{eigen}}', first) + shown.map((name) => `   ${name}\n`).join(''),
  );
}

function cpp() {
  const xml = path.join(scratch, 'doxygen');
  mkdirSync(xml, { recursive: true });
  const headers = publicHeaders();
  if (headers.length < 10) throw new Error('the build has no rules that install headers');
  const settings = {
    PROJECT_NAME: 'hgp',
    INPUT: headers.join(' '),
    STRIP_FROM_PATH: path.join(root, 'core'),
    OUTPUT_DIRECTORY: xml,
    GENERATE_HTML: 'NO',
    GENERATE_LATEX: 'NO',
    GENERATE_XML: 'YES',
    XML_PROGRAMLISTING: 'NO',
    JAVADOC_AUTOBRIEF: 'YES',
    EXTRACT_ALL: 'YES',
    EXCLUDE_SYMBOLS: 'hgp::detail*',
    QUIET: 'YES',
    WARN_IF_UNDOCUMENTED: 'NO',
    WARNINGS: 'NO',
  };
  const text = Object.entries(settings).map(([name, value]) => `${name} = ${value}\n`);
  writeFileSync(path.join(xml, 'Doxyfile'), text.join(''));
  run('doxygen', [path.join(xml, 'Doxyfile')]);
  const written = path.join(scratch, 'cpp-pages');
  writeCppPages(written, headers, path.join(xml, 'xml'));
  const pages = sphinx(written, 'cpp', 'api/cpp', { HGP_DOXYGEN: path.join(xml, 'xml') });
  return pages.map((page) => ({
    ...page,
    html: page.html.replaceAll(/<em>Defined[^<]*<\/em>/g, ''),
  }));
}

/** The first comment of an entry of the package, which says what it is for. */
function purposeOf(entry) {
  const source = readFileSync(path.join(root, `wasm/package/src/${entry}.ts`), 'utf8');
  const [comment] = source.match(/^(?:\/\/.*\n)+/);
  return comment
    .replaceAll(/^\/\/ ?/gm, '')
    .replaceAll('\n', ' ')
    .trim()
    .replaceAll('|', '\\|');
}

/** The list of entries, as programs import them and with what each is for; TypeDoc has only their names. */
function withPurposes(markdown) {
  const row = /^\| \[([\w-]+)\]\((.*?)\) \| .*\|$/gm;
  return markdown
    .replace('## Modules', '## What programs import')
    .replace('| Module |', '| Import |')
    .replaceAll(row, (_, entry, href) => {
      const name = entry === 'index' ? 'hgp' : `hgp/${entry}`;
      return `| [${name}](${href}) | ${purposeOf(entry)} |`;
    });
}

function js() {
  const folder = path.join(scratch, 'js');
  rmSync(folder, { recursive: true, force: true });
  const entries = ['index', 'core', 'lite', 'worker', 'three', 'gltf-transform', 'gzip'];
  run(process.execPath, [
    path.join(root, 'site/node_modules/typedoc/bin/typedoc'),
    ...['--plugin', path.join(root, 'site/node_modules/typedoc-plugin-markdown/dist/index.js')],
    ...['--out', folder, '--tsconfig', path.join(root, 'wasm/tsconfig.json')],
    ...[
      '--skipErrorChecking',
      '--readme',
      'none',
      '--disableSources',
      '--hideBreadcrumbs',
      '--hidePageHeader',
    ],
    ...['--logLevel', 'Error', '--excludePrivate', '--excludeInternal', '--name', 'JavaScript API'],
    ...[
      '--indexFormat',
      'table',
      '--parametersFormat',
      'table',
      '--propertyMembersFormat',
      'table',
    ],
    ...entries.flatMap((name) => ['--entryPoints', path.join(root, `wasm/package/src/${name}.ts`)]),
  ]);
  const outOf = (name) => name.replace(/README\.md$/, 'index.html').replace(/\.md$/, '.html');
  return files(folder, '.md').map((name) => {
    const resolve = (href) =>
      /^(https?:|#)/.test(href)
        ? href
        : href.replace(/README\.md/, 'index.html').replace(/\.md(?=#|$)/, '.html');
    const markdown = readFileSync(path.join(folder, name), 'utf8');
    const text = name === 'README.md' ? withPurposes(markdown) : markdown;
    const { html, title, headings } = render(text, resolve);
    return { file: `api/js/${outOf(name)}`, title, html, headings };
  });
}

/** All reference pages: { file, title, html, headings }. */
export function referencePages() {
  rmSync(scratch, { recursive: true, force: true });
  return [...cpp(), ...js(), ...python()];
}
