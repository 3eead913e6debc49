// Decoders of compressed glTF: draco3dgltf and meshoptimizer, loaded when the first file needs them.
// The core checks sizes before and after decoding.

/** A decoder returns its result or { error }: no exception crosses WebAssembly frames. */
const answering = (decode) => (request) => {
  try {
    return decode(request);
  } catch (error) {
    return { error: String(error?.message ?? error) };
  }
};

async function loadMeshopt({ importFile }) {
  const { MeshoptDecoder } = await importFile(
    new URL('../decoders/meshopt_decoder.js', import.meta.url),
  );
  await MeshoptDecoder.ready;
  return answering(({ source, count, stride, mode, filter }) => {
    const bytes = new Uint8Array(count * stride);
    MeshoptDecoder.decodeGltfBuffer(bytes, count, stride, source, mode, filter);
    return { bytes };
  });
}

/** glTF's component types with Draco's names. */
const dracoTypes = {
  5120: ['DT_INT8', 1],
  5121: ['DT_UINT8', 1],
  5122: ['DT_INT16', 2],
  5123: ['DT_UINT16', 2],
  5125: ['DT_UINT32', 4],
  5126: ['DT_FLOAT32', 4],
};

function decodeDraco(draco, { source, vertexCount, indexCount, attributes }) {
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  const mesh = new draco.Mesh();
  let at = 0;
  /** A copy of bytes that Draco writes to its own memory. */
  const taken = (size, write) => {
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

async function loadDraco({ importFile, readFile }) {
  const [{ default: createDraco }, wasmBinary] = await Promise.all([
    importFile(new URL('../decoders/draco_decoder.js', import.meta.url)),
    readFile(new URL('../decoders/draco_decoder.wasm', import.meta.url)),
  ]);
  const draco = await createDraco({ wasmBinary });
  return answering((request) => decodeDraco(draco, request));
}

const loaders = { draco: loadDraco, meshopt: loadMeshopt };
const loaded = {}; // promises

/** { draco, meshopt } with the functions that `needs` requires and those already loaded. */
export async function decodersFor(needs, platform) {
  for (const kind of Object.keys(loaders)) {
    if (needs[kind]) {
      loaded[kind] ??= loaders[kind](platform).catch((error) => {
        delete loaded[kind]; // so that the next file tries again
        throw error;
      });
    }
  }
  const entries = Object.entries(loaded).map(async ([kind, decode]) => [kind, await decode]);
  return Object.fromEntries(await Promise.all(entries));
}
