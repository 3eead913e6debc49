// Reads a GLB and writes it with seamless texture coordinates in every mesh.

import { WebIO } from '@gltf-transform/core';
import { createClient } from 'hgp';
import { seamless } from 'hgp/gltf-transform';

const status = document.querySelector('[role=status]');

document.querySelector('input').addEventListener('change', async (event) => {
  const [file] = event.target.files;
  if (!file) return;
  status.textContent = 'Computing …';
  const client = await createClient();
  try {
    const io = new WebIO();
    const document_ = await io.readBinary(new Uint8Array(await file.arrayBuffer()));
    let count = 0;
    await document_.transform(seamless({ client, onMesh: () => (count += 1) }));
    const bytes = await io.writeBinary(document_);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes], { type: 'model/gltf-binary' }));
    link.download = file.name.replace(/\.glb$/i, '') + '-seamless.glb';
    link.textContent = `${link.download} (${count} meshes)`;
    status.replaceChildren(link);
    document.title = 'done';
  } catch (error) {
    status.textContent = error.message;
    document.title = 'failed';
  } finally {
    client.terminate();
  }
});
