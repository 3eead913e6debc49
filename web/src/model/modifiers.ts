// Keys that make another one a shortcut.

type Pressed = Pick<KeyboardEvent, 'ctrlKey' | 'metaKey' | 'altKey'>;

/** Whether a key belongs to the browser, the system or the page's shortcuts: with Ctrl, ⌘ or Alt. */
export const hasModifier = ({ ctrlKey, metaKey, altKey }: Pressed): boolean =>
  ctrlKey || metaKey || altKey;
