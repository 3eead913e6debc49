// The triangles of a file that form a surface, and what is outside or wound the other way: found here
// without the core.

const minus = (a, b) => a.map((x, n) => x - b[n]);

export function areaOf([a, b, c]) {
  const [p, q] = [minus(b, a), minus(c, a)];
  const normal = [0, 1, 2].map(
    (n) => p[(n + 1) % 3] * q[(n + 2) % 3] - p[(n + 2) % 3] * q[(n + 1) % 3],
  );
  return Math.hypot(...normal) / 2;
}

/** Whether two orders of the same three vertices run the same way round. */
const isSameWay = (a, b) => b[(b.indexOf(a[0]) + 1) % 3] === a[1];

/**
 * Leaves out triangles that name a vertex twice and copies of others; winds the rest alike. Of copies that
 * run opposite ways either may be the one that stays: then `reversed` is one of a few numbers.
 */
export function surfaceOf(map) {
  const out = { ...map, triangles: [], corners: [], origin: [] };
  const facts = { folded: 0, duplicates: 0, differing: 0, reversed: 0, isAmbiguous: false };
  const hasBothWays = new Set();
  const firstOf = new Map();
  for (const [t, triangle] of map.triangles.entries()) {
    if (new Set(triangle).size < 3) {
      facts.folded += 1;
      continue;
    }
    const key = [...triangle].sort((a, b) => a - b).join(' ');
    const twin = firstOf.get(key);
    if (twin !== undefined) {
      facts.duplicates += 1;
      const uvAt = (s, v) => map.uv[map.corners[s][map.triangles[s].indexOf(v)]];
      const isSame = triangle.every((v) => {
        const [a, b] = [uvAt(t, v), uvAt(twin, v)];
        return a[0] === b[0] && a[1] === b[1];
      });
      facts.differing += !isSame;
      if (!isSameWay(map.triangles[twin], triangle)) {
        hasBothWays.add(twin);
        facts.isAmbiguous ||= !isSame;
      }
      continue;
    }
    firstOf.set(key, t);
    out.origin.push(t);
    out.triangles.push([...triangle]);
    out.corners.push([...map.corners[t]]);
  }
  windAlike(out, facts);
  facts.reversedAtLeast =
    facts.reversed - out.origin.filter((t, n) => out.isFlipped[n] && hasBothWays.has(t)).length;
  facts.reversedAtMost =
    facts.reversed + out.origin.filter((t, n) => !out.isFlipped[n] && hasBothWays.has(t)).length;
  return { surface: out, facts };
}

function windAlike(map, facts) {
  const around = new Map();
  const key = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);
  for (const [t, corners] of map.triangles.entries())
    for (let k = 0; k < 3; k++) {
      const edge = key(corners[k], corners[(k + 1) % 3]);
      if (!around.has(edge)) around.set(edge, []);
      around.get(edge).push([t, corners[k]]);
    }
  facts.isManifold = [...around.values()].every((list) => list.length <= 2);
  const flip = map.triangles.map(() => null);
  for (let seed = 0; seed < flip.length; seed++) {
    if (flip[seed] !== null) continue;
    const members = [seed];
    flip[seed] = false;
    for (let n = 0; n < members.length; n++) {
      const t = members[n];
      for (let k = 0; k < 3; k++) {
        const [a, b] = [map.triangles[t][k], map.triangles[t][(k + 1) % 3]];
        for (const [s, tail] of around.get(key(a, b))) {
          if (s === t || flip[s] !== null) continue;
          flip[s] = tail === a ? !flip[t] : flip[t];
          members.push(s);
        }
      }
    }
    const turned = members.filter((t) => flip[t]).length;
    facts.isAmbiguous ||= 4 * Math.min(turned, members.length - turned) >= members.length;
    const other = 2 * turned > members.length;
    for (const t of members) if (other) flip[t] = !flip[t];
    facts.reversed += other ? members.length - turned : turned;
  }
  map.isFlipped = flip;
  for (const [t, isFlipped] of flip.entries())
    if (isFlipped) {
      map.triangles[t].reverse();
      map.corners[t].reverse();
    }
}
