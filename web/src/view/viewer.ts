// The 3D view. Draws on demand: nothing runs while nothing changes.

import {
  AmbientLight,
  Color,
  DirectionalLight,
  DoubleSide,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { checkerTexture } from './checker';
import { toGeometry, type TexturedMesh } from './geometry';

const tilesOnSurface = 150;

export class Viewer {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(35, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #checker = checkerTexture();
  readonly #canvas: HTMLCanvasElement;
  #mesh: Mesh | undefined;
  #isPending = false;

  constructor(canvas: HTMLCanvasElement) {
    this.#canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#scene.add(new AmbientLight(new Color('white'), 1.3));
    const light = new DirectionalLight(new Color('white'), 2.2);
    light.position.set(0.4, 0.8, 1);
    this.#camera.add(light);
    this.#scene.add(this.#camera);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.listenToKeyEvents(canvas);
    this.#controls.addEventListener('change', () => this.draw());
    new ResizeObserver(() => this.#resize()).observe(canvas);
  }

  /** Shows a mesh; keeps the camera when it is the same surface with other texture coordinates. */
  show(mesh: TexturedMesh, keepCamera = false): void {
    this.#mesh?.geometry.dispose();
    this.#mesh?.removeFromParent();
    const geometry = toGeometry(mesh, tilesOnSurface);
    const isTextured = geometry.hasAttribute('uv');
    this.#mesh = new Mesh(
      geometry,
      new MeshStandardMaterial({
        map: isTextured ? this.#checker : null,
        color: isTextured ? 0xffffff : 0x9fb3c8,
        roughness: 0.75,
        side: DoubleSide,
      }),
    );
    this.#scene.add(this.#mesh);
    if (!keepCamera) this.#frame();
    this.draw();
  }

  draw(): void {
    if (this.#isPending) return;
    this.#isPending = true;
    requestAnimationFrame(() => {
      this.#isPending = false;
      this.#renderer.render(this.#scene, this.#camera);
      this.#canvas.dataset.triangles = String(this.#renderer.info.render.triangles);
    });
  }

  #frame(): void {
    const geometry = this.#mesh?.geometry;
    geometry?.computeBoundingSphere();
    const sphere = geometry?.boundingSphere;
    if (!sphere) return;
    const radius = sphere.radius || 1;
    const distance = (1.1 * radius) / Math.sin((Math.PI / 180) * (this.#camera.fov / 2));
    this.#controls.target.copy(sphere.center);
    this.#camera.position.set(0.45, 0.35, 0.82).normalize().multiplyScalar(distance);
    this.#camera.position.add(sphere.center);
    this.#camera.near = distance / 100;
    this.#camera.far = distance * 100;
    this.#camera.updateProjectionMatrix();
    this.#controls.update();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    this.draw();
  }
}
