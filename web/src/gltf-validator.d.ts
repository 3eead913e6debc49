// Types for the part of gltf-validator that the page uses; the package has none.
declare module 'gltf-validator' {
  export interface ValidatorReport {
    validatorVersion: string;
    issues: {
      numErrors: number;
      numWarnings: number;
      numInfos: number;
      numHints: number;
      messages: { code: string; message: string; severity: 0 | 1 | 2 | 3; pointer?: string }[];
      truncated: boolean;
    };
  }
  export function validateBytes(
    bytes: Uint8Array,
    options: {
      uri?: string;
      maxIssues?: number;
      writeTimestamp?: boolean;
      externalResourceFunction?(uri: string): Promise<Uint8Array>;
    },
  ): Promise<ValidatorReport>;
}
