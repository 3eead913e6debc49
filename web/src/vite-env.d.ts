/// <reference types="vite/client" />
declare module 'hgp/worker?worker&url' {
  const url: string;
  export default url;
}
declare module 'virtual:examples' {
  export const examples: import('../examples.mjs').Example[];
}
