// What the page is about, in one place: files, surface, what is asked, results. Panels and views read
// it and are told when it changes; the files beside this one change it.

import type { Client, ModelInfo, Result, Where } from 'hgp';
import { computeBudget, type Budget } from './budget';
import type { Objection } from './check';
import type { Files, Missing } from './files';
import { History } from './history';
import { emptyPrescription, sameAsked, type Prescription } from './prescription';
import type { Output, Solved } from './solved';
import type { Surface } from './surface';
import type { MeshSurvey } from './survey';
import type { Validation } from './validate';

export type Phase =
  | 'starting'
  | 'empty'
  | 'loading'
  | 'needs-files'
  | 'pick-mesh'
  | 'invalid'
  | 'editing'
  | 'running';

export interface Message {
  kind: 'note' | 'good' | 'error';
  text: string;
  actions?: { label: string; do(): void }[];
}

export interface Progress {
  title: string;
  stage: string;
  detail: string;
  fraction: number;
  begin: number;
}

export type Pattern =
  'cross' | 'grid' | 'checker' | 'hex' | 'circles' | 'image' | 'material' | 'plain';
export type Overlay = 'none' | 'angle' | 'area' | 'seams' | 'flips';

export interface Look {
  pattern: Pattern;
  overlay: Overlay;
  /** Tiles along the diagonal of the bounding box. */
  tiles: number;
  hasSeams: boolean;
  hasWire: boolean;
  image?: ImageBitmap;
}

export const patterns: Pattern[] = [
  'cross',
  'grid',
  'checker',
  'hex',
  'circles',
  'image',
  'material',
  'plain',
];
export const overlays: Overlay[] = ['none', 'angle', 'area', 'seams', 'flips'];

export interface LoadSettings {
  readonly weld?: number;
  readonly fix: {
    readonly orient?: boolean;
    readonly split?: boolean;
    readonly degenerate?: boolean;
  };
}

/** What undo goes back and forth over. */
export interface Step {
  readonly asked: Prescription;
  readonly settings: LoadSettings;
}

/** How Run is done; what is asked of the map is elsewhere. */
export interface SolveSettings {
  rounds: number;
  quality: boolean;
  /** `file`: the directions of the imported field, instead of a smooth field of the solver's own. */
  frames: 'auto' | 'file';
  /** In seconds; without it a run takes as long as it takes. */
  timeLimit?: number;
}

const plainSettings: LoadSettings = { fix: {} };

const mostLog = 200;

export class App {
  phase: Phase = 'starting';
  client?: Client;
  files: Files = new Map();
  main = '';
  missing: Missing[] = [];
  /** Several models were dropped: which one? */
  candidates: string[] = [];
  info?: ModelInfo;
  /** About the mesh that is open: how it is used, what it has already. */
  remarks: string[] = [];
  /** What `info` and `surface` were loaded with; undo may be ahead of it. */
  loaded: LoadSettings = plainSettings;
  /** Of each mesh of a file that holds several. */
  survey: MeshSurvey[] = [];
  surface?: Surface;
  /** The model that was open before, where it had cones: a new version of it takes them over. */
  previous?: { main: string; asked: Prescription; surface: Surface; info: ModelInfo };
  history = new History<Step>({ asked: emptyPrescription(4, 0, 0), settings: plainSettings });
  solve: SolveSettings = { rounds: 12, quality: false, frames: 'auto' };
  /** The direction field that the cones were imported from last, as it was read. */
  field?: { name: string; text: string };
  /** The user has said what the cones are, even if that is none. */
  isExplicit = false;
  keepsBalanced = false;
  /** Vertices of cones, the one edited last at the end. */
  editOrder: number[] = [];
  /** Index of the selected cone, −1 for none. */
  selected = -1;
  /** Up to three, the newest last: undo finds the map that belongs to it. */
  results: Solved[] = [];
  /** The map that the worker holds, and can write again without solving. */
  inWorker?: Result;
  /** How the file shall be written, while it is. */
  wanted?: Output;
  validation?: Validation;
  /** What the solver says of cones that add up. */
  objection?: Objection;
  /** Outlines places; there once the views are. */
  showPlaces?: (where: Where[]) => void;
  message?: Message;
  /** What has been said since the page was opened, the newest last. */
  readonly log: { time: Date; text: string }[] = [];
  progress?: Progress;
  /** What the solver chooses for this surface by itself, by q, as far as that is known. */
  natural = new Map<number, Prescription>();
  look: Look = { pattern: 'cross', overlay: 'none', tiles: 24, hasSeams: true, hasWire: false };
  running?: AbortController;
  /** Counts what has been dropped, chosen or closed: what was asked for last is what is opened. */
  openings = 0;
  isUnsaved = false;
  #listeners = new Set<() => void>();
  #isTelling = false;
  /** Computed once for what it is the budget of. */
  #budget?: { of: unknown[]; budget: Budget };

