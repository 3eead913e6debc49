// The picture of two by two tiles that a grid as material is made of.

import { zlibSync } from 'fflate';

const side = 64; // pixels of the image, which shows two by two tiles
const lineWidth = 3;
const colours = [
  [233, 237, 242],
  [205, 214, 224],
  [29, 63, 99],
]; // paper, shade, lines

const crcTable = Int32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? (c >>> 1) ^ 0xedb88320 : c >>> 1;
  return c;
});

function chunk(kind: string, data: Uint8Array): Uint8Array {
  const out = new Uint8Array(12 + data.length);
  const view = new DataView(out.buffer);
  view.setUint32(0, data.length);
  out.set(new TextEncoder().encode(kind), 4);
  out.set(data, 8);
  let crc = -1;
  for (const byte of out.subarray(4, 8 + data.length)) {
    crc = (crc >>> 8) ^ crcTable[(crc ^ byte) & 255];
  }
  view.setUint32(8 + data.length, ~crc >>> 0);
  return out;
}

/** As a PNG with a palette. */
export function gridImage(): Uint8Array {
  const half = side / 2;
  const rows = new Uint8Array(side * (side + 1)); // each with a filter byte of 0
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      const isLine = x % half < lineWidth || y % half < lineWidth;
      const isShade = Math.floor(x / half) !== Math.floor(y / half);
      rows[y * (side + 1) + 1 + x] = isLine ? 2 : isShade ? 1 : 0;
    }
  }
  const head = new Uint8Array(13);
  const view = new DataView(head.buffer);
  view.setUint32(0, side);
  view.setUint32(4, side);
  head.set([8, 3, 0, 0, 0], 8); // eight bits, palette
  const parts = [
    new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', head),
    chunk('PLTE', Uint8Array.from(colours.flat())),
    chunk('IDAT', zlibSync(rows, { level: 9 })),
    chunk('IEND', new Uint8Array(0)),
  ];
  return joined(parts);
}

export function joined(parts: Uint8Array[]): Uint8Array {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
