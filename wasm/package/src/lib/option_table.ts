// Made from core/hgp/api/option_table.cpp by wasm/options.mjs: the options that the core reads, by the call.

/**
 * "grid.cells" is `cells` of the object `grid`; `isOpen`: above `low`, not equal to it.
 * @internal
 */
export interface OptionRow {
  name: string;
  kind: 'flag' | 'integer' | 'number' | 'text' | 'word' | 'wordOrNumber' | 'flagOrNumber' | 'words';
  words?: string[];
  low?: number;
  high?: number;
  isOpen?: boolean;
}

/** @internal */
export const optionTable: Record<'load' | 'solve' | 'verify' | 'write', OptionRow[]> = {
  load: [
    { name: 'surface', kind: 'integer', low: 0 },
    { name: 'weld', kind: 'wordOrNumber', words: ['exact', 'none'], low: 0 },
    { name: 'limits.bytes', kind: 'integer', low: 1 },
    { name: 'limits.triangles', kind: 'integer', low: 1 },
    { name: 'fix', kind: 'words', words: ['orient', 'split', 'degenerate'] },
    { name: 'strict', kind: 'flag' },
    { name: 'writeRepairs', kind: 'flag' },
    { name: 'target', kind: 'word', words: ['obj', 'glb', 'gltf', 'ply'] },
  ],
  solve: [
    { name: 'q', kind: 'integer', low: 1, high: 64 },
    { name: 'count', kind: 'integer', low: 0 },
    {
      name: 'conesFor',
      kind: 'word',
      words: ['balanced', 'few', 'fewer', 'more', 'low-distortion'],
    },
    { name: 'alignToCurvature', kind: 'flag' },
    { name: 'boundary', kind: 'word', words: ['free', 'convex', 'rectangle'] },
    { name: 'maxRounds', kind: 'integer', low: 1, high: 1000 },
    { name: 'method', kind: 'word', words: ['auto', 'harmonic', 'soft', 'printed', 'all-frames'] },
    { name: 'frames', kind: 'word', words: ['auto', 'file'] },
    {
      name: 'improve',
      kind: 'wordOrNumber',
      words: ['isometric', 'conformal', 'area'],
      low: -1,
      high: 1,
    },
    { name: 'quality', kind: 'flag' },
    { name: 'keepGoing', kind: 'flag' },
    { name: 'scale', kind: 'word', words: ['solved', 'unit', 'fit'] },
    { name: 'refine', kind: 'flag' },
    { name: 'convexPolygons', kind: 'flag' },
    { name: 'grid.cells', kind: 'number', low: 1, high: 1000000000000000 },
    { name: 'grid.spacing', kind: 'number', low: 0, isOpen: true },
    { name: 'grid.mode', kind: 'word', words: ['tile', 'quad'] },
    { name: 'symmetric', kind: 'word', words: ['auto', 'X', 'Y', 'Z'] },
  ],
  verify: [
    { name: 'q', kind: 'integer', low: 0, high: 64 },
    { name: 'uvSet', kind: 'integer', low: -1, high: 63 },
    { name: 'tolerance', kind: 'number', low: 0 },
  ],
  write: [
    { name: 'name', kind: 'text' },
    { name: 'format', kind: 'word', words: ['same', 'glb', 'gltf', 'obj', 'flat-obj', 'svg'] },
    { name: 'gridMaterial', kind: 'flagOrNumber', low: 0 },
    { name: 'uvSet', kind: 'integer', low: -1, high: 15 },
    { name: 'embedCones', kind: 'flag' },
    { name: 'allowUncertified', kind: 'flag' },
    { name: 'use', kind: 'flag' },
  ],
};
