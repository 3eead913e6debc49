// Keyboard input. Single keys work only while a view has the focus, Ctrl combinations whenever no dialog is open.

import { attempt, type AppView } from '../actions/app';
import { select, setK } from '../actions/edit_cones';
import { placeOnAny } from '../actions/repair';
import { cancel } from '../actions/job';
import { actionForKey, isDialogOpen, keyOf, perform } from '../actions/registry';
import { clearHighlight } from '../actions/view';
import { defectDegrees } from '../model/surface';
import type { Message } from '../model/types';
import { wholeDegrees } from '../text/format';

const turn = Math.PI / 18;
const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class Keyboard {
  readonly #app: AppView;
  /** The vertex from which arrow keys move the cursor, −1 for none. */
  #cursor = -1;

  constructor(app: AppView) {
    this.#app = app;
    document.addEventListener('keydown', (event) => {
      const isCombination = event.ctrlKey || event.metaKey;
      const isHandled = isCombination ? this.#combination(event) : this.#single(event);
      if (isHandled) event.preventDefault();
    });
  }

  /** Resets the cursor for a new model. */
  reset(): void {
    this.#cursor = -1;
    this.#app.views?.model.setCursor(-1);
  }

  #combination(event: KeyboardEvent): boolean {
    const id = actionForKey(keyOf(event));
    if (!id) return false;
    if (isDialogOpen(this.#app)) return true; // handled, so that the browser does nothing either
    const { target } = event;
    // A value that is being typed is committed first.
    if (target instanceof HTMLInputElement && target.type === 'number') target.blur();
    void perform(this.#app, id);
    return true;
  }

  #single(event: KeyboardEvent): boolean {
    const { ui } = this.#app;
    if (event.key === 'Escape') return this.#escape();
    const view = (event.target as HTMLElement).id;
    if (!['view', 'map'].includes(view) || event.altKey || isDialogOpen(this.#app)) return false;
    if (event.key in arrows || event.key.startsWith('Page')) return this.#move(view, event);
    if (event.key === 'Enter' && view === 'view' && ui.tool === 'place') {
      if (this.#cursor >= 0) void attempt(this.#app, () => placeOnAny(this.#app, this.#cursor));
      return true;
    }
    return ui.hasKeys && this.#letter(event);
  }

  #letter(event: KeyboardEvent): boolean {
    const app = this.#app;
    if (/^[1-9]$/.test(event.key)) {
      void attempt(app, () => setK(app, app.doc.selected, Number(event.key)));
      return true;
    }
    const id = actionForKey(keyOf(event));
    if (!id) return false;
    void perform(app, id);
    if (id === 'place') {
      if (app.ui.tool === 'place') this.#start();
      else this.reset();
    }
    if (id === 'next-cone' || id === 'previous-cone') this.#sayCone();
    return true;
  }

  #escape(): boolean {
    const { doc, ui } = this.#app;
    if (document.querySelector('dialog[open], :popover-open')) return false; // the browser closes it
    if (ui.stopDrag?.()) return true;
    if (doc.selected >= 0) select(this.#app, -1);
    else if (doc.job?.kind === 'run') this.#askCancel();
    else if (doc.job?.kind === 'load') cancel(this.#app);
    else clearHighlight(this.#app);
    return false;
  }

  /** Asks before cancelling: a run may have taken minutes, and a key may be pressed by mistake. */
  #askCancel(): void {
    const { doc } = this.#app;
    if (doc.message && doc.message === this.#question) return cancel(this.#app);
    const yes = { label: 'Cancel the run', run: () => cancel(this.#app) };
    doc.say('Escape once more cancels the run.', 'note', [yes]);
    this.#question = doc.message;
  }
  #question?: Message;

  #sayCone(): void {
    const { doc } = this.#app;
    const cone = doc.prescription.cones[doc.selected];
    if (cone) this.#say(cone.vertex, `Cone ${doc.selected + 1}, k = ${cone.k}: `);
  }

  #move(view: string, event: KeyboardEvent): boolean {
    const { views, ui } = this.#app;
    if (!views) return false;
    const zoom = event.key === 'PageUp' ? 0.85 : event.key === 'PageDown' ? 1 / 0.85 : 0;
    const [x, y] = arrows[event.key] ?? [0, 0];
    if (view === 'map') {
      if (zoom) views.uv.zoom(zoom);
      else views.uv.pan(x * 0.06, y * 0.06);
    } else if (zoom) views.model.orbit.move(0, 0, zoom);
    else if (event.shiftKey) views.model.orbit.pan(-x * 0.06, -y * 0.06);
    else if (ui.tool === 'place') this.#walk(x, -y);
    else views.model.orbit.move(x * turn, -y * turn);
    return true;
  }

  /** Starts at the vertex nearest to the centre of the view. */
  #start(): void {
    const view = this.#app.views?.model;
    const surface = this.#app.doc.model?.surface;
    if (!view || !surface) return;
    const box = view.canvas.getBoundingClientRect();
    const middle = { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 };
    this.#go(view.pick(middle)?.vertex ?? surface.triangles[0]);
  }

  /** Moves to the neighbour whose direction on the screen is closest to that of the arrow. */
  #walk(x: number, y: number): void {
    const view = this.#app.views?.model;
    const surface = this.#app.doc.model?.surface;
    if (!view || !surface) return;
    if (this.#cursor < 0) return this.#start();
    const from = view.toScreen(this.#cursor);
    let best = -1;
    let bestCosine = 0.2;
    for (
      let n = surface.neighbourStart[this.#cursor];
      n < surface.neighbourStart[this.#cursor + 1];
      n++
    ) {
      const to = view.toScreen(surface.neighbours[n]);
      const [dx, dy] = [to.x - from.x, to.y - from.y];
      const cosine = (dx * x + dy * y) / (Math.hypot(dx, dy) || 1);
      if (cosine > bestCosine) [best, bestCosine] = [surface.neighbours[n], cosine];
    }
    if (best >= 0) this.#go(best);
  }

  #go(vertex: number): void {
    this.#cursor = vertex;
    this.#app.views?.model.setCursor(vertex);
    this.#say(vertex, '');
  }

  #say(vertex: number, before: string): void {
    const { doc } = this.#app;
    const surface = doc.model?.surface;
    if (!surface) return;
    const degrees = wholeDegrees(defectDegrees(surface, vertex));
    const where = surface.isBoundary[vertex] ? ', on the boundary' : '';
    const valence = surface.valence[vertex];
    doc.say(`${before}vertex ${vertex}, valence ${valence}, ${degrees}° defect${where}`);
  }
}
