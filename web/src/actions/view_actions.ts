// The actions on the views and on the page itself.

import { areSeamsShown } from '../model/grid';
import { noModel, type Action } from './action';
import type { App } from './app';
import { savePicture, saveTurntable, whyNoTurntable } from './picture';
import {
  frame,
  nextLight,
  nextOverlay,
  nextPattern,
  otherView,
  setLook,
  showHandles,
} from './view';

const lightNames = { studio: 'studio', side: 'from the side', gloss: 'glossy', flat: 'none' };

const seamsShown = ({ doc }: App): boolean =>
  doc.displayed !== undefined && areSeamsShown(doc.look, doc.displayed);

export const viewActions = {
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
  edges: {
    label: 'Choose edges that lines follow',
    group: 'View',
    keys: ['E'],
    icon: 'edges',
    isOn: ({ ui }) => ui.tool === 'edges',
    run: ({ ui, doc }) => {
      ui.tool = ui.tool === 'edges' ? 'orbit' : 'edges';
      if (ui.tool === 'orbit') return;
      doc.say(
        'Edges: click or tap one to choose its chain up to the next corner; Alt and a click removes it.',
      );
    },
  },
  frame: { label: 'Frame the model', group: 'View', keys: ['F'], icon: 'frame', run: frame },
  'reset-camera': {
    label: 'Reset the camera',
    group: 'View',
    keys: ['R'],
    run: ({ views }) => views?.model.orbit.reset(),
  },
  'next-light': {
    label: ({ doc }) => `Light: ${lightNames[doc.look.light]}`,
    group: 'View',
    keys: ['T'],
    icon: 'sun',
    run: nextLight,
  },
  picture: {
    label: 'Save a picture',
    group: 'View',
    icon: 'image',
    whyNot: noModel,
    run: savePicture,
  },
  turntable: {
    label: ({ ui }) => (ui.isRecording ? 'Stop the turntable' : 'Save a turntable'),
    group: 'View',
    icon: 'film',
    whyNot: (app) => noModel(app) || whyNoTurntable(),
    run: saveTurntable,
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
    run: ({ views }) => views?.model.orbit.toggleParallel(),
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

export const pageActions = {
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
