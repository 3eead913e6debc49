import type { Plugin } from 'vite';

export interface Component {
  source: string;
  parts: string[];
}
export function packagesOf(ids: Iterable<string>): Set<string>;
export function unlisted(ids: Iterable<string>, components: Component[]): string[];
export function licences(options: { isPage: boolean }): Plugin;
