// `import url from 'hgp/hgp.wasm'` where a bundler makes a URL of the file; in Node, resolve its name instead.

declare const url: string;
export default url;
