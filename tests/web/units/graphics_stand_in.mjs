// A graphics card that takes everything and draws nothing. It remembers what it was told to draw in the last frame.

/** What drawing depends on, apart from the scene. */
const state = new Set(['viewport', 'scissor', 'clearColor']);
const draws = new Set(['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']); // prettier-ignore

const answers = {
  getContextAttributes: () => ({ alpha: true, antialias: true, depth: true, stencil: false }),
  getExtension: (name) => (/lose_context/i.test(name) ? { loseContext() {}, restoreContext() {} } : null), // prettier-ignore
  getSupportedExtensions: () => [],
  getShaderPrecisionFormat: () => ({ precision: 23, rangeMin: 127, rangeMax: 127 }),
  getShaderInfoLog: () => '',
  getProgramInfoLog: () => '',
  getError: () => 0,
  isContextLost: () => false,
  getAttribLocation: () => 0,
};

export function graphicsCard(canvas, kind) {
  const numbers = new Map();
  const card = { drawn: [], isOver: false, shaders: new Set(), context: undefined };
  let things = 0;
  /** Constants, far enough apart for those that are counted on from the first. */
  const numberOf = (name) => {
    if (!numbers.has(name)) numbers.set(name, 1000 + 100 * numbers.size);
    return numbers.get(name);
  };
  const nameOf = (number) => [...numbers].find(([, n]) => n === number)?.[0];
  const own = {
    ...answers,
    canvas,
    drawingBufferWidth: 600,
    drawingBufferHeight: 400,
    getParameter: (number) => {
      const name = nameOf(number) ?? '';
      if (/^VERSION|SHADING/.test(name)) return 'WebGL 2.0';
      if (/BOX|VIEWPORT/.test(name)) return [0, 0, 600, 400];
      return /^MAX/.test(name) ? 4096 : 1;
    },
    getShaderParameter: () => true,
    getProgramParameter: (_, number) => (/ACTIVE/.test(nameOf(number)) ? 0 : true),
    checkFramebufferStatus: () => numberOf('FRAMEBUFFER_COMPLETE'),
    clientWaitSync: () => numberOf('ALREADY_SIGNALED'),
    getSyncParameter: () => numberOf('SIGNALED'),
    measureText: () => ({ width: 10 }),
    createLinearGradient: () => ({ addColorStop() {} }),
    createRadialGradient: () => ({ addColorStop() {} }),
  };
  card.context = new Proxy(own, {
    get(target, name) {
      if (name in target || typeof name === 'symbol') return target[name];
      if (/^[A-Z][A-Z0-9_]*$/.test(name)) return numberOf(name);
      if (/^create/.test(name)) return (target[name] = () => ({ id: ++things }));
      return (target[name] = (...all) => {
        if (kind === '2d') card.drawn.push([name, ...all]);
        if (!draws.has(name) && !state.has(name) && name !== 'shaderSource') return;
        if (card.isOver) card.drawn = [];
        card.isOver = false;
        if (draws.has(name)) card.drawn.push([name, /Arrays/.test(name) ? all[2] : all[1]]);
        else if (state.has(name)) card.drawn.push([name, ...all]);
        else card.shaders.add(all[1]);
      });
    },
    set(target, name, value) {
      if (kind === '2d') card.drawn.push([name, value]);
      target[name] = value;
      return true;
    },
  });
  return card;
}
