// What the calls of the solver take: files, meshes, prescriptions and options.

import type { Note } from './documents.js';
import type { WasmModule, WebBlob, WebFile, WebUrl } from './globals.js';

export interface InitOptions {
  /** Where hgp.wasm is; by default in this package. In Node also a path. */
  wasmUrl?: string | WebUrl;
  wasmBinary?: ArrayBuffer | ArrayBufferView;
  wasmModule?: WasmModule;
}

/** A File or Blob, or the bytes of one; gzip is decompressed. */
export type FileSource = WebFile | WebBlob | ArrayBuffer | ArrayBufferView;

/** Relative names only; `main` is one of them. */
export interface FileSet {
  main: string;
  files: Map<string, FileSource> | Record<string, FileSource>;
}

/** Files as bytes; `main` is one of their names. */
export interface CoreFiles {
  main: string;
  files: Map<string, Uint8Array>;
  /** Notes of prepare() on the files, which precede those of load(). */
  notes?: Note[];
}

export interface LoadOptions {
  /** Name of the file, for sources without one; its extension helps to recognise the format. */
  name?: string;
  /** Which mesh of the file; by default the one with the most triangles. */
  surface?: number;
  /**
   * Join vertices closer than this, in the file's unit. By default vertices at equal positions are joined where the
   * format requires it (glTF, STL), and in other formats if no two faces share a vertex. `exact`: 0. `none`: only
   * where the format requires it.
   */
  weld?: number | 'exact' | 'none';
  /** Larger files are refused with the code `limit`; by default 2 GiB and 16 million triangles. */
  limits?: { bytes?: number; triangles?: number };
  /** Make exactly these repairs; by default those that the defects of the mesh need. */
  fix?: { orient?: boolean; split?: boolean; degenerate?: boolean };
  /** Make no repairs, and refuse a mesh that needs one. */
  strict?: boolean;
  /**
   * Write repairs into the file: flipped faces and copies of split vertices. Otherwise faces and
   * vertices are unchanged, and the certificate counts the differences. Ids are those of the repaired
   * file: vertices keep theirs, copies follow.
   */
  writeRepairs?: boolean;
  /**
   * Convert the file to this format when it is read, so that write() writes it: a GLB of OBJ, OFF, PLY, STL or
   * .gltf, an OBJ of glTF; 'ply' is for PLY files, which are otherwise written as OBJ. Notes say what is not kept.
   */
  target?: 'obj' | 'glb' | 'gltf' | 'ply';
}

export interface MeshArrays {
  /** Three numbers per vertex. */
  positions: ArrayLike<number>;
  /** Three vertices per triangle; if absent, every three consecutive vertices are a triangle. */
  triangles?: ArrayLike<number> | null;
}

/** The LoadOptions that apply to a mesh given as arrays. */
export interface MeshLoadOptions {
  /**
   * Join vertices closer than this. By default 0: vertices at equal positions are joined, because renderers split
   * vertices where normals or texture coordinates differ. `false`, `none`: vertices are not joined.
   */
  weld?: number | 'exact' | 'none' | false;
  limits?: LoadOptions['limits'];
  fix?: LoadOptions['fix'];
  strict?: LoadOptions['strict'];
}

/** A mesh given as arrays with everything about its map. */
export interface MeshSolveOptions extends MeshArrays, MeshLoadOptions, SolveOptions {}

/** hgp-cones: cone angles 2πk/q, turning angles of boundary loops 2πl/q, rotations along handles 2πr/q. */
export interface Cones {
  q: number;
  cones: { vertex: number; k: number; position?: [number, number, number] }[];
  boundaries?: { loop: number; l: number; anchor?: number }[];
  handles?: { generator: number; r: number }[];
  /** Edges that lines follow with these cones. */
  features?: Features;
}

/** A file of cones or of a field: hgp-cones JSON, OBJ with `c` and `sm` lines, .sing, curvatures, Th_hat, .rawfield,
 * .rosy, .ffield. */
