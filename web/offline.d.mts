export function serviceWorker(files: Map<string, string | Uint8Array>, prefix?: string): string;
