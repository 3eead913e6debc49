// Cones as markers of constant size: number inside, shape by sign. ▲ below a full turn, ▼ above.

import { CanvasTexture, Group, Sprite, SpriteMaterial, SRGBColorSpace, type Vector3 } from 'three';

export interface Marker {
  at: Vector3;
  k: number;
  q: number;
  isSelected: boolean;
  isBad: boolean;
}

const size = 96;
const textures = new Map<string, CanvasTexture>();

function drawShape(context: CanvasRenderingContext2D, sign: number): void {
  const middle = size / 2;
  const r = size * 0.46;
  context.beginPath();
  if (sign === 0) context.arc(middle, middle, r * 0.78, 0, 2 * Math.PI);
  else {
    for (let i = 0; i < 3; i++) {
      const turn = (2 * Math.PI * i) / 3 + (sign > 0 ? -1 : 1) * (Math.PI / 2);
      const y = middle + sign * size * 0.1;
      context.lineTo(middle + r * Math.cos(turn), y + r * Math.sin(turn));
    }
    context.closePath();
  }
}

function textureOf({ k, q, isSelected, isBad }: Marker): CanvasTexture {
  const sign = Math.sign(q - k);
  const key = `${k} ${sign} ${isSelected} ${isBad}`;
  const known = textures.get(key);
  if (known) return known;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d')!;
  drawShape(context, sign);
  context.lineJoin = 'round';
  context.lineWidth = isSelected ? 15 : 9;
  context.strokeStyle = isSelected ? '#ffffff' : '#10161c';
  context.stroke();
  const plain = sign > 0 ? '#ffc23d' : sign < 0 ? '#58b4ff' : '#c9d2db';
  context.fillStyle = isBad ? '#ff7a6e' : plain;
  context.fill();
  if (isSelected) {
    context.lineWidth = 5;
    context.strokeStyle = '#10161c';
    context.stroke();
  }
  context.fillStyle = '#10161c';
  context.font = `700 ${k > 9 ? 30 : 38}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(String(k), size / 2, size / 2 + sign * size * 0.08);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  textures.set(key, texture);
  return texture;
}

export class Markers extends Group {
  /** Height on screen as a part of the view's height. */
  #scale = 0.05;

  show(markers: Marker[], pixels: number, hasDepth: boolean): void {
    this.#clear();
    for (const marker of markers) {
      const map = textureOf(marker);
      // Once where it can be seen, once faintly through the surface.
      for (const isHidden of hasDepth ? [true, false] : [false]) {
        const material = new SpriteMaterial({
          map,
          sizeAttenuation: false,
          depthTest: hasDepth && !isHidden,
          depthWrite: false,
          opacity: isHidden ? 0.22 : 1,
        });
        const sprite = new Sprite(material);
        sprite.position.copy(marker.at);
        sprite.userData.at = marker.at;
        sprite.renderOrder = isHidden ? 5 : 10;
        sprite.userData.size = marker.isSelected ? 1.25 : 1;
        this.add(sprite);
      }
    }
    this.resize(pixels);
  }

  /** `pixels`: part of the view's height that one marker takes, in the camera's own measure. */
  resize(pixels: number): void {
    this.#scale = pixels;
    for (const sprite of this.children) sprite.scale.setScalar(this.#scale * sprite.userData.size);
  }

  /** Lifts markers towards the eye, so that the surface around them does not cut into them. */
  lift(eye: Vector3, by: number): void {
    for (const sprite of this.children) {
      const at = sprite.userData.at as Vector3;
      sprite.position.copy(eye).sub(at).setLength(by).add(at);
    }
  }

  #clear(): void {
    for (const sprite of this.children) (sprite as Sprite).material.dispose();
    this.clear();
  }
}
