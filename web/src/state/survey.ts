// What each mesh of a file with several is good for, so that a person can choose with open eyes.

import type { ModelInfo } from 'hgp';
import type { Use } from './uses';

export interface MeshSurvey {
  index: number;
  /** Nodes that use the mesh; nothing where the format has no nodes. */
  instances?: number;
  isUsable: boolean;
  parts: number;
  /** Why it cannot be used, in a few words. */
  why: string;
}

const mostMeshes = 24;
const mostTriangles = 400_000; // all together: beyond, looking at each would take too long

/** Reads the meshes one by one; the best is the largest that can be used. */
export async function surveyMeshes(
  info: ModelInfo,
  uses: Use[] | undefined,
  read: (index: number) => Promise<ModelInfo>,
): Promise<{ survey: MeshSurvey[]; best: number }> {
  const total = info.surfaces.reduce((sum, { triangles }) => sum + triangles, 0);
  if (info.surfaces.length > mostMeshes || total > mostTriangles) {
    return { survey: [], best: info.surface };
  }
  const survey: MeshSurvey[] = [];
  for (const { index } of info.surfaces) {
    try {
      const { usable, components, defects } = await read(index);
      const why = defects.find(({ fatal }) => fatal)?.kind.replaceAll('-', ' ') ?? 'not usable';
      const parts = components?.length ?? 0;
      survey.push({ index, isUsable: usable, parts, why, instances: uses?.[index]?.instances });
    } catch (error) {
      if ((error as Error).name === 'AbortError') throw error;
      const why = (error as Error).message;
      survey.push({ index, isUsable: false, parts: 0, why, instances: uses?.[index]?.instances });
    }
  }
  const size = (index: number): number => info.surfaces[index].triangles;
  const usable = survey.filter(({ isUsable }) => isUsable).map(({ index }) => index);
  const best = usable.sort((a, b) => size(b) - size(a) || a - b)[0] ?? info.surface;
  return { survey, best };
}
