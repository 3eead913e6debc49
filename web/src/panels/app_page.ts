// The whole page: bars, views and the side panel.

import { html, nothing, type TemplateResult } from 'lit';
import { attempt, type AppView } from '../actions/app';
import { open } from '../actions/open';
import { filesOfInput } from '../formats/file_set';
import type { Tab } from '../model/ui_state';
import { sheetHandle } from './bottom_sheet';
import { Panel } from './panel';
import { keepRoving, roveFocus } from './roving_focus';
import { fileParts } from './top_bar';
import './boundaries_panel';
import './cones_panel';
import './dialogs';
import './legend';
import './live_badge';
import './map_scale';
import './mesh_strip';
import './model_panel';
import './result_panel';
import './seam_note';
import './solve_panel';
import './start_page';
import './status_bar';
import './turning_model';
import './view_toolbar';
import '../styles/narrow.css';
import { plural } from '../text/format';

/** The description of the 3D view for screen readers. */
function describeModel({ doc }: AppView): string {
  const { model, displayed, prescription } = doc;
  if (!model) return '3D view: no model';
  const texture = displayed ? ', textured' : '';
  return `3D view: ${model.main}, ${plural(model.info.triangles, 'triangle')}, ${plural(prescription.cones.length, 'cone')}${texture}`;
}

const tabNames: [Tab, string][] = [
  ['surface', '3D view'],
  ['map', 'UV view'],
];

class AppPage extends Panel {
  override render(): TemplateResult {
    const { app } = this;
    const { doc, ui } = app;
    const hasModel = doc.model !== undefined;
    return html`
      <hgp-top-bar .app=${app}></hgp-top-bar>
      <hgp-mesh-strip .app=${app}></hgp-mesh-strip>
      <main
        id="drop"
        class=${hasModel ? 'has-model' : 'no-model'}
        data-sheet=${ui.sheet}
        data-map=${doc.displayed ? 'shown' : 'none'}
      >
        ${this.#tabs(hasModel)} ${this.#surfacePane(hasModel)} ${this.#splitter(hasModel)}
        ${this.#mapPane(hasModel)}
        ${hasModel ? this.#side() : html`<hgp-start-page .app=${app}></hgp-start-page>`}
      </main>
      <hgp-status-bar .app=${app}></hgp-status-bar>
      <hgp-dialogs .app=${app}></hgp-dialogs>
      ${this.#input('file', 'Choose files')} ${this.#input('folder', 'Choose a folder')}
    `;
  }

  override updated(): void {
    const line = this.querySelector<HTMLElement>('.wipe-line');
    if (line) line.style.left = `${this.app.ui.wipe}%`; // the content security policy forbids style attributes
  }

  #tabs(hasModel: boolean): TemplateResult {
    const { ui } = this.app;
    const tab = ([name, title]: [Tab, string]): TemplateResult =>
      html`<button
        type="button"
        role="tab"
        id="tab-${name}"
        aria-controls="pane-${name}"
        aria-selected=${ui.tab === name}
        tabindex=${ui.tab === name ? 0 : -1}
        @click=${() => (ui.tab = name)}
      >
        ${title}
      </button>`;
    return html`<div class="tabs" ?hidden=${!hasModel}>
      <div role="tablist" aria-label="Views" @keydown=${roveFocus} @focusin=${keepRoving}>
        ${tabNames.map(tab)}
      </div>
      ${ui.isPhone ? fileParts(this.app) : nothing}
    </div>`;
  }

  #surfacePane(hasModel: boolean): TemplateResult {
    const { app } = this;
    const { doc, ui } = app;
    return html`<section
      class="pane"
      id="pane-surface"
      aria-label="3D view"
      data-shown=${ui.tab === 'surface'}
      ?hidden=${!hasModel}
    >
      <hgp-view-toolbar .app=${app}></hgp-view-toolbar>
      <canvas
        id="view"
        tabindex="0"
        role="application"
        aria-roledescription="3D view"
        aria-label=${describeModel(app)}
        aria-describedby="keys"
      ></canvas>
      <p id="keys" class="visually-hidden">
        Arrows orbit. C switches to placing cones. Question mark lists all keys.
      </p>
      <p class="hover" ?hidden=${ui.hover === ''}>${ui.hover}</p>
      ${ui.wipe > 0 && doc.displayed ? html`<i class="wipe-line"></i>` : nothing}
      <hgp-legend .app=${app}></hgp-legend>
      <hgp-seam-note .app=${app}></hgp-seam-note>
      <hgp-live-badge .app=${app}></hgp-live-badge>
      ${doc.stateName === 'stale' ? html`<p class="badge">This map is for the previous cones</p>` : nothing}
    </section>`;
  }

  #splitter(hasModel: boolean): TemplateResult {
    const { ui } = this.app;
    return html`<div
      class="splitter"
      id="splitter"
      role="separator"
      tabindex="0"
      aria-orientation="vertical"
      aria-label="Width of the 3D view"
      aria-valuenow=${ui.split}
      aria-valuemin="20"
      aria-valuemax="80"
      ?hidden=${!hasModel}
    ></div>`;
  }

  #mapPane(hasModel: boolean): TemplateResult {
    const { doc, ui } = this.app;
    const label = doc.displayed
      ? 'UV view: the map laid flat. Arrows move, plus and minus zoom.'
      : 'UV view: no map yet';
    return html`<section
      class="pane"
      id="pane-map"
      aria-label="UV view"
      data-shown=${ui.tab === 'map'}
      ?hidden=${!hasModel}
    >
      <canvas
        id="map"
        tabindex="0"
        role="application"
        aria-roledescription="UV view"
        aria-label=${label}
      ></canvas>
      ${doc.displayed ? html`<hgp-map-scale .app=${this.app}></hgp-map-scale>` : html`<p class="hint">The flat map appears here after Run.</p>`}
    </section>`;
  }

  #side(): TemplateResult {
    const { app } = this;
    return html`<aside aria-label="Inspector">
      ${sheetHandle(app.ui)}
      <hgp-result-panel .app=${app}></hgp-result-panel>
      <hgp-solve-panel .app=${app}></hgp-solve-panel>
      <hgp-cones-panel .app=${app}></hgp-cones-panel>
      <hgp-boundaries-panel .app=${app}></hgp-boundaries-panel>
      <hgp-model-panel .app=${app}></hgp-model-panel>
      <p class="note guide">
        <a href="./guide.html">How cones work, and what to do with the result</a>
      </p>
    </aside>`;
  }

  #input(id: string, label: string): TemplateResult {
    const { app } = this;
    const take = (event: Event): void => {
      const input = event.target as HTMLInputElement;
      const files = filesOfInput([...(input.files ?? [])]);
      input.value = '';
      void attempt(app, () => open(app, files));
    };
    return html`<input
      id=${id}
      type="file"
      multiple
      ?webkitdirectory=${id === 'folder'}
      hidden
      aria-label=${label}
      @change=${take}
    />`;
  }
}
customElements.define('hgp-page', AppPage);
