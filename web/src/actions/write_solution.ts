// Writes a map into its file, reads it back and computes what the panels show about it.

import type { Note, UvMap, WriteOptions, Written } from 'hgp';
import { gridTilesPerUnit } from '../model/grid';
import type { MapNumbers, Model, Output, OutputFile, Solution, SolveRequest } from '../model/types';
import type { App } from './app';
import { stageStart, type JobCall } from './job';
import { sideFiles } from './side_files';

export const writeOptions = ({ uvSet, embedCones, usesNewSet }: Output): WriteOptions => ({
  allowUncertified: true,
  embedCones,
  ...(usesNewSet === undefined ? {} : { use: usesNewSet }),
  ...(uvSet === undefined ? {} : { uvSet }),
});

/** Whether a note is settled: it asks to keep a file next to the new one, and the download includes that file. */
export const isSettled = ({ code, words }: Note, files: OutputFile[]): boolean =>
  code === 'write-keep-beside' && files.some(({ name }) => name === words.name);

/** The numbers of a map alone: they travel to the geometry worker and back. */
export function numbersOf(map: UvMap): MapNumbers {
  const { positions, triangles, uv, cornerToUv, uvToVertex, seams } = map;
  const { certificate, cones, report, memory } = map;
  const arrays = { positions, triangles, uv, cornerToUv, uvToVertex, seams };
  return { ...arrays, certificate, cones, report, memory };
}

const edgeKey = (v: number, w: number, count: number): number =>
  Math.min(v, w) * count + Math.max(v, w);

/** Writes the map, reads it back and computes what the panels show about it. */
export async function writeSolution(
  app: App,
  model: Model,
  request: SolveRequest,
  { map, result: solved }: Pick<Solution, 'map' | 'result'>,
  call: JobCall,
): Promise<Solution> {
  const { doc, geometry } = app;
  const { output } = request;
  call.onProgress(stageStart('write'));
  let written = await map.write(writeOptions(output), call);
  const { info, surface } = model;
  const where = { mesh: info.surface, uvSet: output.uvSet };
  let all = [...written.files, ...(await sideFiles(app, model, written.files))];
  const analyse = async (result: MapNumbers, files: OutputFile[]) =>
    geometry.analyse(surface, result, await map.measure(call), files, where);
  let read = await analyse(solved, all);
  let gridTiles: number | undefined;
  if (output.hasGrid) {
    const { distortion } = read.analysis;
    gridTiles = gridTilesPerUnit(doc.look, surface, { result: read.result, distortion });
    const options = { ...writeOptions(output), gridMaterial: gridTiles };
    written = await map.write(options, call);
    all = [...written.files, ...(await sideFiles(app, model, written.files))];
    read = await analyse(read.result, all);
  }
  call.signal.throwIfAborted();
  const { analysis, preserved, result, files } = read;
  const { seams, uvToVertex } = result;
  const seamAt = new Map<number, number>();
  seams.forEach(({ a }, i) => {
    seamAt.set(edgeKey(uvToVertex[a[0]], uvToVertex[a[1]], surface.vertexCount), i);
  });
  const newest: Written = { ...written, ...files[0], files: files.slice(0, written.files.length) };
  const notes = written.notes.filter((note) => !isSettled(note, files));
  return {
    ...request,
    ...analysis,
    result,
    map,
    surfaceId: surface.id,
    gridTiles,
    written: newest,
    notes,
    preserved,
    files,
    seams,
    seamAt,
  };
}
