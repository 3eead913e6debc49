// The document store: the open file, its prescription, its result.
// Panels and views read it and are notified of changes; only actions write to it.

import { computed } from '@preact/signals-core';
import type { Result } from 'hgp';
import { computeBudget, type Budget } from './gauss_bonnet';
import { sameGrid } from './grid';
import { History } from './history';
import { emptyPrescription, isSilent, samePrescription, type Prescription } from './prescription';
import { storeOf } from './store';
import type {
  Files,
  GridSettings,
  Job,
  LoadSettings,
  Look,
  MeshSummary,
  Message,
  MessageAction,
  Missing,
  Model,
  Objection,
  Output,
  SolveSettings,
  Solution,
  Step,
  Validation,
} from './types';
import { isCertified } from './verdict';

/** What is open; everything that only makes sense with a model is inside `open`. */
export type DocumentState =
  | { readonly kind: 'starting' }
  | { readonly kind: 'failed' }
  | { readonly kind: 'empty' }
  | {
      readonly kind: 'needs-files';
      readonly files: Files;
      readonly main: string;
      readonly missing: Missing[];
    }
  | { readonly kind: 'pick-model'; readonly files: Files; readonly candidates: string[] }
  | { readonly kind: 'open'; readonly model: Model };

/** What was made of one mesh of a file: it waits while another is looked at. */
export interface MeshWork {
  readonly model: Model;
  readonly history: History<Step>;
  readonly solutions: readonly Solution[];
  readonly hasUserCones: boolean;
}

interface Fields {
  state: DocumentState;
  job: Job | undefined;
  history: History<Step>;
  /** The newest last, at most three: undo finds the map that belongs to it. */
  solutions: readonly Solution[];
  /** The other meshes of the file that were worked on, by index. */
  meshes: ReadonlyMap<number, MeshWork>;
  /** Small pictures of the meshes, as far as they were made. */
  thumbnails: ReadonlyMap<number, Uint8ClampedArray>;
  /** What each mesh of the file is good for, where that is known. */
  summaries: readonly MeshSummary[];
  solve: SolveSettings;
  /** The direction field that the cones were imported from last, as it was read. */
  field: { name: string; text: string } | undefined;
  /** The user has said what the cones are, even if that is none. */
  hasUserCones: boolean;
  /** Where the slider between few cones and little distortion stands. */
  coneStep: number;
  /** Index of the selected cone, −1 for none. */
  selected: number;
  /** The map that the worker holds, and can write again without solving. */
  resultInWorker: Result | undefined;
  /** How the file shall be written, while it is. */
  pendingOutput: Output | undefined;
  validation: Validation | undefined;
  objection: Objection | undefined;
  message: Message | undefined;
  /** What has been said since the page was opened, the newest last. */
  log: readonly { time: Date; text: string }[];
  look: Look;
  isUnsaved: boolean;
}

/** As the solver reads them. */
export const loadOptionsOf = ({ weld, fix, hasAllRepairs }: LoadSettings) =>
  hasAllRepairs ? { weld } : { weld, fix };
export const plainSettings: LoadSettings = { fix: {} };
export const plainGrid: GridSettings = { isOn: true, mode: 'tile' };
export const plainOutput: Output = {
  ...{ scale: 'solved', usesNewSet: false, embedCones: true, hasGrid: false },
};
const plainLook: Look = {
  pattern: 'checker',
  overlay: 'none',
  tiles: 24,
  steps: 1,
  seams: 'auto',
  hasWire: false,
};
const middleStep = 2; // of five: balanced
const mostLog = 200;

const begun = (prescription: Prescription, settings = plainSettings): History<Step> =>
  History.of({ prescription, settings });

export class Document extends storeOf<Fields>() {
  /** The model that was open before, where it had cones: a new version of it takes them over. */
  previous?: { model: Model; prescription: Prescription };
  /** Counts what has been dropped, chosen or closed: what was asked for last is what is opened. */
  openRequestId = 0;

  constructor() {
    super({
      state: { kind: 'starting' },
      job: undefined,
      history: begun(emptyPrescription(4, 0, 0)),
      solutions: [],
      meshes: new Map(),
      thumbnails: new Map(),
      summaries: [],
      solve: { rounds: 12, frames: 'auto', grid: plainGrid },
      field: undefined,
      hasUserCones: false,
      coneStep: middleStep,
      selected: -1,
      resultInWorker: undefined,
      pendingOutput: undefined,
      validation: undefined,
      objection: undefined,
      message: undefined,
      log: [],
      look: plainLook,
      isUnsaved: false,
    });
  }

