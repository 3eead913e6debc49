// What Download offers beside the patched original: made from the same map, by writers of our own.

import { zipSync } from 'fflate';
import { toCones, type Prescription } from '../model/prescription';
import type { Model, OutputFile, Solution } from '../model/types';
import { safeName } from './file_set';
import { makeGlb } from './glb';
import { withGrid } from './grid_material';

/** What a download is made from. */
export interface ExportSource {
  model: Model;
  prescription: Prescription;
  solution: Solution;
  /** Of the pattern, per unit of uv. */
  tiles: number;
}

export interface Download {
  name: string;
  bytes: Uint8Array;
  type: string;
}

export type Format = 'same' | 'glb' | 'zip' | 'obj' | 'flat' | 'cones' | 'report' | 'svg';

export const formats: { format: Format; label: string; hint: string }[] = [
  { format: 'same', label: 'Same as the input', hint: 'patched, all else kept' },
  { format: 'glb', label: 'GLB', hint: 'the mesh with its texture coordinates' },
  { format: 'zip', label: 'glTF in a ZIP', hint: '.gltf and .bin' },
  { format: 'obj', label: 'OBJ', hint: 'v, vt and f' },
  { format: 'flat', label: 'Flat OBJ', hint: 'the map itself as a flat mesh' },
  { format: 'cones', label: 'Cones (JSON)', hint: 'to use again, here or on the command line' },
  { format: 'report', label: 'Report (JSON)', hint: 'options, rounds, certificate' },
  { format: 'svg', label: 'UV layout (SVG)', hint: 'every edge of the flattened mesh' },
];

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
const stem = ({ model }: Pick<ExportSource, 'model'>): string =>
  safeName(model.main).replace(/\.[^.]*$/, '') || 'model';

interface Gltf {
  json: Record<string, unknown>;
  bin: Uint8Array;
}

function toGltf({ result }: Solution): Gltf {
  const { positions, uv, uvToVertex, cornerToUv } = result;
  const count = uvToVertex.length;
  const bin = new ArrayBuffer(20 * count + 4 * cornerToUv.length);
  const p = new Float32Array(bin, 0, 3 * count);
  const t = new Float32Array(bin, 12 * count, 2 * count);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 3; k++) {
      const x = Math.fround(positions[3 * uvToVertex[i] + k]);
      p[3 * i + k] = x;
      low[k] = Math.min(low[k], x);
      high[k] = Math.max(high[k], x);
    }
    t[2 * i] = uv[2 * i];
    t[2 * i + 1] = 1 - uv[2 * i + 1];
  }
  new Uint32Array(bin, 20 * count).set(cornerToUv);
  const view = (byteOffset: number, byteLength: number, target: number): object => ({
    ...{ buffer: 0, byteOffset, byteLength, target },
  });
  const json = {
    asset: { version: '2.0', generator: 'hgp' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count, type: 'VEC3', min: low, max: high },
      { bufferView: 1, componentType: 5126, count, type: 'VEC2' },
      { bufferView: 2, componentType: 5125, count: cornerToUv.length, type: 'SCALAR' },
    ],
    bufferViews: [
      view(0, 12 * count, 34962),
      view(12 * count, 8 * count, 34962),
      view(20 * count, 4 * cornerToUv.length, 34963),
    ],
    buffers: [{ byteLength: bin.byteLength }],
  };
  return { json, bin: new Uint8Array(bin) };
}

function toGlb(solution: Solution): Uint8Array {
  const { json, bin } = toGltf(solution);
  return makeGlb(JSON.stringify(json), bin);
}

function toGltfFiles(solution: Solution, name: string): OutputFile[] {
  const { json, bin } = toGltf(solution);
  (json.buffers as { uri?: string }[])[0].uri = `${name}.bin`;
  return [
    { name: `${name}.gltf`, bytes: encode(JSON.stringify(json)) },
    { name: `${name}.bin`, bytes: bin },
  ];
}

async function withChosenGrid(
  { solution, tiles }: ExportSource,
  files: OutputFile[],
): Promise<OutputFile[]> {
  return solution.output.hasGrid ? withGrid(files, { mesh: 0, uvSet: 0, tiles }) : files;
}

function toObj({ result }: Solution): Uint8Array {
  const { positions, triangles, uv, cornerToUv } = result;
  const lines = ['# hgp'];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
  }
  for (let i = 0; i < uv.length; i += 2) lines.push(`vt ${uv[i]} ${uv[i + 1]}`);
  for (let c = 0; c < triangles.length; c += 3) {
    const word = (k: number): string => `${triangles[c + k] + 1}/${cornerToUv[c + k] + 1}`;
    lines.push(`f ${word(0)} ${word(1)} ${word(2)}`);
  }
  return encode(`${lines.join('\n')}\n`);
}

