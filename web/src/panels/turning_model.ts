// The picture on the start page: a model with a map computed by hgp, turning slowly; it stands still if the
// user prefers reduced motion.

import { nothing } from 'lit';
import type { TurningView } from '../views/turning_view';
import { Panel } from './panel';

let made: Promise<TurningView> | undefined;

async function makeView(): Promise<TurningView> {
  const { TurningView: View } = await import('../views/turning_view');
  const view = new View();
  await view.load('./hero.bin');
  return view;
}

class TurningModel extends Panel {
  #view?: TurningView;

  override render(): typeof nothing {
    return nothing;
  }

  override firstUpdated(): void {
    void this.#start().catch(() => undefined); // the page works without the picture
  }

  async #start(): Promise<void> {
    const view = await (made ??= makeView());
    if (!this.isConnected) return;
    this.#view = view;
    this.append(view.canvas);
    view.start();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#view?.stop();
    this.#view = undefined;
  }
}
customElements.define('hgp-turning-model', TurningModel);
