// What an action of the page is.

import type { Icon } from '../text/icon_paths';
import type { App } from './app';

export type ActionGroup = 'File' | 'Run' | 'Cones' | 'View' | 'Page';

export interface Action {
  readonly label: string | ((app: App) => string);
  readonly group: ActionGroup;
  /** Ctrl combinations work anywhere, single keys only while a view has the focus. */
  readonly keys?: readonly string[];
  readonly icon?: Icon;
  /** Why the action is not possible now; empty or undefined if it is. */
  whyNot?(app: App): string;
  /** For actions that switch something: whether it is on. */
  isOn?(app: App): boolean;
  run(app: App): unknown;
}

export const noModel = ({ doc }: App): string => (doc.model ? '' : 'Open a model first.');
