// The page as text: what is in its panels, what the document knows, and what the two views would draw.

import { numberText, valueText } from '../../support/recording.mjs';
import { gatheredFor } from '../../../web/src/views/gathered_attribute.ts';

const skipped = new Set([
  'type',
  'data-engine',
  'style',
  'aria-roledescription',
  'data-frames',
  'aria-hidden',
  'scope',
]);
const cleaned = (text) =>
  text
    .replace(/\d(?:\.\d+)?e[−-]\d\d/g, '≈0')
    .replace(/\d\.\d\d s\b/g, '‹time› s')
    .replace(/glTF Validator [\w.-]+/, 'glTF Validator ‹version›');

function elementText(element) {
  const { id, tagName } = element;
  const name = tagName.toLowerCase();
  let text = name;
  if (id) text += `#${id}`;
  for (const { name: key, value } of element.attributes) {
    if (skipped.has(key) || key === 'id') continue;
    if (key === 'class')
      text += [...new Set(value.split(/\s+/))].filter(Boolean).map((one) => `.${one}`).join(''); // prettier-ignore
    else text += value === '' ? ` ${key}` : ` ${key}="${value.replace(/\s+/g, ' ')}"`;
  }
  if (name === 'input' && element.type === 'checkbox') text += element.checked ? ' ☑' : ' ☐';
  else if (['input', 'select'].includes(name)) text += ` =${element.value}`;
  const own = [...element.childNodes]
    .filter(({ nodeType }) => nodeType === 3)
    .map(({ textContent }) => textContent)
    .join('·')
    .replace(/\s+/g, ' ')
    .replace(/(?: ?· ?)+/g, ' · ')
    .trim();
  return cleaned(own === '' || own === '·' ? text : `${text} ${own}`);
}

const maxRows = 3;
const plain = /^(?:div|span|p|section|tbody|thead|tr|dl|ul|b|small|td|g|br)$/;
/** A drawing by the beginning of its first line. */
const drawingText = (svg) => `${svg.getAttribute('class') ?? ''}${svg.children.length}:${svg.firstElementChild?.getAttribute('d')?.slice(0, 7) ?? ''}`; // prettier-ignore
/** What a person sees of an element, and what is told of it to those who do not see. */
export function* elementLines(element) {
  if (element.tagName.toLowerCase() === 'svg') return yield drawingText(element);
  const line = elementText(element);
  const all = [...element.children];
  // Of a long table its first rows: the document has the rest.
  const isTable = /^tbody/.test(line) && all.length > maxRows && element.closest('#cones');
  const inner = (isTable ? all.slice(0, maxRows) : all).flatMap((child) => [...elementLines(child)]); // prettier-ignore
  if (isTable) inner.push(`rows ${all.length}`);
  // Rows and buttons are one line each.
  if (/^(?:tr|li|button|summary|label|select|h\d)\b/.test(line))
    yield [line, ...inner].join(' | ').replace(/^tr \| th Time\b.*/, 'tr | th Time');
  else {
    if (!plain.test(line)) yield line;
    yield* inner;
  }
}

const docFields = ['prescription', 'settings', 'solve', 'look', 'features', 'hasUserCones', 'coneStep', 'selected', 'isUnsaved', 'pendingOutput', 'validation', 'field', 'firstRun', 'notAgain', 'summaries']; // prettier-ignore
const uiFields = ['tool', 'tab', 'sheet', 'dialog', 'hover', 'theme', 'hasKeys', 'split', 'maxRows', 'openGroups', 'mapScale', 'sort', 'isPhone', 'isNarrow', 'isSystemDark', 'handlesShown', 'isRecording', 'target', 'wipe', 'automatic', 'holdsCone']; // prettier-ignore

