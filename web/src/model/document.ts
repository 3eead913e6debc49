// The document store: the open file, its prescription, its result.
// Panels and views read it and are notified of changes; only actions write to it.

import { computed } from '@preact/signals-core';
import { computeBudget, type Budget } from './gauss_bonnet';
import { sameFeatures, type FeatureChoice } from './features';
import { sameGrid } from './grid';
import { History } from './history';
import type { LiveMap } from './live';
import { emptyPrescription, isSilent, samePrescription, type Prescription } from './prescription';
import { plainGrid, plainLook, plainSettings } from './plain';
import { plainRounds } from './request';
import { storeOf } from './store';
import type { ScenePart } from './scene';
import type {
  DirectionField,
  Files,
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
  QuadPreview,
  SolveSettings,
  Solution,
  Step,
  Validation,
} from './types';
import { isCertified } from './verdict';
import type { Wanted } from './wanted';

/** What is open; everything that requires a model is inside `open`. */
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

/** The work on one mesh of a file, kept while another mesh is open. */
export interface MeshWork {
  readonly model: Model;
  readonly history: History<Step>;
  readonly solutions: readonly Solution[];
  readonly hasUserCones: boolean;
  readonly firstRun: number | undefined;
  readonly features: FeatureChoice | undefined;
}

interface Fields {
  state: DocumentState;
  job: Job | undefined;
  /** The map that is being made without Run; the document can be edited meanwhile. */
  automatic: { readonly controller: AbortController; readonly stage: string } | undefined;
  /** For what a run was cancelled, took too long or failed, or is under way: no map of it is made without Run. */
  notAgain: Wanted | undefined;
  /** For what a map is made without Run even where edits have none: of a cone that was dropped out of the map's reach. */
  promised: Wanted | undefined;
  /** Milliseconds that the first run on this mesh took. */
  firstRun: number | undefined;
  /** What is shown instead of a map: of a cone that is being dragged, or the scale of cones whose map is being made. */
  live: LiveMap | undefined;
  history: History<Step>;
  /** At most three, the newest last, so that undo can show the map of its step. */
  solutions: readonly Solution[];
  /** The other meshes of the file that have been open, by index. */
  meshes: ReadonlyMap<number, MeshWork>;
  /** Thumbnails of the meshes that have one. */
  thumbnails: ReadonlyMap<number, Uint8ClampedArray>;
  /** The meshes of the file as they are drawn beside the open one: of several meshes, or of one that is used often. */
  parts: readonly ScenePart[];
  /** Summaries of the meshes of the file, as far as known. */
  summaries: readonly MeshSummary[];
  solve: SolveSettings;
  /** The direction field from which cones were last imported, as read. */
  field: DirectionField | undefined;
  /** The edges that the next map is to have as straight lines. */
  features: FeatureChoice | undefined;
  /** Whether the user has set the cones, possibly to none. */
  hasUserCones: boolean;
  /** Position of the slider between few cones and low distortion. */
  coneStep: number;
  /** Index of the selected cone, −1 for none. */
  selected: number;
  /** Output settings that are being applied while the file is written. */
  pendingOutput: Output | undefined;
  validation: Validation | undefined;
  objection: Objection | undefined;
  message: Message | undefined;
  /** Messages since the page was opened, the newest last. */
  log: readonly { time: Date; text: string }[];
  look: Look;
  quads: QuadPreview | undefined;
  isUnsaved: boolean;
}

const middleStep = 2; // of five: balanced
const maxLog = 200;

const begun = (prescription: Prescription, settings = plainSettings): History<Step> =>
  History.of({ prescription, settings });

export class Document extends storeOf<Fields>() {
  /** The previously open model, if it had cones: they are transferred to a new version of it. */
  previous?: { model: Model; prescription: Prescription };
  /** Counts requests to open or close; only the result of the last request is used. */
  openRequestId = 0;

  constructor() {
    super({
      state: { kind: 'starting' },
      job: undefined,
      automatic: undefined,
      notAgain: undefined,
      promised: undefined,
      firstRun: undefined,
      live: undefined,
      history: begun(emptyPrescription(4, 0, 0)),
      solutions: [],
      meshes: new Map(),
      thumbnails: new Map(),
      parts: [],
      summaries: [],
      solve: { rounds: plainRounds, frames: 'auto', grid: plainGrid },
      field: undefined,
      features: undefined,
      hasUserCones: false,
      coneStep: middleStep,
      selected: -1,
      pendingOutput: undefined,
      validation: undefined,
      objection: undefined,
      message: undefined,
      log: [],
      look: plainLook,
      quads: undefined,
      isUnsaved: false,
    });
  }

