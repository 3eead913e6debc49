// Vertices opposite to one another in the plane of a symmetric map, found when such a map is first asked for.

import { effect } from '@preact/signals-core';
import { planeOf, type Opposite } from '../model/cone_pairs';
import type { Surface } from '../model/types';
import type { App } from './app';

const images = new WeakMap<Surface, Int32Array>();

/** Where the map is to be symmetric: the vertex opposite to one. */
export function oppositeIn({ doc }: App): Opposite {
  const { usableModel, askedFeatures } = doc;
  const known = usableModel && images.get(usableModel.surface);
  return (vertex) => (known && askedFeatures?.isSymmetric ? known[vertex] : -1);
}

async function find({ geometry }: App, surface: Surface, plane: Plane): Promise<void> {
  const { normal, offset, distance } = plane;
  const found = await geometry.call('images', [surface.id, { normal, offset }, distance]);
  images.set(surface, found);
}

type Plane = NonNullable<ReturnType<typeof planeOf>>;

/** Finds them whenever they are needed for another surface. */
export function watchOpposite(app: App): () => void {
  let asked: Surface | undefined;
  return effect(() => {
    const { usableModel, askedFeatures } = app.doc;
    if (!usableModel || !askedFeatures?.isSymmetric) return;
    const { surface, info } = usableModel;
    const plane = planeOf(info);
    if (!plane || surface === asked || images.has(surface)) return;
    asked = surface;
    find(app, surface, plane).catch(() => (asked = undefined)); // cones are then placed alone
  });
}
