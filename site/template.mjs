// One frame for all pages: head, navigation, content.

import { references, sections } from './pages.mjs';
import { relative } from './markdown.mjs';

const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** No page asks another host for anything; scripts and styles are files of the site. */
const policy =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; " +
  "worker-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'";

function links(file, pages) {
  const item = ([to, title]) =>
    `<li><a href="${relative(file, to)}"${to === file ? ' aria-current="page"' : ''}>${escaped(title)}</a></li>`;
  return `<ul>${pages.map(item).join('')}</ul>`;
}

function navigation(file, has) {
  const groups = sections.map(({ title, pages }) => {
    const own = pages.map(([, to, name]) => [to, name]);
    const all = title === 'Reference' ? [...own, ...references] : own;
    return `<h2>${escaped(title)}</h2>${links(
      file,
      all.filter(([to]) => has(to)),
    )}`;
  });
  return `<nav id="pages" aria-label="Pages">${groups.join('\n')}</nav>`;
}

function contents(headings) {
  const shown = headings.filter(({ level }) => level === 2 || level === 3);
  if (shown.length < 3) return '';
  const item = ({ level, id, text }) =>
    `<li class="level-${level}"><a href="#${escaped(id)}">${escaped(text)}</a></li>`;
  return `<nav class="contents" aria-label="On this page"><h2>On this page</h2><ul>${shown.map(item).join('')}</ul></nav>`;
}

/**
 * @param {{ file: string, title: string, html: string, headings?: object[], scripts?: string[], kind?: string }} page
 * @param {(file: string) => boolean} has  whether the site has a page
 */
export function frame({ file, title, html, headings = [], scripts = [], kind = '' }, has) {
  const to = (name) => relative(file, name);
  const script = (name) => `<script src="${to(name)}" defer></script>`;
  const tops = [
    ['app/index.html', 'Open the page'],
    ['guide.html', 'Guide'],
    ['gallery.html', 'Gallery'],
    ['five-minutes/command-line.html', 'Five minutes'],
    ['api/cpp/index.html', 'C++'],
    ['api/js/index.html', 'JavaScript'],
    ['api/python/index.html', 'Python'],
  ].filter(([name]) => has(name));
  return `<!doctype html>
<html lang="en" data-root="${to('index.html').replace(/index\.html$/, '') || './'}">
<head>
<meta charset="utf-8" />
<meta name="viewport" content="width=device-width, initial-scale=1" />
<meta name="color-scheme" content="light dark" />
<meta http-equiv="Content-Security-Policy" content="${policy}" />
<meta name="description" content="Seamless texture coordinates without folds, with cones of your choice and a certificate" />
<title>${title === 'hgp' ? 'hgp' : `${escaped(title)} — hgp`}</title>
<link rel="icon" href="${to('icon.svg')}" type="image/svg+xml" />
<link rel="stylesheet" href="${to('site.css')}" />
${['search-index.js', 'site.js', ...scripts].map(script).join('\n')}
</head>
<body class="${kind}">
<a class="skip" href="#main">Skip to the text</a>
<header>
<a class="brand" href="${to('index.html')}"><img src="${to('icon.svg')}" width="24" height="24" alt="" />hgp</a>
<nav aria-label="Main">${links(file, tops)}</nav>
<div class="search"><input type="search" id="search" placeholder="Search" aria-label="Search" autocomplete="off"
 role="combobox" aria-expanded="false" aria-controls="found" aria-autocomplete="list" />
<ol id="found" role="listbox" aria-label="Found" hidden></ol></div>
</header>
<div class="columns">
<details class="menu"><summary>All pages</summary></details>
${navigation(file, has)}
<main id="main">
${html}
</main>
${contents(headings)}
</div>
<footer><p>MIT licence. <a href="${to('THIRD_PARTY_LICENSES.txt')}">Works of others, and their licences</a>.
Nothing on this site asks another host for anything; it works offline after the first visit.</p></footer>
</body>
</html>
`;
}
