// Groups of seam edges that are drawn in one colour.

import type { Seam } from '../../model/types';

/** Seam edges that follow one another with the same r are one chain; which chain each edge is in. */
export function seamChains(seams: Seam[], uvToVertex: Uint32Array, q: number): Uint32Array {
  // Which side is called a is arbitrary, so r and q − r are the same turn.
  const turn = ({ r }: Seam): number => Math.min(r, (q - r) % q);
  const chains = new Uint32Array(seams.length);
  const at = new Map<number, number[]>();
  seams.forEach(({ a }, i) => {
    for (const end of a) {
      const v = uvToVertex[end];
      const list = at.get(v);
      if (list) list.push(i);
      else at.set(v, [i]);
    }
  });
  let count = 0;
  const done = new Uint8Array(seams.length);
  for (let first = 0; first < seams.length; first++) {
    if (done[first]) continue;
    count += 1;
    const waiting = [first];
    done[first] = 1;
    while (waiting.length > 0) {
      const i = waiting.pop()!;
      chains[i] = count - 1;
      for (const end of seams[i].a) {
        const around = at.get(uvToVertex[end])!;
        if (around.length !== 2) continue; // a branch or an end of the cut
        for (const j of around) {
          if (done[j] || turn(seams[j]) !== turn(seams[i])) continue;
          done[j] = 1;
          waiting.push(j);
        }
      }
    }
  }
  return chains;
}