/** A value without what only identifies it. */
function bare(value, depth = 5) {
  if (value === null || typeof value !== 'object' || ArrayBuffer.isView(value)) return value;
  if (value instanceof Map || value instanceof Set || value instanceof Blob) return value;
  if (depth === 0) return '…';
  if (Array.isArray(value)) return value.map((one) => bare(one, depth - 1));
  const left = /^(?:id|surfaceId|solver|map|model|files|controller|image|of|surface|prescription|result|seamAt|written)$/; // prettier-ignore
  return Object.fromEntries(Object.entries(value).filter(([key]) => depth < 5 || !left.test(key)).map(([key, one]) => [key, bare(one, depth - 1)])); // prettier-ignore
}

function* solutionLines(name, solution) {
  if (!solution) return;
  const { result: _, written: __, seams, ...others } = bare(solution);
  yield `${name}.seams ${valueText(seams.flatMap(({ a, b, r }) => [...a, ...b, r]))}`;
  for (const [key, value] of Object.entries(others)) yield `${name}.${key} ${valueText(value, 4)}`;
  for (const [key, value] of Object.entries(solution.result)) if (ArrayBuffer.isView(value)) yield `${name}.result.${key} ${valueText(value)}`; // prettier-ignore
}

function* documentLines({ doc, ui }) {
  yield `state ${doc.stateName} ${doc.state.kind}`;
  if (doc.job) {
    const { kind, title, stage, entered, detail, fraction } = doc.job;
    yield `job ${valueText({ kind, title, stage, entered, detail, fraction })}`;
  }
  for (const key of docFields) if (doc[key] !== undefined) yield `doc.${key} ${valueText(bare(doc[key], 5), 5)}`; // prettier-ignore
  // Its text is in the status bar.
  yield `doc.message ${doc.message?.kind} ${doc.message?.details ?? ''}`;
  yield `doc.steps ${doc.history.undoKind} | ${doc.history.redoKind} | ${doc.solutions.length} solutions, ${doc.meshes.size} meshes`; // prettier-ignore
  if (doc.budget) {
    const { cones, components, ...all } = doc.budget;
    yield `doc.budget ${valueText({ ...all, components })}`;
    const wrong = cones.filter(({ isGood, text }) => !isGood || text !== 'ok');
    yield `doc.budget.cones ${cones.length} ${valueText(wrong)}`;
  }
  if (doc.live) yield `doc.live ${valueText(bare(doc.live))}`;
  if (doc.quads) yield `doc.quads ${doc.quads.isShown} ${valueText(doc.quads.made)} ${valueText(doc.quads.shape)}`; // prettier-ignore
  for (const [key, value] of Object.entries(doc.model?.surface ?? {})) if (key !== 'id') yield `surface.${key} ${valueText(value)}`; // prettier-ignore
  for (const { mesh, ...part } of doc.parts) yield `part ${mesh} ${valueText(bare(part), 3)}`;
  for (const [mesh, picture] of doc.thumbnails) yield `thumbnail ${mesh} ${valueText(picture)}`;
  yield* solutionLines('map', doc.displayed);
  for (const key of uiFields) if (ui[key] !== undefined) yield `ui.${key} ${valueText(ui[key])}`;
  for (const [word, text] of new URLSearchParams(location.hash.slice(1))) yield `address ${word} ${/^(?:cones|edges)$/.test(word) ? `${text.length} letters` : text}`; // prettier-ignore
}

const materialKeys = ['side', 'transparent', 'depthTest', 'depthWrite', 'polygonOffset', 'polygonOffsetFactor', 'polygonOffsetUnits', 'flatShading', 'opacity', 'color']; // prettier-ignore
const listed = (object, keys) =>
  keys.filter((key) => object[key] !== undefined).map((key) => `${key} ${valueText(object[key], 1)}`).join(', '); // prettier-ignore

/** What the graphics card gets of an attribute. */
function uploaded(array) {
  const gathered = gatheredFor(array);
  if (!gathered) return array;
  return new array.constructor(gathered.slice(0, gathered.byteLength).slice().buffer);
}

