// Laws of the pictures of cones: what is painted is looked at, as shapes, colours and places on the canvas.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Color } from 'three';
import { ConeMarkers } from '../../../web/src/views/cone_markers.ts';

const [side, columns] = [64, 16];

/** A canvas that remembers what is painted: paths with their place, colours and widths. */
function easel() {
  const acts = [];
  const saved = [];
  let now = { x: 0, y: 0, lineWidth: 1, font: '', fillStyle: '', strokeStyle: '' };
  let path = [];
  const note = (kind, more) => acts.push({ kind, ...now, path, ...more });
  const brush = {
    save: () => saved.push({ ...now }),
    restore: () => (now = saved.pop()),
    translate: (x, y) => (now = { ...now, x: now.x + x, y: now.y + y }),
    clearRect: (x, y, w, h) => note('clear', { box: [now.x + x, now.y + y, w, h] }),
    beginPath: () => (path = []),
    closePath() {},
    lineTo: (x, y) => path.push([x, y]),
    arc: (x, y, r, from, to) => path.push(...Array.from({ length: 40 }, (_, i) => from + ((to - from) * i) / 40).map((a) => [x + r * Math.cos(a), y + r * Math.sin(a)])), // prettier-ignore
    stroke: () => note('stroke'),
    fill: () => note('fill'),
    fillText: (text, x, y) => note('text', { text, at: [x, y] }),
  };
  for (const name of [
    'lineWidth',
    'font',
    'fillStyle',
    'strokeStyle',
    'lineJoin',
    'textAlign',
    'textBaseline',
  ])
    // prettier-ignore
    Object.defineProperty(brush, name, {
      set(value) {
        now = { ...now, [name]: value };
      },
      get: () => now[name],
    });
  const canvas = { getContext: () => brush };
  return { acts, saved, canvas };
}

/** Markers share their pictures, with those of other tests as well: those here are of a module of their own. */
async function studio(name) {
  const one = easel();
  const { ConeMarkers: Markers } = await import(
    `../../../web/src/views/cone_markers.ts?${name}.ts`
  );
  const show = (all, markers = new Markers(false)) => {
    const before = Object.getOwnPropertyDescriptor(globalThis, 'document');
    Object.defineProperty(globalThis, 'document', { value: { createElement: () => one.canvas }, configurable: true, writable: true }); // prettier-ignore
    one.acts.length = 0;
    try {
      markers.show(all);
    } finally {
      if (before) Object.defineProperty(globalThis, 'document', before);
      else delete globalThis.document;
    }
    return markers;
  };
  /** Where on the canvas a marker has its picture. */
  const cellOf = (markers, m = 0) => {
    const look = markers.children[0].geometry.getAttribute('look');
    return [look.getX(4 * m), look.getY(4 * m)];
  };
  const painted = (more) => {
    show([marker(more)]);
    return [...one.acts];
  };
  return { ...one, Markers, show, cellOf, painted };
}
const marker = (more) => ({ at: [0, 0, 0], k: 3, q: 4, isSelected: false, isBad: false, ...more });
const kinds = [];
for (const k of [0, 3, 4, 5, 9, 10, 48])
  for (const isSelected of [false, true])
    for (const isBad of [false, true]) kinds.push({ k, isSelected, isBad });

test('markers that the surface can hide have two layers', () => {
  assert.equal(new ConeMarkers(true).children.length, 2);
});

test('a picture is painted in its own cell, around its middle, after the cell was emptied; the brush is as before', async () => {
  const { canvas, acts, saved, show, cellOf, Markers } = await studio('cells');
  const markers = new Markers(true);
  const cells = new Set();
  for (const kind of kinds) {
    show([marker(kind)], markers);
    const [column, row] = cellOf(markers);
    cells.add(`${column} ${row}`);
    assert.equal(acts[0].kind, 'clear');
    assert.deepEqual(acts[0].box, [column * side, row * side, side, side]);
    for (const { kind: act, x, y, path, lineWidth, at } of acts.slice(1)) {
      assert.deepEqual([x, y], [(column + 0.5) * side, (row + 0.5) * side], 'the middle');
      const rim = act === 'stroke' ? lineWidth / 2 : 0;
      // Not to its last pixel: pictures are smoothed over neighbours.
      for (const p of act === 'text' ? [at] : path)
        for (const z of p) assert.ok(Math.abs(z) + rim <= side / 2, `${z} and ${rim}`);
    }
    assert.equal(saved.length, 0);
  }
  assert.equal(cells.size, kinds.length);
  assert.deepEqual([canvas.width, canvas.height], [side * columns, side * columns]);
});

