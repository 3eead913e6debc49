// Made from schema/*.schema.json by wasm/documents.mjs: the JSON documents of calls and files.

/**
 * Places on the mesh (ids of the surface) or in the file
 */
export type Where = {
  kind: 'vertex' | 'edge' | 'triangle' | 'loop' | 'line' | 'byte';
  id: number;
  /**
   * second vertex of an edge
   */
  other?: number;
}[];

/**
 * What users are told, as a code with its numbers: docs/notes.md lists the codes and a sentence for each
 */
export interface Note {
  code: string;
  /**
   * counts and measurements by name
   */
  numbers: {
    [k: string]: number | null;
  };
  /**
   * names from files and lists by name
   */
  words: {
    [k: string]: string;
  };
  where: Where;
}

export interface Refusal {
  code:
    | 'usage'
    | 'malformed'
    | 'unsupported'
    | 'prescription'
    | 'no-map'
    | 'write-failed'
    | 'limit'
    | 'internal'
    | 'cancelled';
  stage: string;
  message: string;
  where: Where;
  /**
   * what to do, where it is not in the message
   */
  advice?: Note[];
}

/**
 * The verdict on a map and the measurements behind it, all of the stored values. Certified: there are triangles, each has positive area (exact sign), every interior angle sum and every boundary turning is as prescribed, the sides of every seam differ by a rotation by a multiple of 2π/q, all within the thresholds, every prescribed feature edge is exactly straight, and the areas span no more than the number type resolves.
 */
