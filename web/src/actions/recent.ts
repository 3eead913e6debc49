// The files that were opened last.

import type { Files } from '../model/types';
import { forgetRecent, keepRecent, recentFiles } from '../services/recent_files';
import type { App } from './app';

export async function refreshRecent({ ui }: App): Promise<void> {
  ui.recent = await recentFiles();
}

/** Remembers the open model. */
export async function remember(app: App, files: Files): Promise<void> {
  const { model } = app.doc;
  if (!model) return;
  await keepRecent(model.info.file.sha256, model.main, files);
  await refreshRecent(app);
}

export async function clearRecent(app: App): Promise<void> {
  await forgetRecent();
  app.ui.recent = [];
  app.doc.say('The list of recent files is empty; nothing of them is left in this browser.');
}
