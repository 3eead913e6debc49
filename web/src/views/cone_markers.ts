// Cones as markers of constant size with a number inside; the shape shows the sign: ▲ for angles below a full turn,
// ▼ above. All markers are one mesh with one texture.

import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  GLSL3,
  Group,
  Mesh,
  ShaderMaterial,
  SRGBColorSpace,
  Vector2,
  type WebGLRenderer,
} from 'three';

export interface Marker {
  at: [number, number, number];
  k: number;
  q: number;
  isSelected: boolean;
  isBad: boolean;
}

const side = 64; // pixels of one picture in the atlas
const columns = 16;
const rows = 16;

/** The pictures of the markers used last, each drawn once. */
class Atlas {
  readonly texture: CanvasTexture;
  readonly #context: CanvasRenderingContext2D;
  /** By kind, the one that was used last at the end. */
  readonly #cells = new Map<string, number>();

  constructor() {
    const canvas = document.createElement('canvas');
    canvas.width = side * columns;
    canvas.height = side * rows;
    this.#context = canvas.getContext('2d')!;
    this.texture = new CanvasTexture(canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.premultiplyAlpha = true;
  }

  cellOf({ k, q, isSelected, isBad }: Marker): number {
    const sign = Math.sign(q - k);
    const key = `${k} ${sign} ${isSelected} ${isBad}`;
    const known = this.#cells.get(key);
    const cell = known ?? this.#freeCell();
    this.#cells.delete(key);
    this.#cells.set(key, cell);
    if (known !== undefined) return known;
    this.#draw(cell, k, sign, isSelected, isBad);
    this.texture.needsUpdate = true;
    return cell;
  }

  /** Beyond 256 kinds, that of the one which has not been used for the longest time. */
  #freeCell(): number {
    if (this.#cells.size < columns * rows) return this.#cells.size;
    const [[oldest, cell]] = this.#cells;
    this.#cells.delete(oldest);
    return cell;
  }

  #shape(sign: number): void {
    const context = this.#context;
    const r = side * 0.42;
    context.beginPath();
    if (sign === 0) context.arc(0, 0, r * 0.8, 0, 2 * Math.PI);
    else {
      for (let i = 0; i < 3; i++) {
        const turn = (2 * Math.PI * i) / 3 + (sign > 0 ? -1 : 1) * (Math.PI / 2);
        context.lineTo(r * Math.cos(turn), sign * side * 0.1 + r * Math.sin(turn));
      }
      context.closePath();
    }
  }

