// Long work in short steps: the page answers in between.

const longest = 10; // milliseconds at a stretch
const often = 128; // items between two looks at the clock

interface Scheduler {
  yield?(): Promise<void>;
}

/** Ends the current task; what follows is one of its own. */
export function pause(): Promise<void> {
  const { scheduler } = globalThis as { scheduler?: Scheduler };
  return scheduler?.yield?.() ?? new Promise((resolve) => setTimeout(resolve));
}

/** Pauses where it has been long since the last pause. */
export class Breath {
  #begin = performance.now();
  #count = 0;

  /** Cheap to ask: looks at the clock only now and then. */
  get isDue(): boolean {
    this.#count += 1;
    return this.#count % often === 0 && performance.now() - this.#begin > longest;
  }

  async take(): Promise<void> {
    await pause();
    this.#begin = performance.now();
  }
}

/** Does `item(0)` … `item(count − 1)`, pausing whenever it has taken long. */
export async function inSteps(count: number, item: (i: number) => void): Promise<void> {
  const breath = new Breath();
  for (let i = 0; i < count; i++) {
    item(i);
    if (breath.isDue) await breath.take();
  }
  await pause();
}
