// Orbiting with pointer and keys, framing, and keeping the view across runs.

import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const usual = 32; // field of view in degrees
const parallel = 1; // so narrow that parallel lines look parallel
const glideTime = 150; // milliseconds
const wellInView = 0.8; // of the way from the centre of the view to its nearest edge

/** Three quarters from the front, which is +Z in glTF, and from above. */
const startFrom = new Vector3(0.5, 0.38, 0.78).normalize();
const margin = 1.16; // of the distance at which the model touches the edges: tools cover them
const maxPoints = 20_000; // of the model that framing looks at

/** What can be framed: a bounding sphere, and the coordinates of points. */
export interface Shape {
  center: Vector3;
  radius: number;
  places: ArrayLike<number>;
}

/** From where a point can be looked at, the nearest first: as vectors to the camera, as long as `back`, which is the present one. */
function sidesOf(normal: Vector3, back: Vector3): Vector3[] {
  if (normal.lengthSq() === 0) return [back];
  const isAway = normal.dot(back) < 0.15 * back.length();
  // Not straight from above, where the up direction is undefined.
  const front = normal.clone().addScaledVector(startFrom, 0.35);
  const isUpright = Math.abs(normal.y) > 0.9 * normal.length();
  const across = new Vector3(isUpright ? 1 : 0, isUpright ? 0 : 1, 0).cross(normal).normalize();
  const tilted = Array.from({ length: 8 }, (_, i) =>
    front.clone().addScaledVector(across.clone().applyAxisAngle(normal, (i * Math.PI) / 4), 1),
  );
  return [...(isAway ? [] : [back]), front, ...tilted].map((side) => side.setLength(back.length()));
}

export class Orbit {
  readonly controls: OrbitControls;
  readonly #camera: PerspectiveCamera;
  /** All that is drawn, and the part of it on which the user works. */
  #whole: Shape = { center: new Vector3(), radius: 1, places: [] };
  #part = this.#whole;
  /** Which of them is shown as large as it fits. */
  #framed = this.#whole;
  #isTouched = false;

  constructor(camera: PerspectiveCamera, canvas: HTMLCanvasElement, onChange: () => void) {
    this.#camera = camera;
    this.controls = new OrbitControls(camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    let isHeld = false;
    this.controls.addEventListener('change', () => {
      this.#isTouched ||= isHeld; // a click alone moves nothing
      this.#setDepth();
      onChange();
    });
    this.controls.addEventListener('start', () => (isHeld = true));
    this.controls.addEventListener('end', () => (isHeld = false));
  }

  /** Shows a model as large as it fits. */
  frame(whole: Shape, part = whole): void {
    this.#whole = this.#framed = { ...whole, radius: whole.radius || 1 };
    this.#part = part;
    this.#isTouched = false;
    this.#place(startFrom);
  }

  /** Another part of the same model: the camera stays. */
  workOn(part: Shape): void {
    this.#part = part;
  }

  /** Fits the model again after the view's shape has changed, unless the user has moved the camera. */
  reshaped(): void {
    if (!this.#isTouched) this.#place(this.#direction);
  }

  /** All of the model, as it was shown at first. */
  reset(): void {
    this.#framed = this.#whole;
    this.#isTouched = false;
    this.#place(startFrom);
  }

  /** The part on which the user works, from where the camera is. */
  fit(): void {
    this.#framed = this.#part;
    this.#isTouched = false;
    this.#place(this.#direction);
  }

  get #direction(): Vector3 {
    return this.#camera.position.clone().sub(this.controls.target).normalize();
  }

  #place(direction: Vector3): void {
    const { target, distance } = this.#fitted(direction);
    this.controls.target.copy(target);
    this.#camera.position.copy(direction).multiplyScalar(distance).add(target);
    this.controls.update();
    this.#setDepth();
  }

