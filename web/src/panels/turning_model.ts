// The picture of the empty page: a model of our own with a map of our own, turning slowly; still where
// less motion is preferred.

import { html, type TemplateResult } from 'lit';
import type { TurningView } from '../views/turning_view';
import { Panel } from './panel';

class TurningModel extends Panel {
  #view?: TurningView;

  override render(): TemplateResult {
    return html`<canvas class="turning" aria-hidden="true"></canvas>`;
  }

  override firstUpdated(): void {
    void this.#start().catch(() => undefined); // without it the page is as good, only plainer
  }

  async #start(): Promise<void> {
    const { TurningView: View } = await import('../views/turning_view');
    const canvas = this.querySelector('canvas');
    if (!canvas || !this.isConnected) return;
    this.#view = new View(canvas);
    await this.#view.load('./hero.bin');
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#view?.dispose();
    this.#view = undefined;
  }
}
customElements.define('hgp-turning-model', TurningModel);
