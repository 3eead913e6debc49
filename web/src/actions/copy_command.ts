// Copies the equivalent command line to the clipboard.

import { canAlign } from '../model/grid';
import { plainOutput } from '../model/plain';
import type { Solution } from '../model/types';
import { isCertified } from '../model/verdict';
import { cliCommand, type CommandOptions, type CommandOutput } from '../text/cli_command';
import type { App } from './app';

/** What the solver reported to have been asked. */
function optionsOfRun({ doc }: App, { result, field, features }: Solution): CommandOptions {
  const { rounds, improve, scale, grid } = result.report.options;
  return {
    rounds: rounds ?? doc.solve.rounds,
    improve: improve?.balance,
    scale: scale ?? 'solved',
    cells: grid && grid.cells > 0 ? grid.cells : undefined,
    gridMode: grid?.mode ?? 'tile',
    field,
    features,
    timeLimit: doc.solve.timeLimit,
  };
}

/** What Run would ask first. */
function optionsOfNext({ doc }: App): CommandOptions {
  const { rounds, improve, grid, timeLimit } = doc.solve;
  const { q } = doc.prescription;
  const isAligned = grid.isOn && canAlign(q);
  return {
    rounds,
    improve,
    timeLimit,
    scale: plainOutput.scale,
    gridMode: grid.mode,
    cells: isAligned ? (grid.cells ?? 'auto') : undefined,
    field: doc.askedField,
    features: doc.askedFeatures,
  };
}

function outputOf(solution: Solution): CommandOutput {
  const { output, gridTiles } = solution;
  const { uvSet, usesNewSet, embedCones } = output;
  return { uvSet, usesNewSet, embedCones, gridTiles, isUncertified: !isCertified(solution) };
}

/** The command for the map that is shown, or for the next Run; undefined if there is no model. */
export function currentCommand(app: App): string | undefined {
  const { model, prescription, current } = app.doc;
  if (!model) return undefined;
  if (current)
    return cliCommand(model, prescription, optionsOfRun(app, current), outputOf(current));
  const output = { ...plainOutput, isUncertified: false };
  return cliCommand(model, prescription, optionsOfNext(app), output);
}

export async function copyCommand(app: App): Promise<void> {
  const { doc } = app;
  const command = currentCommand(app);
  if (command === undefined) return;
  const does = doc.current?.isDragged
    ? 'that makes a map of these cones anew, which does not depend on how they were dragged'
    : 'that does this run';
  const readsCones = command.includes('--cones ');
  const readsEdges = command.includes('--features ');
  const cones = readsCones ? ' It reads the cones from the file that Export saves.' : '';
  const edges = readsEdges ? ' It reads the edges from the file that Save the list saves.' : '';
  try {
    await navigator.clipboard.writeText(command);
    doc.say(`Copied: the command ${does}.${cones}${edges}`, 'good');
  } catch {
    doc.say(`The browser does not let this page copy. The command: ${command}`);
  }
}
