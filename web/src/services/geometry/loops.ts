/** For loops over every triangle: nothing is allocated per item. */
export function forEachIndex(count: number, item: (i: number) => void): void {
  for (let i = 0; i < count; i++) item(i);
}
