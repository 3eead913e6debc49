/** A sequence of uniformly distributed numbers in [0, 1) from a seed: the same ones every time. */
export function randomSequence(seed: number): () => number {
  let x = seed | 0;
  return () => {
    x = (Math.imul(x, 1664525) + 1013904223) | 0;
    return (x >>> 8) / 2 ** 24;
  };
}
