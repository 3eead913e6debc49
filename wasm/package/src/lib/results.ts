// What the calls of the solver return. The JSON documents are those of the command line; their types are generated
// from the schemas in hgp/schema.

import type { Certificate, Failure, Note, Report, Where as Places } from './documents.js';
import type { HgpFailure } from './error.js';
import type { Cones } from './options.js';

/** A place on the mesh (ids of the surface) or in the file. */
export type Where = Places[number];

/** The codes of the command line's errors, and two that only the package has. */
export type HgpErrorCode = Failure['code'] | 'worker-lost' | 'wasm-unavailable';

/** The loaded surface, to which vertex and triangle ids refer. */
export interface Surface {
  /** Three numbers per vertex, in the file's unit. */
  positions: Float64Array;
  /** Three vertices per triangle. */
  triangles: Uint32Array;
  /** The surface after welds and repairs, which is the one solved; absent if they changed nothing. */
  repaired?: {
    /** Three of its vertices per triangle. */
    triangles: Uint32Array;
    /** Its vertex → a vertex of the surface. */
    vertexOrigin: Int32Array;
    /** Vertex of the surface → its vertex; −1 if a repair removed it. */
    vertexImage: Int32Array;
  };
}

/** Facts about the surface as it is solved (after welds and repairs), in ids of the file. */
export interface SurfaceFacts {
  /** The vertex with which a vertex was joined, or itself; −1 if a repair removed it. */
  representative: Int32Array;
  /** Sum of the triangle angles at each vertex, in radians. */
  angle: Float64Array;
  /** Number of triangles at each vertex; the maximum over its copies if a repair split it. */
  valence: Uint32Array;
  /** 1 for vertices on the boundary; for a split vertex, if all copies are. */
  isBoundary: Uint8Array;
  /** Connected component of each vertex, in the order of `ModelInfo.components`; −1 for vertices without triangles. */
  component: Int32Array;
  /** Connected component of each triangle; −1 if a repair left it out. */
  triangleComponent: Int32Array;
  /** Neighbours of v: neighbours[neighbourStart[v]] … neighbours[neighbourStart[v + 1] − 1]. */
  neighbourStart: Uint32Array;
  neighbours: Uint32Array;
  /** Total area of the triangles, in the file's unit squared. */
  area: number;
}

/** Boundary loops and handle generators, in the order of the numbers `boundaries[].loop` and `handles[].generator`. */
export interface Loops {
  /** Vertices in order, the surface on their left. */
  boundaries: Uint32Array[];
  /** Two vertices for each edge that the generator crosses, in order along a closed walk over triangles. */
  handles: Uint32Array[];
}

/** Cones that transferCones() has moved to another surface. */
export interface MovedCones {
  cones: Cones;
  /** What has no place on it. */
  lost: Note[];
}

/** How the nodes of a glTF use one of its meshes; each of them shows the same map. */
export interface Placements {
  /** How often, with the copies of EXT_mesh_gpu_instancing. */
  count: number;
  /** Whether one of them mirrors the mesh, and its map with it. */
  isMirrored: boolean;
  /** Sixteen numbers, by columns, for each node whose matrix is invertible. */
  matrices: Float64Array;
}

export interface Progress {
  stage: string;
  /** Progress of the stage, 0 to 1. */
  fraction: number;
  /** Iteration of the solver or of the improvement; -1 outside these. */
  iteration: number;
  /**
   * Residual of the solver relative to its target; in the stages `improve` and `align`, the energy's excess over an
   * isometry; -1 otherwise.
   */
  residual: number;
  /** Round of the loop "solve, verify, repair", from 1 to at most maxRounds; both are 0 outside the loop. */
  round: number;
  maxRounds: number;
  /** In parametrizeFile(): index of the mesh, and the number of meshes. */
  mesh?: number;
  meshes?: number;
}

/**
 * The triangles that the certificate is about, one row each: those of `triangles` without the ones that are no surface
 * (copies of others, a vertex named twice), turned over where neighbours disagreed. If the map is certified, every row
 * of `uvTriangles` has exactly positive area in `uv`.
 */
export interface SolvedTriangles {
  /** Three surface vertices per row. */
  triangles: Uint32Array;
  /** Three uv vertices per row, corner by corner those of `triangles` here. */
  uvTriangles: Uint32Array;
  /** Row → the row of the result's `triangles` that it comes from; ascending. */
  origin: Uint32Array;
}

export interface Result {
  /** Three numbers per surface vertex. */
  positions: Float64Array;
  /** Three surface vertices per triangle, as given: also those that repairs turn over or leave out. */
  triangles: Uint32Array;
  /** Two numbers per uv vertex, v pointing up, rounded as the file will store them. */
  uv: Float64Array;
  /** Three uv vertices per triangle. */
  cornerToUv: Uint32Array;
  /** The triangles as solved; the same arrays, unless repairs turned triangles over or left some out. */
  solved: SolvedTriangles;
  /** uv vertex → surface vertex. */
  uvToVertex: Uint32Array;
  /** The two sides of each seam edge as uv vertices, and r: side b is side a rotated by 2πr/q and translated. */
  seams: { a: [number, number]; b: [number, number]; r: number }[];
  certificate: Certificate;
  cones: Cones;
  report: Report;
  /** Size of the linear memory in bytes; it never shrinks. */
  memory: number;
}

