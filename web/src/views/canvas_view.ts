// A canvas with a scene that is drawn only when something has changed; handles the loss of the WebGL
// context.

import { Color, type Object3D, Scene, Vector2, WebGLRenderer, type Camera } from 'three';
import { SlicedUploads } from './sliced_uploads';

/** Pixels of a picture per CSS pixel. */
const maxEnlarged = 6;

/** The frame in which a view was last drawn: the other view waits for the next, so that each task is short. */
let lastFrame = -1;
const stages = new Set<CanvasView>();

export interface Hit {
  triangle: number;
  vertex: number;
  /** Distance from the pointer to the vertex, in CSS pixels. */
  pixels: number;
}

/** The corner of a triangle that is nearest to the pointer. */
export function nearestOf(
  triangle: number,
  corners: Uint32Array,
  pixelsTo: (vertex: number, corner: number) => number,
): Hit {
  let best: Hit = { triangle, vertex: -1, pixels: Infinity };
  corners.forEach((vertex, corner) => {
    const pixels = pixelsTo(vertex, corner);
    if (pixels < best.pixels) best = { ...best, vertex, pixels };
  });
  return best;
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
  /** Something is drawn on the canvas, and must not disappear for a frame. */
  #hasPicture = false;
  #before: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    stages.add(this);
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#uploads = new SlicedUploads(this.renderer.getContext() as WebGL2RenderingContext);
    // Checking for errors waits until a program is compiled, and users could not act on the result.
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.renderer.setClearColor(new Color(0), 0);
    this.#followSize();
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
      this.onRestored();
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
      if (time === lastFrame || this.#isAnotherFirst()) {
        requestAnimationFrame(frame);
        return;
      }
      lastFrame = time;
      this.#isPending = false;
      delete this.canvas.dataset.pending;
      if (!this.#isLost) this.#frame();
    };
    requestAnimationFrame(frame);
  }

  get #isHidden(): boolean {
    return this.canvas.clientWidth === 0 || this.canvas.clientHeight === 0;
  }

  /** Draws again when the canvas changes, also in pixels: zoomed, or moved to a screen with smaller ones. */
  #followSize(): void {
    const observer = new ResizeObserver(() => this.resize());
    try {
      observer.observe(this.canvas, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(this.canvas); // in Safari
    }
  }

  get #pixelRatio(): number {
    return Math.min(devicePixelRatio, 2);
  }

  /** Whether canvas and drawing buffer differ in size. A new buffer waits until the card has finished everything. */
  get #isOutgrown(): boolean {
    const { x, y } = this.renderer.getSize(new Vector2());
    const isSharp = this.renderer.getPixelRatio() === this.#pixelRatio;
    return !isSharp || x !== this.canvas.clientWidth || y !== this.canvas.clientHeight;
  }

  get #isUnsized(): boolean {
    return !this.#hasPicture && !this.#isLost && !this.#isHidden && this.#isOutgrown;
  }

  /** All first buffers are made before anything is drawn, because they would have to wait for that. */
  #isAnotherFirst(): boolean {
    if (this.#isUnsized) return false;
    return [...stages].some((one) => one !== this && one.#isPending && one.#isUnsized);
  }

  #frame(): void {
    if (this.#isHidden) {
      // The next model must not show this one first.
      if (this.#hasPicture) this.renderer.clear();
      this.#hasPicture = false;
      return;
    }
    // A drawing made before everything is uploaded would be discarded.
    if (this.#uploads.isBusy) {
      this.#uploads.step();
      return this.draw();
    }
    if (this.#isOutgrown) {
      if (!this.#uploads.isAtRest()) return this.draw();
      this.#takeSize();
      // A new buffer is empty: whatever was drawn is drawn again in the same frame.
      if (!this.#hasPicture) return this.draw();
    }
    for (const step of this.#before) step();
    this.render();
    this.#hasPicture = true;
    if (this.#uploads.isBusy) this.draw();
    this.canvas.dataset.triangles = String(this.renderer.info.render.triangles);
    this.canvas.dataset.frames = String(this.renderer.info.render.frame);
  }

  protected render(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** What the view shows, at least `width` pixels wide where that is possible. */
  async picture(width: number): Promise<Blob> {
    const { clientWidth, clientHeight } = this.canvas;
    if (this.#isHidden || this.#isLost) throw new Error('the view is not on the screen');
    const ratio = Math.min(maxEnlarged, Math.max(this.#pixelRatio, width / clientWidth));
    this.renderer.setDrawingBufferSize(clientWidth, clientHeight, ratio);
    for (const step of this.#before) step();
    this.render();
    // The picture is taken before toBlob returns.
    const made = new Promise<Blob | null>((done) => this.canvas.toBlob(done, 'image/png'));
    this.renderer.setDrawingBufferSize(clientWidth, clientHeight, this.#pixelRatio);
    this.render();
    const blob = await made;
    if (!blob) throw new Error('the browser could not make a picture');
    return blob;
  }

  /** What is behind the drawing: a colour, or nothing. */
  setBacking(colour: string | undefined): void {
    this.renderer.setClearColor(new Color(colour ?? 0), colour === undefined ? 0 : 1);
    this.draw();
  }

  resize(): void {
    if (!this.#isHidden) this.draw();
  }

  #takeSize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    // Both at once: each of the calls for one of them would make a buffer.
    this.renderer.setDrawingBufferSize(clientWidth, clientHeight, this.#pixelRatio);
    this.onResize(clientWidth, clientHeight);
  }

  /** Called when the context is restored: textures that were drawn are empty. */
  protected onRestored(): void {}

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