  /** Where to look, and from how far, so that all points are in the view and as much room is left as right. */
  #fitted(direction: Vector3): { target: Vector3; distance: number } {
    const right = new Vector3(0, 1, 0).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const high = Math.tan(MathUtils.degToRad(this.#camera.fov / 2));
    const wide = high * this.#camera.aspect;
    const { center, radius, places } = this.#framed;
    const target = center.clone();
    const point = new Vector3();
    const step = 3 * Math.max(1, Math.ceil(places.length / 3 / maxPoints));
    let distance = (radius * margin) / Math.sin(Math.atan(Math.min(high, wide)));
    // The picture is centred for one distance, and the distance found for that centre, in turn.
    for (let round = 0; round < 3 && places.length > 0; round++) {
      const [low, far] = [new Vector3(Infinity, Infinity), new Vector3(-Infinity, -Infinity)];
      let nearest = 0;
      for (let i = 0; i < places.length; i += step) {
        point.set(places[i], places[i + 1], places[i + 2]).sub(target);
        const [x, y, z] = [point.dot(right), point.dot(up), point.dot(direction)];
        if (!Number.isFinite(x + y + z)) continue;
        nearest = Math.max(nearest, z + Math.abs(x) / wide, z + Math.abs(y) / high);
        const depth = Math.max(distance - z, 1e-3 * distance);
        low.min(point.set(x / depth, y / depth, 0));
        far.max(point);
      }
      if (nearest > 0) distance = nearest * margin;
      if (round === 2) break;
      target.addScaledVector(right, (distance * (low.x + far.x)) / 2);
      target.addScaledVector(up, (distance * (low.y + far.y)) / 2);
    }
    return { target, distance };
  }

  #setDepth(): void {
    const distance = this.#camera.position.distanceTo(this.controls.target);
    this.#camera.near = Math.max(this.#whole.radius / 200, distance - this.#whole.radius * 40);
    this.#camera.far = distance + this.#whole.radius * 40;
    this.#camera.updateProjectionMatrix();
  }

  get isParallel(): boolean {
    return this.#camera.fov < usual;
  }

  /** Switches parallel projection on or off; the apparent size at the centre does not change. */
  toggleParallel(): void {
    const isOn = !this.isParallel;
    const before = Math.tan(MathUtils.degToRad(this.#camera.fov / 2));
    this.#camera.fov = isOn ? parallel : usual;
    const factor = before / Math.tan(MathUtils.degToRad(this.#camera.fov / 2));
    const { target } = this.controls;
    this.#camera.position.sub(target).multiplyScalar(factor).add(target);
    this.#setDepth();
    this.controls.update();
  }

  /** How much nearer lines are drawn, chosen so that their depth offset is the same for any field of view. */
  get lift(): number {
    const tangent = (degrees: number): number => Math.tan(MathUtils.degToRad(degrees / 2));
    return (0.003 * tangent(this.#camera.fov)) / tangent(usual);
  }

  /**
   * Centres a point, animated unless reduced motion is preferred; moves around the model if the point faces away or is
   * hidden, where it is not hidden from everywhere.
   * @param isCentred  false: the centre of the view stays where the point is well in view without that
   */
  lookAt(
    point: Vector3,
    normal: Vector3,
    isHidden: (back: Vector3) => boolean = () => false,
    isCentred = true,
  ): void {
    const { target } = this.controls;
    const sides = sidesOf(normal, this.#camera.position.clone().sub(target));
    const toCamera = (side: Vector3): Vector3 => target.clone().add(side).sub(point);
    const around = (side: Vector3): boolean =>
      this.#isWellInView(toCamera(side), side) && !isHidden(toCamera(side));
    const still = isCentred ? undefined : sides.find(around);
    const wanted = still ?? sides.find((side) => !isHidden(side)) ?? sides[0];
    this.#glideTo(still ? target.clone() : point, wanted);
  }

  /** Whether a point is well inside the view of a camera that is `toCamera` from it and looks against `side`. */
  #isWellInView(toCamera: Vector3, side: Vector3): boolean {
    const depth = toCamera.dot(side) / side.length();
    const aside = Math.sqrt(Math.max(0, toCamera.lengthSq() - depth * depth));
    const high = Math.tan(MathUtils.degToRad(this.#camera.fov / 2));
    return aside < wellInView * depth * high * Math.min(1, this.#camera.aspect);
  }

  /** Moves the centre of the view to `to`, and the camera to `back` from there. */
  #glideTo(to: Vector3, back: Vector3): void {
    const { position } = this.#camera;
    const { target } = this.controls;
    const aim = to.clone().sub(target);
    const move = to.clone().add(back).sub(position);
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const begin = performance.now();
    let done = 0;
    const go = (): void => {
      const part = isStill ? 1 : Math.min(1, (performance.now() - begin) / glideTime);
      target.addScaledVector(aim, part - done);
      position.addScaledVector(move, part - done);
      done = part;
      this.controls.update();
      if (part < 1) requestAnimationFrame(go);
    };
    go();
  }

  /** Orbits by radians around and up, and multiplies the distance by `factor`. */
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

  /** Pans by fractions of the view's height. */
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

  /** Position and target, rounded, for the address of the page. */
  toText(): string {
    const all = [...this.#camera.position.toArray(), ...this.controls.target.toArray()];
    return all.map((x) => Number(x.toPrecision(5))).join(',');
  }
  fromText(text: string): void {
    // An empty word would be the number 0.
    const numbers = text.split(',').map((word) => (word.trim() === '' ? NaN : Number(word)));
    if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return;
    this.#isTouched = true;
    this.#camera.position.fromArray(numbers);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
  }
}
