export const headers: Record<string, string>;
export const isolation: Record<string, string>;
export const hashed: { folder: string; cacheControl: string };
