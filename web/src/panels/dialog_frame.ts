// The frame of all dialogs.

import { html, type TemplateResult } from 'lit';

export function dialogFrame(
  id: string,
  title: string,
  body: TemplateResult,
  close: () => void,
): TemplateResult {
  return html`<dialog id=${id} aria-labelledby="${id}-title" @cancel=${close} @close=${close}>
    <h2 id="${id}-title">${title}</h2>
    ${body}
  </dialog>`;
}
