// What a map is, decided from the numbers in a file by exact arithmetic. Shares nothing with the core:
// another language, another number type, another order of steps.
//
// A map is { triangles, corners, uv, q, cones, origin }: vertices of the triangles, their uv numbers, uv
// as stored with v upwards, the asked cones { vertex, k, triangle? } (null: any), and the number that
// each triangle has in the file. `triangle` tells which part of the surface is meant at a vertex of several.

import * as exact from './exact.mjs';

const { minus, cross, square, sign, ratio } = exact;
const ulp = (x, digits) => 2 ** (Math.floor(Math.log2(x)) - (digits - 1));

/** Directed edges → triangle and corner; null where two triangles run along one the same way. */
function sidesOf(triangles) {
  const sides = new Map();
  for (const [t, corners] of triangles.entries())
    for (let k = 0; k < 3; k++) {
      const key = `${corners[k]} ${corners[(k + 1) % 3]}`;
      if (sides.has(key)) return null;
      sides.set(key, [t, k]);
    }
  return sides;
}

/** Corners of triangles in fans: those that meet at a vertex and are connected by edges there. */
function fansOf(triangles, sides) {
  const fan = triangles.map(() => [-1, -1, -1]);
  const fans = [];
  const across = (t, k) => {
    const [a, b] = [triangles[t][k], triangles[t][(k + 1) % 3]];
    return sides.get(`${b} ${a}`);
  };
  for (const [t, corners] of triangles.entries())
    for (let k = 0; k < 3; k++) {
      if (fan[t][k] >= 0) continue;
      const members = [];
      // Back to the first triangle of the fan, or once around; then forward from there.
      let at = [t, k];
      let isClosed = false;
      for (;;) {
        const before = across(...at);
        if (!before) break;
        at = [before[0], (before[1] + 1) % 3];
        if (at[0] === t && at[1] === k) {
          isClosed = true;
          break;
        }
      }
      for (;;) {
        fan[at[0]][at[1]] = fans.length;
        members.push(at);
        const after = across(at[0], (at[1] + 2) % 3);
        if (!after || fan[after[0]][after[1]] >= 0) break;
        at = after;
      }
      fans.push({ vertex: corners[k], members, isClosed });
    }
  return { fan, fans };
}

/** Boundary loops as lists of fans. */
function loopsOf(triangles, sides, fan) {
  const next = new Map();
  for (const [t, corners] of triangles.entries())
    for (let k = 0; k < 3; k++) {
      const [a, b] = [corners[k], corners[(k + 1) % 3]];
      if (!sides.has(`${b} ${a}`)) next.set(fan[t][k], fan[t][(k + 1) % 3]);
    }
  const loops = [];
  const seen = new Set();
  for (const begin of next.keys()) {
    if (seen.has(begin)) continue;
    const loop = [];
    for (let f = begin; !seen.has(f); f = next.get(f)) {
      seen.add(f);
      loop.push(f);
    }
    loops.push(loop);
  }
  return loops;
}

function componentsOf(triangles, sides) {
  const of = triangles.map(() => -1);
  let count = 0;
  for (let t = 0; t < triangles.length; t++) {
    if (of[t] >= 0) continue;
    const open = [t];
    of[t] = count;
    while (open.length > 0) {
      const s = open.pop();
      for (let k = 0; k < 3; k++) {
        const other = sides.get(`${triangles[s][(k + 1) % 3]} ${triangles[s][k]}`);
        if (other && of[other[0]] < 0) {
          of[other[0]] = count;
          open.push(other[0]);
        }
      }
    }
    count++;
  }
  return { of, count };
}

/** Per fan the index that was asked, and how many cones are at no inner vertex. */
function askedOf({ cones, q, origin }, fans) {
  const asked = fans.map(() => q);
  const facts = { asked, strays: 0, isAmbiguous: false };
  const taken = new Set();
  for (const { vertex, k, triangle } of cones ?? []) {
    const all = fans.map((_, n) => n).filter((n) => fans[n].vertex === vertex);
    const isMeant = (n) =>
      triangle === undefined || fans[n].members.some(([t]) => origin[t] === triangle);
    const [n, ...others] = all.filter(isMeant);
    facts.isAmbiguous ||= others.length > 0;
    if (n === undefined || !fans[n].isClosed || taken.has(n)) facts.strays += 1;
    else asked[n] = k;
    taken.add(n);
  }
  return facts;
}

