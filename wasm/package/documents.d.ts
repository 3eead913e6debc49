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
 * What a map is, by inspection of the stored values alone. Certified: there are triangles, each has exactly positive area, every interior angle sum and every boundary turning is as asked, every seam is a rotation by a multiple of 2π/q, each within the thresholds, and the areas span no more than the number type resolves.
 */
export interface Certificate {
  format: 'hgp-certificate';
  version: 1;
  certified: boolean;
  /**
   * the areas fit the precision; a certified map always is
   */
  usable: boolean;
  q: number;
  /**
   * the set of the file that was verified
   */
  uvSet?: number;
  precision: 'float32' | 'float64';
  triangles: number;
  /**
   * triangles that are not positive
   */
  flipped: number;
  wrongAngles: number;
  wrongTurnings: number;
  seamEdges: number;
  brokenSeams: number;
  /**
   * seam edges whose two sides satisfy z' = i^r z + t exactly in the stored numbers; null unless q is 1, 2 or 4
   */
  exactSeams: number | null;
  /**
   * of exactSeams, those with an integer translation: a grid of unit squares continues across them
   */
  integerSeams: number | null;
  /**
   * largest distance of an interior angle sum to a multiple of 2π/q, radians
   */
  maxConeDistance: number;
  /**
   * the same of a boundary loop, radians
   */
  maxTurningDistance: number;
  /**
   * of the seam edge that is worst beside what it is allowed, relative to its own length
   */
  maxSeamResidual: number;
  /**
   * accepted at that edge, relative to its own length
   */
  seamTolerance: number;
  /**
   * All triangles of the surface as they are stored: verified, or outside the certificate and why
   */
  stored: {
    triangles: number;
    judged: number;
    /**
     * outside: copies of a verified triangle, with its uv
     */
    duplicates: number;
    /**
     * of those, with other uv; never in what was written here
     */
    differing: number;
    /**
     * outside: a vertex named twice, or of a component in which no triangle has an area
     */
    zeroArea: number;
    /**
     * verified with the orientation opposite to the stored one
     */
    reversed: number;
    /**
     * copies of vertices that the verified surface has and the file does not
     */
    splitVertices: number;
  };
  /**
   * The tolerances that this map would pass
   */
  needed: {
    /**
     * of each seam edge's own length
     */
    seam: number;
    /**
     * radians
     */
    angle: number;
    /**
     * with the larger of the two as tolerance every rule holds
     */
    sufficient: boolean;
  };
  components: {
    certified: boolean;
    usable: boolean;
    /**
     * uv were well formed and finite, so that the facts are there
     */
    measured: boolean;
    vertices: number;
    edges: number;
    triangles: number;
    eulerCharacteristic: number;
    genus: number;
    boundaryLoops: number;
    orientation: {
      positive: number;
      zero: number;
      negative: number;
      constrained: number;
      constrainedPositive: number;
      /**
       * triangles, at most 10 000
       */
      notPositive: number[];
    };
    angles: {
      wrong: number;
      /**
       * radians
       */
      worstDistance: number;
      worstVertex: number;
      /**
       * accepted at worstVertex, radians
       */
      allowed: number;
      smallestAngle: number;
      overlappingBoundaryVertices: number[];
    };
    /**
     * asked ones and every vertex that is one
     */
    cones: {
      vertex: number;
      asked: number;
      measured: number;
      /**
       * of the angle to that multiple of 2π/q, radians
       */
      distance: number;
      /**
       * accepted distance here, radians
       */
      allowed: number;
    }[];
    wrongCones: {
      vertex: number;
      asked: number;
      measured: number;
      /**
       * of the angle to that multiple of 2π/q, radians
       */
      distance: number;
      /**
       * accepted distance here, radians
       */
      allowed: number;
    }[];
    turnings: {
      loop: number;
      asked: number | null;
      measured: number;
      /**
       * radians
       */
      distance: number;
      /**
       * radians
       */
      allowed: number;
    }[];
    handles: {
      generator: number;
      asked: number | null;
      measured: number | null;
    }[];
    seams: {
      edges: number;
      broken: number;
      /**
       * edges that hold bit for bit; null unless q is 1, 2 or 4
       */
      exact?: number | null;
      /**
       * of those, with an integer translation
       */
      integer?: number | null;
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
       * the edge that is worst beside what it is allowed
       */
      worstEdge: number[];
      /**
       * uv units
       */
      worstLengthResidual: number;
      largestUv: number;
      meanUvEdge: number;
    };
    gaussBonnet: {
      have: number;
      need: number;
    };
    /**
     * How much of the map lies on top of itself, counted on a grid of 512 × 512 points; reported, not verified
     */
    overlap: {
      /**
       * of the covered plane, 0 to 1
       */
      share: number;
      /**
       * most triangles over one point
       */
      layers: number;
    };
    distortion: {
      /**
       * μ = |f_z̄|/|f_z|, weighted by surface area
       */
      meanMu: number;
      p95Mu: number;
      maxMu: number;
      worstMuTriangle: number;
      /**
       * log₂ of the area ratio at the best global scale
       */
      rmsLogArea: number;
      p95LogArea: number;
      minLogArea: number;
      maxLogArea: number;
      /**
       * excess over an isometry at the best global scale
       */
      symmetricDirichlet: number;
      areaSpan: number;
      smallestToMeanArea: number;
      smallestTriangle: number;
    };
    /**
     * What the verdict was made with
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
       * most that rounding may excuse, relative to a seam edge's own length and in radians
       */
      largestRounding: number;
      /**
       * least accepted ratio of the smallest to the mean area scale
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
        | 'gauss-bonnet'
        | 'euler'
        | 'range'
        | 'empty';
      count: number;
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
     * nothing was asked of it; its cones will be chosen
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
    warnings: string[];
    error?: Error;
  }[];
  /**
   * Sentences for people
   */
  notes: string[];
  error?: Error;
}

/**
 * What is asked of a map: rotation order q, cones, turning of boundaries, rotation of handles. Cone angles are 2πk/q; interior vertices that are not listed have k = q. What is left out is completed by the program; an absent list of cones means automatic cones, an empty one means none.
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
     * of the file; where it differs, positions decide
     */
    sha256?: string;
  };
  cones?: {
    /**
     * 0-based; the file's own id for OBJ, OFF and PLY, the welded id for glTF and STL
     */
    vertex: number;
    /**
     * angle index
     */
    k: number;
    /**
     * where the surface touches itself at this vertex: a triangle of the part that is meant
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
     * turning index: total turning 2πl/q
     */
    l: number;
    /**
     * a vertex on that loop; decides when given
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
}

/**
 * What became of every mesh of a file that has several.
 */
export interface FileReport {
  format: 'hgp-file';
  version: 1;
  /**
   * All of them.
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
 * What a file holds and whether it can be parametrized.
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
    uvSets: number[];
    /**
     * Sentences for people
     */
    notes: string[];
  }[];
  /**
   * the one that is used
   */
  surface: number;
  /**
   * after repairs
   */
  vertices: number;
  triangles: number;
  eulerCharacteristic?: number;
  genus?: number;
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
  /**
   * Sentences for people
   */
  notes: string[];
  error?: Error;
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
   * null: faces and vertices are those of the file. Otherwise the result, its certificate and the written file are of the repaired surface; input counts the vertices before, which keep their ids, and copies follow
   */
  repairsWritten: {
    /**
     * triangles whose corners are written in the other order
     */
    facesTurned: number;
    /**
     * vertices that are written once more, so that the fans of faces around them are apart; in glTF, where vertices at one place are read as one, these are stored vertices
     */
    verticesCopied: number;
  } | null;
  /**
   * null: the mesh is as it was. Otherwise the result, its certificate and the written file are of a mesh with these edges split at their midpoints; ids below and input's counts are of the mesh before, vertices keep their ids and new ones follow
   */
  refined: {
    /**
     * how many are split
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
     * programs that gave no map on the mesh as it was
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
    boundary: 'free' | 'convex';
    scale: 'solved' | 'unit' | 'fit';
    /**
     * what was asked; both sizes 0: no grid
     */
    grid: {
      cells: number;
      spacing: number;
      mode: 'tile' | 'quad';
    };
    /**
     * auto: our own smooth connection; file: the directions of the given field
     */
    frames: 'auto' | 'file';
    automaticCones: boolean;
    q?: number;
    coneCount?: number;
    /**
     * What automatic cones are chosen for, where their number is not asked
     */
    conesFor?: 'balanced' | 'few' | 'low-distortion';
    alignToCurvature?: boolean;
  };
  seconds: number;
  /**
   * Sentences for people
   */
  notes: string[];
  components: {
    certifiedBeforeStoring: boolean;
    usable: boolean;
    /**
     * How harmonic the stored values are: rows (7), (8), (14) with mean-value weights at every interior vertex that is no cone, relative to the mean uv edge there
     */
    harmonic: {
      rows: number;
      /**
       * above 1e-6, in float32 above that and what rounding can do there
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
     * where a grid was asked: what was reached, what was tried, and why there is none
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
         * cells tried, relative to those asked
         */
        density: number;
        turnedTriangles: number;
      }[];
      /**
       * why there is none; empty where there is
       */
      reason: string;
      /**
       * without an aligned map: cones that are in each other's way, closest first
       */
      closestCones: {
        /**
         * two, as numbered in the file
         */
        vertices: number[];
        /**
         * from one to the other in the map as solved
         */
        cells: number;
      }[];
      /**
       * without an aligned map: a number of cells at which there is one, 0 if none was found
       */
      workingCells: number;
    } | null;
    /**
     * null where none was asked for or the map is not certified
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
    /**
     * Sentences for people
     */
    notes: string[];
  }[];
  cones: ConesDocument;
  certificate: Certificate;
}
