// The module that Emscripten builds from wasm/bindings.cpp.
// eslint-disable-next-line @typescript-eslint/no-explicit-any -- Embind declares nothing
export default function createModule(options: object): Promise<any>;
