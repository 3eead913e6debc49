// The page's solution for the map of a square, which passes every row of the verdict.

import { analyse } from '../../../web/src/services/geometry/analyse.ts';
import { plainFacts } from './plain_facts.mjs';

/** Neighbours, as the map's distances to seams want them. */
export function edgesOf(triangles, vertexCount) {
  const vertices = Array.from({ length: vertexCount }, () => [0, 0, 0]);
  const rows = Array.from({ length: triangles.length / 3 }, (_, t) => [...triangles.subarray(3 * t, 3 * t + 3)]); // prettier-ignore
  return { ...plainFacts({ vertices, triangles: rows }), vertexCount };
}

/** A square of four triangles around a middle vertex, mapped onto itself. */
export function square() {
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 0);
  const triangles = Uint32Array.of(0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4);
  const uv = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5);
  const uvToVertex = Uint32Array.of(0, 1, 2, 3, 4);
  return { positions, triangles, uv, cornerToUv: triangles.slice(), uvToVertex, seams: [] };
}

export const counts = (some) => ({
  ...{ triangles: 4, verified: 4, duplicates: 0, differing: 0, zeroArea: 0, reversed: 0 },
  ...{ splitVertices: 0, ...some },
});

export const certificate = {
  ...{ certified: true, usable: true, q: 4, precision: 'float64', triangles: 4, flipped: 0 },
  ...{ wrongAngles: 0, wrongTurnings: 0, seamEdges: 0, brokenSeams: 0, maxConeDistance: 0 },
  ...{ maxTurningDistance: 0, maxSeamResidual: 0, seamTolerance: 1e-9, components: [] },
  ...{ exactSeams: null, stored: counts({}) },
};

export function objOf({ positions, triangles, uv, cornerToUv }) {
  const lines = [];
  for (let v = 0; v < positions.length; v += 3)
    lines.push(`v ${positions.slice(v, v + 3).join(' ')}`);
  for (let i = 0; i < uv.length; i += 2) lines.push(`vt ${uv[i]} ${uv[i + 1]}`);
  for (let c = 0; c < triangles.length; c += 3) {
    const corner = (k) => `${triangles[c + k] + 1}/${cornerToUv[c + k] + 1}`;
    lines.push(`f ${corner(0)} ${corner(1)} ${corner(2)}`);
  }
  return new TextEncoder().encode(lines.join('\n'));
}

/** What the solver says of a map beside its certificate. */
export function measuresOf({ uv, cornerToUv, seams }) {
  const count = cornerToUv.length / 3;
  const signed = Array.from({ length: count }, (_, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * cornerToUv[3 * t + k]);
    return ((uv[b] - uv[a]) * (uv[c + 1] - uv[a + 1]) - (uv[b + 1] - uv[a + 1]) * (uv[c] - uv[a])) / 2; // prettier-ignore
  });
  return {
    stretch: new Float32Array(count).fill(1),
    area: new Float32Array(count),
    flipped: Uint32Array.from([...signed.keys()].filter((t) => !(signed[t] > 0))),
    ...{ surfaceArea: 1, uvArea: signed.reduce((sum, x) => sum + Math.abs(x), 0) },
    overlaps: { pairs: 0, triangles: new Uint32Array(0), isMore: false },
    seamChains: new Uint32Array(seams?.length ?? 0),
  };
}

/** The page's solution for a map and the file that was written for it. */
export function solutionOf(map, bytes = objOf(map)) {
  const files = [{ name: 'square.obj', bytes }];
  const edges = edgesOf(map.triangles, 5);
  const { analysis } = analyse({ map, measures: measuresOf(map), files, mesh: 0 }, edges);
  const prescription = { q: 4, cones: [], turnings: [], handles: [] };
  return { ...analysis, prescription, written: { bytes }, files, result: { ...map, certificate } };
}
