// The shadow where a model stands: one textured square, computed when the model changes, so that it costs nothing to draw.

import {
  DataTexture,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  RGBAFormat,
} from 'three';
import { groundShadow, shadowCells } from '../services/geometry/shadow_map';

const darkest = 0.5;

export class ContactShadow extends Mesh<PlaneGeometry, MeshBasicMaterial> {
  #of?: ArrayLike<number>;

  constructor() {
    const geometry = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
    super(geometry, new MeshBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false })); // prettier-ignore
    this.renderOrder = -1;
    this.visible = false;
    this.frustumCulled = false;
  }

  /** Puts the shadow under a model; undefined: under none. It is seen from above only. */
  show(places: ArrayLike<number> | undefined): void {
    if (places === this.#of) return;
    this.#of = places;
    const shadow = places && groundShadow(places);
    this.visible = shadow !== undefined;
    this.material.map?.dispose();
    this.material.map = null;
    if (!shadow) return;
    const data = new Uint8Array(4 * shadowCells * shadowCells);
    // The first row of a texture is at the side of the square that is towards the viewer.
    for (let row = 0; row < shadowCells; row++) {
      for (let at = 0; at < shadowCells; at++) {
        const dark = shadow.dark[(shadowCells - 1 - row) * shadowCells + at];
        data[4 * (row * shadowCells + at) + 3] = Math.round(255 * darkest * dark);
      }
    }
    const texture = new DataTexture(data, shadowCells, shadowCells, RGBAFormat);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    this.material.map = texture;
    this.material.needsUpdate = true;
    this.position.set(shadow.x, shadow.y - 1e-3 * shadow.side, shadow.z);
    this.scale.set(shadow.side, 1, shadow.side);
  }
}
