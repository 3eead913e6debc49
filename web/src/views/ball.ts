// A ball around a geometry, for the order of drawing.

import { Sphere, Vector3, type BufferAttribute, type InterleavedBufferAttribute } from 'three';

/**
 * A ball around points; at the origin where some are not finite, as in files with defects, for which three.js would
 * write an error.
 */
export function ballAround(points: BufferAttribute | InterleavedBufferAttribute): Sphere {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const point = new Vector3();
  let off = 0; // NaN from the first number on that is not finite
  for (let i = 0; i < points.count; i++) {
    point.fromBufferAttribute(points, i);
    off += 0 * (point.x + point.y + point.z);
    low.min(point);
    high.max(point);
  }
  if (off !== 0 || points.count === 0) return new Sphere();
  return new Sphere(low.clone().add(high).multiplyScalar(0.5), low.distanceTo(high) / 2);
}
