// The model with its own materials, read by three.js from a glTF: its meshes, each placed by its
// nodes. This module is loaded only for a glTF. The 3D view lights it.

import {
  type BufferGeometry,
  Color,
  Group,
  LoadingManager,
  type Material,
  Matrix4,
  Mesh,
  type MeshStandardMaterial,
  type Object3D,
  type Texture,
} from 'three';
import { splitGlb, surfaceMeshes, type Json } from '../formats/glb';
import type { Files, OutputFile } from '../model/types';
import { creaseAngle } from '../services/geometry/crease_normals';
import { ballAround } from './ball';

interface Source {
  /** The main file first. */
  written: OutputFile[];
  files: Files;
  meshes: readonly PlacedMesh[];
}

interface PlacedMesh {
  /** Index among the meshes with triangles. */
  mesh: number;
  /** What places its instances, by columns. */
  matrices: readonly (readonly number[])[];
}

/** The instances of each mesh; those of one that could not be read are missing. */
export interface OwnScene {
  group: Group;
  instances: ReadonlyMap<number, readonly OwnInstance[]>;
}

/** One instance: how quiet it is, from 0 to 1, and the colour to which that fades it. */
export class OwnInstance extends Group {
  readonly quiet = { value: 0 };
  readonly paper = { value: new Color() };
}

// One white pixel, which replaces a missing or invalid image.
const blankPng =
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==';
const blankImage = (): Blob =>
  new Blob([Uint8Array.from(atob(blankPng), (c) => c.charCodeAt(0))], { type: 'image/png' });
const imageEnding = /\.(png|jpe?g|webp|avif)$/i;

/** Whether a file is an image, by its first bytes: the extension may be wrong. */
async function isImage(file: Blob): Promise<boolean> {
  const head = new Uint8Array(await file.slice(0, 12).arrayBuffer());
  const text = String.fromCharCode(...head);
  return /^\x89PNG|^\xff\xd8\xff|^RIFF....WEBP|^....ftypavif/s.test(text);
}

async function usableFiles({ files, written }: Source): Promise<Map<string, Blob>> {
  const found = new Map<string, Blob>();
  const all: [string, Blob | Uint8Array][] = [
    ...files,
    ...written.slice(1).map(({ name, bytes }): [string, Uint8Array] => [name, bytes]),
  ];
  for (const [name, file] of all) {
    const blob = file instanceof Blob ? file : new Blob([file as BlobPart]);
    if (!imageEnding.test(name) || (await isImage(blob))) found.set(name, blob);
  }
  return found;
}

/** The content of a data URL as a Blob, which the page's content security policy allows to be fetched. */
function blobOfDataUrl(url: string): Blob {
  const comma = url.indexOf(',');
  const head = url.slice(5, comma);
  const text = decodeURIComponent(url.slice(comma + 1));
  const data = head.endsWith(';base64') ? atob(text) : text;
  const type = head.replace(/;base64$/, '');
  return new Blob([Uint8Array.from(data, (c) => c.charCodeAt(0))], { type });
}

/** Loads images and buffers only from the given files. */
function managerOf(files: Map<string, Blob>): [LoadingManager, () => void] {
  const manager = new LoadingManager();
  const urls: string[] = [];
  manager.setURLModifier((url) => {
    if (url.startsWith('blob:')) return url;
    if (url.startsWith('data:')) {
      urls.push(URL.createObjectURL(blobOfDataUrl(url)));
      return urls.at(-1)!;
    }
    const name = decodeURIComponent(url.replace(/^(\.\/)+/, ''));
    const blob = files.get(name);
    // As a Blob, because the page's content security policy forbids fetching data: URLs.
    const otherwise = imageEnding.test(name) ? blankImage() : new Blob();
    urls.push(URL.createObjectURL(blob ?? otherwise));
    return urls.at(-1)!;
  });
  return [manager, () => urls.forEach((url) => URL.revokeObjectURL(url))];
}

