// The formats that Download offers: the file from which the preview was read back, other formats written by the
// solver, and files that the page makes itself.

import type { WriteOptions } from 'hgp';
import { toCones, type Prescription } from '../model/prescription';
import type { Model, OutputFile, Solution } from '../model/types';
import { nameStem, safeName } from './file_set';

/** The data from which a download is made. */
export interface ExportSource {
  model: Model;
  prescription: Prescription;
  solution: Solution;
  /** Tiles of the pattern per unit of uv. */
  tiles: number;
}

export interface Download {
  name: string;
  bytes: Uint8Array;
  type: string;
}

export type Format = 'same' | 'glb' | 'zip' | 'obj' | 'flat' | 'cones' | 'report' | 'svg';

export const formats: { format: Format; label: string; hint: string }[] = [
  { format: 'same', label: 'Same as the input', hint: 'only the coordinates change' },
  { format: 'glb', label: 'GLB', hint: 'the mesh with its texture coordinates' },
  { format: 'zip', label: 'glTF in a ZIP', hint: '.gltf and .bin' },
  { format: 'obj', label: 'OBJ', hint: 'v, vt and f' },
  { format: 'flat', label: 'Flat OBJ', hint: 'the map itself as a flat mesh' },
  { format: 'cones', label: 'Cones (JSON)', hint: 'to use again, here or on the command line' },
  { format: 'report', label: 'Report (JSON)', hint: 'options, rounds, certificate' },
  { format: 'svg', label: 'UV layout (SVG)', hint: 'every edge of the flattened mesh' },
];

/** The formats that the solver writes from its current map. */
export type SolverFormat = Exclude<Format, 'same' | 'cones' | 'report'>;

const solverFormats: Record<SolverFormat, [WriteOptions['format'], string]> = {
  glb: ['glb', 'glb'],
  zip: ['gltf', 'gltf'],
  obj: ['obj', 'obj'],
  flat: ['flat-obj', 'flat.obj'],
  svg: ['svg', 'svg'],
};

const types: Record<string, string> = {
  glb: 'model/gltf-binary',
  obj: 'text/plain',
  svg: 'image/svg+xml',
  json: 'application/json',
  zip: 'application/zip',
};

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
const stem = ({ model }: Pick<ExportSource, 'model'>): string => nameStem(model.main);

/** A .gltf does not count as one file, even if its buffer is embedded. */
const isOneFile = (files: OutputFile[]): boolean =>
  files.length === 1 && !/\.gltf$/i.test(files[0].name);

/** The solver's options for a format. */
export function writeOptionsFor(source: ExportSource, format: SolverFormat): WriteOptions {
  const { solution, tiles } = source;
  const [asked, extension] = solverFormats[format];
  const gridMaterial = solution.output.hasGrid ? tiles : false;
  return { format: asked, name: `${stem(source)}.${extension}`, gridMaterial };
}

/** The file name of a download in this format. */
export function nameOf(source: ExportSource, format: Format): string {
  const { solution, model } = source;
  const name = stem(source);
  switch (format) {
    case 'same': {
      const { files } = solution;
      return isOneFile(files) ? safeName(files[0].name || model.main) : `${name}.zip`;
    }
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

/** A single file as it is, several files in a ZIP. */
export async function packed(
  name: string,
  files: OutputFile[],
  zip: (files: OutputFile[]) => Promise<Uint8Array>,
): Promise<Download> {
  const bytes = isOneFile(files) ? files[0].bytes : await zip(files);
  const type = types[name.slice(name.lastIndexOf('.') + 1).toLowerCase()];
  return { name, bytes, type: type ?? 'application/octet-stream' };
}

export function reportFile(source: ExportSource): Download {
  const bytes = encode(`${JSON.stringify(source.solution.result.report, null, 1)}\n`);
  return { name: nameOf(source, 'report'), bytes, type: types.json };
}

export function coneFile({
  model,
  prescription,
}: Pick<ExportSource, 'model' | 'prescription'>): Download {
  const { info, surface } = model;
  const cones = {
    format: 'hgp-cones',
    version: 1,
    mesh: { vertices: info.vertices, triangles: info.triangles, sha256: info.file.sha256 },
    ...toCones(prescription, surface.positions),
  };
  const bytes = encode(`${JSON.stringify(cones, null, 1)}\n`);
  return { name: `${stem({ model })}.cones.json`, bytes, type: types.json };
}
