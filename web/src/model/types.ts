// Types that several parts of the page share.

import type { ModelInfo, Result, SurfaceFacts, Where, Written } from 'hgp';
import type { Prescription } from './prescription';

/** By relative name. */
export type Files = Map<string, Blob | Uint8Array>;

export interface OutputFile {
  name: string;
  bytes: Uint8Array;
}

export interface Missing {
  name: string;
  /** Geometry cannot be read without it; images can be left out. */
  isNeeded: boolean;
}

/**
 * The loaded surface: ids are those of the file; what is known of vertices is told by the solver, of what
 * repairs and welds made of them.
 */
export interface Surface extends SurfaceFacts {
  /** Names it in the geometry worker. */
  id: number;
  positions: Float64Array;
  triangles: Uint32Array;
  vertexCount: number;
  diagonal: number;
  /** Where the model is seen: positions and normals moved by the first node that uses the mesh. */
  places: Float64Array;
  normals: Float32Array;
  /** That node turns left hands into right ones. */
  isMirrored: boolean;
  /** A ball around it, where it is seen. */
  center: [number, number, number];
  radius: number;
  /** Three numbers per triangle corner, ready to be drawn. */
  cornerPositions: Float32Array;
  /** Four bytes per corner, 127 for 1: a graphics card takes long to be given more. */
  cornerNormals: Int8Array;
}

export interface LoadSettings {
  readonly weld?: number;
  /** All repairs that the solver knows of, instead of those of `fix`. */
  readonly hasAllRepairs?: boolean;
  readonly fix: {
    readonly orient?: boolean;
    readonly split?: boolean;
    readonly degenerate?: boolean;
  };
}

/** What undo goes back and forth over. */
export interface Step {
  readonly prescription: Prescription;
  readonly settings: LoadSettings;
}

/** Alignment to a grid of squares. */
export interface GridSettings {
  readonly isOn: boolean;
  /** Grid cells in all; nothing: as many as the model and its cones need. */
  readonly cells?: number;
  /** `quad`: cones lie on grid points, so that the cells are a quad mesh. */
  readonly mode: 'tile' | 'quad';
}

/** How Run is done; what is asked of the map is the prescription. */
export interface SolveSettings {
  rounds: number;
  /** Less distortion: −1 of angles, 0 of both, 1 of areas; nothing: the map as solved. */
  improve?: number;
  /** `file`: the directions of the imported field, instead of a smooth field of the solver's own. */
  frames: 'auto' | 'file';
  grid: GridSettings;
  /** In seconds; without it a run takes as long as it takes. */
  timeLimit?: number;
}

export interface Seam {
  /** Ends as uv vertices, corresponding ends first. */
  a: [number, number];
  b: [number, number];
  r: number;
}

/** Where and how the map goes into the file. */
export interface Output {
  /** glTF: the set to write; without it the next free one. */
  uvSet?: number;
  /** glTF: the textures of the file use the set that is written. */
  usesNewSet: boolean;
  scale: 'solved' | 'unit' | 'fit';
  embedCones: boolean;
  /** glTF: the mesh gets a grid as its material. */
  hasGrid: boolean;
}

/** What a solution is the solution of. */
export interface SolveRequest {
  prescription: Prescription;
  /** Welds and repairs of the surface that it is the map of. */
  settings: LoadSettings;
  improve?: number;
  frames: 'auto' | 'file';
  /** As it was set; `cells` are those that were asked of the solver, where any were. */
  grid: GridSettings;
  cells?: number;
  output: Output;
}

/** Values at 0, 5, 50, 95, 99 and 100 percent. */
export interface Quantiles {
  min: number;
  p5: number;
  median: number;
  p95: number;
  p99: number;
  max: number;
}

export interface Distortion {
  /** Ratio of singular values, 1 = angles kept. */
  stretch: Quantiles;
  /** log₂ of the area scaling relative to the whole. */
  area: Quantiles;
  /** Its absolute value. */
  areaSize: Quantiles;
  seamDistance: Quantiles;
  /** Triangles that are not positive in the map. */
  flipped: Uint32Array;
  uvArea: number;
  surfaceArea: number;
}

export interface LeastArea {
  /** In the map, of the triangle that has least of it; negative where it is folded over. */
  area: number;
  /** Of all triangles. */
  mean: number;
  triangle: number;
  /** How many are below zero, and how many are zero. */
  negative: number;
  zero: number;
  /** The smallest that is above zero. */
  smallestPositive: number;
}