/** The map as geometry: programs that show no texture coordinates show this. */
function toFlatObj({ result }: Solution): Uint8Array {
  const { uv, cornerToUv } = result;
  const lines = ['# hgp: the map laid flat'];
  for (let i = 0; i < uv.length; i += 2) lines.push(`v ${uv[i]} ${uv[i + 1]} 0`);
  for (let i = 0; i < uv.length; i += 2) lines.push(`vt ${uv[i]} ${uv[i + 1]}`);
  for (let c = 0; c < cornerToUv.length; c += 3) {
    const word = (k: number): string => `${cornerToUv[c + k] + 1}/${cornerToUv[c + k] + 1}`;
    lines.push(`f ${word(0)} ${word(1)} ${word(2)}`);
  }
  return encode(`${lines.join('\n')}\n`);
}

/** Every edge once, seams in a second path, v upwards. */
function toSvg({ result, box }: Solution): Uint8Array {
  const { uv, cornerToUv, seams } = result;
  const size = 1000 / Math.max(box.width, box.height, 1e-30);
  const point = (i: number): string =>
    `${((uv[2 * i] - box.x) * size).toFixed(2)} ${((box.y + box.height - uv[2 * i + 1]) * size).toFixed(2)}`;
  const edges = new Set<string>();
  for (let c = 0; c < cornerToUv.length; c++) {
    const a = cornerToUv[c];
    const b = cornerToUv[c % 3 === 2 ? c - 2 : c + 1];
    edges.add(a < b ? `M${point(a)}L${point(b)}` : `M${point(b)}L${point(a)}`);
  }
  const sides = seams.flatMap(({ a, b }) => [a, b].map(([i, j]) => `M${point(i)}L${point(j)}`));
  const [width, height] = [box.width * size, box.height * size].map((n) => n.toFixed(2));
  return encode(
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -5 ${+width + 10} ${+height + 10}" ` +
      `fill="none" stroke-linecap="round"><path stroke="#55606c" stroke-width=".5" ` +
      `d="${[...edges].join('')}"/><path stroke="#b3261e" stroke-width="2" ` +
      `d="${sides.join('')}"/></svg>\n`,
  );
}

/** A glTF is several files, even where its buffer is written inside. */
const isOneFile = ({ files }: Solution): boolean =>
  files.length === 1 && !/\.gltf$/i.test(files[0].name);

/** What a download of this format is called. */
export function nameOf(source: ExportSource, format: Format): string {
  const { solution, model } = source;
  const name = stem(source);
  switch (format) {
    case 'same':
      return isOneFile(solution) ? safeName(solution.files[0].name || model.main) : `${name}.zip`;
    case 'obj':
      return solution.output.hasGrid ? `${name}.zip` : `${name}.obj`;
    case 'flat':
      return `${name}.flat.obj`;
    case 'cones':
    case 'report':
      return `${name}.${format}.json`;
    default:
      return `${name}.${format}`;
  }
}

function zipped(name: string, files: OutputFile[]): Download {
  const entries = Object.fromEntries(files.map((file) => [file.name, file.bytes]));
  return { name, bytes: zipSync(entries), type: 'application/zip' };
}

async function toObjDownload(source: ExportSource, name: string): Promise<Download> {
  const main = { name: `${stem(source)}.obj`, bytes: toObj(source.solution) };
  const made = await withChosenGrid(source, [main]);
  return made.length > 1 ? zipped(name, made) : { ...main, type: 'text/plain' };
}

/** The bytes for a format; the patched original is the very bytes that the preview shows. */
export async function makeDownload(source: ExportSource, format: Format): Promise<Download> {
  const { solution } = source;
  const name = nameOf(source, format);
  switch (format) {
    case 'same':
      return isOneFile(solution)
        ? { name, bytes: solution.files[0].bytes, type: 'application/octet-stream' }
        : zipped(name, solution.files);
    case 'glb': {
      const [made] = await withChosenGrid(source, [{ name, bytes: toGlb(solution) }]);
      return { ...made, type: 'model/gltf-binary' };
    }
    case 'zip':
      return zipped(name, await withChosenGrid(source, toGltfFiles(solution, stem(source))));
    case 'obj':
      return toObjDownload(source, name);
    case 'flat':
      return { name, bytes: toFlatObj(solution), type: 'text/plain' };
    case 'cones':
      return coneFile(source);
    case 'report': {
      const bytes = encode(`${JSON.stringify(solution.result.report, null, 1)}\n`);
      return { name, bytes, type: 'application/json' };
    }
    case 'svg':
      return { name, bytes: toSvg(solution), type: 'image/svg+xml' };
  }
}

export function coneFile({
  model,
  prescription,
}: Pick<ExportSource, 'model' | 'prescription'>): Download {
  const { info, surface } = model;
  const cones = {
    ...{ format: 'hgp-cones', version: 1 },
    mesh: { vertices: info.vertices, triangles: info.triangles, sha256: info.file.sha256 },
    ...toCones(prescription, surface.positions),
  };
  const bytes = encode(`${JSON.stringify(cones, null, 1)}\n`);
  return { name: `${stem({ model })}.cones.json`, bytes, type: 'application/json' };
}
