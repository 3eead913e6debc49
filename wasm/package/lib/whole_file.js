// Maps every mesh of a file; each map is written into the result of the previous one.

import { HgpError } from './error.js';
import { checkOptions } from './options.js';

/** The cones stored in a mesh, unless another order is requested. */
function storedCones(core, q) {
  const cones = core.embeddedCones();
  return cones && (q === undefined || q === cones.q) ? cones : undefined;
}

/**
 * Does what `hgp param` does with a file of several meshes. A mesh without a certified map is not changed,
 * unless `keepGoing` or `write.allowUncertified` is set; without them, files are returned only if all meshes
 * are certified.
 * @param {import('../core.js').Core} core
 * @param {import('../core.js').CoreFiles} source
 * @param {import('../core.js').FileOptions} options
 * @return {import('../core.js').FileResult}
 */
export function parametrizeFile(core, source, options) {
  checkOptions('parametrizeFile', options);
  const { weld, fix, strict, writeRepairs, limits, target, write = {}, ...solve } = options;
  delete solve.name; // it belongs to the source
  const load = { weld, fix, strict, writeRepairs, limits, target };
  const storesAll = Boolean(solve.keepGoing || write.allowUncertified);
  const count = core.load(source, load).surfaces.length;
  const { onProgress } = core;
  let { main, files } = source;
  /** @type {import('../core.js').FileResult['files']} */
  let written = [];
  /** @type {import('../core.js').MeshOutcome[]} */
  const meshes = [];
  const notes = [];
  const takeOne = (mesh) => {
    core.load({ main, files }, { ...load, surface: mesh });
    const cones = solve.boundary === 'convex' ? undefined : storedCones(core, solve.q);
    const { certificate, report } = core.parametrize({ ...solve, cones });
    meshes.push({ mesh, certified: certificate.certified, report });
    if (!certificate.certified && !storesAll) return;
    const made = core.write({ ...write, allowUncertified: storesAll });
    notes.push(...made.notes.map((note) => `mesh ${mesh}: ${note}`));
    // Keeps side files written with earlier meshes; the main file is the last one written.
    const others = written.slice(1);
    const isNew = ({ name }) => made.files.every((file) => file.name !== name);
    written = [...made.files, ...others.filter(isNew)];
    main = made.name;
    files = new Map(files);
    for (const { name, bytes } of written) files.set(name, bytes);
  };
  try {
    for (let mesh = 0; mesh < count; mesh++) {
      core.onProgress =
        onProgress && ((progress) => onProgress({ ...progress, mesh, meshes: count }));
      try {
        takeOne(mesh);
      } catch (error) {
        if (!(error instanceof HgpError) || error.code === 'cancelled') throw error;
        const { message, details } = error;
        const code = /** @type {import('../core.js').HgpErrorCode} */ (error.code);
        meshes.push({ mesh, certified: false, error: { code, message, ...details } });
      }
    }
  } finally {
    core.onProgress = onProgress;
  }
  core.load(source, load);
  const certified = meshes.every((one) => one.certified);
  if (written.length === 0 || !(certified || storesAll))
    return { certified, meshes, notes: [], files: [] };
  const [{ name, bytes }] = written;
  return { certified, meshes, notes, files: written, name, bytes };
}
