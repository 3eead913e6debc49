// The context of every action (document, page state, workers, views), and the error boundary in which
// actions run.

import type { Client } from 'hgp';
import type { Document } from '../model/document';
import type { UiState } from '../model/ui_state';
import type { GeometryClient } from '../services/geometry_client';
import { describeError, isAbort } from '../text/error_messages';
import type { ModelView } from '../views/model_view';
import type { UvView } from '../views/uv_view';

export interface App {
  readonly doc: Document;
  readonly ui: UiState;
  readonly geometry: GeometryClient;
  /** There once the solver has started; until then nothing can be opened. */
  client: Client | undefined;
  /** There once the canvases are. */
  views: { model: ModelView; uv: UvView } | undefined;
}

export function solverOf({ client }: App): Client {
  if (!client) throw new Error('The solver has not started yet.');
  return client;
}

/** Says what went wrong; what was cancelled went as it should. */
export function sayFailure({ doc }: App, error: unknown): void {
  if (isAbort(error)) return;
  console.warn(error);
  doc.say(describeError(error, doc.model?.main ?? ''), 'error');
}

/** The error boundary: whatever `work` throws or rejects with is said, and ends here. */
export async function attempt(app: App, work: () => unknown): Promise<void> {
  try {
    await work();
  } catch (error) {
    sayFailure(app, error);
  }
}
