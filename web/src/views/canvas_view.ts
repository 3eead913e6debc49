// A canvas with a scene that is drawn only when something has changed; and what happens when the
// graphics card takes it away.

import { Color, type Object3D, Scene, WebGLRenderer, type Camera } from 'three';
import { SlicedUploads } from './sliced_uploads';

/** The frame in which some stage has been drawn: the other one waits, so that each task is short. */
let lastFrame = -1;

export interface Hit {
  triangle: number;
  vertex: number;
  /** From the pointer to the vertex, in CSS pixels. */
  pixels: number;
}

export abstract class CanvasView {
  readonly canvas: HTMLCanvasElement;
  readonly scene = new Scene();
  readonly renderer: WebGLRenderer;
  abstract readonly camera: Camera;
  /** Told when the picture is lost, and when it is back. */
  onContext?: (isLost: boolean) => void;
  readonly #uploads: SlicedUploads;
  #isPending = false;
  #isLost = false;
  #before: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#uploads = new SlicedUploads(this.renderer.getContext() as WebGL2RenderingContext);
    // Asking whether a program compiled waits until it has; nobody could act on the answer.
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(new Color(0), 0);
    new ResizeObserver(() => this.resize()).observe(canvas);
    // Prevented, so that the browser gives the context back as soon as it can; the renderer then
    // makes everything anew by itself.
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

  /** Something that must be up to date in every picture. */
  beforeDraw(step: () => void): void {
    this.#before.push(step);
  }

  /**
   * Draws one of each thing once, before any is needed: compiling the programs of the graphics card
   * takes long, and would hold the page up in the middle of a run. Nobody waits for it here, either.
   */
  async warm(things: Object3D[]): Promise<void> {
    const scene = new Scene();
    scene.add(...things);
    for (const thing of things) {
      thing.frustumCulled = false;
      thing.position.z = -1;
    }
    await this.renderer.compileAsync(scene, this.camera);
    if (this.canvas.clientWidth > 0) return; // someone is quicker: what is shown stays
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
      // What is drawn before all of it is there would be thrown away.
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

  /** Position of a pointer as WebGL counts it: −1 … 1. */
  pointer(event: { clientX: number; clientY: number }): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: (2 * (event.clientX - box.left)) / box.width - 1,
      y: 1 - (2 * (event.clientY - box.top)) / box.height,
    };
  }
}
