export function guidePage(markdown: string, stylesheet: string): string;
