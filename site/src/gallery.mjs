// Models that can be turned, with a choice of patterns and the flat map beside each. One WebGL context draws all of
// them; each figure shows its last picture in a plain canvas, so that a long page needs no more memory than one model.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Mesh,
  PerspectiveCamera,
  Scene,
  Spherical,
  WebGLRenderer,
} from 'three';
import { setPalette, setPattern, surfaceMaterial } from '../../web/src/views/pattern_material';

const palettes = {
  light: { paper: '#e9edf2', ink: '#1d3f63', second: '#f3b63f' },
  dark: { paper: '#dfe5eb', ink: '#24507e', second: '#f3b63f' },
};

let renderer;
/** The renderer of all figures; throws if there is no WebGL. */
function shared() {
  renderer ??= new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.setClearColor(new Color(0), 0);
  return renderer;
}

/** Counts, positions, normals, uv, triangles; see modelBytes in web/hero.mjs. */
function read(data) {
  const [vertices, corners] = new Uint32Array(data, 0, 2);
  const geometry = new BufferGeometry();
  let at = 8;
  for (const [name, width] of [
    ['position', 3],
    ['normal', 3],
    ['uv', 2],
  ]) {
    const values = new Float32Array(data, at, width * vertices);
    geometry.setAttribute(name, new BufferAttribute(values, width));
    at += values.byteLength;
  }
  geometry.setAttribute('tint', new BufferAttribute(new Uint8Array(4 * vertices), 4, true));
  geometry.setIndex(new BufferAttribute(new Uint32Array(data, at, corners), 1));
  geometry.computeBoundingSphere();
  return geometry;
}

class Model {
  #scene = new Scene();
  #camera = new PerspectiveCamera(28, 1, 0.01, 1000);
  #place = new Spherical(1, 1.15, 0.6);
  #mesh;
  #canvas;
  #about;
  #frame = 0;

  constructor(canvas, about, geometry) {
    this.#canvas = canvas;
    this.#about = about;
    this.#mesh = new Mesh(geometry, surfaceMaterial(true));
    const { center, radius } = geometry.boundingSphere;
    this.#mesh.position.copy(center).negate();
    this.#place.radius = (1.06 * radius) / Math.sin((14 * Math.PI) / 180);
    this.#scene.add(this.#mesh);
    this.setPattern(about.pattern);
    const isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    const colours = Object.entries(palettes[isDark ? 'dark' : 'light']);
    const palette = Object.fromEntries(colours.map(([name, value]) => [name, new Color(value)]));
    setPalette(this.#mesh.material, palette);
    this.#listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  setPattern(name) {
    const { q, scale, isAligned } = this.#about;
    setPattern(this.#mesh.material, name, { q, scale, isAligned });
    this.draw();
  }

  turn(x, y) {
    this.#place.theta -= x;
    this.#place.phi = Math.min(3, Math.max(0.14, this.#place.phi - y));
    this.draw();
  }

  #listen() {
    const canvas = this.#canvas;
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.hasPointerCapture(event.pointerId))
        this.turn(event.movementX / 120, event.movementY / 120);
    });
    const keys = {
      ArrowLeft: [-0.15, 0],
      ArrowRight: [0.15, 0],
      ArrowUp: [0, -0.15],
      ArrowDown: [0, 0.15],
    };
    canvas.addEventListener('keydown', (event) => {
      if (!(event.key in keys)) return;
      event.preventDefault();
      this.turn(...keys[event.key]);
    });
  }

  draw() {
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => this.#drawNow());
  }

  #drawNow() {
    const canvas = this.#canvas;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(devicePixelRatio, 2);
    const gl = shared();
    gl.setPixelRatio(ratio);
    gl.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#camera.position.setFromSpherical(this.#place);
    this.#camera.lookAt(0, 0, 0);
    this.#camera.updateMatrixWorld();
    this.#mesh.material.uniforms.toStudio.value.setFromMatrix4(this.#camera.matrixWorld);
    gl.render(this.#scene, this.#camera);
    canvas.width = gl.domElement.width;
    canvas.height = gl.domElement.height;
    canvas.getContext('2d').drawImage(gl.domElement, 0, 0);
    canvas.dataset.drawn = '';
  }
}

/** Draws the triangles in the plane. */
function drawMap(canvas, geometry) {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0) return;
  const ratio = Math.min(devicePixelRatio, 2);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const uv = geometry.getAttribute('uv').array;
  const index = geometry.index.array;
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  uv.forEach((x, i) => {
    low[i % 2] = Math.min(low[i % 2], x);
    high[i % 2] = Math.max(high[i % 2], x);
  });
  const [wide, tall] = [high[0] - low[0], high[1] - low[1]];
  const scale = Math.min((width - 4) / wide, (height - 4) / tall);
  const [left, top] = [(width - scale * wide) / 2, (height + scale * tall) / 2];
  const path = new Path2D();
  const x = (i) => left + scale * (uv[2 * i] - low[0]);
  const y = (i) => top - scale * (uv[2 * i + 1] - low[1]);
  for (let t = 0; t < index.length; t += 3) {
    path.moveTo(x(index[t]), y(index[t]));
    path.lineTo(x(index[t + 1]), y(index[t + 1]));
    path.lineTo(x(index[t + 2]), y(index[t + 2]));
    path.closePath();
  }
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  const { color } = getComputedStyle(canvas);
  context.fillStyle = color;
  context.strokeStyle = color;
  context.globalAlpha = 0.25;
  context.fill(path);
  context.globalAlpha = 0.4;
  context.lineWidth = 0.2;
  context.stroke(path);
  canvas.dataset.drawn = '';
}

async function show(figure) {
  const about = JSON.parse(figure.dataset.model);
  const canvas = figure.querySelector('canvas.model');
  const response = await fetch(new URL(about.file, document.baseURI));
  if (!response.ok) throw new Error(`${about.file}: ${response.status}`);
  const geometry = read(await response.arrayBuffer());
  const model = new Model(canvas, about, geometry);
  const map = figure.querySelector('canvas.map');
  if (map) {
    drawMap(map, geometry);
    new ResizeObserver(() => drawMap(map, geometry)).observe(map);
  }
  figure
    .querySelector('select')
    ?.addEventListener('change', ({ target }) => model.setPattern(target.value));
}

const waiting = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      waiting.unobserve(target);
      show(target).catch((error) => {
        target.querySelector('canvas').replaceWith(
          Object.assign(document.createElement('p'), {
            textContent: `This model cannot be shown here: ${error.message}`,
          }),
        );
      });
    }
  },
  { rootMargin: '300px' },
);
for (const figure of document.querySelectorAll('figure[data-model]')) waiting.observe(figure);
