// Notes as the page says them: buttons instead of options, places outlined instead of listed.

import assert from 'node:assert/strict';
import test from 'node:test';
import { messageForPage } from '../../../web/src/text/error_messages.ts';
import { defectsInWords, noteForPage, weldIn } from '../../../web/src/text/notes.ts';
import { remarksOn } from '../../../web/src/text/remarks.ts';
import { repairsMade } from '../../../web/src/text/repairs.ts';
import { describeTransfer } from '../../../web/src/text/transfer.ts';
import { readCatalogue } from '../../../wasm/phrases.mjs';

const note = (code, numbers = {}, words = {}, where = []) => ({ code, numbers, words, where });

const equal = note('weld-would-join', { vertices: 2, before: 14, after: 12 });
const crack = note('crack', { vertices: 64, gap: 2e-6, weld: 2.1e-6, partial: 0 });

test('every code has a sentence on the page, and only advice for the command line is silent', () => {
  for (const code of readCatalogue().keys()) {
    const text = noteForPage(note(code));
    assert.notEqual(text, code);
    assert.doesNotMatch(
      text.replace(/command line: --refine|command line, --refine/, ''),
      /--[a-z]/,
    );
  }
});

test('notes name buttons of the page instead of options of the command line', () => {
  assert.equal(
    noteForPage(equal),
    '2 vertices have the position of another one; joining would make 14 parts into 12',
  );
  assert.match(
    noteForPage(crack),
    /within 2e-06 .*; joining vertices closer than 2\.1e-06 closes it$/,
  );
  assert.match(
    noteForPage(note('map-evened-lengths')),
    /“Less distortion” under Solve lowers it\.$/,
  );
  assert.match(noteForPage(note('grid-few-advised')), /move the slider to Fewer$/);
});

test('a note offers the length at which vertices are joined', () => {
  assert.equal(weldIn([equal]), 0);
  assert.equal(weldIn([equal, crack]), 2.1e-6);
  assert.equal(weldIn([note('t-junctions', { vertices: 4 })]), undefined);
});

test('defects are told without ids, and those that may stay are not told', () => {
  const defects = [
    { kind: 'non-manifold-edge', fatal: true, count: 1 },
    { kind: 'inconsistent-edge', fatal: true, count: 3 },
    { kind: 'isolated-vertex', fatal: false, count: 7 },
  ];
  assert.equal(
    defectsInWords(defects),
    '1 edge has more than two faces; 3 edges have two faces of opposite orientation.',
  );
  assert.equal(defectsInWords([]), '');
});

test('repairs are told with their reasons; a cut of a one-sided surface says what it costs', () => {
  const edge = [{ kind: 'edge', id: 0, other: 3 }];
  const notes = [
    note('read-polygons', { polygons: 2 }),
    note('defect-inconsistent-edge', { count: 1, only: 1, repaired: 1 }, {}, edge),
    note('repair-one-sided-cut', { components: 1, edges: 4 }),
    note('repair-copies', { triangles: 2 }),
  ];
  const made = repairsMade({ notes }, { fix: {}, hasAllRepairs: true });
  assert.equal(made.defects, '1 edge has two faces of opposite orientation.');
  assert.deepEqual(made.made, [
    '1 one-sided component cut along 4 edges: a texture ends at this cut',
    '2 triangles left out as copies of others, with the uv of those',
  ]);
  assert.equal(repairsMade({ notes }, { fix: {} }), undefined);
});

test('an error keeps its rule and number, and gets the advice that the page has', () => {
  const rule = '9 triangles, more than the limit of 4 triangles';
  assert.equal(messageForPage(rule, [note('raise-triangles')]), rule);
  assert.equal(
    messageForPage('2 edges have more than two faces.', [note('repair-by-hand')]),
    '2 edges have more than two faces. No repair removes this; edit the mesh there.',
  );
});

test('bytes that a gzip file has behind its content are remarked on from the first on, before what is known of the mesh', () => {
  const info = { surfaces: [{ uvSets: [0] }], surface: 0 };
  const plain = remarksOn(info, undefined);
  assert.deepEqual(remarksOn(info, undefined, 0), plain);
  for (const bytes of [1, 2, 512]) {
    const [first, ...rest] = remarksOn(info, undefined, bytes);
    assert.deepEqual(rest, plain);
    assert.match(first, new RegExp(`(^|\\D)${bytes}\\D`));
  }
});

test('of cones that moved it is told how many were kept, up to four that were not, and how many more; of none nothing', () => {
  const codes = ['moved-cone-removed', 'moved-cone-gone', 'moved-cone-boundary'];
  for (let kept = 0; kept < 4; kept++) {
    for (let count = 0; count < 8; count++) {
      const lost = Array.from({ length: count }, (_, i) => note(codes[i % 3], { vertex: 50 + i }));
      const text = describeTransfer(kept, lost);
      assert.equal(text === '', kept + count === 0, `${kept} and ${count}`);
      if (text === '') continue;
      assert.match(text, new RegExp(`^ ${kept} cone${kept === 1 ? '' : 's'} kept[;.]`));
      const named = lost.filter((one) => text.includes(noteForPage(one)));
      assert.deepEqual(named, lost.slice(0, 4));
      const more = count > 4 ? [`; and ${count - 4} more.`] : [];
      assert.deepEqual(text.match(/; and \d+ more\./g) ?? [], more, text);
    }
  }
});
