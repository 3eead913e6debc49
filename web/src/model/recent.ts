// A file that was opened before.

export interface Recent {
  /** The SHA-256 of the main file. */
  id: string;
  main: string;
  /** In milliseconds since 1970. */
  time: number;
  files: [name: string, content: Blob][];
}