export interface Certificate {
  format: 'hgp-certificate';
  version: 1;
  /**
   * every rule holds in every component; then there are no reasons
   */
  certified: boolean;
  /**
   * distortion.areaSpan is above the machine epsilon of the number type; true for every certified map
   */
  usable: boolean;
  /**
   * rotation order: angles are multiples of 2π/q
   */
  q: number;
  /**
   * the uv set of the file that was verified
   */
  uvSet?: number;
  /**
   * the number type that uv are stored in
   */
  precision: 'float32' | 'float64';
  /**
   * triangles that were verified
   */
  triangles: number;
  /**
   * triangles that are not positive
   */
  flipped: number;
  /**
   * interior vertices whose angle sum is not the prescribed 2πk/q (k = q where no cone is prescribed)
   */
  wrongAngles: number;
  /**
   * boundary loops whose turning is not the prescribed 2πl/q
   */
  wrongTurnings: number;
  /**
   * interior edges whose two sides have different uv
   */
  seamEdges: number;
  /**
   * seam edges whose sides do not differ by a rotation by a multiple of 2π/q
   */
  brokenSeams: number;
  /**
   * seam edges whose two sides satisfy z' = e^{i2πr/q} z + t exactly: in the stored numbers for q = 1, 2, 4, between the points of the triangular lattice that they stand for where q = 3, 6; null for other q
   */
  exactSeams: number | null;
  /**
   * of exactSeams, those with an integer translation: a grid of unit squares (q = 3, 6: unit triangles) continues across them
   */
  integerSeams: number | null;
  /**
   * Only where features are prescribed, over all components
   */
  features?: {
    /**
     * prescribed feature edges, boundary edges included
     */
    edges: number;
    /**
     * of these, edges whose ends have the same u or the same v on every side, bit for bit
     */
    straightEdges: number;
    /**
     * runs of feature edges between branches, ends and corners
     */
    chains: number;
    /**
     * of these, chains of straight edges
     */
    straightChains: number;
    /**
     * vertices between two feature edges where the line of the map turns
     */
    corners: number;
  };
  /**
   * largest distance of an interior angle sum from a multiple of 2π/q, radians
   */
  maxConeDistance: number;
  /**
   * largest distance of the turning of a boundary loop from a multiple of 2π/q, radians
   */
  maxTurningDistance: number;
  /**
   * residual of the seam edge that comes closest to its limit or exceeds it most, relative to its own length
   */
  maxSeamResidual: number;
  /**
   * accepted at that edge, relative to its own length
   */
  seamTolerance: number;
  /**
   * All triangles of the surface as they are stored: verified, or not covered by the certificate, and why
   */
  stored: {
    /**
     * stored triangles of the surface
     */
    triangles: number;
    /**
     * triangles that the certificate covers
     */
    verified: number;
    /**
     * not covered: copies of a verified triangle, with its uv
     */
    duplicates: number;
    /**
     * of the duplicates, those with other uv; 0 in files that hgp wrote
     */
    differing: number;
    /**
     * not covered: triangles that name a vertex twice, or whose component has no triangle with an area
     */
    zeroArea: number;
    /**
     * verified with the opposite of their stored orientation
     */
    reversed: number;
    /**
     * copies of vertices in the verified surface that are not in the file
     */
    splitVertices: number;
    /**
     * polygons of the file with more than three corners; the certificate is about the triangles that hgp cuts them into
     */
    polygons: number;
    /**
     * of those polygons whose triangles are all verified, the ones that are not convex in the map: along other diagonals than hgp's they have a triangle without positive area
     */
    notConvex: number;
  };
  notes?: Note[];
  /**
   * How much of the map overlaps itself: of the component where it is most
   */
  overlap: {
    /**
     * share of the covered plane that more than one triangle covers, 0 to 1
     */
    share: number;
    /**
     * most triangles over one point
     */
    layers: number;
  };
  /**
   * The smallest tolerances with which this map would be accepted
   */
  needed: {
    /**
     * for seams, relative to the length of each seam edge
     */
    seam: number;
    /**
     * for angles, radians
     */
    angle: number;
    /**
     * with the larger of the two as tolerance, every rule holds
     */
    sufficient: boolean;
  };
  /**
   * one entry per connected component
   */
  components: {
    certified: boolean;
    usable: boolean;
    /**
     * the uv were well formed and finite, so that the facts below were measured
     */
    measured: boolean;
    /**
     * vertices with triangles
     */
    vertices: number;
    edges: number;
    triangles: number;
    /**
     * V − E + F
     */
    eulerCharacteristic: number;
    genus: number;
    boundaryLoops: number;
    orientation: {
      /**
       * triangles of positive area
       */
      positive: number;
      /**
       * triangles without area
       */
      zero: number;
      /**
       * flipped triangles
       */
      negative: number;
      /**
       * triangles with a cone or a boundary vertex (F_cb)
       */
      constrained: number;
      /**
       * of these, triangles of positive area
       */
      constrainedPositive: number;
      /**
       * ids of triangles that are flipped or without area, at most 10 000
       */
      notPositive: number[];
    };
    angles: {
      /**
       * interior vertices whose angle sum is not as prescribed
       */
      wrong: number;
      /**
       * largest distance of an interior angle sum from a multiple of 2π/q, radians
       */
      worstDistance: number;
      /**
       * where that is
       */
      worstVertex: number;
      /**
       * accepted at worstVertex, radians
       */
      allowed: number;
      /**
       * smallest corner angle of all triangles in uv, radians
       */
      smallestAngle: number;
      /**
       * boundary vertices with an angle above 2π; allowed
       */
      overlappingBoundaryVertices: number[];
    };
    /**
     * prescribed cones and all vertices that were measured to be one (measured ≠ q)
     */
    cones: {
      vertex: number;
      /**
       * prescribed k; q where no cone is prescribed
       */
      asked: number;
      /**
       * k of the nearest angle 2πk/q
       */
      measured: number;
      /**
       * of the measured angle from that multiple of 2π/q, radians
       */
      distance: number;
      /**
       * accepted distance here, radians
       */
      allowed: number;
    }[];
    /**
     * vertices whose measured k is not the prescribed one, or whose angle is too far from it
     */
    wrongCones: {
      vertex: number;
      /**
       * prescribed k; q where no cone is prescribed
       */
      asked: number;
      /**
       * k of the nearest angle 2πk/q
       */
      measured: number;
      /**
       * of the measured angle from that multiple of 2π/q, radians
       */
      distance: number;
      /**
       * accepted distance here, radians
       */
      allowed: number;
    }[];
    /**
     * every boundary loop, with turning angle 2πl/q
     */
    turnings: {
      loop: number;
      /**
       * prescribed l; null where it is free
       */
      asked: number | null;
      /**
       * l of the nearest turning 2πl/q
       */
      measured: number;
      /**
       * of the measured turning from that multiple of 2π/q, radians
       */
      distance: number;
      /**
       * accepted distance, radians
       */
      allowed: number;
    }[];
    /**
     * rotation 2πr/q along every handle generator
     */
    handles: {
      generator: number;
      /**
       * prescribed r; null where it is free
       */
      asked: number | null;
      /**
       * r; null where a seam on the way has no rotation
       */
      measured: number | null;
    }[];
    seams: {
      /**
       * seam edges
       */
      edges: number;
      /**
       * seam edges without a rotation by a multiple of 2π/q
       */
      broken: number;
      /**
       * seam edges that hold without any rounding, as exactSeams says; null unless q is 1, 2, 3, 4 or 6
       */
      exact?: number | null;
      /**
       * of those, with an integer translation
       */
      integer?: number | null;
      /**
       * connected components of the surface cut along the seams
       */
      charts: number;
      /**
       * at worstEdge, relative to its own length
       */
      worstResidual: number;
      /**
       * accepted there, relative to its own length
       */
      allowed: number;
      /**
       * the seam edge that comes closest to its limit or exceeds it most, as two vertices
       */
      worstEdge: number[];
      /**
       * largest difference of the lengths of the two sides, in uv units
       */
      worstLengthResidual: number;
      /**
       * largest |u| or |v|
       */
      largestUv: number;
      /**
       * mean length of the triangle sides in uv
       */
      meanUvEdge: number;
    };
    /**
     * Only where features are prescribed
     */
    features?: {
      /**
       * prescribed feature edges, boundary edges included
       */
      edges: number;
      /**
       * of these, edges whose ends have the same u or the same v on every side, bit for bit
       */
      straightEdges: number;
      /**
       * runs of feature edges between branches, ends and corners
       */
      chains: number;
      /**
       * of these, chains of straight edges
       */
      straightChains: number;
      /**
       * vertices between two feature edges where the line of the map turns
       */
      corners: number;
      /**
       * vertices of the edges that are not straight, at most 10 000
       */
      notStraight: [number, number][];
    };
    /**
     * Lemma 6.2 for the measured integers: have = Σ(q − k) + Σl, need = q(2 − 2g − m)
     */
    gaussBonnet: {
      have: number;
      need: number;
    };
    /**
     * How much of the map overlaps itself, counted on a grid of up to 512 × 512 points; reported, the verdict does not depend on it
     */
    overlap: {
      /**
       * share of the covered plane that more than one triangle covers, 0 to 1
       */
      share: number;
      /**
       * most triangles over one point
       */
      layers: number;
    };
    /**
     * Distortion of the positive triangles; the verdict does not depend on it except for areaSpan
     */
    distortion: {
      /**
       * mean of μ = |f_z̄|/|f_z| (0 is conformal), weighted by surface area
       */
      meanMu: number;
      /**
       * half of the surface area has at most this μ; its stretch σ₁/σ₂ = (1 + μ)/(1 − μ) is the typical one
       */
      medianMu: number;
      /**
       * 95 % of the surface area have at most this μ
       */
      p95Mu: number;
      /**
       * largest μ
       */
      maxMu: number;
      /**
       * where that is
       */
      worstMuTriangle: number;
      /**
       * root mean square of log₂(uv area / surface area) at the best global scale
       */
      rmsLogArea: number;
      /**
       * 95 % of the surface area have at most this absolute value of it
       */
      p95LogArea: number;
      /**
       * smallest value of it
       */
      minLogArea: number;
      /**
       * largest value of it
       */
      maxLogArea: number;
      /**
       * how much sizes vary: the scale √(uv area / surface area) that 95 % of the surface area have at most, over the one that 5 % have at most; 1 if all are equal
       */
      sizeSpread: number;
      /**
       * mean symmetric Dirichlet energy minus that of an isometry, at the best global scale; ≥ 0
       */
      symmetricDirichlet: number;
      /**
       * smallest uv area per surface area, relative to the mean
       */
      areaSpan: number;
      /**
       * smallest uv area, relative to the mean
       */
      smallestToMeanArea: number;
      /**
       * the triangle with the smallest uv area per surface area
       */
      smallestTriangle: number;
    };
    /**
     * The bounds of the verdict
     */
    thresholds: {
      /**
       * accepted residual of a seam edge, relative to its own length
       */
      seam: number;
      /**
       * accepted distance of an angle sum or a turning, radians
       */
      angle: number;
      /**
       * what storing can add to the residual of any seam edge, in uv units; 0 where nothing was rounded
       */
      rounding: number;
      /**
       * upper bound of what is accepted because of rounding, relative to a seam edge's own length and in radians
       */
      largestRounding: number;
      /**
       * smallest accepted distortion.areaSpan
       */
      areaSpan: number;
    };
    /**
     * why this component is not certified
     */
    reasons: {
      rule:
        | 'prescription'
        | 'malformed-uv'
        | 'not-finite'
        | 'orientation'
        | 'cone-angle'
        | 'turning'
        | 'seam'
        | 'handle'
        | 'feature'
        | 'gauss-bonnet'
        | 'euler'
        | 'range'
        | 'empty';
      /**
       * places that break the rule
       */
      count: number;
      /**
       * the measured number at the worst place, in the unit of the rule
       */
      worst: number;
      message: string;
      where: Where;
    }[];
  }[];
}

