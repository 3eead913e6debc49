// The page before a model is open: an animated result, a button for files, and examples.

import { html, type TemplateResult } from 'lit';
import { examples } from 'virtual:examples';
import { attempt } from '../actions/app';
import { openExample } from '../actions/open';
import { actionButton } from './action_button';
import { Panel } from './panel';
import './start_page.css';

class StartPage extends Panel {
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
