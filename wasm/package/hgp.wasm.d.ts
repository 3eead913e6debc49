// For bundlers that turn `import url from 'hgp/hgp.wasm'` into a URL of the file; in Node, resolve its name instead.

declare const url: string;
export default url;
