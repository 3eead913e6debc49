// Reads a glTF file without any of our code: glTF-Transform, after Draco and meshopt data have been
// unpacked with their own JavaScript decoders.

import { Logger, NodeIO } from '@gltf-transform/core';
import draco3d from 'draco3dgltf';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { openFile } from './container.mjs';

const draco = await draco3d.createDecoderModule();
await MeshoptDecoder.ready;

const componentBytes = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const components = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** @returns {{text: string, json: object, buffers: (Uint8Array|null)[], document: Document}} */
export async function readIndependently(file) {
  const bytes = new Uint8Array(readFileSync(file));
  const { text, bin, others } = openFile(bytes);
  const json = JSON.parse(text.replace(/^\uFEFF/, ''));
  const buffers = (json.buffers ?? []).map((buffer, index) => {
    if (buffer.uri?.startsWith('data:')) {
      return new Uint8Array(Buffer.from(buffer.uri.split(',')[1], 'base64'));
    }
    if (buffer.uri) {
      return new Uint8Array(readFileSync(path.join(path.dirname(file), decodeURI(buffer.uri))));
    }
    return index === 0 && bin ? bin : null;
  });
  const plain = unpack(structuredClone(json), [...buffers]);
  const document = await new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .readJSON(plain);
  return { bytes, text, json, buffers, others, document };
}

function unpack(json, buffers) {
  const viewBytes = (view) => {
    const { buffer, byteOffset = 0, byteLength } = json.bufferViews[view];
    return buffers[buffer].subarray(byteOffset, byteOffset + byteLength);
  };
  const addBuffer = (bytes) => {
    json.buffers.push({ byteLength: bytes.length });
    buffers.push(bytes);
    return buffers.length - 1;
  };
  for (const view of json.bufferViews ?? []) {
    const packed = view.extensions?.EXT_meshopt_compression;
    if (!packed) continue;
    const { buffer, byteOffset = 0, byteLength, count, byteStride, mode, filter } = packed;
    const out = new Uint8Array(count * byteStride);
    const source = buffers[buffer].subarray(byteOffset, byteOffset + byteLength);
    MeshoptDecoder.decodeGltfBuffer(out, count, byteStride, source, mode, filter);
    Object.assign(view, { buffer: addBuffer(out), byteOffset: 0 });
    delete view.extensions;
  }
  for (const mesh of json.meshes ?? []) {
    for (const primitive of mesh.primitives) {
      const packed = primitive.extensions?.KHR_draco_mesh_compression;
      if (!packed) continue;
      const decoded = unpackDraco(viewBytes(packed.bufferView), packed, primitive, json);
      for (const [accessor, bytes] of decoded) {
        json.bufferViews.push({
          buffer: addBuffer(bytes),
          byteOffset: 0,
          byteLength: bytes.length,
        });
        json.accessors[accessor].bufferView = json.bufferViews.length - 1;
        delete json.accessors[accessor].byteOffset;
      }
      delete primitive.extensions.KHR_draco_mesh_compression;
    }
  }
  delete json.extensionsRequired;
  const resources = {};
  for (const [index, buffer] of (json.buffers ?? []).entries()) {
    delete buffer.extensions;
    buffer.uri = `buffer${index}.bin`;
    resources[buffer.uri] = buffers[index] ?? new Uint8Array(buffer.byteLength);
  }
  // Images by name are not read; one grey texel stands in.
  for (const image of json.images ?? []) {
    if (image.uri && !image.uri.startsWith('data:')) resources[image.uri] = new Uint8Array([0]);
  }
  return { json, resources };
}

function unpackDraco(bytes, packed, primitive, json) {
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  buffer.Init(new Int8Array(bytes), bytes.length);
  const mesh = new draco.Mesh();
  const status = decoder.DecodeBufferToMesh(buffer, mesh);
  if (!status.ok()) throw new Error(status.error_msg());
  const out = new Map();
  const count = mesh.num_faces() * 3;
  const pointer = draco._malloc(count * 4);
  decoder.GetTrianglesUInt32Array(mesh, count * 4, pointer);
  const indices = new Uint32Array(draco.HEAPU8.buffer, pointer, count).slice();
  draco._free(pointer);
  const type = json.accessors[primitive.indices].componentType;
  const TypedArray = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array }[type];
  out.set(primitive.indices, new Uint8Array(TypedArray.from(indices).buffer));
  for (const [semantic, id] of Object.entries(packed.attributes)) {
    const accessor = json.accessors[primitive.attributes[semantic]];
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    const size =
      mesh.num_points() * components[accessor.type] * componentBytes[accessor.componentType];
    const types = {
      5120: draco.DT_INT8,
      5121: draco.DT_UINT8,
      5122: draco.DT_INT16,
      5123: draco.DT_UINT16,
      5125: draco.DT_UINT32,
      5126: draco.DT_FLOAT32,
    };
    const place = draco._malloc(size);
    const dataType = types[accessor.componentType];
    decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, dataType, size, place);
    out.set(primitive.attributes[semantic], draco.HEAPU8.slice(place, place + size));
    draco._free(place);
  }
  for (const object of [mesh, buffer, decoder]) draco.destroy(object);
  return out;
}
