// One finished run: the map, the bytes that Download saves, and what the panels say about them.

import type { Result, Written } from 'hgp';
import type { App, LoadSettings } from './app';
import { inSteps, pause } from './breath';
import { leastArea, measure, type Distortion, type LeastArea } from './measure';
import { findOverlaps, type Overlaps } from './overlaps';
import { sideFiles } from './files';
import { keptIn } from './kept';
import type { Prescription } from './prescription';
import { readBack, type Corners, type OutputFile } from './readback';
import { distanceToSeams } from './seam_distance';
import { prepareSpread, spacingOf } from './spread';

export interface Seam {
  /** Ends as uv vertices, corresponding ends first. */
  a: [number, number];
  b: [number, number];
  r: number;
}

/** Where and how the map goes into the file. */
export interface Output {
  /** glTF: the set to write; without it the next free one. */
  uvSet?: number;
  scale: 'solved' | 'unit' | 'fit';
  embedCones: boolean;
  /** glTF: the mesh gets a grid as its material. */
  hasGrid: boolean;
}

export const plainOutput: Output = { scale: 'solved', embedCones: true, hasGrid: false };

/** What a result is the result of. */
export interface Order {
  asked: Prescription;
  /** Welds and repairs of the surface that it is the map of. */
  settings: LoadSettings;
  quality: boolean;
  frames: 'auto' | 'file';
  output: Output;
}

export interface Solved extends Order {
  result: Result;
  isCertified: boolean;
  written: Written;
  /** What the writer has to say. */
  notes: string[];
  /** What else is in the file and stays: "3 materials, 1 skin". */
  kept: string;
  /** What was written, and what it names beside that. */
  files: OutputFile[];
  /** Texture coordinates read back from the written bytes, in triangle order. */
  corners: Corners;
  /** The bytes hold the very map that was judged. */
  isSameAsFile: boolean;
  distortion: Distortion;
  least: LeastArea;
  /** Triangles that lie on top of others, which is allowed. */
  overlaps: Overlaps;
  /** From each vertex to the nearest seam along edges. */
  seamDistance: Float32Array;
  seams: Seam[];
  /** Colour group of each seam edge: the two sides of a chain have the same. */
  chains: Uint32Array;
  /** Edge of the surface (smaller vertex × |V| + larger) → seam. */
  seamAt: Map<number, number>;
}

async function cornersOf({ positions, triangles, uv, cornerToUv }: Result): Promise<Corners> {
  const out = {
    positions: new Float32Array(3 * triangles.length),
    uv: new Float32Array(2 * triangles.length),
  };
  await inSteps(triangles.length, (c) => {
    for (let i = 0; i < 3; i++) out.positions[3 * c + i] = positions[3 * triangles[c] + i];
    for (let i = 0; i < 2; i++) out.uv[2 * c + i] = uv[2 * cornerToUv[c] + i];
  });
  return out;
}

async function isSame(a: Corners, b: Corners): Promise<boolean> {
  const near = async (x: Float32Array, y: Float32Array): Promise<boolean> => {
    if (x.length !== y.length) return false;
    let largest = 1;
    let apart = 0;
    await inSteps(x.length, (i) => {
      largest = Math.max(largest, Math.abs(y[i]));
      const far = Math.abs(x[i] - y[i]);
      if (!(far <= apart)) apart = Number.isNaN(far) ? Infinity : far;
    });
    return apart <= 2e-6 * largest;
  };
  return (await near(a.uv, b.uv)) && (await near(a.positions, b.positions));
}

/** Seam edges that follow one another with the same r get one colour. */
function chainsOf(seams: Seam[], uvToVertex: Uint32Array, q: number): Uint32Array {
  // Which side is called a is arbitrary, so r and q − r are the same turn.
  const turn = ({ r }: Seam): number => Math.min(r, (q - r) % q);
  const chains = new Uint32Array(seams.length);
  const at = new Map<number, number[]>();
  seams.forEach(({ a }, i) => {
    for (const end of a) {
      const v = uvToVertex[end];
      at.set(v, [...(at.get(v) ?? []), i]);
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

/** The writer asks to keep a file beside the new one: the download brings it along. */
const isSettled = (note: string, files: OutputFile[]): boolean =>
  files.some(({ name }) => note === `keep ${name} next to the new file`);

export async function finish(
  app: App,
  { asked, settings, quality, frames, output }: Order,
  result: Result,
  written: Written,
): Promise<Solved> {
  const { seams, uvToVertex } = result;
  const own = await cornersOf(result);
  let corners = own;
  let isSameAsFile = false;
  const files = [...written.files, ...(await sideFiles(app.files, written.files))];
  const notes = written.notes.filter((note) => !isSettled(note, files));
  const kept = await keptIn(files[0]);
  try {
    const read = await readBack(files, app.info?.surface ?? 0, output.uvSet);
    isSameAsFile = await isSame(read, own);
    if (isSameAsFile) corners = read;
  } catch {
    // A file that cannot be read back is shown as such in the certificate.
  }
  await pause();
  const distortion = await measure(own);
  const least = await leastArea(result);
  const overlaps = await findOverlaps(own.uv, result.cornerToUv);
  const seamDistance = await distanceToSeams(app.surface!, seams, uvToVertex);
  await pause();
  const chains = chainsOf(seams, uvToVertex, asked.q);
  await prepareSpread(app.surface!, spacingOf(app.surface!, app.look.tiles));
  const count = result.positions.length / 3;
  const seamAt = new Map<number, number>();
  seams.forEach(({ a }, i) => {
    const [v, w] = [uvToVertex[a[0]], uvToVertex[a[1]]];
    seamAt.set(Math.min(v, w) * count + Math.max(v, w), i);
  });
  return {
    ...{ asked, settings, quality, frames, output, result, written, notes, kept, files, corners },
    ...{ isSameAsFile, seams },
    ...{ distortion, least, overlaps, seamDistance, chains, seamAt },
    isCertified: result.certificate.certified,
  };
}
