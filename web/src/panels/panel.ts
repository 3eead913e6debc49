// The base class of every component: renders again when a signal that it has read changes. Components use the
// styles of the page, so there is no shadow root.

import { effect } from '@preact/signals-core';
import { LitElement } from 'lit';
import type { AppView } from '../actions/app';

export abstract class Panel extends LitElement {
  static override properties = { app: { attribute: false } };
  declare app: AppView;
  #dispose?: () => void;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override performUpdate(): void {
    if (!this.isUpdatePending) return;
    this.#dispose?.();
    let isDrawn = false;
    this.#dispose = effect(() => {
      if (isDrawn) return this.requestUpdate();
      isDrawn = true;
      super.performUpdate();
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#dispose?.();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate();
  }
}