/**
 * The exact integer budget q|C| − Σk + Σl = q(2 − 2g − m) of every component; nothing is solved.
 */
export interface CheckReport {
  format: 'hgp-check';
  version: 1;
  valid: boolean;
  q?: number;
  components: {
    component: number;
    valid: boolean;
    /**
     * nothing is prescribed for it; its cones will be chosen
     */
    automatic: boolean;
    genus: number;
    boundaryLoops: number;
    cones: number;
    budget: null | {
      have: number;
      need: number;
      left: number;
      openLoops: number;
    };
    warnings: Note[];
    error?: Refusal;
  }[];
  notes: Note[];
  error?: Refusal;
}

/**
 * A prescription: rotation order q, cones, turning of boundaries, rotations along handles. Cone angles are 2πk/q; interior vertices that are not listed have k = q. hgp completes what is left out; an absent list of cones means automatic cones, an empty one means none.
 */
export interface ConesDocument {
  format?: 'hgp-cones';
  version?: 1;
  /**
   * rotation order
   */
  q: number;
  /**
   * The mesh that the ids belong to
   */
  mesh?: {
    vertices?: number;
    triangles?: number;
    /**
     * of the file; where it differs, cones are found by their positions
     */
    sha256?: string;
  };
  cones?: {
    /**
     * 0-based; the file's own id for OBJ, OFF and PLY, the welded id for glTF and STL
     */
    vertex: number;
    /**
     * angle index: the cone angle is 2πk/q
     */
    k: number;
    /**
     * where the surface touches itself at this vertex: a triangle of the sheet that is meant
     */
    triangle?: number;
    /**
     * @minItems 3
     * @maxItems 3
     */
    position?: [number, number, number];
  }[];
  boundaries?: {
    /**
     * index of the boundary loop as inspect lists them
     */
    loop: number;
    /**
     * turning index l: the loop turns by 2πl/q
     */
    l: number;
    /**
     * a vertex on that loop; takes precedence over the index
     */
    anchor?: number;
  }[];
  handles?: {
    /**
     * index of the handle generator
     */
    generator: number;
    /**
     * rotation by 2πr/q along it
     */
    r: number;
  }[];
  /**
   * Edges that the map sends to lines u = const or v = const, exactly (q = 4); with any of them, boundary edges are features
   */
  features?: {
    /**
     * the boundary edges, also where there is no other feature
     */
    rims?: boolean;
    /**
     * inner edges with a larger dihedral angle, degrees; hgp writes what it found as lines
     */
    creases?: number;
    /**
     * edges that the file of the mesh itself marks: OBJ l lines, between OBJ s groups, between materials, where normals differ; hgp writes what it found as lines
     */
    marked?: ('lines' | 'smoothing' | 'materials' | 'normals')[];
    lines?: {
      /**
       * consecutive ones are joined by an edge
       *
       * @minItems 2
       */
      vertices: [number, number, ...number[]];
      /**
       * one per vertex; where the file differs, vertices are found by them
       */
      positions?: [number, number, number][];
    }[];
  };
  /**
   * Where present, edges that are not listed have turn 0, and the map realises exactly this holonomy
   */
  matchings?: {
    /**
     * triangle whose counterclockwise boundary contains tail → head
     */
    from: number;
    /**
     * triangle on the other side
     */
    to?: number;
    tail: number;
    head: number;
    /**
     * direction a of `from` continues as a + turn (mod q) in `to`
     */
    turn: number;
  }[];
}

