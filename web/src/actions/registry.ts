// Every action of the page, one entry each: buttons, keys, the list of keys and the palette read it.

import { areSeamsShown } from '../model/grid';
import { canRepair } from '../model/repairs';
import type { Icon } from '../text/icon_paths';
import { attempt, type App } from './app';
import { copyCommand } from './copy_command';
import { exportCones, download } from './download';
import { balance, clearCones, deleteCone, importCones, selectNext, setK } from './edit_cones';
import { cancel } from './job';
import { close } from './open';
import { repairAndRun } from './repair';
import { downloadQuads, whyNoQuads } from './quads';
import { runAll } from './run_all';
import { run, suggestCones, whyNotRun } from './solve';
import { redo, undo } from './undo';
import { validate } from './validate';
import {
  chooseFile,
  frame,
  nextOverlay,
  nextPattern,
  otherView,
  setLook,
  showHandles,
} from './view';

export type ActionGroup = 'File' | 'Run' | 'Cones' | 'View' | 'Page';

export interface Action {
  readonly label: string | ((app: App) => string);
  readonly group: ActionGroup;
  /** Ctrl combinations work anywhere, single keys only while a view has the focus. */
  readonly keys?: readonly string[];
  readonly icon?: Icon;
  /** Why the action is not possible now; empty or undefined if it is. */
  whyNot?(app: App): string;
  /** For actions that switch something: whether it is on. */
  isOn?(app: App): boolean;
  run(app: App): unknown;
}

const noModel = ({ doc }: App): string => (doc.model ? '' : 'Open a model first.');
const noMap = ({ doc }: App): string => (doc.current ? '' : 'Run first.');
const noCones = ({ doc }: App): string =>
  doc.prescription.cones.length > 0 ? '' : 'There are no cones.';
const notSelected = ({ doc }: App): string => (doc.selected >= 0 ? '' : 'Select a cone first.');
const notEditable = ({ doc }: App): string => (doc.usableModel ? '' : 'Open a model first.');
const selectedK = ({ doc }: App): number => doc.prescription.cones[doc.selected]?.k ?? 0;

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
  'delete-cone': {
    label: 'Delete the cone',
    group: 'Cones',
    keys: ['Delete', 'Backspace'],
    icon: 'cross',
    whyNot: notSelected,
    run: (app) => deleteCone(app, app.doc.selected),
  },
} satisfies Record<string, Action>;

const seamsShown = ({ doc }: App): boolean =>
  doc.displayed !== undefined && areSeamsShown(doc.look, doc.displayed);

const viewActions = {
  orbit: {
    label: 'Orbit',
    group: 'View',
    icon: 'orbit',
    isOn: ({ ui }) => ui.tool === 'orbit',
    run: ({ ui }) => (ui.tool = 'orbit'),
  },
  place: {
    label: 'Place cones',
    group: 'View',
    keys: ['C'],
    icon: 'place',
    isOn: ({ ui }) => ui.tool === 'place',
    run: ({ ui, doc }) => {
      ui.tool = ui.tool === 'place' ? 'orbit' : 'place';
      if (ui.tool === 'orbit') return;
      doc.say('Place: click or tap the surface; with keys, arrows and Enter in the 3D view.');
    },
  },
  frame: { label: 'Frame the model', group: 'View', keys: ['F'], icon: 'frame', run: frame },
  'reset-camera': {
    label: 'Reset the camera',
    group: 'View',
    keys: ['R'],
    run: ({ views }) => views?.model.orbit.reset(),
  },
  wire: {
    label: 'Wireframe',
    group: 'View',
    keys: ['L'],
    icon: 'wire',
    isOn: ({ doc }) => doc.look.hasWire,
    run: (app) => setLook(app, { hasWire: !app.doc.look.hasWire }),
  },
  seams: {
    label: 'Seams',
    group: 'View',
    keys: ['S'],
    icon: 'seams',
    whyNot: ({ doc }) => (doc.displayed ? '' : 'Run first.'),
    isOn: seamsShown,
    run: (app) => setLook(app, { seams: seamsShown(app) ? 'off' : 'on' }),
  },
  parallel: {
    label: 'Parallel projection',
    group: 'View',
    keys: ['O'],
    run: ({ views }) => views?.model.toggleParallel(),
  },
  'next-pattern': { label: 'Next pattern', group: 'View', keys: ['G'], run: nextPattern },
  'next-overlay': { label: 'Next overlay', group: 'View', keys: ['H'], run: nextOverlay },
  'other-view': { label: 'To the UV view and back', group: 'View', keys: ['U'], run: otherView },
  handles: {
    label: 'Loops around handles',
    group: 'View',
    whyNot: noModel,
    isOn: ({ ui }) => ui.handlesShown,
    run: (app) => showHandles(app, !app.ui.handlesShown),
  },
} satisfies Record<string, Action>;

const pageActions = {
  palette: {
    label: 'All actions',
    group: 'Page',
    keys: ['Ctrl+K'],
    icon: 'list',
    run: ({ ui }) => (ui.dialog = 'palette'),
  },
  help: {
    label: 'Help and shortcuts',
    group: 'Page',
    keys: ['?'],
    icon: 'help',
    run: ({ ui }) => (ui.dialog = 'help'),
  },
  log: { label: 'Log', group: 'Page', run: ({ ui }) => (ui.dialog = 'log') },
  theme: {
    label: ({ ui }) => `Theme: ${ui.theme}`,
    group: 'Page',
    icon: 'theme',
    run: ({ ui }) => ui.nextTheme(),
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
