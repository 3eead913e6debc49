// Says over the 3D view in which state the map of a dragged cone is.

import { html, nothing, type TemplateResult } from 'lit';
import { liveText } from '../text/dragged';
import { Panel } from './panel';
import './live_badge.css';

class LiveBadge extends Panel {
  override render(): TemplateResult | typeof nothing {
    const { live, automatic } = this.app.doc;
    if (!live) return nothing;
    return html`<p class="badge live ${live.state}" id="live">
      ${liveText(live, automatic !== undefined)}
    </p>`;
  }
}
customElements.define('hgp-live-badge', LiveBadge);