/**
 * Why a command ended without its result. The same codes on the command line, in the package and on the page.
 */
export interface Failure {
  format: 'hgp-error';
  version: 1;
  code:
    | 'usage'
    | 'malformed'
    | 'unsupported'
    | 'prescription'
    | 'no-map'
    | 'write-failed'
    | 'limit'
    | 'internal'
    | 'cancelled';
  stage: string;
  message: string;
  where: Where;
  /**
   * the input, as it was named on the command line; not in the package
   */
  file?: string;
  /**
   * what to do, where it is not in the message
   */
  advice?: Note[];
}

/**
 * The results of all meshes of a file that has several.
 */
export interface FileReport {
  format: 'hgp-file';
  version: 1;
  /**
   * all meshes are certified
   */
  certified: boolean;
  meshes: {
    mesh: number;
    certified: boolean;
    /**
     * hgp-report (param), hgp-certificate (verify), or hgp-error where there is no map.
     */
    document: {
      format: 'hgp-report' | 'hgp-certificate' | 'hgp-error';
      version: 1;
    };
  }[];
}

/**
 * The contents of a file, and whether its mesh can be parametrized.
 */
export interface ModelInfo {
  format: 'hgp-inspect';
  version: 1;
  usable: boolean;
  file: {
    name: string;
    format: 'obj' | 'off' | 'ply' | 'stl' | 'gltf' | 'glb' | 'arrays';
    bytes: number;
    sha256: string;
  };
  surfaces: {
    index: number;
    name: string;
    /**
     * after welding
     */
    vertices: number;
    storedVertices: number;
    welded: boolean;
    triangles: number;
    /**
     * glTF: how often the nodes of the file show this mesh; each shows the same map
     */
    uses?: number;
    /**
     * glTF: whether one of them mirrors it, and its map with it
     */
    mirrored?: boolean;
    uvSets: number[];
    notes: Note[];
  }[];
  /**
   * the mesh that is used, as index into surfaces
   */
  surface: number;
  /**
   * after repairs
   */
  vertices: number;
  triangles: number;
  eulerCharacteristic?: number;
  genus?: number;
  /**
   * What --creases and --rims would take (absent for unusable meshes)
   */
  features?: {
    /**
     * dihedral angle above which an edge is a crease
     */
    degrees: number;
    creaseEdges: number;
    /**
     * runs of creases between ends and crossings
     */
    creaseChains: number;
    rimEdges: number;
  };
  /**
   * Planes with --symmetric: each cuts every component into two sides that are mirror images of each other, or exchanges it with another component (absent for unusable meshes)
   */
  mirrors?: {
    /**
     * the axis that is the normal, through the centre of the bounding box of the triangles; empty for a principal axis
     */
    name: 'X' | 'Y' | 'Z' | '';
    /**
     * @minItems 3
     * @maxItems 3
     */
    normal: [number, number, number];
    /**
     * normal · p of the plane's points; 0 where it is below 1e-6 of the box's diagonal
     */
    offset: number;
    /**
     * in the plane
     */
    edgesIn: number;
    /**
     * with ends on both sides, which mirror each other
     */
    edgesAcross: number;
    /**
     * of a vertex's mirror image from the vertex that stands for it, at most
     */
    distance: number;
  }[];
  boundaryLoops?: number;
  isolatedVertices?: number;
  components?: {
    component: number;
    vertices: number;
    edges: number;
    triangles: number;
    eulerCharacteristic: number;
    genus: number;
    handleGenerators: {
      first: number;
      count: number;
    };
    boundaryLoops: {
      loop: number;
      vertices: number;
      /**
       * a vertex on the loop
       */
      anchor: number;
      length: number;
      /**
       * Σ (π − θ) in radians of the surface itself
       */
      turningAngle: number;
    }[];
  }[];
  diagonal: number;
  defects: {
    kind:
      | 'index-out-of-range'
      | 'not-finite'
      | 'extent'
      | 'repeated-vertex'
      | 'zero-area'
      | 'duplicate-face'
      | 'non-manifold-edge'
      | 'inconsistent-edge'
      | 'non-manifold-vertex'
      | 'isolated-vertex';
    fatal: boolean;
    count: number;
    where: Where;
  }[];
  notes: Note[];
  error?: Refusal;
}

