export function heroModel(): Promise<Uint8Array>;