test('the number of a cone is its k, inside its shape, and every digit as large as another', async () => {
  const { painted } = await studio('numbers');
  const sizes = new Set();
  for (const kind of kinds) {
    const acts = painted(kind);
    const { text, at, font, textAlign, textBaseline } = acts.at(-1);
    assert.equal(acts.at(-1).kind, 'text', 'on top of everything');
    assert.equal(text, String(kind.k));
    assert.deepEqual([textAlign, textBaseline, at[0]], ['center', 'middle', 0]);
    const size = Number(font.match(/(\d+)px/)[1]);
    if (kind.k < 10) sizes.add(size);
    assert.ok(size >= side / 4, 'to be read');
    // Digits are six tenths as wide as they are high.
    const { path } = acts.find((act) => act.kind === 'fill');
    const half = 0.3 * size * text.length;
    const width = widthAt(path, at[1]);
    assert.ok(2 * half <= width, `${text}: ${2 * half} in ${width}`);
  }
  assert.equal(sizes.size, 1);
});

/** How wide a convex shape is at a height. */
function widthAt(path, y) {
  const xs = [];
  path.forEach((p, i) => {
    const q = path[(i + 1) % path.length];
    if ((p[1] - y) * (q[1] - y) <= 0 && p[1] !== q[1])
      xs.push(p[0] + ((q[0] - p[0]) * (y - p[1])) / (q[1] - p[1]));
  });
  return Math.max(...xs) - Math.min(...xs);
}

test('shapes: a triangle of equal sides with its tip up or down, a disk; each about as large, in the middle', async () => {
  const { painted } = await studio('shapes');
  const pathOf = (k) => painted({ k, q: 20 }).find(({ kind }) => kind === 'fill').path;
  const [below, above, full] = [17, 23, 20].map(pathOf);
  for (const [path, way] of [
    [below, 1],
    [above, -1],
  ]) {
    // prettier-ignore
    const sides = path.map((p, i) => Math.hypot(...p.map((x, j) => x - path[(i + 1) % 3][j])));
    for (const one of sides) assert.ok(Math.abs(one - sides[0]) < 1e-9 && one > 0.6 * side);
    const [tip, ...base] = [...path].sort((p, q) => way * (p[1] - q[1]));
    assert.ok(Math.abs(tip[0]) < 1e-9 && Math.abs(base[0][1] - base[1][1]) < 1e-9);
    // As far to the tip as to the base: the marker is where its cone is.
    assert.ok(Math.abs(tip[1] + base[0][1]) < 0.05 * side);
  }
  const radii = full.map((p) => Math.hypot(...p));
  assert.ok(Math.max(...radii) - Math.min(...radii) < 1e-9);
  const areaOf = (path) => Math.abs(path.reduce((sum, p, i) => {
    const q = path[(i + 1) % path.length];
    return sum + p[0] * q[1] - p[1] * q[0];
  }, 0)) / 2; // prettier-ignore
  const ratio = areaOf(full) / areaOf(below);
  assert.ok(ratio > 1 && ratio < 2, `${ratio}`);
});

