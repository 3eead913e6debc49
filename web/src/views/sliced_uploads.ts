// Uploads large arrays to the graphics card in slices, a few per frame, and none before the card has received those of
// the previous frame: a single upload of 40 MB, or one queued behind others, blocks the main thread for as long as the
// card, or the software renderer, is busy.

import type { Mesh } from 'three';
import { gatheredFor } from './gathered_attribute';

const sliceBytes = 2 ** 20;
const frameBytes = 4 * sliceBytes;
const longestWait = 500; // milliseconds; after that the next slices are sent even without an answer
const longestRest = 5000; // milliseconds to wait for the card to finish everything
const frameTime = 8; // milliseconds per frame for uploads

interface Upload {
  buffer: WebGLBuffer;
  byteLength: number;
  /** The next bytes, at most so many. */
  slice: (begin: number, maxBytes: number) => Uint8Array;
  done: number;
}

function sliceOf(data: ArrayBufferView): Upload['slice'] {
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  return (begin, maxBytes) => bytes.subarray(begin, begin + maxBytes);
}

/** Intercepts uploads by three.js: large buffers are allocated immediately and filled afterwards. */
export class SlicedUploads {
  readonly #gl: WebGL2RenderingContext;
  readonly #bind: WebGL2RenderingContext['bindBuffer'];
  readonly #fill: WebGL2RenderingContext['bufferSubData'];
  /** The buffer that was bound last to each target. */
  readonly #bound = new Map<number, WebGLBuffer | null>();
  #waiting: Upload[] = [];
  #sent: { fence: WebGLSync; time: number } | undefined;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#bind = gl.bindBuffer.bind(gl);
    this.#fill = gl.bufferSubData.bind(gl);
    const remove = gl.deleteBuffer.bind(gl);
    gl.deleteBuffer = (buffer) => {
      this.#drop(buffer);
      remove(buffer);
    };
    const allocate = gl.bufferData.bind(gl) as (...all: unknown[]) => void;
    gl.bindBuffer = (target, buffer) => {
      this.#bound.set(target, buffer);
      this.#bind(target, buffer);
    };
    gl.bufferData = (target: number, data: unknown, usage: number, ...rest: unknown[]) => {
      const buffer = this.#bound.get(target);
      const isSliced = target === gl.ARRAY_BUFFER || target === gl.ELEMENT_ARRAY_BUFFER;
      const gathered = gatheredFor(data);
      const all = gathered ?? (ArrayBuffer.isView(data) ? data : undefined);
      const isLarge = all !== undefined && all.byteLength > frameBytes;
      if (!isSliced || !isLarge || !buffer || rest.length > 0) {
        return allocate(target, gathered?.slice(0, frameBytes) ?? data, usage, ...rest);
      }
      this.#drop(buffer);
      allocate(target, all.byteLength, usage);
      const slice = gathered ? gathered.slice.bind(gathered) : sliceOf(data as ArrayBufferView);
      this.#waiting.push({ buffer, byteLength: all.byteLength, slice, done: 0 });
    };
    gl.bufferSubData = ((...all: Parameters<typeof gl.bufferSubData>) => {
      // The whole buffer is replaced: slices still waiting for it are outdated.
      if (all[1] === 0) this.#drop(this.#bound.get(all[0]) ?? null);
      this.#fill(...all);
    }) as typeof gl.bufferSubData;
  }

  get isBusy(): boolean {
    return this.#waiting.length > 0;
  }

  #drop(buffer: WebGLBuffer | null): void {
    this.#waiting = this.#waiting.filter((upload) => upload.buffer !== buffer);
  }

  /** Drops everything after a lost context: three.js uploads it again. */
  forget(): void {
    this.#waiting = [];
    this.#sent = undefined;
  }

  /** Places a fence behind everything sent to the card so far. */
  #mark(time: number): void {
    const gl = this.#gl;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence) this.#sent = { fence, time };
    gl.flush();
  }

  /** Whether the card has finished everything; if not, ask again in the next frame. */
  isAtRest(): boolean {
    if (this.#sent) return !this.#isCardBusy(longestRest);
    this.#mark(performance.now());
    return this.#sent === undefined; // a lost context has no fences
  }

  /** Whether the card has not yet received the last slices. */
  #isCardBusy(wait: number): boolean {
    const gl = this.#gl;
    if (!this.#sent) return false;
    const { fence, time } = this.#sent;
    const isTaken = gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
    if (!isTaken && performance.now() - time < wait) return true;
    gl.deleteSync(fence);
    this.#sent = undefined;
    return false;
  }

  /** Uploads as many slices as a frame has time for, at least one unless the card is busy. */
  step(): void {
    if (this.#isCardBusy(longestWait)) return;
    const gl = this.#gl;
    const begin = performance.now();
    for (let sent = 0; this.#waiting.length > 0 && sent < frameBytes; sent += sliceBytes) {
      const upload = this.#waiting[0];
      const piece = upload.slice(upload.done, sliceBytes);
      // Binding where indices are bound would change the geometry that is bound.
      this.#bind(gl.COPY_WRITE_BUFFER, upload.buffer);
      this.#fill(gl.COPY_WRITE_BUFFER, upload.done, piece);
      upload.done += piece.length;
      if (upload.done === upload.byteLength) this.#waiting.shift();
      if (performance.now() - begin > frameTime) break;
    }
    this.#bind(gl.COPY_WRITE_BUFFER, null);
    this.#mark(begin);
  }
}

/**
 * Leaves a new large geometry out of the frame that makes its buffers: these are filled after it, and millions of
 * corners at one point would be drawn for nothing.
 */
export function drawWhenUploaded(mesh: Mesh): void {
  const { geometry } = mesh;
  const bytes = 12 * geometry.getAttribute('position').count;
  mesh.onAfterRender = () => geometry.setDrawRange(0, Infinity);
  if (bytes > frameBytes) geometry.setDrawRange(0, 0);
}
