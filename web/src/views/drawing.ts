// Everything that draws, with three.js: loaded when the page is on the screen.

export { ModelView } from './model_view';
export { oneOfEach } from './shader_warmup';
export { UvView } from './uv_view';
export { ViewUpdates } from './view_updates';
