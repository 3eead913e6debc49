// Decoders of compressed glTF: draco3dgltf and meshoptimizer, loaded when the first file needs them.
// The core checks sizes before and after decoding.

import { messageOf } from './error.js';
import type { FileReader } from './platform.js';

type Answer<T> = T | { error: string };

/** A decoder returns its result or { error }: no exception crosses WebAssembly frames. */
const answering =
  <Request, T>(decode: (request: Request) => T) =>
  (request: Request): Answer<T> => {
    try {
      return decode(request);
    } catch (error) {
      return { error: messageOf(error) };
    }
  };

interface MeshoptRequest {
  source: Uint8Array;
  count: number;
  stride: number;
  mode: string;
  filter: string;
}
interface Meshopt {
  MeshoptDecoder: {
    ready: Promise<void>;
    decodeGltfBuffer(
      to: Uint8Array,
      count: number,
      stride: number,
      source: Uint8Array,
      mode: string,
      filter: string,
    ): void;
  };
}

async function loadMeshopt({ importFile }: FileReader) {
  const url = new URL('../decoders/meshopt_decoder.js', import.meta.url);
  const { MeshoptDecoder } = (await importFile(url)) as Meshopt;
  await MeshoptDecoder.ready;
  return answering(({ source, count, stride, mode, filter }: MeshoptRequest) => {
    const bytes = new Uint8Array(count * stride);
    MeshoptDecoder.decodeGltfBuffer(bytes, count, stride, source, mode, filter);
    return { bytes };
  });
}

/** glTF's component types with Draco's names. */
const dracoTypes: Record<number, [string, number]> = {
  5120: ['DT_INT8', 1],
  5121: ['DT_UINT8', 1],
  5122: ['DT_INT16', 2],
  5123: ['DT_UINT16', 2],
  5125: ['DT_UINT32', 4],
  5126: ['DT_FLOAT32', 4],
};

interface DracoRequest {
  source: Uint8Array;
  vertexCount: number;
  indexCount: number;
  attributes: { uniqueId: number; componentType: number; components: number }[];
}
interface DracoMesh {
  num_points(): number;
  num_faces(): number;
}
interface DracoAttribute {
  ptr: number;
  num_components(): number;
}
interface DracoDecoder {
  DecodeBufferToMesh(buffer: object, mesh: DracoMesh): { ok(): boolean; error_msg(): string };
  GetTrianglesUInt32Array(mesh: DracoMesh, size: number, to: number): boolean;
  GetAttributeByUniqueId(mesh: DracoMesh, id: number): DracoAttribute;
  GetAttributeDataArrayForAllPoints(
    mesh: DracoMesh,
    attribute: DracoAttribute,
    type: unknown,
    size: number,
    to: number,
  ): boolean;
}
interface Draco {
  Decoder: new () => DracoDecoder;
  DecoderBuffer: new () => { Init(source: Uint8Array, size: number): void };
  Mesh: new () => DracoMesh;
  HEAPU8: Uint8Array<ArrayBuffer>;
  _malloc(size: number): number;
  _free(at: number): void;
  destroy(object: object): void;
  [type: string]: unknown;
}

function decodeDraco(
  draco: Draco,
  { source, vertexCount, indexCount, attributes }: DracoRequest,
): { indices: Uint32Array; attributes: Uint8Array[] } {
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  const mesh = new draco.Mesh();
  let at = 0;
  /** A copy of bytes that Draco writes to its own memory. */
  const taken = (size: number, write: (at: number, size: number) => boolean) => {
    at = draco._malloc(size);
    if (!at) throw new Error('out of memory');
    const isWritten = write(at, size);
    const bytes = isWritten ? draco.HEAPU8.slice(at, at + size) : undefined;
    draco._free(at);
    at = 0;
    if (!bytes) throw new Error('an attribute is not of the stated type');
    return bytes;
  };
  try {
    buffer.Init(source, source.length);
    const status = decoder.DecodeBufferToMesh(buffer, mesh);
    if (!status.ok()) throw new Error(status.error_msg());
    if (mesh.num_points() !== vertexCount || 3 * mesh.num_faces() !== indexCount) {
      throw new Error(`it has ${mesh.num_points()} vertices and ${mesh.num_faces()} triangles`);
    }
    const indices = taken(4 * indexCount, (to, size) =>
      decoder.GetTrianglesUInt32Array(mesh, size, to),
    );
    return {
      indices: new Uint32Array(indices.buffer),
      attributes: attributes.map(({ uniqueId, componentType, components }) => {
        const [type, width] = dracoTypes[componentType];
        const attribute = decoder.GetAttributeByUniqueId(mesh, uniqueId);
        if (!attribute.ptr || attribute.num_components() !== components) {
          throw new Error(`there is no attribute ${uniqueId} of the stated type`);
        }
        return taken(vertexCount * components * width, (to, size) =>
          decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, draco[type], size, to),
        );
      }),
    };
  } finally {
    if (at) draco._free(at);
    for (const object of [mesh, buffer, decoder]) draco.destroy(object);
  }
}

async function loadDraco({ importFile, readFile }: FileReader) {
  const [imported, wasmBinary] = await Promise.all([
    importFile(new URL('../decoders/draco_decoder.js', import.meta.url)),
    readFile(new URL('../decoders/draco_decoder.wasm', import.meta.url)),
  ]);
  const { default: createDraco } = imported as { default: (options: object) => Promise<Draco> };
  const draco = await createDraco({ wasmBinary });
  return answering((request: DracoRequest) => decodeDraco(draco, request));
}

const loaders = { draco: loadDraco, meshopt: loadMeshopt };
type Kind = keyof typeof loaders;
const loaded = new Map<Kind, Promise<unknown>>();

/**
 * { draco, meshopt } with the functions that `needs` requires and those already loaded.
 * @internal
 */
export async function decodersFor(
  needs: Record<Kind, boolean>,
  platform: FileReader,
): Promise<object> {
  for (const kind of Object.keys(loaders) as Kind[]) {
    if (!needs[kind] || loaded.has(kind)) continue;
    const loading: Promise<unknown> = loaders[kind](platform);
    loaded.set(kind, loading);
    loading.catch(() => loaded.delete(kind)); // so that the next file tries again
  }
  const entries = [...loaded].map(async ([kind, decode]) => [kind, await decode] as const);
  return Object.fromEntries(await Promise.all(entries));
}
