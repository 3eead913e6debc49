// Geometries for WebGL: one vertex per triangle corner, so that texture coordinates and
// overlays can differ on the two sides of an edge.

import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SerializedBvh } from '../model/scene';
import type { Solution, Surface } from '../model/types';
import { flatPositions } from '../services/geometry/flat_positions';
import { cornerNormals, cornerPositions, FlatAttribute } from './gathered_attribute';

/** `same`: a geometry of the same surface, whose positions and normals are taken from it, with what the card has. */
export function surfaceGeometry(
  surface: Surface,
  solution?: Solution,
  same?: BufferGeometry,
): BufferGeometry {
  const geometry = new BufferGeometry();
  const { places, triangles } = surface;
  const position = same?.getAttribute('position') ?? cornerPositions(places, triangles);
  const normal = same?.getAttribute('normal') ?? cornerNormals(surface);
  same?.deleteAttribute('position').deleteAttribute('normal');
  geometry.setAttribute('position', position).setAttribute('normal', normal);
  geometry.boundingSphere = new Sphere(new Vector3(...surface.center), surface.radius);
  if (solution) geometry.setAttribute('uv', new BufferAttribute(solution.cornerUv, 2));
  return geometry;
}

/** The triangles of a surface as placed, for picking: on the arrays that are there anyway. */
export function pickGeometry({
  places,
  triangles,
}: Pick<Surface, 'places' | 'triangles'>): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  return geometry.setIndex(new BufferAttribute(triangles, 1));
}

/** The map as a flat mesh; it needs no normals, because it is not lit. */
export function flatGeometry({
  cornerUv,
  box,
}: Pick<Solution, 'cornerUv' | 'box'>): BufferGeometry {
  const geometry = new BufferGeometry();
  const center = new Vector3(box.x + box.width / 2, box.y + box.height / 2, 0);
  geometry.boundingSphere = new Sphere(center, Math.hypot(box.width, box.height) / 2);
  const flat = new FlatAttribute(cornerUv);
  return geometry.setAttribute('position', flat).setAttribute('uv', flat);
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

/** A tree over at most so many corners is built when it is needed; larger ones come from the geometry worker. */
export const cornersAtOnce = 30_000;

const treeOptions = { indirect: true, targetLeafSize: 10 };

/** A tree over a small geometry, built synchronously; undefined if that would take long. */
export function bvhAtOnce(geometry: BufferGeometry): MeshBVH | undefined {
  const position = geometry.getAttribute('position');
  if ((geometry.index ?? position).count > cornersAtOnce) return undefined;
  if (position.itemSize === 3) return new MeshBVH(geometry, treeOptions);
  // A map: a tree over its two numbers per corner would have wrong boxes.
  const flat = new BufferAttribute(flatPositions(position.array), 3);
  const tree = new MeshBVH(new BufferGeometry().setAttribute('position', flat), treeOptions);
  const serialized = MeshBVH.serialize(tree, { cloneBuffers: false });
  return bvhFrom(serialized as unknown as SerializedBvh, geometry);
}
