/** A loop without allocations per item, for use over all triangles. */
export function forEachIndex(count: number, item: (i: number) => void): void {
  for (let i = 0; i < count; i++) item(i);
}