/** One seam edge: the least residual over all rotations, relative to the edge's own length. */
function seamResidual(df, dg, q) {
  const own = square(df) < square(dg) ? square(df) : square(dg);
  // An edge without length on both sides is turned by anything.
  if (own === 0n)
    return { residual: Infinity, r: -1, own, isZero: square(df) === 0n && square(dg) === 0n };
  let best = { residual: Infinity, r: -1, own };
  for (const [r, rotation] of exact.rotations(q).entries()) {
    const turned = exact.times(rotation, df);
    const rest = minus(
      dg.map((x) => x << exact.bits),
      turned,
    );
    const residual = Math.sqrt(ratio(square(rest), own << (2n * exact.bits)));
    if (residual < best.residual) best = { residual, r, own, isZero: square(rest) === 0n };
  }
  return best;
}

/**
 * @param map        triangles must be consistently oriented
 * @param precision  'float64' or 'float32': the type that the file stores
 * @param areas      of the triangles on the surface
 * @returns facts, `isCertified`, and `isClose` where a number is so near its bound that other arithmetic
 *          may decide otherwise
 */
export function checkMap(map, precision, areas) {
  const { triangles, corners, uv, q, cones } = map;
  const tolerance = map.tolerance ?? 1e-6;
  const facts = { notPositive: [], seams: 0, exact: 0, broken: 0, wrongCones: 0, wrongLoops: 0 };
  const near = [];
  const note = (value, bound) => {
    if (value > 0 && Math.abs(value / bound - 1) < 1e-5) near.push([value, bound]);
  };
  const isWithin = (value, bound) => {
    note(value, bound);
    return value <= bound;
  };

  const { unit, points } = exact.integerPoints(uv);
  const at = (t, k) => points[corners[t][k]];
  const length = (squared) => Math.sqrt(exact.toNumber(squared, 2 * unit));

  const uvAreas = triangles.map((_, t) => {
    const twice = cross(minus(at(t, 1), at(t, 0)), minus(at(t, 2), at(t, 0)));
    const area = exact.toNumber(twice, 2 * unit) / 2;
    if (sign(twice) > 0) return Math.max(area, Number.MIN_VALUE); // below what a double can say
    facts.notPositive.push(t);
    return area;
  });

  const sides = sidesOf(triangles);
  const { fan, fans } = fansOf(triangles, sides);
  const loops = loopsOf(triangles, sides, fan);
  const components = componentsOf(triangles, sides);

  // What rounding to float32 may do, per component [decision 026].
  const largest = new Array(components.count).fill(0);
  for (const [t, own] of corners.entries())
    for (const c of own) {
      const [u, v] = uv[c];
      const sizes = precision === 'float32' ? [u, v, 1 + v] : [u, v];
      largest[components.of[t]] = Math.max(largest[components.of[t]], ...sizes.map(Math.abs));
    }
  const rounding = largest.map((x) =>
    precision === 'float32' && x > 0 ? 4 * ulp(x, 24) * Math.SQRT1_2 : 0,
  );

  const turned = new Array(fans.length).fill(0);
  for (const [key, [t, k]] of sides) {
    const [a, b] = key.split(' ').map(Number);
    const other = sides.get(`${b} ${a}`);
    if (!other || a > b) continue;
    const [s, l] = other;
    const [f0, f1, g0, g1] = [at(t, k), at(t, (k + 1) % 3), at(s, (l + 1) % 3), at(s, l)];
    if (f0[0] === g0[0] && f0[1] === g0[1] && f1[0] === g1[0] && f1[1] === g1[1]) continue;
    facts.seams += 1;
    const seam = seamResidual(minus(f1, f0), minus(g1, g0), q);
    if (seam.isZero) facts.exact += 1;
    const own = length(seam.own);
    const there = rounding[components.of[t]];
    const allowed =
      own > 0 ? Math.max(tolerance, Math.min(tolerance + there / own, there > 0 ? 1e-2 : 0)) : 0;
    if (!isWithin(seam.residual, allowed)) facts.broken += 1;
    if (there > 0) {
      const turn = there < own ? Math.asin(there / own) : Math.PI;
      turned[fan[t][k]] += turn;
      turned[fan[t][(k + 1) % 3]] += turn;
    }
  }
  const allowedAngle = (there) =>
    Math.min(
      Math.max(tolerance, precision === 'float32' ? Math.min(tolerance + there, 1e-2) : 0),
      Math.PI / 2 / q,
    );

  const { asked, strays, isAmbiguous } = askedOf(map, fans);
  facts.strays = strays;
  facts.areConesAmbiguous = isAmbiguous;

  // Angles mean something only in positive triangles.
  facts.measured = [];
  const euler = fans.length - (3 * triangles.length + boundaryEdges(loops)) / 2 + triangles.length;
  if (facts.notPositive.length === 0) {
    const sums = fans.map(({ members }) => {
      const sum = new exact.AngleSum();
      for (const [t, k] of members)
        sum.add(minus(at(t, (k + 1) % 3), at(t, k)), minus(at(t, (k + 2) % 3), at(t, k)));
      return sum;
    });
    let turnSum = 0;
    for (const [n, { vertex, isClosed }] of fans.entries()) {
      if (!isClosed) continue;
      const { n: k, distance } = exact.nearest(sums[n].turns, sums[n].rest, q);
      if (k !== q) facts.measured.push([vertex, k]);
      turnSum += q - k;
      const wanted = cones === null ? Math.max(1, k) : asked[n];
      if (k !== wanted || !isWithin(distance, allowedAngle(turned[n]))) facts.wrongCones += 1;
    }
    for (const loop of loops) {
      // Σ(π − θ): −1 per vertex, and the conjugates of the angles.
      let rest = [loop.length % 2 === 0 ? 1n : -1n, 0n];
      let raw = loop.length * Math.PI;
      let there = 0;
      for (const f of loop) {
        const [x, y] = sums[f].rest;
        rest = exact.times(rest, [x, -y]);
        const own = exact.argument([x, y]);
        raw -= 2 * Math.PI * sums[f].turns + (own < 0 ? own + 2 * Math.PI : own);
        there += turned[f];
      }
      const l = Math.round((raw * q) / (2 * Math.PI));
      const [c, s] = exact.rotations(q)[((l % q) + q) % q];
      const distance = Math.abs(exact.argument(exact.times(rest, [c, -s])));
      turnSum += l;
      if (!isWithin(distance, allowedAngle(there))) facts.wrongLoops += 1;
    }
    if (turnSum !== q * euler) facts.gaussBonnet = turnSum - q * euler;
  }

  // Areas must not span more than the number type resolves, per component.
  facts.areaSpan = areaSpans(uvAreas, areas, components).map((span) => {
    const epsilon = precision === 'float32' ? 2 ** -23 : 2 ** -52;
    if (span !== null) note(span, epsilon);
    facts.isOutOfRange ||= span !== null && span < epsilon;
    return span;
  });
  facts.isCertified =
    triangles.length > 0 &&
    facts.notPositive.length === 0 &&
    facts.strays + facts.broken + facts.wrongCones + facts.wrongLoops === 0 &&
    facts.gaussBonnet === undefined &&
    !facts.isOutOfRange;
  facts.isClose = near.length > 0;
  return facts;
}

const boundaryEdges = (loops) => loops.reduce((sum, loop) => sum + loop.length, 0);

/** Smallest area scale relative to the mean, per component; null where there is no area. */
function areaSpans(uvAreas, areas, components) {
  const sums = Array.from({ length: components.count }, () => ({
    uv: 0,
    area: 0,
    least: Infinity,
  }));
  for (const [t, area] of areas.entries()) {
    if (!(area > 0) || !(uvAreas[t] > 0)) continue;
    const sum = sums[components.of[t]];
    sum.uv += uvAreas[t];
    sum.area += area;
    sum.least = Math.min(sum.least, uvAreas[t] / area);
  }
  return sums.map(({ uv, area, least }) => (area > 0 ? least / (uv / area) : null));
}