  #draw(cell: number, k: number, sign: number, isSelected: boolean, isBad: boolean): void {
    const context = this.#context;
    context.save();
    context.translate(((cell % columns) + 0.5) * side, (Math.floor(cell / columns) + 0.5) * side);
    context.clearRect(-side / 2, -side / 2, side, side);
    this.#shape(sign);
    context.lineJoin = 'round';
    // A light rim around the dark one: seen on every background.
    context.lineWidth = 10;
    context.strokeStyle = isSelected ? '#ffffff' : 'rgb(255 255 255 / 75%)';
    context.stroke();
    if (!isSelected) {
      context.lineWidth = 6;
      context.strokeStyle = '#10161c';
      context.stroke();
    }
    const plain = sign > 0 ? '#ffc23d' : sign < 0 ? '#58b4ff' : '#c9d2db';
    context.fillStyle = isBad ? '#ff7a6e' : plain;
    context.fill();
    if (isSelected) {
      context.lineWidth = 3.5;
      context.strokeStyle = '#10161c';
      context.stroke();
    }
    context.fillStyle = '#10161c';
    context.font = `700 ${k > 9 ? 20 : 26}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(String(k), 0, sign * side * 0.08);
    context.restore();
  }
}

let shared: Atlas | undefined;

const vertexShader = /* glsl */ `
in vec2 corner;
in vec3 look; // column and row in the atlas, size
uniform vec2 size; // of the view, in pixels
uniform float pixels;
uniform float lift; // towards the eye, so that the surface around does not cut into it
out vec2 at;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  if (projectionMatrix[2][3] == -1.0) eye.xyz *= 1.0 - min(0.5, lift / max(length(eye.xyz), 1e-9));
  gl_Position = projectionMatrix * eye;
  gl_Position.xy += corner * look.z * pixels / size * gl_Position.w;
  at = vec2((look.x + 0.5 + 0.5 * corner.x) / ${columns}.0, 1.0 - (look.y + 0.5 - 0.5 * corner.y) / ${rows}.0);
}`;

const fragmentShader = /* glsl */ `
in vec2 at;
uniform sampler2D atlas;
uniform float opacity;
layout(location = 0) out vec4 seen;
void main() {
  vec4 colour = texture(atlas, at);
  if (colour.a < 0.02) discard;
  seen = linearToOutputTexel(vec4(colour.rgb / colour.a, 1.0));
  seen.a = colour.a * opacity;
}`;

function materialOf(hasDepth: boolean): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    transparent: true,
    depthTest: hasDepth,
    depthWrite: false,
    uniforms: {
      size: { value: new Vector2(1, 1) },
      pixels: { value: 1 },
      lift: { value: 0 },
      opacity: { value: 1 },
      atlas: { value: null },
    },
  });
}

const corners = [-1, -1, 1, -1, 1, 1, -1, 1];

function geometryOf(markers: Marker[], atlas: Atlas): BufferGeometry {
  const position = new Float32Array(12 * markers.length);
  const corner = new Float32Array(8 * markers.length);
  const look = new Float32Array(12 * markers.length);
  const index = new Uint32Array(6 * markers.length);
  markers.forEach((marker, m) => {
    const cell = atlas.cellOf(marker);
    corner.set(corners, 8 * m);
    index.set(
      [0, 1, 2, 0, 2, 3].map((i) => 4 * m + i),
      6 * m,
    );
    for (let v = 4 * m; v < 4 * m + 4; v++) {
      position.set(marker.at, 3 * v);
      const grown = marker.isSelected ? 1.25 : 1;
      look.set([cell % columns, Math.floor(cell / columns), grown], 3 * v);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('corner', new BufferAttribute(corner, 2));
  geometry.setAttribute('look', new BufferAttribute(look, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

const usual = 30; // CSS pixels

export class ConeMarkers extends Group {
  readonly #meshes: Mesh<BufferGeometry, ShaderMaterial>[];

  /** `hasDepth`: markers behind the surface are drawn faintly. */
  constructor(hasDepth: boolean, order = 10) {
    super();
    const kinds = hasDepth ? [false, true] : [false];
    this.#meshes = kinds.map((isTested, i) => {
      const mesh = new Mesh(new BufferGeometry(), materialOf(isTested));
      mesh.renderOrder = order + i;
      mesh.frustumCulled = false;
      mesh.onBeforeRender = (renderer: WebGLRenderer) =>
        renderer.getSize(mesh.material.uniforms.size.value as Vector2);
      this.add(mesh);
      return mesh;
    });
    this.setStyle(1, 1);
  }

  show(markers: Marker[]): void {
    shared ??= new Atlas();
    const atlas = shared;
    const geometry = geometryOf(markers, atlas);
    this.#meshes[0].geometry.dispose();
    for (const mesh of this.#meshes) {
      mesh.geometry = geometry;
      mesh.material.uniforms.atlas.value = atlas.texture;
    }
    this.visible = markers.length > 0;
  }

  /** Sets the size, relative to the default, and the opacity. */
  setStyle(scale: number, opacity: number): void {
    const isLayered = this.#meshes.length > 1;
    this.#meshes.forEach(({ material }, i) => {
      material.uniforms.pixels.value = usual * scale;
      material.uniforms.opacity.value = isLayered && i === 0 ? 0.2 * opacity : opacity;
    });
  }

  setLift(by: number): void {
    for (const { material } of this.#meshes) material.uniforms.lift.value = by;
  }
}
