// A grid as the material of an OBJ: a library of its own beside it, named in two new lines at the top.
// Lines that name other materials become comments; every other line keeps its bytes.

import type { OutputFile } from '../model/types';

const newline = 10;
const name = 'hgp_grid';

const startsWith = (bytes: Uint8Array, at: number, word: string): boolean =>
  [...word].every((letter, i) => bytes[at + i] === letter.charCodeAt(0));

/** Where lines begin that name a material or a library of them. */
function linesOfMaterials(bytes: Uint8Array): number[] {
  const found: number[] = [];
  for (let line = 0; line < bytes.length; line = bytes.indexOf(newline, line) + 1 || bytes.length) {
    let at = line;
    while (bytes[at] === 32 || bytes[at] === 9) at += 1;
    if (startsWith(bytes, at, 'usemtl') || startsWith(bytes, at, 'mtllib')) found.push(line);
  }
  return found;
}

function commented(bytes: Uint8Array, head: Uint8Array): Uint8Array {
  const lines = linesOfMaterials(bytes);
  const out = new Uint8Array(head.length + bytes.length + 2 * lines.length);
  out.set(head);
  let to = head.length;
  [0, ...lines].forEach((from, i) => {
    if (i > 0) out.set([35, 32], to); // "# "
    if (i > 0) to += 2;
    const part = bytes.subarray(from, lines[i] ?? bytes.length);
    out.set(part, to);
    to += part.length;
  });
  return out;
}

/** `tiles` per unit of uv; the image shows two by two of them. */
export function withObjGrid(
  { name: file, bytes }: OutputFile,
  tiles: number,
  picture: Uint8Array,
): OutputFile[] {
  const stem = `${file
    .replace(/^.*\//, '')
    .replace(/\.[^.]*$/, '')
    .replace(/[^\w.-]+/g, '_')}.grid`;
  const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
  const scale = Number((tiles / 2).toPrecision(6));
  const library = `newmtl ${name}\nKd 1 1 1\nmap_Kd -s ${scale} ${scale} 1 ${stem}.png\n`;
  return [
    { name: file, bytes: commented(bytes, encode(`mtllib ${stem}.mtl\nusemtl ${name}\n`)) },
    { name: `${stem}.mtl`, bytes: encode(library) },
    { name: `${stem}.png`, bytes: picture },
  ];
}