function* objectLines(name, object) {
  const { geometry, material, matrixWorld } = object;
  const own = object.constructor.name;
  const kind = object.userData?.mesh === undefined ? own : `${own} ${valueText(object.userData)}`;
  const order = object.renderOrder ? ` order ${object.renderOrder}` : '';
  yield `${name} ${kind}${object.visible ? '' : ' hidden'}${order} ${valueText(matrixWorld.elements.map((x) => Number(numberText(x))))}`; // prettier-ignore
  if (!object.visible) return;
  if (geometry) {
    const parts = Object.entries(geometry.attributes).map(([key, { array, count }]) => `${key} ${count} ${valueText(uploaded(array))}`); // prettier-ignore
    yield `${name} ${kind} geometry ${parts.join(', ')}${geometry.index ? `, index ${valueText(uploaded(geometry.index.array))}` : ''}`; // prettier-ignore
  }
  for (const one of material ? [material].flat() : []) {
    const flags = materialKeys.filter((key) => one[key] && !(key === 'toneMapped' || (key === 'opacity' && one[key] === 1))); // prettier-ignore
    // Of a program of the page's own; what three.js defines for its materials says nothing of the page.
    const defined = Object.entries((one.uniforms && one.defines) ?? {}).map(([key, value]) => `${key.toLowerCase()} ${value}`); // prettier-ignore
    const uniforms = defined.concat(Object.entries(one.uniforms ?? {}).map(([key, { value }]) => `${key} ${uniformText(value)}`)); // prettier-ignore
    if (one.map) uniforms.push(`map ${textureText(one.map)}`);
    yield `${name} ${kind} material ${listed(one, flags)}; ${uniforms.join(', ')}`;
  }
}

/** A texture by its size, how it is read, and what is in it as far as it is numbers. */
const textureText = ({ image, wrapS, magFilter }) => `texture ${image?.width}×${image?.height} ${wrapS} ${magFilter} ${ArrayBuffer.isView(image?.data) ? valueText(image.data) : ''}`; // prettier-ignore

function uniformText(value) {
  if (value?.isTexture) return textureText(value);
  if (value?.isColor) return value.getHexString();
  if (value?.elements) return valueText([...value.elements]);
  if (value?.toArray) return valueText(value.toArray());
  return valueText(Array.isArray(value) ? value.map((one) => one?.toArray?.() ?? one) : value, 2);
}

function* viewLines(name, view, card) {
  const { camera, scene } = view;
  yield `${name} camera ${listed(camera, ['fov', 'aspect', 'near', 'far', 'zoom', 'left', 'right', 'top', 'bottom'])}`; // prettier-ignore
  yield `${name} camera at ${valueText(camera.position.toArray())} ${valueText(camera.quaternion.toArray())}`; // prettier-ignore
  const { controls } = view.orbit ?? view;
  yield `${name} controls ${listed(controls, ['enabled', 'enableRotate', 'zoomSpeed'])} ${valueText(controls.target.toArray())}`; // prettier-ignore
  const things = [];
  scene.traverse((object) => void things.push(object));
  for (const [i, object] of things.entries()) if (i > 0) yield* objectLines(name, object);
  const { options } = card;
  yield `${name} context ${valueText({ ...options, ratio: view.renderer.getPixelRatio() })}`;
  yield `${name} draws ${card.drawn.map(([what, ...all]) => `${what} ${all.map((x) => valueText(x)).join(' ')}`).join(', ')}`; // prettier-ignore
}

/** All of it, line by line. */
export function pageLines(app, cardOf) {
  const lines = [...elementLines(document.body), ...documentLines(app)];
  lines.push(`title ${document.title} ${valueText({ ...document.documentElement.dataset })}`);
  for (const [name, view] of Object.entries(app.views ?? {})) lines.push(...viewLines(name, view, cardOf(view.canvas))); // prettier-ignore
  return lines;
}
