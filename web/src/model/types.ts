// Types that several parts of the page share.

import type {
  Model as SolverModel,
  ModelInfo,
  Quads,
  Result,
  SurfaceFacts,
  UvMap,
  Where,
  Written,
  Note,
} from 'hgp';
import type { FeatureChoice } from './features';
import type { QuadShape } from './quad_shape';
import type { Distortion, SmallestArea, Overlaps, Sizes } from './measures';
import type { Prescription } from './prescription';

/** By relative name. */
export type Files = Map<string, Blob | Uint8Array>;

export interface OutputFile {
  name: string;
  bytes: Uint8Array;
}

export interface Missing {
  name: string;
  /** Whether geometry needs the file; images do not. */
  isNeeded: boolean;
}

/**
 * The loaded surface. Ids are those of the file; facts about vertices come from the solver and describe the surface
 * after welds and repairs.
 */
export interface Surface extends SurfaceFacts {
  /** Identifies it in the geometry worker. */
  id: number;
  positions: Float64Array;
  triangles: Uint32Array;
  vertexCount: number;
  diagonal: number;
  /** Positions as displayed, transformed by the first node that uses the mesh; the same array if it does not move them. */
  places: Float64Array;
  normals: Float32Array;
  /** Whether that node's transformation is a reflection. */
  isMirrored: boolean;
  /** Centre of a bounding sphere of the displayed positions. */
  center: [number, number, number];
  radius: number;
  /** Four bytes per vertex, 127 for 1: more would take longer to upload to the graphics card. */
  packedNormals: Int8Array;
  /** Corners at creases, ascending, whose normals are not those of their vertices, */
  creaseCorners: Uint32Array;
  /** and theirs, four bytes each. */
  creaseNormals: Int8Array;
}

export interface LoadSettings {
  readonly weld?: number;
  /** All repairs that the solver finds necessary, instead of those in `fix`. */
  readonly hasAllRepairs?: boolean;
  readonly fix: {
    readonly orient?: boolean;
    readonly split?: boolean;
    readonly degenerate?: boolean;
  };
}

/** The state that undo and redo restore. */
export interface Step {
  readonly prescription: Prescription;
  readonly settings: LoadSettings;
}

/** Alignment to a grid of squares. */
export interface GridSettings {
  readonly isOn: boolean;
  /** Total number of grid cells; undefined: as many as the model and its cones need. */
  readonly cells?: number;
  /** `quad`: cones lie on grid points, so that the cells are a quad mesh. */
  readonly mode: 'tile' | 'quad';
}

/** Options of Run, apart from the prescription. */
export interface SolveSettings {
  rounds: number;
  /** Distortion to lower: −1 of angles, 0 of both, 1 of areas; undefined: the map as solved. */
  improve?: number;
  /** `file`: the directions of the imported field; `auto`: a smooth field computed by the solver. */
  frames: 'auto' | 'file';
  grid: GridSettings;
  /** In seconds; undefined: no limit. */
  timeLimit?: number;
}

export interface Seam {
  /** The ends of both sides as uv vertices, in corresponding order. */
  a: [number, number];
  b: [number, number];
  r: number;
}

/** Where and how the map goes into the file. */
export interface Output {
  /** glTF: the set to write; undefined: the next free one. */
  uvSet?: number;
  /** glTF: whether the file's textures use the written set; undefined: those that could not be seen with their own. */
  usesNewSet?: boolean;
  scale: 'solved' | 'unit' | 'fit';
  embedCones: boolean;
  /** glTF: the mesh gets a grid as its material. */
  hasGrid: boolean;
}

/** A file with a direction at every place of the surface. */
export interface DirectionField {
  name: string;
  text: string;
}

/** The input of a solution. */
export interface SolveRequest {
  prescription: Prescription;
  /** Welds and repairs of its surface. */
  settings: LoadSettings;
  improve?: number;
  frames: 'auto' | 'file';
  /** That of `frames`, if they are those of a file. */
  field?: DirectionField;
  /** Edges that are straight lines. */
  features?: FeatureChoice;
  /** The settings; `cells` is the number requested from the solver, if any. */
  grid: GridSettings;
  cells?: number;
  output: Output;
  /** The map follows from another one by dragging a cone: its bytes are not those of a run. */
  isDragged?: boolean;
}

