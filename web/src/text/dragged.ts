// What is said of maps that were made by dragging a cone, and while one is dragged.

import type { LiveMap } from '../model/live';
import { canAlign } from '../model/grid';
import type { Solution } from '../model/types';
import { plural } from './format';

/** In which way the map of a drag is not that of a run. */
export function draggedNote({ grid, prescription }: Solution): string {
  const isAsked = grid.isOn && canAlign(prescription.q);
  const lines = isAsked ? ' Lines do not meet at its seams.' : '';
  return (
    'This map came from dragging a cone; its bytes depend on the path that the cone took.' +
    `${lines} Run, like the command line, makes one that depends on nothing else${isAsked ? ' and is aligned' : ''}.`
  );
}

/** The state of the map under the hand. @param isMade  whether the map is being made by a run */
export function liveText({ state, notPositive, reasons }: LiveMap, isMade = false): string {
  switch (state) {
    case 'heat':
      if (isMade) return 'Scale only: the map is being made';
      return 'Scale only: the map of this place is not known yet';
    case 'certified':
      return 'Passes every check · not stored yet';
    case 'storing':
      return 'Passes every check · being stored';
    case 'fails': {
      const folded =
        notPositive.length > 0 ? `: ${plural(notPositive.length, 'triangle')} folded` : '';
      return `Does not pass${folded || `: ${reasons[0] ?? ''}`}`;
    }
  }
}
