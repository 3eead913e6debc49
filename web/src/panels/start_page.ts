// The page before a model is open: an animated result, a button for files, and examples.

import { html, nothing, type TemplateResult } from 'lit';
import { examples } from 'virtual:examples';
import { attempt } from '../actions/app';
import { open, openExample } from '../actions/open';
import { clearRecent } from '../actions/recent';
import { actionButton } from './action_button';
import { Panel } from './panel';
import './start_page.css';

class StartPage extends Panel {
  /** The files that were opened last. */
  #recent(): TemplateResult | typeof nothing {
    const { app } = this;
    const { recent } = app.ui;
    if (recent.length === 0) return nothing;
    return html`<div class="recent" role="group" aria-label="Recent files">
      <h3>or continue with</h3>
      <p class="row">
        ${recent.map(
          (one) =>
            html`<button
              type="button"
              data-recent=${one.id}
              title=${new Date(one.time).toLocaleString()}
              @click=${() => void attempt(app, () => open(app, new Map(one.files)))}
            >
              ${one.main}
            </button>`,
        )}
        <button
          type="button"
          class="link"
          id="forget-recent"
          title="They are kept in this browser only"
          @click=${() => void attempt(app, () => clearRecent(app))}
        >
          Forget these
        </button>
      </p>
    </div>`;
  }

  override render(): TemplateResult {
    const { app } = this;
    return html`<section class="empty" aria-label="Start">
      <div class="hero">
        <hgp-turning-model .app=${app}></hgp-turning-model>
        <div class="pitch">
          <h2><span class="for-mouse">Drop</span><span class="for-fingers">Open</span> a mesh</h2>
          <p class="lead">
            It comes back with texture coordinates that continue across every seam, without folds.
          </p>
          <p>GLB, glTF, OBJ, PLY, STL, OFF, a folder or a ZIP.<br />Files stay on this computer.</p>
          <p class="row">
            ${actionButton(app, 'open', { domId: 'choose', className: 'primary', text: 'Choose files', hasIcon: false })}
            ${actionButton(app, 'open-folder', { domId: 'choose-folder', text: 'Choose a folder', hasIcon: false })}
          </p>
          ${this.#recent()}
        </div>
      </div>
      <h3>or try an example</h3>
      <ul class="cards">
        ${examples.map(
          (example) =>
            html`<li>
              <button
                type="button"
                class="card"
                data-card=${example.id}
                @click=${() => void attempt(app, () => openExample(app, example))}
              >
                <img
                  src="./thumbnails/${example.id}.png"
                  width="120"
                  height="120"
                  alt=""
                  loading="lazy"
                />
                <b>${example.title}</b><small>${example.hint}</small>
              </button>
            </li>`,
        )}
      </ul>
    </section>`;
  }
}
customElements.define('hgp-start-page', StartPage);
