// Remarks on a loaded mesh that matter before it is mapped: it has one map, whoever shows it.

import type { ModelInfo, Placements } from 'hgp';
import { gzipNote, noteForPage } from './notes';

/** `ignoredBytes`: how many there are behind the content of a gzip file. */
export function remarksOn(
  { surfaces, surface }: ModelInfo,
  placements: Placements | undefined,
  ignoredBytes = 0,
): string[] {
  const remarks = ignoredBytes > 0 ? [noteForPage(gzipNote(ignoredBytes))] : [];
  const sets = surfaces[surface]?.uvSets ?? [];
  if (placements && placements.count > 1) {
    remarks.push(`Used ${placements.count} times in the scene: each shows the same map.`);
  }
  if (placements?.isMirrored) {
    remarks.push('A node mirrors it, so the map is mirrored there, too.');
  }
  if (sets.length === 0) return remarks;
  const names = sets.map((n) => `TEXCOORD_${n}`).join(', ');
  const isKept = `It has ${names}: kept, unless you replace one under Download.`;
  return [...remarks, placements ? isKept : 'It has texture coordinates: they are replaced.'];
}
