// The light of the 3D view: a studio of soft lamps, given by one function of the direction. Materials of a glTF are lit
// by it as an environment map, the patterns by its irradiance in spherical harmonics (Ramamoorthi and Hanrahan 2001),
// so that both look as if they stood in the same room. The room turns with the camera: no side is ever dark.

import {
  type Camera,
  DataTexture,
  DataUtils,
  EquirectangularReflectionMapping,
  HalfFloatType,
  LinearFilter,
  type Matrix3,
  Matrix4,
  NeutralToneMapping,
  PMREMGenerator,
  RGBAFormat,
  type Scene,
  type Vector3,
  type WebGLRenderer,
} from 'three';

type Direction = readonly [number, number, number];

interface Lamp {
  /** From the model to the lamp: +x is right, +y up, +z towards the viewer. */
  towards: Direction;
  radiance: number;
  /** The lobe is exp(sharpness (cos − 1)). */
  sharpness: number;
}

const unit = ([x, y, z]: Direction): Direction => {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
};

const lamps: Lamp[] = [
  { towards: unit([0.6, 0.7, 0.6]), radiance: 2.6, sharpness: 10 },
  { towards: unit([0.6, 0.7, 0.6]), radiance: 5, sharpness: 120 }, // its core, which metals show
  { towards: unit([-0.55, 0.05, 0.85]), radiance: 0.75, sharpness: 3 },
  { towards: unit([-0.35, 0.55, -0.85]), radiance: 0.9, sharpness: 7 },
];
const floor = 0.15;
const ceiling = 0.4;
/**
 * How much brighter materials are lit than patterns: these have no tone mapping and would lose their shape in white. With
 * it, own materials had 92 to 95 % of the mean luminance that they have in <model-viewer> with its neutral environment
 * (two models); the core of the lamp and the darker floor have changed that by −1 %, of polished metal by −6 %.
 */
const exposure = 1.5;

/** From a direction, given by a unit vector. */
export function radiance(x: number, y: number, z: number): number {
  const height = Math.min(1, Math.max(0, (y + 0.7) / 1.6));
  let sum = floor + (ceiling - floor) * height * height * (3 - 2 * height);
  for (const { towards, radiance: peak, sharpness } of lamps) {
    const cosine = x * towards[0] + y * towards[1] + z * towards[2];
    sum += peak * Math.exp(sharpness * (cosine - 1));
  }
  return sum;
}

const sideways = 1.1; // radians

const [width, height] = [512, 256];

/** Calls with the direction and the solid angle of each pixel of the equirectangular picture, by rows from below. */
function forEachPixel(visit: (x: number, y: number, z: number, area: number) => void): void {
  for (let row = 0; row < height; row++) {
    const up = ((row + 0.5) / height - 0.5) * Math.PI;
    const area = ((Math.PI / height) * 2 * Math.PI * Math.cos(up)) / width;
    for (let column = 0; column < width; column++) {
      const around = ((column + 0.5) / width - 0.5) * 2 * Math.PI;
      const [x, z] = [Math.cos(around) * Math.cos(up), Math.sin(around) * Math.cos(up)];
      visit(x, Math.sin(up), z, area);
    }
  }
}

/** What is reflected by a white matte surface: the sum of these times the terms in `reflected` of the pattern shader. */
export const irradiance: readonly number[] = (() => {
  const sums = new Array<number>(9).fill(0);
  forEachPixel((x, y, z, area) => {
    const light = radiance(x, y, z) * area;
    const basis = [1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y];
    basis.forEach((value, i) => (sums[i] += light * value));
  });
  // The squared norms of the basis, times the factors 1, 2/3, 1/4 by which a matte surface blurs each band.
  const [first, second] = [1 / (4 * Math.PI), (2 / 3) * (3 / (4 * Math.PI))];
  const [third, middle, last] = [15, 5 / 4, 15 / 4].map((n) => (1 / 4) * (n / (4 * Math.PI)));
  const factors = [first, second, second, second, third, third, middle, third, last];
  return sums.map((sum, i) => sum * factors[i]);
})();

function picture(): DataTexture {
  const data = new Uint16Array(4 * width * height);
  let at = 0;
  forEachPixel((x, y, z) => {
    const value = DataUtils.toHalfFloat(radiance(x, y, z));
    data.set([value, value, value, DataUtils.toHalfFloat(1)], at);
    at += 4;
  });
  const texture = new DataTexture(data, width, height, RGBAFormat, HalfFloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The studio of one scene. */
export class StudioLight {
  readonly #renderer: WebGLRenderer;
  readonly #scene: Scene;
  readonly #toStudio: Matrix3;

  /** `toStudio` is set to the rotation from the coordinates of the eye, for patterns. */
  constructor(renderer: WebGLRenderer, scene: Scene, toStudio: Matrix3) {
    this.#renderer = renderer;
    this.#scene = scene;
    this.#toStudio = toStudio;
    renderer.toneMapping = NeutralToneMapping; // of materials, not of patterns
  }

  /** Turns the studio, so that the strongest lamp is at the side. */
  set isFromSide(isOn: boolean) {
    this.#turned = isOn ? sideways : 0;
  }
  #turned = 0;

  /** Lights materials. */
  lightMaterials(): void {
    if (this.#scene.environment) return;
    const generator = new PMREMGenerator(this.#renderer);
    const source = picture();
    this.#scene.environment = generator.fromEquirectangular(source).texture;
    this.#scene.environmentIntensity = exposure;
    source.dispose();
    generator.dispose();
  }

  /** After the loss of the context, textures that were drawn are empty. */
  restore(): void {
    if (!this.#scene.environment) return;
    this.#scene.environment = null;
    this.lightMaterials();
  }

  /** The studio follows the camera around its target, but stays upright. */
  turn(camera: Camera, target: Vector3): void {
    const back = camera.position.clone().sub(target);
    const around = Math.atan2(back.x, back.z) + this.#turned;
    this.#scene.environmentRotation.set(0, around, 0);
    const eye = new Matrix4().makeRotationY(-around).multiply(camera.matrixWorld);
    this.#toStudio.setFromMatrix4(eye);
  }
}
