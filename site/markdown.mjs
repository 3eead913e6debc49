// Markdown to HTML, with GitHub's ids of headings, and links that fit the site.

import { Marked } from 'marked';
import path from 'node:path';

const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const plain = (html) =>
  html
    .replace(/<[^>]*>/g, '')
    .replace(/&#(\d+);/g, (_, code) => String.fromCharCode(Number(code)))
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&amp;/g, '&');

/** The id that GitHub gives a heading. */
export const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}_\s-]/gu, '')
    .trim()
    .replace(/\s/g, '-');

/** A cell of a table. An empty corner is no header: one without words would be announced as such. */
const cell = (html, tag) => (html || tag === 'td' ? `<${tag}>${html}</${tag}>` : '<td></td>');

/**
 * @param {(href: string) => string | undefined} resolve  a link as written → one of the site; undefined: no link
 * @returns {{ html: string, title: string, headings: { level: number, id: string, text: string, at: number }[] }}
 */
export function render(markdown, resolve) {
  const headings = [];
  const seen = new Map();
  const renderer = {
    heading({ tokens, depth }) {
      const inner = this.parser.parseInline(tokens);
      const text = plain(inner);
      const base = slug(text);
      const count = seen.get(base) ?? 0;
      seen.set(base, count + 1);
      const id = count ? `${base}-${count}` : base;
      headings.push({ level: depth, id, text });
      return `<h${depth} id="${escaped(id)}">${inner}</h${depth}>\n`;
    },
    link({ href, tokens }) {
      const inner = this.parser.parseInline(tokens);
      const place = resolve(href);
      return place === undefined
        ? `<span class="in-source" title="in the sources: ${escaped(href)}">${inner}</span>`
        : `<a href="${escaped(place)}">${inner}</a>`;
    },
    image({ href, text }) {
      return `<img src="${escaped(resolve(href) ?? href)}" alt="${escaped(text)}" loading="lazy" />`;
    },
    code({ text, lang }) {
      const what = lang ? ` data-language="${escaped(lang)}"` : '';
      return `<pre tabindex="0"${what}><code>${escaped(text)}</code></pre>\n`;
    },
    table(token) {
      const row = (cells, tag) =>
        `<tr>${cells.map(({ tokens }) => cell(this.parser.parseInline(tokens), tag)).join('')}</tr>`;
      const body = token.rows.map((cells) => row(cells, 'td')).join('\n');
      // Markdown's tables all have a header row; one without words is no header to a reader.
      const hasHeader = token.header.some(({ text }) => text.trim());
      const head = hasHeader ? `<thead>${row(token.header, 'th')}</thead>` : '';
      return `<div class="table" tabindex="0"><table>${head}<tbody>${body}</tbody></table></div>\n`;
    },
  };
  const html = new Marked({ gfm: true }).use({ renderer }).parse(markdown);
  return { html, title: headings[0]?.text ?? '', headings };
}

/** What a page says below each of its headings, for the search: { id, heading, text }[]. */
export function parts(html) {
  return html
    .split(/(?=<h[1-4] id=")/)
    .map((part) => {
      const [, id = '', heading = ''] = part.match(/^<h\d id="([^"]*)">(.*?)<\/h\d>/s) ?? [];
      return { id, heading: plain(heading), text: plain(part.replace(/^<h\d.*?<\/h\d>/s, ' ')) };
    })
    .map((part) => ({ ...part, text: part.text.replace(/\s+/g, ' ').trim() }))
    .filter(({ heading, text }) => heading || text);
}

/** A relative link from one page of the site to another. */
export function relative(from, to) {
  const way = path.posix.relative(path.posix.dirname(from), to);
  return way === '' ? './' : way;
}
