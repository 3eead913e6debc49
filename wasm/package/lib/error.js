// The error class of this package.

/** An error with the same code on the page, in this package and on the command line. */
export class HgpError extends Error {
  /** @param {{ code: string, message: string, stage?: string, where?: object[] }} failure */
  constructor({ code, message, stage, where }) {
    super(message);
    this.name = 'HgpError';
    this.code = code;
    this.details = { stage, where };
  }
}

/** The error of a call with invalid arguments. */
export const usage = (message) => new HgpError({ code: 'usage', message });

/** The error if WebAssembly, or a file of this package, could not be loaded. */
export const unavailable = (message, cause) => {
  const error = new HgpError({ code: 'wasm-unavailable', message });
  if (cause !== undefined) error.cause = cause;
  return error;
};