const luminanceOf = (style) => {
  // Three's colours are linear.
  const { r, g, b } = new Color(style);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const contrast = (a, b) => {
  const [low, high] = [a, b].map(luminanceOf).sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

test('colours tell the sign, and bad ones from all others; numbers and lines are read on every one', async () => {
  const { painted } = await studio('colours');
  const fillOf = (more) => painted({ q: 30, ...more }).find(({ kind }) => kind === 'fill').fillStyle; // prettier-ignore
  const plain = [29, 31, 30].map((k) => fillOf({ k }));
  const bad = [29, 31, 30].map((k) => fillOf({ k, isBad: true }));
  assert.deepEqual([new Set(plain).size, new Set(bad).size, new Set([...plain, ...bad]).size], [3, 1, 4]); // prettier-ignore
  // The degree does not count, only on which side of a full turn it is.
  assert.deepEqual([27, 33].map((k) => fillOf({ k })), plain.slice(0, 2)); // prettier-ignore
  const [below, above] = plain.map((one) => new Color(one));
  assert.ok(below.r > 2 * below.b && above.b > 2 * above.r, 'warm and cold');
  for (const kind of kinds) {
    const acts = painted({ ...kind, q: 7 });
    const { fillStyle: paint } = acts.find((act) => act.kind === 'fill');
    const lines = acts.filter((act) => act.kind === 'stroke');
    const { fillStyle: ink } = acts.at(-1);
    assert.ok(contrast(ink, paint) > 4.5, 'the number');
    const { strokeStyle: dark } = lines[1];
    assert.ok(contrast(dark, paint) > 4.5, 'the line');
    assert.match(lines[0].strokeStyle, kind.isSelected ? /^#ffffff$/ : /^rgb\(255 255 255/);
    assert.ok(lines[0].lineWidth > lines[1].lineWidth + 2, 'a rim on both sides of the line');
    for (const { lineJoin } of lines) assert.equal(lineJoin, 'round', 'no spikes out of the cell');
  }
});

test('every marker shows its own picture, however many kinds there have been', async () => {
  const { show, acts, cellOf, Markers } = await studio('many');
  /** What is on the canvas, by cells. */
  const canvas = new Map();
  const markers = new Markers(true);
  const look = () => {
    for (const { kind, x, y, text } of acts)
      if (kind === 'text') canvas.set([x, y].map((z) => Math.floor(z / side)).join(), text);
  };
  const see = (kind) => {
    show([marker(kind)], markers);
    look();
    assert.ok(cellOf(markers).every((x) => x >= 0 && x < columns));
    assert.equal(canvas.get(cellOf(markers).join()), String(kind.k));
  };
  for (let k = 0; k < 600; k++) {
    see({ k, q: 700 });
    see({ k: Math.max(0, k - 200), q: 700 });
  }
  for (let k = 0; k < 600; k++) see({ k, q: 700 });
  // One that stays while others come and go.
  for (let k = 1; k < 600; k++) {
    show([marker({ k: 0, q: 700 }), marker({ k, q: 700 })], markers);
    look();
    [0, k].forEach((x, m) => assert.equal(canvas.get(cellOf(markers, m).join()), String(x)));
  }
  // All kinds that fit are there together.
  const all = Array.from({ length: 256 }, (_, k) => marker({ k, q: 700 }));
  show(all, markers);
  look();
  all.forEach(({ k }, m) => assert.equal(canvas.get(cellOf(markers, m).join()), String(k)));
  show(all, markers);
  assert.equal(acts.length, 0, 'nothing is painted twice');
  // The card gets the canvas when something on it is new, and else not.
  const { value: texture } = markers.children[0].material.uniforms.atlas;
  const { version } = texture;
  see({ k: 3, q: 700 });
  assert.equal(texture.version, version);
  see({ k: 3, q: 700, isBad: true });
  assert.ok(texture.version > version);
});

test('markers that are shown anew free what the card had, once, and both layers have the same', async () => {
  const { show, Markers } = await studio('freed');
  const markers = new Markers(true, 7);
  assert.deepEqual(markers.children.map((one) => one.renderOrder), [7, 8]); // prettier-ignore
  const freed = [];
  for (let round = 0; round < 3; round++) {
    show([marker({ k: round })], markers);
    const [a, b] = markers.children;
    assert.equal(a.geometry, b.geometry);
    assert.deepEqual([a, b].map(({ material }) => material.uniforms.atlas.value.image.width), [1024, 1024]); // prettier-ignore
    a.geometry.addEventListener('dispose', () => freed.push(round));
    assert.equal(markers.visible, true);
  }
  assert.deepEqual(freed, [0, 1]);
  // The size on the screen is that of the canvas in which they are drawn.
  for (const mesh of markers.children) {
    mesh.onBeforeRender({ getSize: (to) => to.set(321, 123) });
    assert.deepEqual(mesh.material.uniforms.size.value.toArray(), [321, 123]);
    assert.deepEqual([mesh.material.transparent, mesh.material.depthWrite], [true, false]);
  }
});

test('the corners of a marker are seen from in front, whatever its place', async () => {
  const { show, Markers } = await studio('corners');
  const markers = show([marker({}), marker({ at: [4, 5, 6] })], new Markers(false));
  const { geometry } = markers.children[0];
  const [corner, index] = [geometry.getAttribute('corner'), [...geometry.index.array]];
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = index.slice(t, t + 3).map((v) => [corner.getX(v), corner.getY(v)]);
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    assert.equal(area, 4, 'half of the square, the same way round');
  }
});
