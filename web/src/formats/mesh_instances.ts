// How the nodes of a glTF use its meshes: how often, where, and whether mirrored. A mesh has one map;
// remarks say how the nodes affect it.

import type { ModelInfo } from 'hgp';
import { composed, determinant, identity, product, type Matrix } from '../model/matrix';
import type { Files } from '../model/types';
import { gltfOf, isGltf, isObject, objectsIn, surfaceMeshes, type Json } from './glb';

export interface MeshInstances {
  count: number;
  isMirrored: boolean;
  /** Matrix of the first node, by columns. */
  matrix: Matrix;
  /** Of every node, the first included; without the copies of EXT_mesh_gpu_instancing. */
  matrices: Matrix[];
}

const numbersIn = (value: unknown): number[] | undefined =>
  Array.isArray(value) && value.every((x) => typeof x === 'number') ? value : undefined;

function localMatrix({ matrix, translation, rotation, scale }: Json): Matrix {
  const m = numbersIn(matrix);
  if (m?.length === 16) return m;
  const [t, r, s] = [translation, rotation, scale].map(numbersIn);
  return composed(
    t?.length === 3 ? t : [0, 0, 0],
    r?.length === 4 ? r : [0, 0, 0, 1],
    s?.length === 3 ? s : [1, 1, 1],
  );
}

/** The matrix of a node including its ancestors; guards against cycles in invalid files. */
function worldMatrix(nodes: Json[], parents: Map<number, number>, start: number): Matrix {
  let world = identity;
  const seen = new Set<number>();
  for (let i: number | undefined = start; i !== undefined && !seen.has(i); i = parents.get(i)) {
    seen.add(i);
    world = product(localMatrix(nodes[i] ?? {}), world);
  }
  return world;
}

/** A skinned mesh is placed by its joints; in the bind pose, by the first of them. */
function skinMatrix(json: Json, node: Json, world: (i: number) => Matrix): Matrix | undefined {
  const skin = typeof node.skin === 'number' ? objectsIn(json.skins)[node.skin] : undefined;
  const [joint] = numbersIn(skin?.joints) ?? [];
  return joint === undefined ? undefined : world(joint);
}

/** Number of instances that EXT_mesh_gpu_instancing makes of a node; 1 without it. */
function copiesOf({ extensions }: Json, accessors: Json[]): number {
  const instancing = isObject(extensions) ? extensions.EXT_mesh_gpu_instancing : undefined;
  const attributes = isObject(instancing) ? instancing.attributes : undefined;
  const [first] = isObject(attributes) ? Object.values(attributes) : [];
  const count = typeof first === 'number' ? accessors[first]?.count : undefined;
  return typeof count === 'number' ? count : 1;
}

/** Instances by mesh with triangles, in the solver's numbering; undefined if the format has no nodes. */
export async function instancesOf(
  files: Files,
  main: string,
): Promise<MeshInstances[] | undefined> {
  if (!isGltf(main)) return undefined;
  const json = await gltfOf(files, main);
  const nodes = objectsIn(json.nodes);
  const accessors = objectsIn(json.accessors);
  const parents = new Map(
    nodes.flatMap(({ children }, i) => (numbersIn(children) ?? []).map((c) => [c, i])),
  );
  const meshes = objectsIn(json.meshes).map((): MeshInstances => ({
    ...{ count: 0, isMirrored: false, matrix: identity, matrices: [] },
  }));
  nodes.forEach((node, i) => {
    const mesh = typeof node.mesh === 'number' ? meshes[node.mesh] : undefined;
    if (!mesh) return;
    mesh.count += copiesOf(node, accessors);
    const world = (n: number): Matrix => worldMatrix(nodes, parents, n);
    const own = world(i);
    const isFinite = own.every(Number.isFinite) && determinant(own) !== 0;
    if (isFinite) {
      mesh.matrices.push(skinMatrix(json, node, world) ?? own);
      mesh.matrix = mesh.matrices[0];
    }
    mesh.isMirrored ||= determinant(own) < 0;
  });
  return surfaceMeshes(json).map((mesh) => meshes[mesh]);
}

/** Remarks on the loaded mesh that matter before it is mapped. */
export function remarksOn(
  { surfaces, surface }: ModelInfo,
  instances: MeshInstances | undefined,
): string[] {
  const remarks: string[] = [];
  const sets = surfaces[surface]?.uvSets ?? [];
  if (instances && instances.count > 1) {
    remarks.push(`Used ${instances.count} times in the scene: each shows the same map.`);
  }
  if (instances?.isMirrored) {
    remarks.push('A node mirrors it, so the map is mirrored there, too.');
  }
  if (sets.length === 0) return remarks;
  const names = sets.map((n) => `TEXCOORD_${n}`).join(', ');
  const isKept = `It has ${names}: kept, unless Download is told to replace one.`;
  return [...remarks, instances ? isKept : 'It has texture coordinates: they are replaced.'];
}
