// Every mesh of a file, one after the other, each written into what the one before has written.

import { HgpError } from './error.js';
import { checkOptions } from './options.js';

/** The cones that a mesh itself stores, unless another order is asked for. */
function storedCones(core, q) {
  const cones = core.embeddedCones();
  return cones && (q === undefined || q === cones.q) ? cones : undefined;
}

/**
 * What `hgp param` does with a file of several meshes. A mesh without a certified map is left as it was,
 * unless `keepGoing` or `write.allowUncertified` store what there is; without them nothing is written unless
 * all are certified.
 * @param {import('../core.js').Core} core
 * @param {import('../core.js').CoreFiles} source
 * @param {import('../core.js').FileOptions} options
 * @return {import('../core.js').FileResult}
 */
export function parametrizeFile(core, source, options) {
  checkOptions('parametrizeFile', options);
  const { weld, fix, strict, writeRepairs, limits, target, write = {}, ...solve } = options;
  delete solve.name; // the source has it
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
    // Side files that earlier meshes made stay; the main file is the latest.
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
