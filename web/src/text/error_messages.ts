// Failures as messages for users: the rule, the number, what to do.

import { HgpError } from 'hgp';
import { quoted } from './cli_command';

export const isAbort = (error: unknown): boolean => (error as Error)?.name === 'AbortError';

export function describeError(error: unknown, name: string): string {
  const message = error instanceof Error ? error.message : String(error);
  if (!(error instanceof HgpError)) return message;
  if (error.code === 'limit') {
    const command = `hgp param ${quoted(name)}`;
    return `${message.replace(/\.?$/, '.')} Your cones are saved. The command line may use more memory: ${command}`;
  }
  if (error.code === 'malformed') return `“${name}” cannot be read: ${message}`;
  return message;
}

/**
 * One sentence without advice for the command line: instead of its options the page has buttons, and instead of
 * listing ids it outlines places.
 */
export const withoutCliAdvice = (message = 'This mesh cannot be used as it is.'): string =>
  message
    .replace(/Repair with --fix.*$/, '')
    .replace(/ \((?:first: )?\d[\d–, …]*\)/g, '')
    .trim();
