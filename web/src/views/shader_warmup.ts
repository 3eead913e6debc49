// One object of each kind that the views draw.

import { BufferAttribute, BufferGeometry, Color, Mesh, type Object3D } from 'three';
import { ContactShadow } from './contact_shadow';
import { Lines, Wire } from './lines';
import { ConeMarkers } from './cone_markers';
import { setPattern, surfaceMaterial } from './pattern_material';

export function oneOfEach(isLit: boolean): Object3D[] {
  const geometry = new BufferGeometry();
  // The flat map has no normals, so the same material has a different shader program for it.
  const sizes = { position: 3, uv: 2, tint: 4, ...(isLit ? { normal: 3 } : {}) };
  for (const [name, size] of Object.entries(sizes)) {
    const values = Float32Array.from({ length: 3 * size }, (_, i) => (i * 0.37) % 1);
    geometry.setAttribute(name, new BufferAttribute(values, size));
  }
  const places = [1, 2, 3, 4, 5, 7]; // any two
  const lines = new Lines(2);
  lines.set(places, new Color());
  const wire = new Wire(1, isLit);
  wire.set(geometry, new Color());
  const markers = new ConeMarkers(isLit);
  markers.show([{ at: [1, 2, 3], k: 1, q: 4, isSelected: false, isBad: false }]);
  const mapped = surfaceMaterial(isLit);
  setPattern(mapped, 'checker', { q: 4, scale: 1, isAligned: false });
  const surfaces = [surfaceMaterial(isLit), mapped].map((one) => new Mesh(geometry, one));
  const all = [...surfaces, lines, wire, markers];
  if (!isLit) return all;
  const shadow = new ContactShadow();
  shadow.show(places);
  return [...all, shadow];
}