  get asked(): Prescription {
    return this.history.value.asked;
  }

  get settings(): LoadSettings {
    return this.history.value.settings;
  }

  /** A new beginning that undo does not cross. */
  begin(asked: Prescription, settings: LoadSettings = this.settings): void {
    this.history = new History<Step>({ asked, settings });
    this.editOrder = [];
  }

  get budget(): Budget | undefined {
    const { asked, surface, info } = this;
    if (!surface || !info?.usable) return undefined;
    const of = [asked, surface, info, this.objectionNow];
    if (this.#budget?.of.every((one, i) => one === of[i])) return this.#budget.budget;
    const budget = computeBudget(asked, surface, info);
    const { text, warnings = [] } = this.objectionNow ?? {};
    Object.assign(budget, text ? { isReady: false, text, warnings } : { warnings });
    this.#budget = { of, budget };
    return budget;
  }

  get objectionNow(): Objection | undefined {
    const { objection, asked, surface } = this;
    return objection?.asked === asked && objection.surface === surface ? objection : undefined;
  }

  /** Results on the surface as it is now, which repairs and welds make another. */
  get fitting(): Solved[] {
    const now = JSON.stringify(this.loaded);
    return this.results.filter(({ settings }) => JSON.stringify(settings) === now);
  }

  /** The result of exactly what is asked now. */
  get current(): Solved | undefined {
    const { quality, frames } = this.solve;
    return this.fitting.findLast(
      (one) => one.quality === quality && one.frames === frames && sameAsked(one.asked, this.asked),
    );
  }

  /** What is asked is what the solver would choose by itself. */
  get isNatural(): boolean {
    const natural = this.natural.get(this.asked.q);
    return natural !== undefined && sameAsked(natural, this.asked);
  }

  /** What the views show: the current result, or the last one, which is then stale. */
  get shown(): Solved | undefined {
    return this.current ?? this.fitting.at(-1);
  }

  /** Run suggests cones where nothing has been said: a turning or a rotation is something said. */
  get needsCones(): boolean {
    const { cones, turnings, handles } = this.asked;
    const isSilent = cones.length === 0 && [...turnings, ...handles].every((n) => n === null);
    return isSilent && (!this.isExplicit || !this.budget?.isReady);
  }

  /** The state of the page in one word. */
  get state(): string {
    if (this.phase !== 'editing') return this.phase;
    if (this.current) return this.current.isCertified ? 'certified' : 'not-certified';
    if (this.shown) return 'stale';
    return this.budget?.isReady || this.needsCones ? 'ready' : 'unbalanced';
  }

  /** Frames can come from a file only where one with directions was imported. */
  takeField(field?: { name: string; text: string }): void {
    this.field = field;
    if (!field) this.solve = { ...this.solve, frames: 'auto' };
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  /** Tells everyone once per frame, however much changes. */
  changed(): void {
    if (this.#isTelling) return;
    this.#isTelling = true;
    queueMicrotask(() => {
      this.#isTelling = false;
      for (const listener of this.#listeners) listener();
    });
  }

  say(text: string, kind: Message['kind'] = 'note', actions?: Message['actions']): void {
    this.message = { kind, text, actions };
    this.log.push({ time: new Date(), text });
    if (this.log.length > mostLog) this.log.shift();
    this.changed();
  }

  forgetModel(): void {
    const before = this.running;
    this.running = this.progress = undefined; // what it still has to say is about a closed model
    before?.abort();
    const { main, asked, surface, info } = this;
    const isWorth = surface && info?.usable && asked.cones.length > 0;
    this.previous = isWorth ? { main, asked, surface, info } : undefined;
    this.info = undefined;
    this.surface = undefined;
    this.results = [];
    this.selected = -1;
    this.missing = [];
    this.candidates = [];
    this.isExplicit = false;
    this.natural.clear();
    this.isUnsaved = false;
    this.survey = [];
    this.inWorker = undefined;
    this.takeField();
    this.loaded = plainSettings;
    this.message = undefined;
    this.begin(emptyPrescription(this.asked.q, 0, 0), plainSettings);
  }
}
