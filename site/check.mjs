// What a built site must hold: every link leads somewhere, and no page asks another host for anything.

import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';

const decoded = (text) =>
  decodeURIComponent(
    text
      .replace(/&#(\d+);/g, (_, code) => String.fromCharCode(Number(code)))
      .replaceAll('&amp;', '&'),
  );

/** @returns {string[]}  what is wrong */
export function brokenLinks(folder) {
  const wrong = [];
  const idsOf = new Map();
  const ids = (file) => {
    if (!idsOf.has(file)) {
      const text = readFileSync(file, 'utf8');
      idsOf.set(
        file,
        new Set([...text.matchAll(/\s(?:id|name)="([^"]*)"/g)].map(([, id]) => decoded(id))),
      );
    }
    return idsOf.get(file);
  };
  const pages = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter(
    (name) => name.endsWith('.html') && !name.startsWith('app/'),
  );
  for (const page of pages) {
    // What is between tags is text, and may speak of attributes.
    const tags = readFileSync(path.join(folder, page), 'utf8').match(/<[a-z][^>]*>/g) ?? [];
    for (const tag of tags)
      for (const [, kind, link] of tag.matchAll(/\s(href|src)="([^"]*)"/g)) {
        if (/^(https?:)?\/\//.test(link)) {
          if (!tag.startsWith('<a ')) wrong.push(`${page}: asks another host: ${tag}`);
          continue;
        }
        if (/^(data|mailto):/.test(link)) continue;
        const [place, id] = link.split('#');
        let file = place
          ? path.join(folder, path.dirname(page), decoded(place))
          : path.join(folder, page);
        if (existsSync(file) && statSync(file).isDirectory()) file = path.join(file, 'index.html');
        if (!existsSync(file)) wrong.push(`${page}: ${kind} ${link}: no such file`);
        else if (
          id &&
          file.endsWith('.html') &&
          !file.includes('/app/') &&
          !ids(file).has(decoded(id))
        )
          wrong.push(`${page}: ${link}: no such place`);
      }
  }
  return wrong;
}
