// From which sides a point of the surface can be seen.

import { Ray, type Vector3 } from 'three';

/** Rays begin at this fraction of the way to the camera, so that the triangles around the point are not in front of it. */
const start = 0.01;

/**
 * Whether something hides a point from a camera at `back` from it.
 * @param firstHit  the distance along a ray to the nearest surface; undefined: none
 */
export function hiding(
  point: Vector3,
  firstHit: (ray: Ray) => number | undefined,
): (back: Vector3) => boolean {
  return (back) => {
    const ray = new Ray(point.clone().addScaledVector(back, start), back.clone().normalize());
    return (firstHit(ray) ?? Infinity) < (1 - start) * back.length();
  };
}
