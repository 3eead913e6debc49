// Orbiting with pointer and keys, framing, and keeping the view across runs.

import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const startFrom = new Vector3(0.5, 0.38, 0.78).normalize();

export class Orbit {
  readonly controls: OrbitControls;
  readonly #camera: PerspectiveCamera;
  #radius = 1;
  #center = new Vector3();
  #isTouched = false;

  constructor(camera: PerspectiveCamera, canvas: HTMLCanvasElement, onChange: () => void) {
    this.#camera = camera;
    this.controls = new OrbitControls(camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', onChange);
    this.controls.addEventListener('start', () => (this.#isTouched = true));
  }

  frame(center: Vector3, radius: number, keepDirection = false): void {
    this.#center = center.clone();
    this.#radius = radius || 1;
    this.#isTouched = false;
    const direction = keepDirection
      ? this.#camera.position.clone().sub(this.controls.target).normalize()
      : startFrom;
    this.#place(direction);
  }

  /** The view has another shape: fits again, unless someone has chosen where to look from. */
  reshaped(): void {
    if (!this.#isTouched) this.fit();
  }

  reset(): void {
    this.#place(startFrom);
  }

  fit(): void {
    this.#place(this.#camera.position.clone().sub(this.controls.target).normalize());
  }

  #place(direction: Vector3): void {
    const half = MathUtils.degToRad(this.#camera.fov / 2);
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.#camera.aspect));
    const distance = (1.12 * this.#radius) / Math.sin(narrow);
    this.controls.target.copy(this.#center);
    this.#camera.position.copy(direction).multiplyScalar(distance).add(this.#center);
    this.#camera.near = this.#radius / 200;
    this.#camera.far = distance + this.#radius * 40;
    this.#camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** Radians around and up; factor of the distance. */
  move(around: number, up: number, factor = 1): void {
    this.#isTouched = true;
    const { target } = this.controls;
    const offset = this.#camera.position.clone().sub(target);
    const at = new Spherical().setFromVector3(offset);
    at.theta += around;
    at.phi = MathUtils.clamp(at.phi + up, 0.05, Math.PI - 0.05);
    at.radius *= factor;
    this.#camera.position.setFromSpherical(at).add(target);
    this.controls.update();
  }

  /** Parts of the view's height. */
  pan(x: number, y: number): void {
    this.#isTouched = true;
    const { target } = this.controls;
    const distance = this.#camera.position.distanceTo(target);
    const height = 2 * distance * Math.tan(MathUtils.degToRad(this.#camera.fov / 2));
    const right = new Vector3().setFromMatrixColumn(this.#camera.matrix, 0);
    const up = new Vector3().setFromMatrixColumn(this.#camera.matrix, 1);
    const step = right.multiplyScalar(x * height).add(up.multiplyScalar(y * height));
    this.#camera.position.add(step);
    target.add(step);
    this.controls.update();
  }

  /** For the address of the page: position and target, rounded. */
  toText(): string {
    const all = [...this.#camera.position.toArray(), ...this.controls.target.toArray()];
    return all.map((x) => Number(x.toPrecision(5))).join(',');
  }
  fromText(text: string): void {
    const numbers = text.split(',').map(Number);
    if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return;
    this.#isTouched = true;
    this.#camera.position.fromArray(numbers);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
  }
}
