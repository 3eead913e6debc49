// Copies the equivalent command line to the clipboard.

import { automaticCells, canAlign } from '../model/grid';
import { cliCommand } from '../text/cli_command';
import type { App } from './app';

/** The cells of the current map, or those that Run would request first. */
function cellsOf({ current, solve, prescription, model }: App['doc']): number | undefined {
  if (current) return current.cells;
  if (!solve.grid.isOn || !canAlign(prescription.q)) return undefined;
  return solve.grid.cells ?? automaticCells(model!.surface, prescription.cones.length);
}

export async function copyCommand({ doc }: App): Promise<void> {
  if (!doc.model) return;
  const command = cliCommand(doc.model, doc.prescription, doc.solve, doc.field, cellsOf(doc));
  const isFile = command.includes('--cones ');
  const also = isFile ? ' It reads the cones from the file that Export saves.' : '';
  try {
    await navigator.clipboard.writeText(command);
    doc.say(`Copied: the command that does this run.${also}`, 'good');
  } catch {
    doc.say(`The browser does not let this page copy. The command: ${command}`);
  }
}
