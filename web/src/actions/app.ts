// The context of every action (document, page state, workers, views), and the error boundary in which
// actions run.

import { effect } from '@preact/signals-core';
import type { Client } from 'hgp';
import type { OpenDocument, ReadonlyDocument } from '../model/document';
import type { UiState } from '../model/ui_state';
import type { GeometryClient } from '../services/geometry_client';
import { describeError, isAbort } from '../text/error_messages';
import type { ModelView } from '../views/model_view';
import type { UvView } from '../views/uv_view';

/** The context as panels and input have it: they read the document, and only actions write it. */
export interface AppView {
  readonly doc: ReadonlyDocument;
  readonly ui: UiState;
  readonly geometry: GeometryClient;
  /** Undefined until the solver has started; nothing can be opened before that. */
  client: Client | undefined;
  /** Undefined until the canvases exist. */
  views: { model: ModelView; uv: UvView } | undefined;
}

export interface App extends AppView {
  readonly doc: OpenDocument;
}

export function solverOf({ client }: App): Client {
  if (!client) throw new Error('The solver has not started yet.');
  return client;
}

/** Waits until files can be opened, or never will be. */
export function started({ doc }: App): Promise<void> {
  return new Promise((resolve) => {
    const dispose = effect(() => {
      if (doc.state.kind === 'starting') return;
      resolve();
      queueMicrotask(() => dispose());
    });
  });
}

/** Reports a failure to the user; cancellation is not a failure. */
export function sayFailure({ doc }: AppView, error: unknown): void {
  if (isAbort(error)) return;
  console.warn(error);
  doc.say(describeError(error, doc.model?.main ?? ''), 'error');
}

/** The error boundary: reports whatever `work` throws or rejects with, and does not propagate it. */
export async function attempt(app: AppView, work: () => unknown): Promise<void> {
  try {
    await work();
  } catch (error) {
    sayFailure(app, error);
  }
}
