// The worker that runs the Khronos glTF validator. Loaded on first use.

import { validateBytes, type ValidatorReport } from 'gltf-validator';

export interface ToValidate {
  main: string;
  files: Map<string, Uint8Array>;
}

const maxIssues = 100;

async function validate({ main, files }: ToValidate): Promise<ValidatorReport> {
  return validateBytes(files.get(main)!, {
    uri: main,
    maxIssues: maxIssues,
    writeTimestamp: false,
    externalResourceFunction: (uri) => {
      const found = files.get(decodeURIComponent(uri));
      return found ? Promise.resolve(found) : Promise.reject(new Error(`${uri} is not here`));
    },
  });
}

addEventListener('message', ({ data }: MessageEvent<ToValidate>) => {
  validate(data).then(
    (report) => postMessage({ report }),
    (error: unknown) =>
      postMessage({ error: error instanceof Error ? error.message : String(error) }),
  );
});
