// Decoders of compressed files beside the package, as ES modules that find nothing by themselves
// (docs/decisions/014).

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

/** Writes draco, meshopt (glTF) and fflate (gzip) from node_modules into a folder. */
export function packDecoders(modules, out) {
  mkdirSync(out, { recursive: true });
  const sourceOf = (name) => readFileSync(path.join(modules, name), 'utf8');
  // The script asks for CommonJS and for Node's file system where it can; in here it finds neither, and
  // takes the bytes it is given.
  const hidden = ['process', 'require', 'module', 'exports', 'define', '__dirname', '__filename'];
  writeFileSync(
    path.join(out, 'draco_decoder.js'),
    `// draco3dgltf, Apache-2.0, https://github.com/google/draco
const create = ((${hidden.join(', ')}) => {
${sourceOf('draco3dgltf/draco_decoder_gltf_nodejs.js')}
return DracoDecoderModule;
})();
export default create;
`,
  );
  copyFileSync(
    path.join(modules, 'draco3dgltf/draco_decoder_gltf.wasm'),
    path.join(out, 'draco_decoder.wasm'),
  );
  const meshopt = sourceOf('meshoptimizer/meshopt_decoder.mjs');
  writeFileSync(path.join(out, 'meshopt_decoder.js'), meshopt);
  writeFileSync(path.join(out, 'fflate.js'), sourceOf('fflate/esm/browser.js'));
}