/**
 * A whole run: input, options, every round of every component, the completed prescription and the certificate of what is written.
 */
export interface Report {
  format: 'hgp-report';
  version: 1;
  program: {
    name: 'hgp';
    version: string;
  };
  certified: boolean;
  input: {
    name: string;
    format: string;
    bytes: number;
    sha256: string;
    surface: number;
    vertices: number;
    triangles: number;
  };
  /**
   * null: faces and vertices are those of the file. Otherwise the result, its certificate and the written file are of the repaired surface; input counts the vertices before the repairs, which keep their ids, and copies follow
   */
  repairsWritten: {
    /**
     * triangles that are written with the opposite orientation
     */
    facesTurned: number;
    /**
     * copies of vertices that were written to separate fans of faces; in glTF, where vertices at equal positions are read as one, these are stored vertices
     */
    verticesCopied: number;
  } | null;
  /**
   * null: the mesh was not refined. Otherwise the result, its certificate and the written file are of a mesh with these edges split at their midpoints; ids below and the counts of input are of the original mesh, vertices keep their ids and new ones follow; where edges are split in steps, for features, later ones may end at these
   */
  refined: {
    /**
     * edges that were split
     */
    edges: number;
    /**
     * of the refined mesh
     */
    vertices: number;
    /**
     * of the refined mesh
     */
    triangles: number;
    /**
     * programs that gave no map of the original mesh
     */
    roundsBefore: number;
    where: {
      reason: string;
      component: number;
      count: number;
      edges: Where;
    }[];
  } | null;
  options: {
    rounds: number;
    /**
     * edges may be split where there is no map
     */
    refine: boolean;
    /**
     * only maps in which every polygon is convex are certified
     */
    convexPolygons?: true;
    /**
     * the plane that was asked for across which the map is its own mirror image; the note `symmetric` names the plane that was taken
     */
    symmetric?: 'auto' | 'X' | 'Y' | 'Z';
    /**
     * null: the map as solved
     */
    improve: null | {
      /**
       * empty between the three
       */
      word: 'isometric' | 'conformal' | 'area' | '';
      /**
       * -1: angles, 0: isometric (symmetric Dirichlet), 1: areas
       */
      balance: number;
    };
    method: 'auto' | 'harmonic' | 'soft' | 'printed' | 'all-frames';
    boundary: 'free' | 'convex' | 'rectangle';
    scale: 'solved' | 'unit' | 'fit';
    /**
     * the requested grid; both sizes 0: no grid
     */
    grid: {
      cells: number;
      spacing: number;
      mode: 'tile' | 'quad';
    };
    /**
     * auto: a smooth field that hgp computes; file: the directions of the given field
     */
    frames: 'auto' | 'file';
    automaticCones: boolean;
    q?: number;
    coneCount?: number;
    /**
     * what automatic cones are optimised for, where their number is not given
     */
    conesFor?: 'balanced' | 'few' | 'fewer' | 'more' | 'low-distortion';
    alignToCurvature?: boolean;
  };
  seconds: number;
  notes: Note[];
  components: {
    certifiedBeforeStoring: boolean;
    usable: boolean;
    /**
     * How harmonic the stored values are: residuals of rows (7), (8), (14) at every interior vertex that is not a cone, relative to the mean uv edge there
     */
    harmonic: {
      /**
       * of the rows: the paper's, or cotangents in [0.01, 20] if rows with the paper's are violated and none of those with cotangents is. Theorem 6.1 holds for all positive weights
       */
      weights: 'mean-value' | 'cotangent';
      rows: number;
      /**
       * rows with a residual above 1e-6; for float32, above 1e-6 plus what rounding can cause there
       */
      violated: number;
      largestResidual: number;
    };
    /**
     * whether the map meets the hypotheses of Theorem 6.1; the certificate does not depend on it
     */
    theorem61: 'applies' | 'silent';
    theorem61Reason: string;
    cones: number;
    rounds: {
      method: string;
      constrainedTriangles: number;
      iterations: number;
      solverStatus: string;
      flipped: number;
      wrongAngles: number;
      /**
       * ‖Lz‖², a statistic of the solver
       */
      laplacianEnergy: number;
      seconds: number;
    }[];
    times: {
      stage: string;
      seconds: number;
    }[];
    /**
     * null where no grid was requested; otherwise what was reached, what was tried, and why there is no aligned map
     */
    grid: {
      aligned: boolean;
      /**
       * area of the map in cells
       */
      cells: number;
      /**
       * edge of a cell in units of the surface
       */
      spacing: number;
      cellsPerCone: number;
      /**
       * free Gaussian integers
       */
      integers: number;
      attempts: {
        method: string;
        /**
         * ratio of the tried density to the requested one
         */
        density: number;
        turnedTriangles: number;
      }[];
      /**
       * why there is no aligned map; null if there is one. Its places are the cones that are too close
       */
      reason: Note | null;
      /**
       * without an aligned map: the cones that are too close, closest first
       */
      closestCones: {
        /**
         * two, as numbered in the file
         */
        vertices: number[];
        /**
         * distance of the two in cells, in the map as solved
         */
        cells: number;
      }[];
      /**
       * without an aligned map: a number of cells that works, 0 if none was found
       */
      workingCells: number;
    } | null;
    /**
     * null where none was requested or the map is not certified
     */
    improvement: null | {
      balance: number;
      /**
       * false: the map is as before, since the verifier did not accept the improved one or nothing was gained
       */
      kept: boolean;
      outcome:
        | 'converged'
        | 'nothing to gain'
        | 'no descent'
        | 'step limit'
        | 'work limit'
        | 'singular'
        | 'not injective';
      steps: {
        /**
         * mean energy over the surface minus that of an isometry, after the step
         */
        excess: number;
        /**
         * 1: a full Newton step
         */
        length: number;
      }[];
      /**
       * Of the map as solved
       */
      before: {
        meanMu: number;
        p95Mu: number;
        rmsLogArea: number;
        symmetricDirichlet: number;
      };
      /**
       * The same once it is improved, before any alignment
       */
      after: {
        meanMu: number;
        p95Mu: number;
        rmsLogArea: number;
        symmetricDirichlet: number;
      };
      /**
       * The improvement of the aligned map, the integers held; null where the map is not aligned or has no seams
       */
      onGrid: null | {
        /**
         * false: the map is as aligned
         */
        kept: boolean;
        outcome:
          | 'converged'
          | 'nothing to gain'
          | 'no descent'
          | 'step limit'
          | 'work limit'
          | 'singular'
          | 'not injective';
        steps: {
          /**
           * mean energy over the surface minus that of an isometry, after the step
           */
          excess: number;
          /**
           * 1: a full Newton step
           */
          length: number;
        }[];
        /**
         * Of the map as aligned
         */
        before: {
          meanMu: number;
          p95Mu: number;
          rmsLogArea: number;
          symmetricDirichlet: number;
        };
        /**
         * The same of the map that is returned
         */
        after: {
          meanMu: number;
          p95Mu: number;
          rmsLogArea: number;
          symmetricDirichlet: number;
        };
      };
    };
    conflict: Where;
    notes: Note[];
  }[];
  cones: ConesDocument;
  certificate: Certificate;
}
