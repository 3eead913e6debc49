import { html, svg, type TemplateResult } from 'lit';
import { iconPaths, type Icon } from '../text/icon_paths';

export function icon(name: Icon): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 16 16" aria-hidden="true">
    ${svg`<path d=${iconPaths[name]} />`}
  </svg>`;
}
