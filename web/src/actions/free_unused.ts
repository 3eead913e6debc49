// Memory of the workers: models and maps in the solver, surfaces and maps in the geometry worker. What the document
// does not refer to any more is freed, and of the meshes that wait while another is open, what is large.

import { effect, untracked } from '@preact/signals-core';
import type { Model as SolverModel, UvMap } from 'hgp';
import type { MeshWork } from '../model/document';
import type { Solution } from '../model/types';
import { bytesOfAll } from '../text/format';
import type { App } from './app';

/** What meshes that wait may keep in the solver, in total; every one of them has its own copy of the file. */
const maxWaiting = { triangles: 500_000, bytes: 128 * 2 ** 20 };

interface Handles {
  models: Set<SolverModel>;
  maps: Set<UvMap>;
}

const known = new WeakMap<App, Handles>();

/** The waiting meshes that the solver keeps: as many as there is room for, small ones first. */
function keptMeshes(waiting: MeshWork[]): MeshWork[] {
  const sizeOf = ({ model, solutions }: MeshWork): number =>
    model.info.triangles * (1 + solutions.length);
  let { triangles, bytes } = maxWaiting;
  return [...waiting]
    .sort((a, b) => sizeOf(a) - sizeOf(b))
    .filter((work) => {
      triangles -= sizeOf(work);
      bytes -= bytesOfAll(work.model.files);
      return triangles >= 0 && bytes >= 0;
    });
}

/** Frees what is not needed. Nothing may be under way: a job has results that are not in the document yet. */
export function freeUnused(app: App): void {
  const { doc, geometry } = app;
  const waiting = [...doc.meshes.values()];
  const kept = keptMeshes(waiting);
  const inSolver = [...doc.solutions, ...kept.flatMap(({ solutions }) => solutions)];
  const open = doc.model ? [doc.model] : [];
  // The file of the previous model may have been overwritten: its cones are moved from what was read.
  const previous = doc.previous ? [doc.previous.model] : [];
  const models = [...open, ...previous, ...kept.map(({ model }) => model)];
  const now: Handles = {
    maps: new Set(inSolver.map(({ map }) => map)),
    models: new Set(models.map(({ solver }) => solver)),
  };
  // An earlier state of the mesh, to which undo can lead.
  for (const { model } of now.maps) now.models.add(model);
  const before = known.get(app);
  known.set(app, now);
  for (const map of before?.maps ?? []) if (!now.maps.has(map)) void map.dispose();
  for (const model of before?.models ?? []) if (!now.models.has(model)) void model.dispose();

  const drawn: Solution[] = [...doc.solutions, ...waiting.flatMap(({ solutions }) => solutions)];
  const surfaces = [...open, ...waiting.map(({ model }) => model)].map(({ surface }) => surface.id);
  geometry.keepOnly(
    new Set([...surfaces, ...drawn.map(({ surfaceId }) => surfaceId)]),
    new Set(drawn.map(({ id }) => id)),
  );
}

/** Frees memory after every change of the document, in a task of its own. */
export function watchMemory(app: App): () => void {
  const { doc } = app;
  let timer: ReturnType<typeof setTimeout> | undefined;
  return effect(() => {
    void [doc.model, doc.solutions, doc.meshes];
    clearTimeout(timer);
    const isOver = (): boolean => !doc.isBusy && !doc.automatic;
    // Actions change several members, some of them when their job is over.
    if (isOver()) timer = setTimeout(() => untracked(() => isOver() && freeUnused(app)));
  });
}
