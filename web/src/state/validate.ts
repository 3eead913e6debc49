// The second opinion: Khronos' validator on the very bytes that Download saves.

import type { ValidatorReport } from 'gltf-validator';
import type { App } from './app';
import { make } from './exports';
import { isGltf } from './files';
import { scriptUrl, validatorUrl } from './scripts';
import type { Solved } from './solved';

export interface Validation {
  of: Solved;
  isGood: boolean;
  text: string;
  /** The most severe first. */
  issues: string[];
}

const severities = ['Error', 'Warning', 'Information', 'Hint'];
const mostShown = 12;

function inWords({
  issues,
  validatorVersion,
}: ValidatorReport): Pick<Validation, 'text' | 'issues'> {
  const { numErrors, numWarnings, numInfos, numHints, messages, truncated } = issues;
  const count = (n: number, what: string): string => `${n} ${what}${n === 1 ? '' : 's'}`;
  const shown = messages.toSorted((a, b) => a.severity - b.severity).slice(0, mostShown);
  const more = messages.length > shown.length || truncated ? ['… and more'] : [];
  return {
    text:
      `${count(numErrors, 'error')}, ${count(numWarnings, 'warning')}, ` +
      `${count(numInfos + numHints, 'remark')} (glTF Validator ${validatorVersion}).`,
    issues: [
      ...shown.map(
        ({ severity, message, pointer }) =>
          `${severities[severity]}: ${message}${pointer ? ` (${pointer})` : ''}`,
      ),
      ...more,
    ],
  };
}

function ask(main: string, files: Map<string, Uint8Array>): Promise<ValidatorReport> {
  const worker = new Worker(scriptUrl(validatorUrl), { type: 'module', name: 'glTF validator' });
  const answer = new Promise<ValidatorReport>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<{ report?: ValidatorReport; error?: string }>) =>
      data.report ? resolve(data.report) : reject(new Error(data.error));
    worker.onerror = () => reject(new Error('it did not start'));
  });
  worker.postMessage({ main, files });
  return answer.finally(() => worker.terminate());
}

/** The written file where it is a glTF, otherwise the GLB that Download offers. */
export async function validate(app: App, solved: Solved): Promise<void> {
  const [{ name }] = solved.written.files;
  const files = new Map<string, Uint8Array>();
  let main = name;
  if (isGltf(name)) {
    for (const file of solved.files) files.set(file.name, file.bytes);
  } else {
    const made = make(app, solved, 'glb');
    main = made.name;
    files.set(main, made.bytes);
  }
  try {
    const report = await ask(main, files);
    const isGood = report.issues.numErrors === 0;
    app.validation = { of: solved, isGood, ...inWords(report) };
  } catch (error) {
    const text = `The validator could not run: ${(error as Error).message}`;
    app.validation = { of: solved, isGood: false, text, issues: [] };
  }
  app.changed();
}
