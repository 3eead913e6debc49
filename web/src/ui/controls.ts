// What the page knows beside the document: tool, tab, theme, what the pointer is over. And the views.

import type { Where } from 'hgp';
import { overlays, patterns, type App, type Look, type Pattern } from '../state/app';
import { bytesOf } from '../state/files';
import { importCones, select } from '../state/edit';
import { handleLoops, loopSegments } from '../state/handles';
import type { MapView } from '../view/map_view';
import type { SurfaceView } from '../view/surface_view';
import { placesOf } from './places';
import type { Sheet } from './sheet';

const few = 2; // log₁₀ of the range of the scale: from 3 tiles to 300
const themes = ['auto', 'light', 'dark'] as const;

function stored(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Storage may be forbidden: then it is forgotten. */
function store(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Nothing to do.
  }
}

export class Controls {
  tool: 'orbit' | 'place' = 'orbit';
  tab: 'surface' | 'map' = 'surface';
  sheet: Sheet = 'half';
  menu = '';
  dialog = '';
  hover = '';
  theme: (typeof themes)[number] = 'auto';
  hasKeys = stored('hgp-keys') !== 'off';
  /** Width of the 3D view in percent of both. */
  split = 58;
  mostRows = 60;
  /** Puts back a cone that is being dragged; whether there was one. */
  stopDrag?: () => boolean;
  sort: { by: 'number' | 'vertex' | 'k'; isDown: boolean } = { by: 'number', isDown: false };
  surfaceView?: SurfaceView;
  mapView?: MapView;
  readonly #app: App;
  readonly #phone = matchMedia('(max-width: 640px)'); // as in small.css

  constructor(app: App) {
    this.#app = app;
    this.#phone.addEventListener('change', () => app.changed());
    const theme = stored('hgp-theme') as (typeof themes)[number];
    if (themes.includes(theme)) this.theme = theme;
    this.#applyTheme();
    app.showPlaces = (where) => this.showPlaces(where);
  }

  #changed(): void {
    this.#app.changed();
  }

  setTool(tool: 'orbit' | 'place'): void {
    this.tool = tool;
    if (tool === 'place')
      this.#app.say('Place: click the surface; or arrows and Enter in the 3D view.');
    this.#changed();
  }
  setTab(tab: 'surface' | 'map'): void {
    this.tab = tab;
    this.#changed();
  }
  setSheet(sheet: Sheet): void {
    this.sheet = sheet;
    this.#changed();
  }
  toggleMenu(menu: string): void {
    this.menu = this.menu === menu ? '' : menu;
    this.#changed();
  }
  show(dialog: string): void {
    this.dialog = dialog;
    this.#changed();
  }
  setHover(text: string): void {
    if (text === this.hover) return;
    this.hover = text;
    this.#changed();
  }
  setKeys(isOn: boolean): void {
    this.hasKeys = isOn;
    store('hgp-keys', isOn ? 'on' : 'off');
    this.#changed();
  }
  setSplit(percent: number): void {
    this.split = Math.round(Math.min(80, Math.max(20, percent)));
    document.documentElement.style.setProperty('--part', String(this.split / 100));
    this.#changed();
  }
  sortBy(by: Controls['sort']['by']): void {
    this.sort = { by, isDown: this.sort.by === by && !this.sort.isDown };
    this.#changed();
  }
  /** Selects a cone and brings it to the middle. */
  lookAt(index: number): void {
    const cone = this.#app.asked.cones[index];
    if (!cone) return;
    select(this.#app, index);
    this.surfaceView?.lookAt(cone.vertex);
    this.setTab('surface');
  }
  showMoreRows(): void {
    this.mostRows = Infinity;
    this.#changed();
  }

  nextTheme(): void {
    this.theme = themes[(themes.indexOf(this.theme) + 1) % themes.length];
    store('hgp-theme', this.theme);
    this.#applyTheme();
    this.#changed();
  }
  #applyTheme(): void {
    document.documentElement.dataset.theme = this.theme;
  }
  get isPhone(): boolean {
    return this.#phone.matches;
  }
  get isDark(): boolean {
    if (this.theme !== 'auto') return this.theme === 'dark';
    return matchMedia('(prefers-color-scheme: dark)').matches;
  }

  setLook(part: Partial<Look>): void {
    this.#app.look = { ...this.#app.look, ...part };
    this.#changed();
  }
  nextPattern(step = 1): void {
    const choice: Pattern[] = patterns.filter((name) => name !== 'image' && name !== 'material');
    const at = choice.indexOf(this.#app.look.pattern);
    this.setLook({ pattern: choice[(at + step + choice.length) % choice.length] });
  }
  nextOverlay(): void {
    const at = overlays.indexOf(this.#app.look.overlay);
    this.setLook({ overlay: overlays[(at + 1) % overlays.length] });
  }
  sliderOf(tiles: number): number {
    return Math.round((100 / few) * Math.log10(tiles / 3));
  }
  setSlider(value: number): void {
    this.setLook({ tiles: 3 * 10 ** ((few * value) / 100) });
  }

  choosePattern(pattern: Pattern): void {
    if (pattern === 'image') return this.#chooseImage();
    this.setLook({ pattern });
  }
  #chooseImage(): void {
    this.#choose('image/png,image/jpeg,image/webp', async (file) => {
      try {
        const image = await createImageBitmap(file, { imageOrientation: 'flipY' });
        this.setLook({ pattern: 'image', image });
      } catch {
        this.#app.say(`“${file.name}” is no image that this browser can read.`, 'error');
      }
    });
    this.#changed();
  }
  chooseConeFile(): void {
    this.#choose('', async (file) => {
      await importCones(this.#app, file.name, new TextDecoder().decode(await bytesOf(file)));
    });
  }
  #choose(accept: string, take: (file: File) => Promise<void>): void {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = accept;
    input.addEventListener('change', () => input.files?.[0] && void take(input.files[0]));
    input.click();
  }
  chooseFiles(): void {
    document.querySelector<HTMLInputElement>('#file')?.click();
  }
  chooseFolder(): void {
    document.querySelector<HTMLInputElement>('#folder')?.click();
  }

  frame(): void {
    this.surfaceView?.orbit.fit();
    this.mapView?.fit();
    this.surfaceView?.draw();
  }

  /** Outlines places in both views and brings the first to the middle. */
  showPlaces(where: Where[]): void {
    const { surface, shown } = this.#app;
    if (!surface) return;
    const places = placesOf(where, surface, shown);
    this.surfaceView?.highlight(places.triangles, places.edges);
    this.mapView?.highlight(places.triangles, places.uvEdges);
    if (places.first >= 0) this.surfaceView?.lookAt(places.first);
    const count = where.length;
    this.#app.say(count === 1 ? `Shown: ${places.text}.` : `${count} places shown, in pink.`);
    this.setTab('surface');
  }

  handlesShown = false;
  /** The loops around handles, in the colours of their rows. */
  showHandles(isOn: boolean): void {
    this.handlesShown = isOn;
    const { surface } = this.#app;
    const loops = isOn && surface ? handleLoops(surface) : [];
    this.surfaceView?.setHandles(loops.map((loop) => loopSegments(surface!, loop)));
    this.#changed();
  }

  /** What a screen reader says of the 3D view. */
  describe(): string {
    const { info, surface, shown, asked, main } = this.#app;
    if (!surface || !info) return '3D view: no model';
    const texture = shown ? ', textured' : '';
    return `3D view: ${main}, ${info.triangles} triangles, ${asked.cones.length} cones${texture}`;
  }
}
