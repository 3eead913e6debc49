// A canvas with a scene that is drawn only when something has changed; handles the loss of the WebGL
// context.

import { Color, type Object3D, Scene, WebGLRenderer, type Camera } from 'three';
import { SlicedUploads } from './sliced_uploads';

/** The frame in which a view was last drawn: the other view waits for the next, so that each task is short. */
let lastFrame = -1;

export interface Hit {
  triangle: number;
  vertex: number;
  /** Distance from the pointer to the vertex, in CSS pixels. */
  pixels: number;
}

export abstract class CanvasView {
  readonly canvas: HTMLCanvasElement;
  readonly scene = new Scene();
  readonly renderer: WebGLRenderer;
  abstract readonly camera: Camera;
  /** Called when the context is lost and when it is restored. */
  onContext?: (isLost: boolean) => void;
  readonly #uploads: SlicedUploads;
  #isPending = false;
  #isLost = false;
  #before: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#uploads = new SlicedUploads(this.renderer.getContext() as WebGL2RenderingContext);
    // Checking for errors waits until a program is compiled, and users could not act on the result.
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(new Color(0), 0);
    new ResizeObserver(() => this.resize()).observe(canvas);
    // Prevented, so that the browser restores the context as soon as it can; the renderer then
    // recreates everything itself.
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#uploads.forget();
      this.#isLost = true;
      this.onContext?.(true);
    });
    canvas.addEventListener('webglcontextrestored', () => {
      this.#isLost = false;
      this.onContext?.(false);
      this.draw();
    });
  }

  /** Adds a step that is executed before every drawing. */
  beforeDraw(step: () => void): void {
    this.#before.push(step);
  }

  /**
   * Draws one object of each kind in advance: compiling shader programs takes long and would otherwise block the
   * page in the middle of a run. Asynchronous.
   */
  async warm(things: Object3D[]): Promise<void> {
    const scene = new Scene();
    scene.add(...things);
    for (const thing of things) {
      thing.frustumCulled = false;
      thing.position.z = -1;
    }
    await this.renderer.compileAsync(scene, this.camera);
    if (this.canvas.clientWidth > 0) return; // the view is already visible and must not change
    this.renderer.setSize(16, 16, false);
    this.renderer.render(scene, this.camera);
    this.renderer.clear();
    this.resize();
  }

  draw(): void {
    if (this.#isPending) return;
    this.#isPending = true;
    this.canvas.dataset.pending = '';
    const frame = (time: number): void => {
      if (time === lastFrame) {
        requestAnimationFrame(frame);
        return;
      }
      lastFrame = time;
      this.#isPending = false;
      delete this.canvas.dataset.pending;
      if (this.canvas.clientWidth === 0 || this.#isLost) return;
      // A drawing made before everything is uploaded would be discarded.
      if (this.#uploads.isBusy) {
        this.#uploads.step();
        return this.draw();
      }
      for (const step of this.#before) step();
      this.render();
      if (this.#uploads.isBusy) this.draw();
      this.canvas.dataset.triangles = String(this.renderer.info.render.triangles);
      this.canvas.dataset.frames = String(this.renderer.info.render.frame);
    };
    requestAnimationFrame(frame);
  }

  protected render(): void {
    this.renderer.render(this.scene, this.camera);
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.onResize(clientWidth, clientHeight);
    this.draw();
  }

  protected abstract onResize(width: number, height: number): void;

  /** Position of a pointer in normalised device coordinates, −1 … 1. */
  pointer(event: { clientX: number; clientY: number }): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: (2 * (event.clientX - box.left)) / box.width - 1,
      y: 1 - (2 * (event.clientY - box.top)) / box.height,
    };
  }
}