export interface Overlaps {
  /** Pairs of triangles that share area and no corner. */
  pairs: number;
  triangles: Uint32Array;
  /** There are so many that counting stopped. */
  isMore: boolean;
}

/** A surface with its map, corner by corner. */
export interface Corners {
  /** Per triangle corner, three numbers. */
  positions: Float64Array;
  /** Per triangle corner, two numbers, v pointing up. */
  uv: Float64Array;
  /** Where there are polygons: corners of each, and all of the above is per polygon corner. */
  sizes?: number[];
}

/** What the geometry worker finds out about a map. */
export interface Analysis {
  /** Names it in the geometry worker. */
  id: number;
  /** The written bytes hold the very map that was certified. */
  isSameAsFile: boolean;
  /** Why not, where they do not. */
  difference: string;
  /** Two numbers per triangle corner, v pointing up: from the file where it is the same. */
  cornerUv: Float32Array;
  /** The map laid flat, three numbers per corner. */
  flatPositions: Float32Array;
  distortion: Distortion;
  least: LeastArea;
  /** Triangles that lie on top of others, which is allowed. */
  overlaps: Overlaps;
  /** Colour group of each seam edge: the two sides of a chain have the same. */
  chains: Uint32Array;
  box: Box;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** One finished run: the map, the bytes that Download saves, and what is known about them. */
export interface Solution extends SolveRequest, Analysis {
  result: Result;
  written: Written;
  /** What the writer has to say. */
  notes: string[];
  /** What else is in the file and stays: "3 materials, 1 skin". */
  preserved: string;
  /** What was written, and what it names beside that. */
  files: OutputFile[];
  seams: Seam[];
  /** The solver may have kept the map under this name. */
  keptAs: string;
  /** Edge of the surface (smaller vertex × |V| + larger) → seam. */
  seamAt: Map<number, number>;
}

export interface MeshSummary {
  index: number;
  /** Nodes that use the mesh; nothing where the format has no nodes. */
  instances?: number;
  isUsable: boolean;
  components: number;
  /** Why it cannot be used, in a few words. */
  why: string;
}

/** A file that is open, with the mesh of it that is worked on. */
export interface Model {
  readonly main: string;
  readonly files: Files;
  readonly info: ModelInfo;
  readonly surface: Surface;
  /** What it was loaded with; undo may be ahead of it. */
  readonly loaded: LoadSettings;
  /** About the mesh: how it is used, what it has already. */
  readonly remarks: string[];
  /** From the mesh to where its first node puts it, column by column. */
  readonly matrix: readonly number[];
}

/** What the solver says of cones that add up. */
export interface Objection {
  prescription: Prescription;
  surface: Surface;
  /** Empty where there is none. */
  text: string;
  warnings: string[];
}

export interface Validation {
  of: Solution;
  isGood: boolean;
  text: string;
  /** The most severe first. */
  issues: string[];
}

export interface MessageAction {
  label: string;
  run(): unknown;
}

export interface Message {
  kind: 'note' | 'good' | 'error';
  text: string;
  actions?: MessageAction[];
  /** What is worth reading only when someone asks. */
  details?: string;
}

export interface Job {
  kind: 'load' | 'run';
  title: string;
  stage: string;
  /** Stages that have been entered, in order. */
  entered: string[];
  detail: string;
  fraction: number;
  /** Where it can be said honestly. */
  secondsLeft?: number;
  begin: number;
  controller: AbortController;
}

export type Pattern =
  | 'checker'
  | 'grid'
  | 'brick'
  | 'wood'
  | 'plaid'
  | 'cross'
  | 'hex'
  | 'circles'
  | 'image'
  | 'material'
  | 'plain';
export type Overlay = 'none' | 'angle' | 'area' | 'seams' | 'flips';

export interface Look {
  pattern: Pattern;
  overlay: Overlay;
  /** Tiles along the diagonal of the bounding box. */
  tiles: number;
  /** Tiles along a cell of an aligned map. */
  steps: number;
  /** `auto`: in the 3D view where lines do not meet, in the UV view always. */
  seams: 'auto' | 'on' | 'off';
  hasWire: boolean;
  image?: ImageBitmap;
}

export const patterns: readonly Pattern[] = [
  'checker',
  'grid',
  'brick',
  'wood',
  'plaid',
  'cross',
  'hex',
  'circles',
  'image',
  'material',
  'plain',
];
export const overlays: readonly Overlay[] = ['none', 'angle', 'area', 'seams', 'flips'];

export type ShowPlaces = (where: Where[]) => void;
