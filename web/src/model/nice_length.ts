// Round lengths for scales.

/** The largest of 1, 2 and 5 times a power of ten that is at most `most`. */
export function niceLength(max: number): number {
  const power = Math.floor(Math.log10(max));
  const step = [5, 2, 1].find((n) => n * 10 ** power <= max * (1 + 1e-12)) ?? 1;
  return Number(`${step}e${power}`);
}
