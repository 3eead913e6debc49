// A checker texture whose squares are one unit of (u, v) wide at scale 1.

import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
} from 'three';

const dark = [23, 50, 77];
const light = [245, 182, 66];

export function checkerTexture(): DataTexture {
  const size = 64;
  const texels = new Uint8Array(size * size * 4);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const isDark = x < size / 2 === y < size / 2;
      texels.set([...(isDark ? dark : light), 255], 4 * (y * size + x));
    }
  }
  const texture = new DataTexture(texels, size, size, RGBAFormat);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}
