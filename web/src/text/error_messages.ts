// Failures as messages for users: the rule, the number, what to do.

import { HgpError, type ModelInfo, type Note } from 'hgp';
import { quoted } from './cli_command';
import { defectsInWords, noteForPage } from './notes';

export const isAbort = (error: unknown): boolean => (error as Error)?.name === 'AbortError';

/** The message with the advice that the page has for it. */
export function messageForPage(message: string, advice: readonly Note[] = []): string {
  const sentences = advice.map((note) => noteForPage(note)).filter((sentence) => sentence !== '');
  if (sentences.length === 0) return message;
  return `${[message.replace(/\.$/, ''), ...sentences].join('. ')}.`;
}

/** Why a mesh cannot be used as it is; places are outlined, and repairs have buttons. */
export function whyUnusable({ defects, error }: Pick<ModelInfo, 'defects' | 'error'>): string {
  const { message = 'This mesh cannot be used as it is.', advice } = error ?? {};
  return defectsInWords(defects) || messageForPage(message, advice);
}

export function describeError(error: unknown, name: string): string {
  if (!(error instanceof HgpError)) return error instanceof Error ? error.message : String(error);
  const message = messageForPage(error.rule, error.advice);
  if (error.code === 'limit') {
    const command = `hgp param ${quoted(name)}`;
    return `${message.replace(/\.?$/, '.')} Your cones are saved. The command line may use more memory: ${command}`;
  }
  if (error.code === 'malformed') return `“${name}” cannot be read: ${message}`;
  return message;
}
