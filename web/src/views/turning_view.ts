// A textured model that turns slowly. There is one for the lifetime of the page: releasing a WebGL context blocks
// the main thread until the graphics card has finished its work.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  type Matrix3,
  Mesh,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { setPalette, setPattern, surfaceMaterial } from './pattern_material';

const turnTime = 40_000; // milliseconds for one turn
const tiles = 1; // of the pattern per unit of uv

export class TurningView {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(28, 1, 0.1, 100);
  readonly #mesh = new Mesh(new BufferGeometry(), surfaceMaterial(true));
  readonly #observer: ResizeObserver;
  readonly #stillness = matchMedia('(prefers-reduced-motion: reduce)');
  readonly canvas = document.createElement('canvas');
  #frame = 0;
  #isTurning = false;

  constructor() {
    const { canvas } = this;
    canvas.className = 'turning';
    canvas.ariaHidden = 'true';
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#scene.add(this.#mesh);
    const { material } = this.#mesh;
    setPattern(material, 'plaid', { q: 4, scale: tiles, isAligned: true });
    setPalette(material, {
      paper: new Color('#e9edf2'),
      ink: new Color('#1d3f63'),
      second: new Color('#f3b63f'),
    });
    this.#observer = new ResizeObserver(() => this.#resize());
    this.#observer.observe(canvas);
  }

  /** Loads a file: vertex and index counts, then positions, normals and uv per vertex, then triangles. */
  async load(url: string): Promise<void> {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    const data = await response.arrayBuffer();

    const [vertices, corners] = new Uint32Array(data, 0, 2);
    const geometry = this.#mesh.geometry;
    let at = 8;
    for (const [name, width] of [
      ['position', 3],
      ['normal', 3],
      ['uv', 2],
    ] as const) {
      const values = new Float32Array(data, at, width * vertices);
      geometry.setAttribute(name, new BufferAttribute(values, width));
      at += values.byteLength;
    }
    geometry.setAttribute('tint', new BufferAttribute(new Uint8Array(4 * vertices), 4, true));
    geometry.setIndex(new BufferAttribute(new Uint32Array(data, at, corners), 1));
    geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere!;
    this.#mesh.position.copy(center).negate();
    this.#camera.position
      .set(0, 0.55, 1)
      .setLength((0.94 * radius) / Math.sin((14 * Math.PI) / 180));
    this.#camera.lookAt(0, 0, 0);
    this.#camera.updateMatrixWorld();
    const { toStudio } = this.#mesh.material.uniforms;
    (toStudio.value as Matrix3).setFromMatrix4(this.#camera.matrixWorld);
    this.#resize();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#renderer.domElement;
    if (width === 0 || height === 0 || !this.#isTurning) return;
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    cancelAnimationFrame(this.#frame);
    this.#draw();
  }

  #draw(): void {
    const isStill = this.#stillness.matches;
    this.#scene.rotation.y = isStill
      ? 0.6
      : (2 * Math.PI * (performance.now() % turnTime)) / turnTime;
    this.#renderer.render(this.#scene, this.#camera);
    if (this.#mesh.geometry.index) this.#renderer.domElement.dataset.drawn = '';
    if (!isStill && this.#isTurning) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  start(): void {
    this.#isTurning = true;
    this.#resize();
  }

  stop(): void {
    this.#isTurning = false;
    cancelAnimationFrame(this.#frame);
  }
}