  get model(): Model | undefined {
    return this.state.kind === 'open' ? this.state.model : undefined;
  }
  /** The model, where it can be solved. */
  get usableModel(): Model | undefined {
    return this.model?.info.usable ? this.model : undefined;
  }
  get prescription(): Prescription {
    return this.history.value.prescription;
  }
  get settings(): LoadSettings {
    return this.history.value.settings;
  }
  get isBusy(): boolean {
    return this.job !== undefined;
  }

  readonly #objectionNow = computed(() => {
    const { objection, prescription, model } = this;
    const isAbout =
      objection?.prescription === prescription && objection.surface === model?.surface;
    return isAbout ? objection : undefined;
  });

  readonly #budget = computed((): Budget | undefined => {
    const model = this.usableModel;
    if (!model) return undefined;
    const budget = computeBudget(this.prescription, model.surface, model.info);
    const { text, warnings = [] } = this.#objectionNow.value ?? {};
    return text ? { ...budget, isReady: false, text, warnings } : { ...budget, warnings };
  });
  get budget(): Budget | undefined {
    return this.#budget.value;
  }

  readonly #forSurface = computed((): readonly Solution[] => {
    const loaded = this.model?.loaded;
    return this.solutions.filter(({ settings }) => sameSettings(settings, loaded));
  });

  readonly #current = computed((): Solution | undefined => {
    const { improve, frames, grid } = this.solve;
    return this.#forSurface.value.findLast(
      (one) =>
        one.improve === improve &&
        one.frames === frames &&
        sameGrid(one.grid, grid, one.prescription.q) &&
        samePrescription(one.prescription, this.prescription),
    );
  });
  /** The solution of exactly what is prescribed now. */
  get current(): Solution | undefined {
    return this.#current.value;
  }

  readonly #displayed = computed(() => this.#current.value ?? this.#forSurface.value.at(-1));
  /** What the views show: the current solution, or the last one, which is then stale. */
  get displayed(): Solution | undefined {
    return this.#displayed.value;
  }

  /** Run suggests cones where nothing has been said: a turning or a rotation is something said. */
  get needsCones(): boolean {
    return isSilent(this.prescription) && (!this.hasUserCones || !this.budget?.isReady);
  }

  readonly #stateName = computed((): string => {
    const { state, job } = this;
    if (job) return job.kind === 'load' ? 'loading' : 'running';
    if (state.kind !== 'open') return state.kind;
    if (!state.model.info.usable) return 'invalid';
    if (this.current) return isCertified(this.current) ? 'certified' : 'not-certified';
    if (this.displayed) return 'stale';
    return this.budget?.isReady || this.needsCones ? 'ready' : 'unbalanced';
  });
  /** The state of the page in one word. */
  get stateName(): string {
    return this.#stateName.value;
  }

  /** A new beginning that undo does not cross. */
  begin(prescription: Prescription, settings: LoadSettings = this.settings): void {
    this.history = begun(prescription, settings);
  }

  /** Frames can come from a file only where one with directions was imported. */
  takeField(field?: { name: string; text: string }): void {
    this.field = field;
    if (!field) this.solve = { ...this.solve, frames: 'auto' };
  }

  say(text: string, kind: Message['kind'] = 'note', actions?: MessageAction[], details = ''): void {
    this.message = { kind, text, actions, details };
    this.log = [...this.log.slice(1 - mostLog), { time: new Date(), text: `${text} ${details}` }];
  }

  /** The mesh that is open, to come back to. */
  get work(): MeshWork | undefined {
    const { model, history, solutions, hasUserCones } = this;
    return model && { model, history, solutions, hasUserCones };
  }

  /** Nothing is left of the mesh that was open; the file may be. */
  clearMesh(): void {
    this.solutions = [];
    this.selected = -1;
    this.hasUserCones = false;
    this.coneStep = middleStep;
    this.resultInWorker = undefined;
    this.validation = undefined;
    this.message = undefined;
    this.takeField();
    this.begin(emptyPrescription(this.prescription.q, 0, 0), plainSettings);
  }

  clearModel(): void {
    const { job, model, prescription } = this;
    this.job = undefined; // what it still has to say is about a closed model
    job?.controller.abort();
    const isWorth = model?.info.usable && prescription.cones.length > 0;
    this.previous = isWorth ? { model, prescription } : undefined;
    this.state = { kind: 'empty' };
    this.meshes = new Map();
    this.summaries = [];
    this.thumbnails = new Map();
    this.isUnsaved = false;
    this.clearMesh();
  }
}

const sameSettings = (a: LoadSettings, b: LoadSettings | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);