export interface ConeFile {
  name: string;
  text: string;
  /** The order q, for files that do not state one; by default 4. */
  q?: number;
}

/** How the file of a mesh marks edges: OBJ `l` lines, borders of smoothing groups and of materials, split normals. */
export type FeatureMark = 'lines' | 'smoothing' | 'materials' | 'normals';

/** Edges that become lines u = const or v = const, exactly (q = 4). With any of them, all boundary edges are features. */
export interface Features {
  /** The boundary edges, also where there is no other feature. */
  rims?: boolean;
  /** Inner edges with a larger dihedral angle, in degrees. */
  creases?: number;
  /** Edges that the file marks. */
  marked?: FeatureMark[];
  /** Polylines along edges. Where the file has changed since, vertices are found by their positions. */
  lines?: { vertices: number[]; positions?: [number, number, number][] }[];
}

/** A list of edges: `.sharp`, OBJ with `l` lines, hgp-cones JSON, otherwise rows of two vertices. */
export interface FeatureFile {
  name: string;
  text: string;
}

export interface SuggestOptions {
  q?: number;
  /** Number of cones; by default chosen by `conesFor`. A note says so if this number is not possible. */
  count?: number;
  /**
   * `balanced` (default): low distortion, and the map follows boundaries. `few`: as few as keep areas within a
   * factor of about two. `low-distortion`: as many as lower distortion noticeably, with free boundary turning.
   * `fewer` and `more`: a number halfway between `balanced` and these.
   */
  conesFor?: 'balanced' | 'few' | 'fewer' | 'more' | 'low-distortion';
  /** Align the field that determines the cones to principal curvature directions; q must be even. */
  alignToCurvature?: boolean;
}

export interface SolveOptions extends SuggestOptions {
  /** Chosen automatically if absent. */
  cones?: Cones;
  /** A direction field (.rawfield, .rosy, .ffield): it determines what `cones` leave open, and must have these cones. */
  field?: ConeFile;
  /** Edges that become straight lines; cones and corners are those of a field along them, which has the given `cones`. */
  features?: Features | FeatureFile;
  /**
   * Frames of the map. `auto`: a smooth field that hgp computes with the prescribed cones, turnings and rotations.
   * `file`: the directions of `field`, which must have exactly these; otherwise the call fails with `prescription`,
   * or with `usage` if there is no field with directions.
   */
  frames?: 'auto' | 'file';
  /**
   * `convex`: maps a disk without cones onto a convex polygon. `rectangle`: onto a rectangle, whose corners are cones
   * with k = 1 on the boundary, or chosen.
   */
  boundary?: 'free' | 'convex' | 'rectangle';
  /** Maximum number of programs per component; by default 24. */
  maxRounds?: number;
  /**
   * `auto`: the harmonic map, then soft frame constraints, hard ones with the frames of the connection and of an angle
   * structure, and untangling.
   * `harmonic`: the harmonic map, then hard constraints on triangles at cones and boundary. `soft`: soft ones. `printed`: program and
   * iteration as printed in the paper. `all-frames`: hard constraints on every triangle.
   */
  method?: 'auto' | 'harmonic' | 'soft' | 'printed' | 'all-frames';
  /**
   * Lower the distortion of a certified map; the result is again certified. `isometric` (angles and areas), `conformal`
   * (angles), `area`, or a number from -1 (angles) through 0 (isometric) to 1 (areas).
   */
  improve?: 'isometric' | 'conformal' | 'area' | number;
  /** The same as `improve: 'isometric'`. */
  quality?: boolean;
  /**
   * If a component has no map, do not fail: it keeps its uv or is cut open to a disk. The map
   * as a whole is then not certified, and write() needs `allowUncertified`.
   */
  keepGoing?: boolean;
  /** `solved`: as solved. `unit`: mean uv edge length 1. `fit`: scaled uniformly into [0, 1]². */
  scale?: 'solved' | 'unit' | 'fit';
  /**
   * If no map is found, split edges and solve again. `positions` and `triangles` of the result, and written files, are
   * then those of the refined mesh, in which vertices keep their ids; `report.refined` says what was split.
   */
  refine?: boolean;
  /**
   * Certify only maps in which every polygon of the file is convex, for readers that cut polygons along other
   * diagonals than hgp; uv are moved for that after the solve.
   */
  convexPolygons?: boolean;
  /**
   * Solve one side of a plane that mirrors the mesh, and mirror the map, to the last bit (q = 4). Across X, Y or Z through
   * the centre of the triangles' bounding box, or whichever plane fits; `inspect` lists them. Cones cannot be chosen by number
   * or purpose then.
   */
  symmetric?: 'auto' | 'X' | 'Y' | 'Z';
  /**
   * Align the map to a grid (q = 2 or 4): all translations of seams become integers, with one cell per unit of uv, so
   * that grid lines meet at every seam. About `cells` cells in total, or cells of edge length `spacing` in the file's
   * unit; `quad`: cones lie on grid points as well. `'auto'`, also as `cells`, and `mode` alone choose the number: 14 cells
   * along the diagonal, at least 800 and 40 per cone, 20 along features (in a file of several meshes, the size of those
   * of the largest one), and where that gives no aligned map, a number that does (up to 100 000 triangles). If no aligned
   * map is found, the result is the map without a grid, and `report.components[].grid` says why and how many cells would work.
   */
  grid?: 'auto' | { cells?: number | 'auto'; spacing?: number; mode?: 'tile' | 'quad' };
}