/** A surface with its map, corner by corner. */
export interface Corners {
  /** Per triangle corner, three numbers. */
  positions: Float64Array;
  /** Per triangle corner, two numbers, v pointing up. */
  uv: Float64Array;
  /** For polygons: the number of corners of each; the arrays above are then per polygon corner. */
  sizes?: number[];
}

/** What the geometry worker computes for a map. */
export interface Analysis {
  /** Identifies it in the geometry worker. */
  id: number;
  /** Whether the written bytes contain exactly the certified map. */
  isSameAsFile: boolean;
  /** Why not, if they do not. */
  difference: string;
  /** Two numbers per triangle corner, v pointing up: read from the file if it has the same map. */
  cornerUv: Float32Array;
  distortion: Distortion;
  sizes: Sizes;
  smallestArea: SmallestArea;
  /** Triangles that overlap others, which is allowed. */
  overlaps: Overlaps;
  /** The chain of each seam edge; both sides of a chain have the same colour. */
  chains: Uint32Array;
  box: Box;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** What the page keeps of a map: its views number triangles as the file does. */
export type MapNumbers = Omit<Result, 'solved'>;

/** One finished run: the map, the bytes that Download saves, and what is known about them. */
export interface Solution extends SolveRequest, Analysis {
  result: MapNumbers;
  /** The map in the solver, which writes it again; disposed of if it was large and others came. */
  map: UvMap;
  /** The id of the surface that was analysed. */
  surfaceId: number;
  /** Tiles per unit of uv of the grid that was written as the material. */
  gridTiles?: number;
  written: Written;
  /** Notes of the writer. */
  notes: Note[];
  /** Other content of the file, which is kept: "3 materials, 1 skin". */
  preserved: string;
  /** The written files, and the files to which they refer. */
  files: OutputFile[];
  seams: Seam[];
  /** Edge of the surface (smaller vertex × |V| + larger) → seam. */
  seamAt: Map<number, number>;
}

/** The quads of a map, which are shown on the model before they are saved. */
export interface QuadPreview {
  of: Solution;
  /** As OBJ. */
  made: Quads;
  glb: Uint8Array;
  shape: QuadShape;
  /** The number of cells that was requested, if any. */
  asked?: number;
  isShown: boolean;
}

export interface MeshSummary {
  index: number;
  /** Number of nodes that use the mesh; undefined if the format has no nodes. */
  instances?: number;
  isUsable: boolean;
  components: number;
  /** Why it cannot be used, in a few words. */
  why: string;
}

/** An open file, with the mesh that is open. */
export interface Model {
  readonly main: string;
  readonly files: Files;
  /** The mesh in the solver. Of meshes that wait, large ones are disposed of. */
  readonly solver: SolverModel;
  readonly info: ModelInfo;
  readonly surface: Surface;
  /** The settings with which it was loaded; during undo, the document may already have others. */
  readonly loaded: LoadSettings;
  /** Remarks on the mesh: how nodes use it, which uv sets it has. */
  readonly remarks: string[];
  /** The matrix of the mesh's first node, by columns. */
  readonly matrix: readonly number[];
}

/** The solver's objection to cones that satisfy Gauss–Bonnet. */
export interface Objection {
  prescription: Prescription;
  surface: Surface;
  features: FeatureChoice | undefined;
  /** Empty if there is none. */
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
  run: () => unknown;
}

export interface Message {
  kind: 'note' | 'good' | 'error';
  text: string;
  actions?: MessageAction[];
  /** Further text, shown on request. */
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
  /** Undefined if it cannot be estimated reliably. */
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
/** `side`: the studio turned, so that relief is seen; `gloss`: as if polished; `flat`: the colours alone. */
export type Light = 'studio' | 'side' | 'gloss' | 'flat';
export const lights: readonly Light[] = ['studio', 'side', 'gloss', 'flat'];
export type Overlay = 'none' | 'angle' | 'area' | 'seams' | 'flips';

export interface Look {
  pattern: Pattern;
  overlay: Overlay;
  /** Tiles along the diagonal of the bounding box. */
  tiles: number;
  /** Tiles along the edge of a cell of an aligned map. */
  steps: number;
  /** `auto`: in the 3D view only seams at which lines do not meet, in the UV view all. */
  seams: 'auto' | 'on' | 'off';
  hasWire: boolean;
  light: Light;
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