  get model(): Model | undefined {
    return this.state.kind === 'open' ? this.state.model : undefined;
  }
  /** The model, if it can be solved. */
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
    const { objection, prescription, model, askedFeatures } = this;
    const isAbout =
      objection?.prescription === prescription &&
      objection.surface === model?.surface &&
      objection.features === askedFeatures;
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
        one.field === this.askedField &&
        sameFeatures(one.features, this.askedFeatures) &&
        sameGrid(one.grid, grid, one.prescription.q) &&
        samePrescription(one.prescription, this.prescription),
    );
  });
  /** What Run would make a map of; undefined if there is nothing to run. */
  get wanted(): Wanted | undefined {
    const {
      usableModel: model,
      prescription,
      solve,
      askedFeatures: features,
      askedField: field,
    } = this;
    return model && { model, prescription, solve, features, field };
  }
  /** The field whose directions are the frames of a run. */
  get askedField(): DirectionField | undefined {
    return this.solve.frames === 'file' ? this.field : undefined;
  }
  /** The features that a run follows: lines follow them for q = 4 and where frames are not those of a file. */
  get askedFeatures(): FeatureChoice | undefined {
    return this.askedField || this.prescription.q !== 4 ? undefined : this.features;
  }
  /** The solution of exactly the current prescription. */
  get current(): Solution | undefined {
    return this.#current.value;
  }

  readonly #displayed = computed(() => this.#current.value ?? this.#forSurface.value.at(-1));
  /** The solution that the views show: the current one or, marked as stale, the last one. */
  get displayed(): Solution | undefined {
    return this.#displayed.value;
  }

  /** The runs on this surface that are kept, the newest last. */
  get runs(): readonly Solution[] {
    return this.#forSurface.value;
  }

  /** The solution that the displayed one has replaced, if that is the newest. */
  get beforeDisplayed(): Solution | undefined {
    const all = this.#forSurface.value;
    return all.at(-1) === this.displayed ? all.at(-2) : undefined;
  }

  /** Whether Run chooses cones: only if nothing is prescribed, neither cones nor turnings nor rotations. */
  get needsCones(): boolean {
    return isSilent(this.prescription) && (!this.hasUserCones || !this.budget?.isReady);
  }

  /** Whether Run chooses the cones: where nothing is prescribed, and along features unless those that are placed are kept. */
  get choosesCones(): boolean {
    const { askedFeatures: features, askedField: field, needsCones, prescription } = this;
    return features ? !features.keepsCones || isSilent(prescription) : needsCones && !field;
  }

  readonly #stateName = computed((): string => {
    const { state, job } = this;
    if (job) return job.kind === 'load' ? 'loading' : 'running';
    if (state.kind !== 'open') return state.kind;
    if (!state.model.info.usable) return 'invalid';
    if (this.automatic) return 'renewing';
    if (this.live) return 'dragging';
    if (this.current) return isCertified(this.current) ? 'certified' : 'not-certified';
    if (this.displayed) return 'stale';
    return this.budget?.isReady || this.needsCones || this.choosesCones ? 'ready' : 'unbalanced';
  });
  /** The state of the page in one word. */
  get stateName(): string {
    return this.#stateName.value;
  }

  /** Starts a new history, beyond which undo does not go. */
  begin(prescription: Prescription, settings: LoadSettings = this.settings): void {
    this.history = begun(prescription, settings);
  }

  /** Stores an imported field; frames can be taken from it only if it has directions. */
  takeField(field?: DirectionField): void {
    this.field = field;
    if (!field) this.solve = { ...this.solve, frames: 'auto' };
  }

  say(text: string, kind: Message['kind'] = 'note', actions?: MessageAction[], details = ''): void {
    this.message = { kind, text, actions, details };
    this.log = [...this.log.slice(1 - maxLog), { time: new Date(), text: `${text} ${details}` }];
  }

  /** The work on the open mesh, to be restored later. */
  get work(): MeshWork | undefined {
    const { model, history, solutions, hasUserCones, firstRun, features } = this;
    return model && { model, history, solutions, hasUserCones, firstRun, features };
  }

  /** Clears everything about the open mesh, but not the file. */
  clearMesh(): void {
    this.automatic?.controller.abort();
    this.automatic = undefined;
    this.notAgain = undefined;
    this.promised = undefined;
    this.live = undefined;
    this.firstRun = undefined;
    this.solutions = [];
    this.selected = -1;
    this.hasUserCones = false;
    this.coneStep = middleStep;
    this.validation = undefined;
    this.quads = undefined;
    this.message = undefined;
    this.features = undefined;
    this.takeField();
    this.begin(emptyPrescription(this.prescription.q, 0, 0), plainSettings);
  }

  clearModel(): void {
    const { job, model, prescription } = this;
    this.job = undefined; // its further reports are about a closed model
    job?.controller.abort();
    const isWorth = model?.info.usable && prescription.cones.length > 0;
    // A version that could not be read does not end what is known of the one before.
    if (model) this.previous = isWorth ? { model, prescription } : undefined;
    this.state = { kind: 'empty' };
    this.meshes = new Map();
    this.parts = [];
    this.summaries = [];
    this.thumbnails = new Map();
    this.isUnsaved = false;
    this.clearMesh();
  }
}

/** The members of a document. */
export type OpenDocument = Pick<Document, keyof Document>;
/** The same for those who only read it: views, panels, input. What they have to say goes through say(). */
export type ReadonlyDocument = Readonly<OpenDocument>;

const sameSettings = (a: LoadSettings, b: LoadSettings | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);