export interface VerifyOptions {
  /** The prescription that the map must have; by default any cones are accepted. */
  cones?: Cones;
  /** As in SolveOptions. */
  field?: ConeFile;
  /** Edges that must be straight. */
  features?: Features | FeatureFile;
  /** Order of the rotations, if no cones are given; by default 4. */
  q?: number;
  /** The uv set to verify; by default the last one. */
  uvSet?: number;
  /** Tolerance of seams, relative to the length of each seam edge, and of angles in radians; by default 1e-6. */
  tolerance?: number;
}

export interface WriteOptions {
  /**
   * `same` (default): the original file with the map, otherwise unchanged. `glb`, `gltf`, `obj`: the mesh alone; its
   * uv are snapped to the numbers of that format and verified again. `flat-obj`: the map as a flat mesh. `svg`: the
   * edges of the map as a drawing.
   */
  format?: 'same' | 'glb' | 'gltf' | 'obj' | 'flat-obj' | 'svg';
  /** glTF, OBJ: a grid as the material, with this number of tiles per unit of uv; `true`: a suitable number. */
  gridMaterial?: boolean | number;
  /** The uv set to write, replaced if it exists; by default the one after the last. */
  uvSet?: number;
  /** File name of the result; by default that of the source, with the extension of what is written. */
  name?: string;
  /** Store the cones in the file, for use when it is loaded again. */
  embedCones?: boolean;
  /** Write a map that is not certified; otherwise the call fails with `no-map`. */
  allowUncertified?: boolean;
  /**
   * glTF: make the materials' textures use the written set, or keep theirs (`false`); by default those use it whose own
   * set is missing or has no area. A note says which set they use.
   */
  use?: boolean;
}

/** Options of parametrizeFile(): those of load() and parametrize() and, in `write`, those of write(). */
export interface FileOptions
  extends
    Omit<LoadOptions, 'surface'>,
    Omit<SolveOptions, 'cones' | 'field' | 'frames' | 'refine'> {
  write?: Omit<WriteOptions, 'format'>;
}

/** Options of combine(). */
export type CombineOptions = Pick<
  WriteOptions,
  'name' | 'uvSet' | 'embedCones' | 'allowUncertified' | 'use' | 'gridMaterial'
>;

export interface FeatureListOptions {
  /** The name of the file, whose extension decides the format; by default features.json. */
  name?: string;
}

export interface QuadOptions {
  /**
   * File name, whose extension determines the format: .obj or .ply for quads, .glb for triangles. The GLB of a .gltf
   * contains its pictures, where load() got them beside it.
   */
  name?: string;
}