/** Measurements of the result per triangle and per seam edge, in the order of `triangles` and `seams`. */
export interface Measures {
  /** Ratio of the singular values of the derivative, at least 1; 1 preserves angles. */
  stretch: Float32Array;
  /** log₂ of uv area per surface area at the best global scale of its component, as in the certificate. */
  area: Float32Array;
  /** Triangles covered by the certificate that are flipped or have no area in the map. */
  flipped: Uint32Array;
  /** Total area of the triangles on the surface, in the file's unit squared. */
  surfaceArea: number;
  /** Total area of the triangles in the map, in absolute values. */
  uvArea: number;
  /** Triangles that overlap in the plane and share no uv, which is allowed; `isMore`: counting stopped early. */
  overlaps: { pairs: number; triangles: Uint32Array; isMore: boolean };
  /** For each seam edge, the number of the seam to which it belongs. */
  seamChains: Uint32Array;
}

/** What a position of a dragged cone gives. */
export interface DragFrame {
  /**
   * `certified`: the map as it is here is certified, in double precision and not stored. `fails`: it is not, for
   * `reasons`. `heat`: there is no map of this position, only `logScale`.
   */
  state: 'heat' | 'certified' | 'fails';
  vertex: number;
  /** Of `heat`: dragTo() with the same vertex brings the map nearer, for about as long as the drag took to begin. */
  isApproaching: boolean;
  /** As in a result, with uv that no corner uses; empty for `heat`. */
  uv: Float64Array;
  cornerToUv: Uint32Array;
  /** The logarithm of the conformal factor by surface vertex; NaN where nothing is dragged. */
  logScale: Float32Array;
  /** Triangles that are flipped or have no area. */
  notPositive: Uint32Array;
  reasons: string[];
  /** The cones of this map, completed: rotations around handles follow the path of the cone. */
  cones: Cones;
}

/** A position that was not computed, because the cone has been dragged on. */
export interface SupersededFrame {
  state: 'superseded';
  vertex: number;
}

export interface Quads {
  name: string;
  bytes: Uint8Array;
  vertices: number;
  quads: number;
  /** Number of cells that the boundary cuts; they are left out. */
  clipped: number;
  /** Pairs of vertices that several edges join in the grid as it is, around short handles and close cones. */
  multipleEdges: number;
  /** Strips of quads that were cut lengthwise so that no two edges have the same end vertices. */
  cuts: number;
  /** Edges that were replaced by a vertex of three edges for the same purpose, where strips are long. */
  replaced: number;
  /** How often all cells were divided into four, where cutting strips does not achieve that. */
  halvings: number;
  /** Quads of which a corner is turned over in space: the surface bends more there than a cell can follow. */
  foldedInSpace: number;
  /** Quads that are the only one at a cone with k = 1, so that two of their edges coincide. */
  foldedQuads: number;
  /** Quads across a seam of the input's texture coordinates, or across the border of a material. */
  acrossSeams: number;
  /** On these, and on what of the input the format does not keep. */
  notes: Note[];
}

/** A list of features. */
export interface FeatureList {
  name: string;
  text: string;
  /** Edges inside the surface, and on its boundary. */
  creaseEdges: number;
  rimEdges: number;
  /** Runs of edges between ends and crossings. */
  chains: number;
  notes: Note[];
}

export interface OutputFile {
  name: string;
  bytes: Uint8Array;
}

export interface Written {
  /** Name and bytes of the main file. */
  name: string;
  bytes: Uint8Array;
  /** The main file and its side files, in this order. */
  files: OutputFile[];
  notes: Note[];
  /** Written vertex → stored vertex; empty if they are the same. */
  xref: Int32Array;
  /** Whether the map is certified with the numbers in this file; formats round differently. */
  certified: boolean;
}

/** The outcome for one mesh: its report, or the error if it has no map. */
export interface MeshOutcome {
  /** Index among the meshes of the file that have triangles. */
  mesh: number;
  certified: boolean;
  /** False if a grid was asked for and the map is not aligned to it; the mesh then counts as one without a map. */
  aligned: boolean;
  report?: Report;
  error?: HgpFailure;
}

/** A note on a mesh of a file, or on the file as a whole. */
export interface MeshNote extends Note {
  mesh?: number;
}

export interface FileResult {
  /** Whether the maps of all meshes are certified. */
  certified: boolean;
  meshes: MeshOutcome[];
  /**
   * The file with all maps and its side files, the main file first. Empty if a mesh is not certified, unless
   * `keepGoing` or `write.allowUncertified` is set.
   */
  files: OutputFile[];
  /** Name and bytes of the main file, if there is one. */
  name?: string;
  bytes?: Uint8Array;
  notes: MeshNote[];
}
