// Long work in short steps: the page answers in between.

const longest = 12; // milliseconds at a stretch
const often = 256; // items between two looks at the clock

export const pause = (): Promise<void> =>
  new Promise((resolve) => {
    // A message comes back at once; timers are held back by browsers.
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });

/** Does `item(0)` … `item(count − 1)`, pausing whenever it has taken long. */
export async function inSteps(count: number, item: (i: number) => void): Promise<void> {
  let begin = performance.now();
  for (let i = 0; i < count; i++) {
    item(i);
    if (i % often !== 0 || performance.now() - begin < longest) continue;
    await pause();
    begin = performance.now();
  }
  await pause();
}
