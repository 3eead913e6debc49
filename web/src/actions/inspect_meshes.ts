// Inspects every mesh of a file that has several, so that the user can choose one.

import type { ModelInfo, Placements } from 'hgp';
import type { MeshSummary } from '../model/types';
import { isAbort } from '../text/error_messages';

const maxMeshes = 64;
const maxTriangles = 400_000; // in total: inspecting more would take too long

async function summarize(
  index: number,
  instances: number | undefined,
  read: (index: number) => Promise<ModelInfo>,
): Promise<MeshSummary> {
  try {
    const { usable, components, defects } = await read(index);
    const why = defects.find(({ fatal }) => fatal)?.kind.replaceAll('-', ' ') ?? 'not usable';
    return { index, isUsable: usable, components: components?.length ?? 0, why, instances };
  } catch (error) {
    if (isAbort(error)) throw error;
    return { index, isUsable: false, components: 0, why: (error as Error).message, instances };
  }
}

/** Reads the meshes one by one; the best is the largest that can be used. */
export async function surveyMeshes(
  info: ModelInfo,
  placements: readonly Placements[],
  read: (index: number) => Promise<ModelInfo>,
): Promise<{ summaries: MeshSummary[]; best: number }> {
  const total = info.surfaces.reduce((sum, { triangles }) => sum + triangles, 0);
  if (info.surfaces.length > maxMeshes || total > maxTriangles) {
    return { summaries: [], best: info.surface };
  }
  const summaries: MeshSummary[] = [];
  for (const { index } of info.surfaces) {
    summaries.push(await summarize(index, placements[index]?.count, read));
  }
  const size = (index: number): number => info.surfaces[index].triangles;
  const usable = summaries.filter(({ isUsable }) => isUsable).map(({ index }) => index);
  const best = usable.sort((a, b) => size(b) - size(a) || a - b)[0] ?? info.surface;
  return { summaries, best };
}
