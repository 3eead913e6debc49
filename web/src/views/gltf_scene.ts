// The model with its own materials, as three.js reads a glTF: one mesh of it, where its first node
// puts it. Fetched only when there is a glTF.

import {
  AmbientLight,
  type BufferGeometry,
  DirectionalLight,
  Group,
  HemisphereLight,
  LoadingManager,
  type Material,
  Matrix4,
  Mesh,
  type Object3D,
  type Texture,
} from 'three';
import { splitGlb, surfaceMeshes, type Json } from '../formats/glb';
import type { Files, OutputFile } from '../model/types';

interface Source {
  /** The main file first. */
  written: OutputFile[];
  files: Files;
  /** Among those with triangles. */
  mesh: number;
  /** Column by column: from the mesh to where it is seen. */
  matrix: readonly number[];
}

// One white pixel, in place of an image that is missing or none.
const blankPng =
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==';
const blankImage = (): Blob =>
  new Blob([Uint8Array.from(atob(blankPng), (c) => c.charCodeAt(0))], { type: 'image/png' });
const imageEnding = /\.(png|jpe?g|webp|avif)$/i;

/** By its first bytes: what ends like an image may be anything. */
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

/** As it may be fetched under the page's policy. */
function blobOfDataUrl(url: string): Blob {
  const comma = url.indexOf(',');
  const head = url.slice(5, comma);
  const text = decodeURIComponent(url.slice(comma + 1));
  const data = head.endsWith(';base64') ? atob(text) : text;
  const type = head.replace(/;base64$/, '');
  return new Blob([Uint8Array.from(data, (c) => c.charCodeAt(0))], { type });
}

/** Images and buffers come from the files at hand and from nowhere else. */
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
    // As a Blob: the page's policy lets nothing be fetched from data: URLs.
    const otherwise = imageEnding.test(name) ? blankImage() : new Blob();
    urls.push(URL.createObjectURL(blob ?? otherwise));
    return urls.at(-1)!;
  });
  return [manager, () => urls.forEach((url) => URL.revokeObjectURL(url))];
}

/** Skins and morph targets stay at rest: what is parametrized is the base shape. */
function atRest(object: Object3D, matrix: Matrix4): Group {
  const group = new Group();
  object.traverse((part) => {
    const { geometry, material } = part as Partial<Mesh<BufferGeometry, Material>>;
    if (!geometry || !material || !(part as Mesh).isMesh) return;
    geometry.morphAttributes = {};
    const mesh = new Mesh(geometry, material);
    for (const one of [material].flat()) one.side = 2;
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(matrix);
    group.add(mesh);
  });
  return group;
}

/** A copy, in which the header of a GLB counts at least the chunks that are read. */
function withRightLength(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const copy = bytes.slice();
  const chunks = splitGlb(copy);
  const header = new DataView(copy.buffer);
  const end = copy.length - (chunks?.rest.length ?? 0);
  if (chunks && header.getUint32(8, true) < end) header.setUint32(8, end, true);
  return copy;
}

export async function loadGltfMesh(source: Source): Promise<Group> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
  const [manager, free] = managerOf(await usableFiles(source));
  try {
    const { bytes } = source.written[0];
    const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder);
    const gltf = await loader.parseAsync(withRightLength(bytes).buffer, '');
    const mesh = surfaceMeshes(gltf.parser.json as Json)[source.mesh];
    const object = (await gltf.parser.getDependency('mesh', mesh)) as Object3D;
    const group = atRest(object, new Matrix4().fromArray(source.matrix));
    const light = new DirectionalLight(0xffffff, 2);
    light.position.set(0.4, 0.8, 1);
    const sky = new HemisphereLight(0xffffff, 0x8d8d8d, 1.2);
    group.add(new AmbientLight(0xffffff, 0.7), sky, light);
    return group;
  } finally {
    free();
  }
}

/** What it holds on the graphics card. */
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
