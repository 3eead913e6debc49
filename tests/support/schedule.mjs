// Runs the stages of a test run two at a time, because builds do not use all cores near their ends, where single
// files are compiled or linked. Stages that measure time run alone.

/**
 * @param {Map<string, {after?: string[], isAlone?: boolean}>} stages  in order of preference;
 *     names in `after` that are not in this map are ignored
 * @param {(name: string) => Promise<void>} run
 * @param {number} lanes  how many at a time
 */
export async function runInOrder(stages, run, lanes = 2) {
  const waiting = new Set(stages.keys());
  const running = new Map();
  const isReady = (name) =>
    (stages.get(name).after ?? []).every((other) => !waiting.has(other) && !running.has(other));
  while (waiting.size + running.size > 0) {
    for (const name of waiting) {
      const isFree =
        running.size < lanes && ![...running.keys()].some((n) => stages.get(n).isAlone);
      if (!isFree || !isReady(name)) continue;
      if (stages.get(name).isAlone && running.size > 0) continue;
      waiting.delete(name);
      running.set(
        name,
        run(name).finally(() => running.delete(name)),
      );
    }
    if (running.size === 0) throw new Error(`stages that wait for one another: ${[...waiting]}`);
    await Promise.race(running.values());
  }
}
