// Runs the Khronos glTF validator on the bytes that Download saves.

import type { ValidatorReport } from 'gltf-validator';
import { isGltf } from '../formats/glb';
import type { Validation } from '../model/types';
import { scriptUrl, validatorUrl } from '../services/trusted_types';
import type { App } from './app';
import { exportFiles, exportSource } from './download';
import { plural } from '../text/format';

const severities = ['Error', 'Warning', 'Information', 'Hint'];
const maxShown = 12;

function describeReport({
  issues,
  validatorVersion,
}: ValidatorReport): Pick<Validation, 'text' | 'issues'> {
  const { numErrors, numWarnings, numInfos, numHints, messages, truncated } = issues;
  const shown = messages.toSorted((a, b) => a.severity - b.severity).slice(0, maxShown);
  const more = messages.length > shown.length || truncated ? ['… and more'] : [];
  return {
    text:
      `${plural(numErrors, 'error')}, ${plural(numWarnings, 'warning')}, ` +
      `${plural(numInfos + numHints, 'remark')} (glTF Validator ${validatorVersion}).`,
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

/** Validates the written file if it is a glTF, otherwise the GLB that Download offers. */
export async function validate(app: App): Promise<void> {
  const { doc } = app;
  const source = exportSource(app);
  if (!source) return;
  const { solution } = source;
  const [{ name }] = solution.written.files;
  const files = new Map<string, Uint8Array>();
  let main = name;
  if (isGltf(name)) {
    for (const file of solution.files) files.set(file.name, file.bytes);
  } else {
    const made = await exportFiles(app, 'glb');
    if (!made) return;
    main = made[0].name;
    files.set(main, made[0].bytes);
  }
  try {
    const report = await ask(main, files);
    const isGood = report.issues.numErrors === 0;
    doc.validation = { of: solution, isGood, ...describeReport(report) };
  } catch (error) {
    const text = `The validator could not run: ${(error as Error).message}`;
    doc.validation = { of: solution, isGood: false, text, issues: [] };
  }
}