/** A copy of a material that can be made quiet. */
function quietable(material: Material, { quiet, paper }: OwnInstance): Material {
  const own = material.clone();
  own.side = 2;
  own.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, { quiet, quietPaper: paper });
    // Of the roots, which are nearly what the eye sees: in linear light a little paper makes black a middle grey.
    const fade =
      'vec3 seen = sqrt(max(gl_FragColor.rgb, 0.0));' +
      'vec3 faded = mix(vec3(dot(seen, vec3(0.3, 0.6, 0.1))), sqrt(quietPaper), 0.55);' +
      'seen = mix(seen, faded, quiet);' +
      'gl_FragColor.rgb = seen * seen;';
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', 'uniform float quiet; uniform vec3 quietPaper; void main() {')
      .replace('#include <colorspace_fragment>', `${fade}\n#include <colorspace_fragment>`);
  };
  own.customProgramCacheKey = () => 'quietable';
  return own;
}

/** An instance without skinning and morph targets, because the base shape is parametrized. */
function atRest(object: Object3D, matrix: Matrix4): OwnInstance {
  const instance = new OwnInstance();
  object.traverse((part) => {
    const { geometry, material } = part as Partial<Mesh>;
    if (!geometry || !material || !(part as Mesh).isMesh) return;
    geometry.morphAttributes = {};
    geometry.boundingSphere ??= ballAround(geometry.getAttribute('position'));
    const [first] = [material].flat();
    const mesh = new Mesh(geometry, quietable(first, instance));
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(matrix);
    instance.add(mesh);
  });
  return instance;
}

const maxForCreases = 60_000; // triangles: finding creases in more of them would block the page

/** Gives meshes without normals smooth ones: glTF prescribes flat triangles, which hide the shape. */
async function smooth(group: Object3D): Promise<void> {
  const { toCreasedNormals } = await import('three/addons/utils/BufferGeometryUtils.js');
  group.traverse((part) => {
    const mesh = part as Mesh<BufferGeometry, MeshStandardMaterial>;
    if (!mesh.isMesh || mesh.geometry.attributes.normal) return;
    const { geometry } = mesh;
    const corners = geometry.index?.count ?? geometry.attributes.position.count;
    if (corners / 3 <= maxForCreases) mesh.geometry = toCreasedNormals(geometry, creaseAngle);
    else geometry.computeVertexNormals();
    for (const one of [mesh.material].flat()) one.flatShading = false;
  });
}

/** A copy in which the length in the header of a GLB includes all chunks that are read. */
function withRightLength(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const copy = bytes.slice();
  const chunks = splitGlb(copy);
  const header = new DataView(copy.buffer);
  const end = copy.length - (chunks?.rest.length ?? 0);
  if (chunks && header.getUint32(8, true) < end) header.setUint32(8, end, true);
  return copy;
}

export async function loadGltfScene(source: Source): Promise<OwnScene> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  const [manager, free] = managerOf(await usableFiles(source));
  try {
    const { bytes } = source.written[0];
    const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder);
    const gltf = await loader.parseAsync(withRightLength(bytes).buffer, '');
    const indices = surfaceMeshes(gltf.parser.json as Json);
    const group = new Group();
    const instances = new Map<number, OwnInstance[]>();
    for (const { mesh, matrices } of source.meshes) {
      const object = (await gltf.parser.getDependency('mesh', indices[mesh])) as Object3D;
      await smooth(object);
      const own = matrices.map((matrix) => atRest(object, new Matrix4().fromArray(matrix)));
      instances.set(mesh, own);
      for (const one of own) group.add(one);
    }
    return { group, instances };
  } finally {
    free();
  }
}

/** Frees a scene's resources on the graphics card. */
export function disposeScene(group: Group | undefined): void {
  group?.traverse((part) => {
    const { geometry, material } = part as Partial<Mesh<BufferGeometry, Material>>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) {
      for (const value of Object.values(one)) {
        if ((value as Texture | undefined)?.isTexture) (value as Texture).dispose();
      }
      one.dispose();
    }
  });
}
