// What the page is about, in one place: files, surface, what is asked, results. Panels and views read
// it and are told when it changes; the files beside this one change it.

import type { Client, ModelInfo } from 'hgp';
import { computeBudget, type Budget } from './budget';
import type { Files, Missing } from './files';
import { History } from './history';
import { emptyPrescription, sameAsked, type Prescription } from './prescription';
import type { Solved } from './solved';
import type { Surface } from './surface';

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
export type Overlay = 'none' | 'angle' | 'area' | 'flips';

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
export const overlays: Overlay[] = ['none', 'angle', 'area', 'flips'];

export interface LoadSettings {
  weld?: number;
  fix: { orient?: boolean; split?: boolean; degenerate?: boolean };
}

export class App {
  phase: Phase = 'starting';
  client?: Client;
  files: Files = new Map();
  main = '';
  missing: Missing[] = [];
  /** Several models were dropped: which one? */
  candidates: string[] = [];
  settings: LoadSettings = { fix: {} };
  info?: ModelInfo;
  surface?: Surface;
  history = new History<Prescription>(emptyPrescription(4, 0, 0));
  /** The user has said what the cones are, even if that is none. */
  isExplicit = false;
  keepsBalanced = false;
  /** Index of the selected cone, −1 for none. */
  selected = -1;
  /** Up to three, the newest last: undo finds the map that belongs to it. */
  results: Solved[] = [];
  message?: Message;
  progress?: Progress;
  /** What was chosen without being asked, so that the page can say so. */
  hasSuggested = false;
  look: Look = { pattern: 'cross', overlay: 'none', tiles: 24, hasSeams: true, hasWire: false };
  running?: AbortController;
  isUnsaved = false;
  #listeners = new Set<() => void>();
  #isTelling = false;

  get asked(): Prescription {
    return this.history.value;
  }

  get budget(): Budget | undefined {
    if (!this.surface || !this.info?.usable) return undefined;
    return computeBudget(this.asked, this.surface, this.info);
  }

  /** The result of exactly what is asked now. */
  get current(): Solved | undefined {
    return this.results.findLast(({ asked }) => sameAsked(asked, this.asked));
  }

  /** What the views show: the current result, or the last one, which is then stale. */
  get shown(): Solved | undefined {
    return this.current ?? this.results.at(-1);
  }

  /** The state of the page in one word. */
  get state(): string {
    if (this.phase !== 'editing') return this.phase;
    if (this.current) return this.current.isCertified ? 'certified' : 'not-certified';
    if (this.results.length > 0) return 'stale';
    return this.budget?.isReady || this.asked.cones.length === 0 ? 'ready' : 'unbalanced';
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
    this.changed();
  }

  forgetModel(): void {
    this.running?.abort();
    this.info = undefined;
    this.surface = undefined;
    this.results = [];
    this.selected = -1;
    this.missing = [];
    this.candidates = [];
    this.isExplicit = false;
    this.hasSuggested = false;
    this.isUnsaved = false;
    this.settings = { fix: {} };
    this.message = undefined;
    this.history = new History(emptyPrescription(this.asked.q, 0, 0));
  }
}
