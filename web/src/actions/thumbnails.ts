// Small pictures of the meshes of a file: of their shape when the file is read, with their map after Run.

import { effect, untracked } from '@preact/signals-core';
import type { Solution, Surface } from '../model/types';
import { gridTilesPerUnit } from '../model/grid';
import type { App } from './app';

/** What is known when the meshes are looked at one after another; pictures are not waited for. */
export function takeThumbnail(app: App, mesh: number, made: Promise<Uint8ClampedArray>): void {
  const { doc } = app;
  const request = doc.openRequestId;
  made.then(
    (picture) => {
      if (doc.openRequestId === request)
        doc.thumbnails = new Map(doc.thumbnails).set(mesh, picture);
    },
    () => undefined, // the strip has names as well
  );
}

function draw(app: App, mesh: number, surface: Surface, solution: Solution | undefined): void {
  const tiles = solution && gridTilesPerUnit(app.doc.look, surface, solution) / 2;
  takeThumbnail(app, mesh, app.geometry.call('thumbnail', [surface.id, solution?.id, tiles]));
}

/** The mesh that is open, and each map that is made of it. */
export function watchThumbnails(app: App): () => void {
  const { doc } = app;
  let last: unknown;
  return effect(() => {
    const { model, displayed } = doc;
    if (!model || model.info.surfaces.length < 2) return;
    const shown = displayed ?? model.surface;
    if (shown === last) return;
    last = shown;
    untracked(() => {
      const { surface: mesh } = model.info;
      // What was made of a mesh stays in its picture while others are looked at.
      if (displayed || !doc.thumbnails.has(mesh)) draw(app, mesh, model.surface, displayed);
    });
  });
}
