// Thumbnails of the meshes of a file: their shape when the file is read, their map after Run.

import { effect, untracked } from '@preact/signals-core';
import type { Solution, Surface } from '../model/types';
import { gridTilesPerUnit } from '../model/grid';
import type { App } from './app';

/** Stores the thumbnail of a mesh when it is ready; nothing waits for it. */
export function takeThumbnail(app: App, mesh: number, made: Promise<Uint8ClampedArray>): void {
  const { doc } = app;
  const request = doc.openRequestId;
  made.then(
    (picture) => {
      if (doc.openRequestId === request)
        doc.thumbnails = new Map(doc.thumbnails).set(mesh, picture);
    },
    () => undefined, // without it the strip shows the name only
  );
}

function draw(app: App, mesh: number, surface: Surface, solution: Solution | undefined): void {
  const tiles = solution && gridTilesPerUnit(app.doc.look, surface, solution) / 2;
  takeThumbnail(app, mesh, app.geometry.call('thumbnail', [surface.id, solution?.id, tiles]));
}

/** Draws thumbnails of the open mesh and of each new map of it. */
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
      // The thumbnail of a mesh keeps its map while other meshes are open.
      if (displayed || !doc.thumbnails.has(mesh)) draw(app, mesh, model.surface, displayed);
    });
  });
}
