// Geometries for WebGL: one vertex per triangle corner, so that texture coordinates and
// overlays can differ on the two sides of an edge.

import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SerializedBvh } from '../model/scene';
import type { Solution, Surface } from '../model/types';

/** `same`: a geometry of the same surface, whose positions are reused. */
export function surfaceGeometry(
  surface: Surface,
  solution?: Solution,
  same?: BufferGeometry,
): BufferGeometry {
  const geometry = new BufferGeometry();
  const position = same?.getAttribute('position');
  const normal = same?.getAttribute('normal');
  geometry.setAttribute('position', position ?? new BufferAttribute(surface.cornerPositions, 3));
  geometry.setAttribute('normal', normal ?? new BufferAttribute(surface.cornerNormals, 4, true));
  geometry.boundingSphere = new Sphere(new Vector3(...surface.center), surface.radius);
  if (solution) geometry.setAttribute('uv', new BufferAttribute(solution.cornerUv, 2));
  return geometry;
}

/** The map as a flat mesh; it needs no normals, because it is not lit. */
export function flatGeometry({ cornerUv, flatPositions, box }: Solution): BufferGeometry {
  const geometry = new BufferGeometry();
  const center = new Vector3(box.x + box.width / 2, box.y + box.height / 2, 0);
  geometry.boundingSphere = new Sphere(center, Math.hypot(box.width, box.height) / 2);
  const position = new BufferAttribute(flatPositions, 3);
  geometry.setAttribute('position', position);
  geometry.setAttribute('uv', new BufferAttribute(cornerUv, 2));
  return geometry;
}

export function setTint(geometry: BufferGeometry, colours: Uint8Array): void {
  if (colours.length !== 4 * geometry.getAttribute('position').count) return; // colours of another model
  const tint = geometry.getAttribute('tint') as BufferAttribute | undefined;
  if (!tint) return void geometry.setAttribute('tint', new BufferAttribute(colours, 4, true));
  (tint.array as Uint8Array).set(colours);
  tint.needsUpdate = true;
}

/** A tree for picking, built by the geometry worker for the same corners. */
export function bvhFrom(serialized: SerializedBvh, geometry: BufferGeometry): MeshBVH {
  return MeshBVH.deserialize(serialized, geometry, { setIndex: false });
}

const smallest = 30_000; // corners: a tree over fewer is built synchronously

/** A tree over a small geometry, built synchronously; undefined if that would take long. */
export const bvhAtOnce = (geometry: BufferGeometry): MeshBVH | undefined =>
  geometry.getAttribute('position').count <= smallest
    ? new MeshBVH(geometry, { indirect: true, targetLeafSize: 10 })
    : undefined;
