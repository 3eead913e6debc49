// Every action of the page, one entry each: buttons, keys, the list of keys and the palette read it.

import { canRepair } from '../model/repairs';
import { noModel, type Action } from './action';
import { attempt, type App } from './app';
import { showRuns, whyNotCompare } from './compare_runs';
import { copyCommand } from './copy_command';
import { exportCones, download } from './download';
import { balance, clearCones, deleteCone, importCones, selectNext, setK } from './edit_cones';
import { cancel } from './job';
import { close } from './open';
import { copyLink } from './share';
import { mirrorCone } from './mirror_cone';
import { repairAndRun } from './repair';
import { downloadQuads, whyNoQuads } from './quads';
import { runAll } from './run_all';
import { run, suggestCones, whyNotRun } from './solve';
import { redo, undo } from './undo';
import { validate } from './validate';
import { chooseFile } from './view';
import { pageActions, viewActions } from './view_actions';

const noMap = ({ doc }: App): string => (doc.current ? '' : 'Run first.');
const noCones = ({ doc }: App): string =>
  doc.prescription.cones.length > 0 ? '' : 'There are no cones.';
const notSelected = ({ doc }: App): string => (doc.selected >= 0 ? '' : 'Select a cone first.');
const notEditable = ({ doc }: App): string => (doc.usableModel ? '' : 'Open a model first.');
const selectedK = ({ doc }: App): number => doc.prescription.cones[doc.selected].k;

const fileActions = {
  open: {
    label: 'Open',
    group: 'File',
    keys: ['Ctrl+O'],
    icon: 'open',
    run: () => document.querySelector<HTMLInputElement>('#file')?.click(),
  },
  'open-folder': {
    label: 'Open a folder',
    group: 'File',
    icon: 'folder',
    run: () => document.querySelector<HTMLInputElement>('#folder')?.click(),
  },
  close: {
    label: ({ doc }) => `Close ${doc.model?.main ?? ''}`.trim(),
    group: 'File',
    icon: 'cross',
    whyNot: noModel,
    run: close,
  },
  download: {
    label: ({ doc, ui: _ }) =>
      doc.current && doc.stateName === 'not-certified' ? 'Download uncertified result' : 'Download',
    group: 'File',
    keys: ['Ctrl+S'],
    icon: 'download',
    whyNot: noMap,
    run: ({ ui }) => (ui.dialog = 'download'),
  },
  'download-quads': {
    label: 'Download quads',
    group: 'File',
    whyNot: whyNoQuads,
    run: (app) => downloadQuads(app, 'obj'),
  },
  'copy-link': {
    label: 'Copy a link to these cones and settings',
    group: 'File',
    icon: 'link',
    whyNot: noModel,
    run: copyLink,
  },
  'save-report': {
    label: 'Save report',
    group: 'File',
    whyNot: noMap,
    run: (app) => download(app, 'report'),
  },
  validate: { label: 'Validate output', group: 'File', whyNot: noMap, run: validate },
  'copy-command': {
    label: 'Copy the command that does this',
    group: 'File',
    whyNot: noModel,
    run: copyCommand,
  },
} satisfies Record<string, Action>;

const runActions = {
  run: { label: 'Run', group: 'Run', keys: ['Ctrl+Enter'], icon: 'run', whyNot: whyNotRun, run },
  'run-all': {
    label: 'Run all meshes',
    group: 'Run',
    icon: 'run',
    whyNot: ({ doc }) => {
      if (!doc.model) return 'Open a model first.';
      if (doc.isBusy) return 'Something is running already.';
      return doc.model.info.surfaces.length > 1 ? '' : 'The file has one mesh.';
    },
    run: runAll,
  },
  'repair-and-run': {
    label: 'Repair and run',
    group: 'Run',
    icon: 'run',
    whyNot: ({ doc }) =>
      doc.model && !doc.isBusy && canRepair(doc.model) ? '' : 'Nothing to repair.',
    run: repairAndRun,
  },
  cancel: {
    label: 'Cancel',
    group: 'Run',
    icon: 'cross',
    whyNot: ({ doc }) => (doc.isBusy ? '' : 'Nothing is running.'),
    run: cancel,
  },
  compare: {
    label: 'Compare runs',
    group: 'Run',
    whyNot: whyNotCompare,
    run: showRuns,
  },
  undo: {
    label: ({ doc }) => `Undo ${doc.history.undoKind}`.trim(),
    group: 'Run',
    keys: ['Ctrl+Z'],
    icon: 'undo',
    whyNot: ({ doc }) => (doc.history.canUndo && !doc.isBusy ? '' : 'Nothing to undo.'),
    run: undo,
  },
  redo: {
    label: ({ doc }) => `Redo ${doc.history.redoKind}`.trim(),
    group: 'Run',
    keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
    icon: 'redo',
    whyNot: ({ doc }) => (doc.history.canRedo && !doc.isBusy ? '' : 'Nothing to redo.'),
    run: redo,
  },
} satisfies Record<string, Action>;

