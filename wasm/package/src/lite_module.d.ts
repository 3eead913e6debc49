// The module that Emscripten builds from wasm/lite.cpp.

/** The results of a call, or the JSON of its failure. */
type Reply<T> = { error: string } | ({ error?: undefined } & T);

interface Arrays {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

export interface LiteModule {
  parametrize(
    mesh: Arrays,
    options: object,
    onProgress?: import('./lib/progress_call.js').ProgressCall,
  ): Reply<{
    uv: Float64Array;
    cornerToUv: Uint32Array;
    uvToVertex: Uint32Array;
    /** a0 a1 b0 b1 r of each seam edge. */
    seams: Int32Array;
    certificate: import('./lib/lite.js').LiteCertificate;
  }>;
  verify(
    mesh: Arrays & { uv: ArrayLike<number>; cornerToUv: ArrayLike<number> },
    options: object,
  ): Reply<{ certificate: import('./lib/lite.js').LiteCertificate }>;
}

export default function createModule(options: object): Promise<LiteModule>;
