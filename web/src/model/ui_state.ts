// The state of the user interface, apart from the document: tool, tab, theme, dialog, hovered element.

import type { Recent } from './recent';
import { storeOf } from './store';

export type Tool = 'orbit' | 'place' | 'edges';
export type Tab = 'surface' | 'map';
export type Sheet = 'peek' | 'half' | 'full';
export type Dialog = '' | 'download' | 'help' | 'log' | 'palette' | 'compare';
export type SortKey = 'number' | 'vertex' | 'k';

/** The programs for which downloads can be made. */
export const targetIds = ['blender', 'three', 'engine', 'quads'] as const;
export type TargetId = (typeof targetIds)[number];

const themes = ['auto', 'light', 'dark'] as const;
export type Theme = (typeof themes)[number];

function stored(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Stores a setting, unless storage is not allowed. */
function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // The setting is then not remembered.
  }
}

interface Fields {
  tool: Tool;
  tab: Tab;
  sheet: Sheet;
  dialog: Dialog;
  hover: string;
  theme: Theme;
  hasKeys: boolean;
  /** Width of the 3D view in percent of both views. */
  split: number;
  maxRows: number;
  /** The values of k whose cones are listed, where there are so many cones that the table counts them. */
  openGroups: ReadonlySet<number>;
  /** Pixels per unit of uv in the UV view. */
  mapScale: number;
  sort: { by: SortKey; isDown: boolean };
  isPhone: boolean;
  /** Whether there is no room for all tools beside the panels, as on a phone or at a large zoom. */
  isNarrow: boolean;
  isSystemDark: boolean;
  handlesShown: boolean;
  /** The files that were opened last, the newest first. */
  recent: readonly Recent[];
  /** Whether a turntable is being recorded. */
  isRecording: boolean;
  /** The program for which downloads are made. */
  target: TargetId;
  /** Position of the wipe between before and after, in percent from the left; 0: only after. */
  wipe: number;
  /** Whether maps follow edits without Run; undefined: where that takes little time. */
  automatic: boolean | undefined;
  /** Whether a cone is being dragged, or its map is being stored. */
  holdsCone: boolean;
  /** The current time in milliseconds, updated while a job runs. */
  now: number;
}

export class UiState extends storeOf<Fields>() {
  /** Cancels the dragging of a cone; returns whether one was being dragged. */
  stopDrag?: () => boolean;

  constructor() {
    const phone = matchMedia('(max-width: 640px)'); // as in narrow.css
    const narrow = matchMedia('(max-width: 900px)');
    const dark = matchMedia('(prefers-color-scheme: dark)');
    super({
      tool: 'orbit',
      tab: 'surface',
      sheet: 'half',
      dialog: '',
      hover: '',
      theme: themes.find((theme) => theme === stored('hgp-theme')) ?? 'auto',
      hasKeys: stored('hgp-keys') !== 'off',
      split: 58,
      maxRows: 60,
      openGroups: new Set(),
      mapScale: 0,
      sort: { by: 'number', isDown: false },
      isPhone: phone.matches,
      isNarrow: narrow.matches,
      isSystemDark: dark.matches,
      handlesShown: false,
      isRecording: false,
      recent: [],
      target: targetIds.find((id) => id === stored('hgp-target')) ?? 'blender',
      wipe: 0,
      automatic: { on: true, off: false }[stored('hgp-automatic') ?? ''],
      holdsCone: false,
      now: performance.now(),
    });
    phone.addEventListener('change', ({ matches }) => (this.isPhone = matches));
    narrow.addEventListener('change', ({ matches }) => (this.isNarrow = matches));
    dark.addEventListener('change', ({ matches }) => (this.isSystemDark = matches));
    document.documentElement.dataset.theme = this.theme;
  }

  get isDark(): boolean {
    return this.theme === 'auto' ? this.isSystemDark : this.theme === 'dark';
  }

  setKeys(isOn: boolean): void {
    this.hasKeys = isOn;
    keep('hgp-keys', isOn ? 'on' : 'off');
  }

  setAutomatic(isOn: boolean): void {
    this.automatic = isOn;
    keep('hgp-automatic', isOn ? 'on' : 'off');
  }

  setTarget(target: TargetId): void {
    this.target = target;
    keep('hgp-target', target);
  }

  nextTheme(): void {
    this.theme = themes[(themes.indexOf(this.theme) + 1) % themes.length];
    keep('hgp-theme', this.theme);
    document.documentElement.dataset.theme = this.theme;
  }

  setSplit(percent: number): void {
    this.split = Math.round(Math.min(80, Math.max(20, percent)));
    document.documentElement.style.setProperty('--part', String(this.split / 100));
  }

  sortBy(by: SortKey): void {
    this.sort = { by, isDown: this.sort.by === by && !this.sort.isDown };
  }
}
