// Keys. Single keys only while a view has the focus; Ctrl combinations anywhere.

import type { App } from '../state/app';
import { deleteCone, placeOrSelect, redo, select, selectNext, setK, undo } from '../state/edit';
import { defectDegrees } from '../state/surface';
import { cancel, run } from '../state/run';
import type { Controls } from './controls';

const step = Math.PI / 18;
const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class Keyboard {
  readonly #app: App;
  readonly #ui: Controls;
  #cursor = -1;

  constructor(app: App, ui: Controls) {
    this.#app = app;
    this.#ui = ui;
    document.addEventListener('keydown', (event) => {
      const isHandled =
        event.ctrlKey || event.metaKey ? this.#combination(event) : this.#single(event);
      if (isHandled) event.preventDefault();
    });
  }

  /** A new model: the vertex that the keyboard was at is gone. */
  reset(): void {
    this.#cursor = -1;
    this.#ui.surfaceView?.setCursor(-1);
  }

  #combination(event: KeyboardEvent): boolean {
    const isText = event.target instanceof HTMLInputElement && event.target.type === 'number';
    switch (event.key.toLowerCase()) {
      case 'o':
        this.#ui.chooseFiles();
        return true;
      case 's':
        if (this.#app.current) this.#ui.show('download');
        return true;
      case 'enter':
        void run(this.#app);
        return true;
      case 'z':
        if (isText) (event.target as HTMLElement).blur();
        if (event.shiftKey) redo(this.#app);
        else undo(this.#app);
        return true;
      case 'y':
        redo(this.#app);
        return true;
      default:
        return false;
    }
  }

  #single(event: KeyboardEvent): boolean {
    const view = (event.target as HTMLElement).id;
    if (event.key === 'Escape') return this.#escape();
    if (!['view', 'map'].includes(view) || event.altKey) return false;
    if (event.key in arrows || event.key.startsWith('Page')) return this.#move(view, event);
    if (event.key === 'Enter' && view === 'view' && this.#ui.tool === 'place') {
      if (this.#cursor >= 0) placeOrSelect(this.#app, this.#cursor);
      return true;
    }
    if (!this.#ui.hasKeys) return false;
    return this.#letter(event.key) || this.#coneKey(event.key);
  }

  #escape(): boolean {
    const app = this.#app;
    if (document.querySelector('dialog[open]')) return false; // it closes by itself
    if (this.#ui.menu) this.#ui.toggleMenu('');
    else if (this.#ui.stopDrag?.()) return true;
    else if (app.selected >= 0) select(app, -1);
    else if (app.phase === 'running') this.#askCancel();
    else if (app.phase === 'loading') cancel(app);
    else {
      this.#ui.surfaceView?.highlight([]);
      this.#ui.mapView?.highlight([]);
    }
    return false;
  }

  /** A run may have taken minutes: one key pressed by mistake does not end it. */
  #askCancel(): void {
    const app = this.#app;
    const question = 'Escape once more cancels the run.';
    if (app.message?.text === question) cancel(app);
    else app.say(question, 'note', [{ label: 'Cancel the run', do: () => cancel(app) }]);
  }

  #letter(key: string): boolean {
    const ui = this.#ui;
    const { look } = this.#app;
    const acts: Record<string, () => void> = {
      c: () => {
        ui.setTool(ui.tool === 'place' ? 'orbit' : 'place');
        if (ui.tool === 'place') this.#start();
        else this.reset();
      },
      f: () => this.#frame(),
      r: () => ui.surfaceView?.orbit.reset(),
      l: () => ui.setLook({ hasWire: !look.hasWire }),
      s: () => ui.setLook({ hasSeams: !look.hasSeams }),
      o: () => ui.surfaceView?.toggleParallel(),
      g: () => ui.nextPattern(),
      h: () => ui.nextOverlay(),
      u: () => this.#otherView(),
      n: () => this.#next(1),
      p: () => this.#next(-1),
      '?': () => ui.show('help'),
    };
    const act = acts[key.toLowerCase()];
    act?.();
    return act !== undefined;
  }

  /** The selected cone, or all. */
  #frame(): void {
    const { selected } = this.#app;
    if (selected >= 0) this.#ui.lookAt(selected);
    else this.#ui.frame();
  }

  /** The keys go to the other view, which in a narrow window takes the place of this one. */
  #otherView(): void {
    const isMap = document.activeElement?.id === 'map';
    this.#ui.setTab(isMap ? 'surface' : 'map');
    queueMicrotask(() => document.querySelector<HTMLElement>(isMap ? '#view' : '#map')?.focus());
  }

  #next(direction: 1 | -1): void {
    selectNext(this.#app, direction);
    const cone = this.#app.asked.cones[this.#app.selected];
    if (!cone) return;
    this.#say(cone.vertex, `Cone ${this.#app.selected + 1}, k = ${cone.k}: `);
  }

  #coneKey(key: string): boolean {
    const { selected, asked } = this.#app;
    const cone = asked.cones[selected];
    if (/^[1-9]$/.test(key)) setK(this.#app, selected, Number(key));
    else if (key === '+' || key === '=') setK(this.#app, selected, (cone?.k ?? 0) + 1);
    else if (key === '-' || key === '−') setK(this.#app, selected, (cone?.k ?? 0) - 1);
    else if (key === 'Delete' || key === 'Backspace') deleteCone(this.#app, selected);
    else return false;
    return true;
  }

  #move(view: string, event: KeyboardEvent): boolean {
    const { surfaceView, mapView, tool } = this.#ui;
    const zoom = event.key === 'PageUp' ? 0.85 : event.key === 'PageDown' ? 1 / 0.85 : 0;
    const [x, y] = arrows[event.key] ?? [0, 0];
    if (view === 'map') {
      if (zoom) mapView?.zoom(zoom);
      else mapView?.pan(x * 0.06, y * 0.06);
    } else if (zoom) surfaceView?.orbit.move(0, 0, zoom);
    else if (event.shiftKey) surfaceView?.orbit.pan(-x * 0.06, -y * 0.06);
    else if (tool === 'place') this.#walk(x, -y);
    else surfaceView?.orbit.move(x * step, -y * step);
    return true;
  }

  /** Begins at the vertex nearest to the middle of the view. */
  #start(): void {
    const view = this.#ui.surfaceView;
    if (!view || !this.#app.surface) return;
    const box = view.canvas.getBoundingClientRect();
    const middle = { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 };
    const hit = view.pick(middle);
    this.#go(hit?.vertex ?? this.#app.surface.triangles[0]);
  }

  /** To the neighbour that lies most in the direction of the arrow, on the screen. */
  #walk(x: number, y: number): void {
    const view = this.#ui.surfaceView;
    const { surface } = this.#app;
    if (!view || !surface) return;
    if (this.#cursor < 0) return this.#start();
    const from = view.toScreen(this.#cursor);
    let best = -1;
    let bestCosine = 0.2;
    for (let n = surface.starts[this.#cursor]; n < surface.starts[this.#cursor + 1]; n++) {
      const to = view.toScreen(surface.neighbours[n]);
      const [dx, dy] = [to.x - from.x, to.y - from.y];
      const cosine = (dx * x + dy * y) / (Math.hypot(dx, dy) || 1);
      if (cosine > bestCosine) [best, bestCosine] = [surface.neighbours[n], cosine];
    }
    if (best >= 0) this.#go(best);
  }

  #go(vertex: number): void {
    this.#cursor = vertex;
    this.#ui.surfaceView?.setCursor(vertex);
    this.#say(vertex, '');
  }

  #say(vertex: number, before: string): void {
    const surface = this.#app.surface!;
    const degrees = defectDegrees(surface, vertex).toFixed(0).replace('-', '−');
    const where = surface.isBoundary[vertex] ? ', on the boundary' : '';
    this.#app.say(
      `${before}vertex ${vertex}, valence ${surface.valence[vertex]}, ${degrees}° defect${where}`,
    );
  }
}
