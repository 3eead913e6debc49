// The model with its own materials, as three.js reads the very file that Download saves. Fetched only
// when someone asks for it.

import {
  AmbientLight,
  DirectionalLight,
  Group,
  LoadingManager,
  type Material,
  type Object3D,
} from 'three';
import type { OutputFile } from '../state/readback';
import type { Files } from '../state/files';

/** Images and buffers come from the files at hand and from nowhere else. */
function managerOf(files: Files, written: OutputFile[]): [LoadingManager, () => void] {
  const manager = new LoadingManager();
  const urls: string[] = [];
  manager.setURLModifier((url) => {
    if (/^(blob|data):/.test(url)) return url;
    const name = decodeURIComponent(url.replace(/^(\.\/)+/, ''));
    const found = written.find((file) => file.name === name)?.bytes ?? files.get(name);
    const blob = found instanceof Blob ? found : new Blob(found ? [found as BlobPart] : []);
    urls.push(URL.createObjectURL(blob));
    return urls.at(-1)!;
  });
  return [manager, () => urls.forEach((url) => URL.revokeObjectURL(url))];
}

export async function loadOriginal(
  written: OutputFile[],
  files: Files,
  mesh: number,
): Promise<Group> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const [manager, free] = managerOf(files, written);
  const { bytes } = written[0];
  const data = bytes.slice().buffer;
  const gltf = await new GLTFLoader(manager).parseAsync(data, '');
  const object = (await gltf.parser.getDependency('mesh', mesh)) as Object3D;
  free();
  const group = new Group();
  const light = new DirectionalLight(0xffffff, 2);
  light.position.set(0.4, 0.8, 1);
  group.add(object.clone(), new AmbientLight(0xffffff, 1.4), light);
  group.traverse((part) => {
    part.frustumCulled = false;
    const { material } = part as { material?: Material };
    if (material) material.side = 2;
  });
  return group;
}
