import assert from 'node:assert/strict';
import test from 'node:test';
import { JsonEditor, spansIn } from '../../../web/src/formats/json_edit.ts';

const text = '{ "big" : 9007199254740993, "x\\"{" : [1.50, {"a":[]} , "]" ],\n\t"e": {} }';

test('every value is where its text is', () => {
  const root = spansIn(text);
  const at = ({ start, end }) => text.slice(start, end);
  assert.equal(at(root), text);
  assert.equal(at(root.members.get('big')), '9007199254740993');
  const list = root.members.get('x"{');
  assert.deepEqual(list.items.map(at), ['1.50', '{"a":[]}', '"]"']);
  assert.equal(at(list.items[1].members.get('a')), '[]');
  assert.equal(root.members.get('e').members.size, 0);
});

test('what is not changed keeps its bytes', () => {
  const edit = new JsonEditor(text);
  edit.set(edit.root, 'new', [1]);
  edit.set(edit.root.members.get('e'), 'f', 'g');
  edit.replace(edit.root.members.get('x"{').items[0], 2);
  assert.equal(
    edit.result,
    '{ "big" : 9007199254740993, "x\\"{" : [2, {"a":[]} , "]" ],\n\t"e": {"f":"g"} ,"new":[1]}',
  );
});

test('additions to one place keep their order; a list that is missing is made', () => {
  const edit = new JsonEditor('{"images":[{}]}');
  assert.equal(edit.add('images', 'a'), 1);
  assert.equal(edit.add('samplers', 'b'), 0);
  edit.set(edit.root, 'c', 3);
  assert.deepEqual(JSON.parse(edit.result), { images: [{}, 'a'], samplers: ['b'], c: 3 });
});
