// Fields of the page: whatever was typed or chosen, and whether or not it was taken, they show what holds then.

import assert from 'node:assert/strict';
import test from 'node:test';
import { blocks, ring } from '../../support/blocks.mjs';
import { toObj } from '../../support/meshes.mjs';
import { $$, drawn, openFiles, openPage, runNow, skip, until } from './whole_page.mjs';

const { runJob } = await import('../../../web/src/actions/job.ts');

const fieldsIn = (page) => $$('input:not([type=file]), select', page);
const nameOf = (field) => field.id || field.getAttribute('aria-label');
const shown = (field) => (field.type === 'checkbox' ? field.checked : field.value);
const valuesIn = (page) => Object.fromEntries(fieldsIn(page).map((field) => [nameOf(field), shown(field)])); // prettier-ignore

/** What a page shows that is made anew. */
async function shownAnew(app) {
  const page = document.createElement('hgp-page');
  page.app = app;
  const aside = document.createElement('div');
  document.body.append(aside);
  aside.append(page);
  await drawn();
  // The stand-in for a browser sets a list before it has its entries.
  for (const panel of $$('*', page)) panel.requestUpdate?.();
  await drawn();
  const values = valuesIn(page);
  aside.remove();
  return values;
}

/** What may be typed into a field, or chosen: most of it is refused by most of them. */
function entriesFor(field) {
  if (field.type === 'checkbox') return [!field.checked];
  if (field.localName === 'select') return [...new Set([field.options[0].value, field.options[field.options.length - 1].value])]; // prettier-ignore
  if (field.type === 'range') return [field.min];
  return ['', '-3', '7'];
}

async function enter(field, value) {
  if (field.type === 'checkbox') field.checked = value;
  else field.value = String(value);
  for (const type of ['input', 'change']) field.dispatchEvent(new Event(type, { bubbles: true }));
  await drawn();
}

/** A ring of blocks without one triangle: it has a handle, a boundary, and cones. */
function ringWithHole() {
  const { vertices, triangles } = blocks(ring);
  return toObj({ vertices, triangles: triangles.slice(1) });
}

test(
  'fields show what holds, whatever was entered, at rest and while the solver runs',
  { skip },
  async (t) => {
    const app = await openPage(t);
    const { doc } = app;
    await openFiles(app, { 'ring.obj': ringWithHole() });
    app.ui.setAutomatic(false);
    await runNow(app);
    const page = document.querySelector('hgp-page');
    const begin = { history: doc.history, solve: doc.solve };
    const cone = (id) => Number(id.match(/^Cone (\d+)/)?.[1] ?? 0);
    for (const isRunning of [true, false]) {
      const all = fieldsIn(page).map(nameOf);
      assert.equal(new Set(all).size, all.length, `${all}`);
      const names = all.filter((id) => cone(id) < 3);
      for (const id of ['Cone 1: k', 'Turning index l of boundary 1', 'Rotation r of handle loop 1', 'weld', 'rounds', 'q-custom']) assert.ok(names.includes(id), id); // prettier-ignore
      for (const id of names) {
        const find = () => fieldsIn(page).find((one) => nameOf(one) === id);
        for (const value of find() ? entriesFor(find()) : []) {
          const field = find();
          if (!field || field.disabled || value === 'image') continue;
          let end;
          const job = isRunning && runJob(app, { kind: 'run', title: '', onFailure: assert.fail }, () => new Promise((resolve) => (end = resolve))); // prettier-ignore
          if (isRunning) await drawn();
          await enter(field, value);
          end?.();
          await job;
          await until(() => !doc.isBusy, `${id} after ${value}`);
          assert.deepEqual(
            valuesIn(page),
            await shownAnew(app),
            `${id} after ${value}, ${isRunning}`,
          );
        }
        Object.assign(doc, begin);
        await drawn();
      }
    }
  },
);
