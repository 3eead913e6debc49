// How the nodes of a glTF use its meshes: how often, and whether mirrored. A map is made once, for the
// mesh; what nodes do with it is said.

import type { ModelInfo } from 'hgp';
import { isGltf, readGltfJson, type Files } from './files';

export interface Use {
  instances: number;
  isMirrored: boolean;
}

interface Node {
  mesh?: number;
  children?: number[];
  matrix?: number[];
  scale?: number[];
  extensions?: { EXT_mesh_gpu_instancing?: { attributes?: Record<string, number> } };
}
interface Whole {
  meshes?: unknown[];
  nodes?: Node[];
  accessors?: { count?: number }[];
}

/** −1 where a node turns left hands into right ones. */
function signOf({ matrix: m, scale: s }: Node): number {
  if (m?.length === 16) {
    const [a, b, c] = [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)];
    const across = [1, 2, 0].map((j, i) => a[j] * b[3 - i - j] - a[3 - i - j] * b[j]);
    return Math.sign(across[0] * c[0] + across[1] * c[1] + across[2] * c[2]);
  }
  return s?.length === 3 ? Math.sign(s[0] * s[1] * s[2]) : 1;
}

/** Of a node with all that are above it; a file may name itself as its own child. */
function signAbove(nodes: Node[], parents: Map<number, number>, start: number): number {
  let sign = 1;
  const seen = new Set<number>();
  for (let i: number | undefined = start; i !== undefined && !seen.has(i); i = parents.get(i)) {
    seen.add(i);
    sign *= signOf(nodes[i] ?? {});
  }
  return sign;
}

/** By mesh; nothing where the format has no nodes. */
export async function usesOf(files: Files, main: string): Promise<Use[] | undefined> {
  if (!isGltf(main)) return undefined;
  const json = (await readGltfJson(main, files.get(main)!)) as Whole;
  const { meshes = [], nodes = [], accessors = [] } = json;
  const parents = new Map(nodes.flatMap(({ children = [] }, i) => children.map((c) => [c, i])));
  const uses = meshes.map((): Use => ({ instances: 0, isMirrored: false }));
  nodes.forEach(({ mesh, extensions }, i) => {
    const use = mesh === undefined ? undefined : uses[mesh];
    if (!use) return;
    const [many] = Object.values(extensions?.EXT_mesh_gpu_instancing?.attributes ?? {});
    use.instances += many === undefined ? 1 : (accessors[many]?.count ?? 1);
    use.isMirrored ||= signAbove(nodes, parents, i) < 0;
  });
  return uses;
}

/** What there is to know about the loaded mesh before its texture coordinates are made. */
export function remarksOn({ surfaces, surface }: ModelInfo, use: Use | undefined): string[] {
  const remarks: string[] = [];
  const sets = surfaces[surface]?.uvSets ?? [];
  if (use && use.instances > 1) {
    remarks.push(`Used ${use.instances} times in the scene: each shows the same map.`);
  }
  if (use?.isMirrored) remarks.push('A node mirrors it: seen there, the map is mirrored, too.');
  if (sets.length > 0) {
    const names = sets.map((n) => `TEXCOORD_${n}`).join(', ');
    remarks.push(use ? `It has ${names}: kept, unless Download is told to replace one.` : 'It has texture coordinates: they are replaced.'); // prettier-ignore
  }
  return remarks;
}
