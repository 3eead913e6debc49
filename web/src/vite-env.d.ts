/// <reference types="vite/client" />
declare module 'hgp/worker?worker&url' {
  const url: string;
  export default url;
}
