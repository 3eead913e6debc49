// Double clicks where single ones are meant, as on Run.

/**
 * Keeps the second click of a double click from a button that has taken the place of the first one meanwhile: Cancel
 * takes that of Run. Clicks by keyboard and clicks one after another count one each, and are left alone.
 */
export function ignoreSecondClicks(target: EventTarget): void {
  let first: string | undefined;
  const take = (event: Event): void => {
    const { detail } = event as MouseEvent;
    const id = (event.target as Element).closest('button')?.id;
    if (detail < 2) first = id;
    else if (id !== first) {
      event.preventDefault();
      event.stopImmediatePropagation();
    }
  };
  target.addEventListener('click', take, { capture: true });
}
