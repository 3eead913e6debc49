// A button for an action. Its name, key and icon, and the reason if it is not available, come from the registry.

import { html, nothing, type TemplateResult } from 'lit';
import type { AppView } from '../actions/app';
import { actions, labelOf, perform, whyNotOf, type ActionId } from '../actions/registry';
import { icon } from './icons';

export interface ButtonOptions {
  /** Instead of the name of the action. */
  text?: string | TemplateResult;
  /** What it does, where the action's name says less. */
  hint?: string;
  /** The element's id, for tests and styles; by default that of the action. */
  domId?: string;
  className?: string;
  isIconOnly?: boolean;
  hasIcon?: boolean;
}

export function actionButton(
  app: AppView,
  id: ActionId,
  {
    text,
    hint,
    domId = id,
    className = '',
    isIconOnly = false,
    hasIcon = true,
  }: ButtonOptions = {},
): TemplateResult {
  const action = actions[id];
  const label = labelOf(app, id);
  const why = whyNotOf(app, id);
  const key = action.keys?.[0];
  const title = why || hint || (key ? `${label} (${key})` : label);
  return html`<button
    type="button"
    id=${domId}
    class="${isIconOnly ? 'only-icon ' : ''}${className}"
    ?disabled=${why !== ''}
    aria-label=${isIconOnly || typeof text === 'object' ? label : nothing}
    aria-pressed=${action.isOn ? String(action.isOn(app)) : nothing}
    title=${title}
    @click=${() => void perform(app, id)}
  >
    ${action.icon && hasIcon ? icon(action.icon) : nothing}${isIconOnly ? nothing : (text ?? label)}
  </button>`;
}