async function importFromFile(app: App): Promise<void> {
  const file = await chooseFile('');
  if (file) await importCones(app, file.name, await file.text());
}

const coneActions = {
  suggest: {
    label: 'Suggest cones',
    group: 'Cones',
    icon: 'wand',
    whyNot: notEditable,
    run: (app) => suggestCones(app),
  },
  balance: {
    label: 'Balance for me',
    group: 'Cones',
    icon: 'balance',
    whyNot: (app) =>
      notEditable(app) ||
      (app.doc.budget?.components.every((one) => one.isBalanced) ? 'It is balanced already.' : ''),
    run: balance,
  },
  'import-cones': { label: 'Import cones…', group: 'Cones', whyNot: noModel, run: importFromFile },
  'export-cones': { label: 'Export cones', group: 'Cones', whyNot: noCones, run: exportCones },
  'clear-cones': { label: 'Clear cones', group: 'Cones', whyNot: noCones, run: clearCones },
  'next-cone': {
    label: 'Next cone',
    group: 'Cones',
    keys: ['N'],
    whyNot: noCones,
    run: (app) => selectNext(app, 1),
  },
  'previous-cone': {
    label: 'Previous cone',
    group: 'Cones',
    keys: ['P'],
    whyNot: noCones,
    run: (app) => selectNext(app, -1),
  },
  'larger-k': {
    label: 'Larger k',
    group: 'Cones',
    keys: ['+', '='],
    whyNot: notSelected,
    run: (app) => setK(app, app.doc.selected, selectedK(app) + 1),
  },
  'smaller-k': {
    label: 'Smaller k',
    group: 'Cones',
    keys: ['-', '−'],
    whyNot: notSelected,
    run: (app) => setK(app, app.doc.selected, selectedK(app) - 1),
  },
  'mirror-cone': {
    label: 'Mirror the cone',
    group: 'Cones',
    keys: ['X'],
    icon: 'mirror',
    whyNot: notSelected,
    run: mirrorCone,
  },
  'delete-cone': {
    label: 'Delete the cone',
    group: 'Cones',
    keys: ['Delete', 'Backspace'],
    icon: 'cross',
    whyNot: notSelected,
    run: (app) => deleteCone(app, app.doc.selected),
  },
} satisfies Record<string, Action>;

const all = { ...fileActions, ...runActions, ...coneActions, ...viewActions, ...pageActions };
export type ActionId = keyof typeof all;

export const actions: Readonly<Record<ActionId, Action>> = all;
export const actionIds = Object.keys(all) as ActionId[];

export function labelOf(app: App, id: ActionId): string {
  const { label } = actions[id];
  return typeof label === 'string' ? label : label(app);
}

export const whyNotOf = (app: App, id: ActionId): string => actions[id].whyNot?.(app) ?? '';

/** Whether a dialog waits for an answer: nothing behind it may change. */
export function isDialogOpen({ doc, ui }: App): boolean {
  return ui.dialog !== '' || doc.state.kind === 'needs-files' || doc.state.kind === 'pick-model';
}

/** Performs the action, or tells the user why it is not possible. Failures are reported. */
export function perform(app: App, id: ActionId): Promise<void> {
  const why = whyNotOf(app, id);
  if (why === '') return attempt(app, () => actions[id].run(app));
  app.doc.say(why);
  return Promise.resolve();
}

/** A key event in the notation of the registry. */
export function keyOf(event: KeyboardEvent): string {
  const name = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  if (!event.ctrlKey && !event.metaKey) return name;
  return `Ctrl+${event.shiftKey ? 'Shift+' : ''}${name}`;
}

const byKey = new Map(actionIds.flatMap((id) => (actions[id].keys ?? []).map((key) => [key, id])));
export const actionForKey = (key: string): ActionId | undefined => byKey.get(key);
