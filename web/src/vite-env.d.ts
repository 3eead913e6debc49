/// <reference types="vite/client" />
declare module 'hgp/worker?worker&url' {
  const url: string;
  export default url;
}
declare module 'virtual:examples' {
  export type Example = import('../examples.mjs').Example;
  export const examples: Example[];
}
