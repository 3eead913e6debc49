// Packs the decoders of compressed files with the package, as self-contained ES modules
// (docs/decisions/014).

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

/**
 * A bundler that makes scripts of modules that are not imported by name (Parcel) leaves them no exports: importFile() of
 * the package's browser.ts then takes them from here.
 */
const registered = (name, exported) => `
(globalThis[Symbol.for('hgp.decoders')] ??= {}).${name} = { ${exported} };
`;

/** Writes draco, meshopt (glTF) and fflate (gzip) from node_modules into a folder. */
export function packDecoders(modules, out) {
  mkdirSync(out, { recursive: true });
  const sourceOf = (name) => readFileSync(path.join(modules, name), 'utf8');
  // The script uses CommonJS and Node's file system if it finds them; here it finds neither, and uses the bytes
  // that it is given.
  const hidden = ['process', 'require', 'module', 'exports', 'define', '__dirname', '__filename'];
  writeFileSync(
    path.join(out, 'draco_decoder.js'),
    `// draco3dgltf, Apache-2.0, https://github.com/google/draco
const create = ((${hidden.join(', ')}) => {
${sourceOf('draco3dgltf/draco_decoder_gltf_nodejs.js')}
return DracoDecoderModule;
})();
export default create;
${registered('draco_decoder', 'default: create')}`,
  );
  copyFileSync(
    path.join(modules, 'draco3dgltf/draco_decoder_gltf.wasm'),
    path.join(out, 'draco_decoder.wasm'),
  );
  const meshopt = sourceOf('meshoptimizer/meshopt_decoder.mjs');
  writeFileSync(
    path.join(out, 'meshopt_decoder.js'),
    meshopt + registered('meshopt_decoder', 'MeshoptDecoder'),
  );
  const fflate = sourceOf('fflate/esm/browser.js');
  writeFileSync(path.join(out, 'fflate.js'), fflate + registered('fflate', 'Gunzip'));
}
