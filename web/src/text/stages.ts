// The stages of a run as steps, and their shares of the total time.

const spans: Record<string, [from: number, to: number]> = {
  read: [0, 0.02],
  weld: [0.02, 0.04],
  topology: [0.04, 0.06],
  prepare: [0.02, 0.06],
  cones: [0.06, 0.14],
  connection: [0.2, 0.22],
  field: [0.06, 0.22],
  cut: [0.22, 0.26],
  assemble: [0.26, 0.3],
  solve: [0.3, 0.8],
  improve: [0.8, 0.85],
  align: [0.85, 0.9],
  verify: [0.9, 0.95],
  write: [0.95, 1],
};

const names: Record<string, string> = {
  read: 'Reading',
  weld: 'Reading',
  topology: 'Reading',
  prepare: 'Preparing',
  cones: 'Choosing cones',
  connection: 'Smooth field',
  field: 'Smooth field',
  cut: 'Cutting',
  assemble: 'Assembling',
  solve: 'Solving',
  improve: 'Improving',
  align: 'Aligning',
  verify: 'Checking',
  write: 'Writing',
};

/** The steps that a run shows, in order. */
export const runSteps = ['field', 'cut', 'solve', 'align', 'verify', 'write'] as const;
const stepOf: Record<string, (typeof runSteps)[number]> = {
  read: 'field',
  weld: 'field',
  topology: 'field',
  cones: 'field',
  field: 'field',
  prepare: 'field',
  connection: 'field',
  cut: 'cut',
  assemble: 'cut',
  solve: 'solve',
  improve: 'solve',
  align: 'align',
  verify: 'verify',
  write: 'write',
};

export const stageName = (stage: string): string => names[stage] ?? stage;

/** The index of the step to which a stage belongs. */
export const stepIndex = (stage: string): number => runSteps.indexOf(stepOf[stage] ?? 'field');

/** Progress of the whole run, given the progress of a stage. */
export function wholeFraction(stage: string, fraction: number, before: number): number {
  const [from, to] = spans[stage] ?? [before, before];
  return Math.max(before, from + (to - from) * Math.min(Math.max(fraction, 0), 1));
}
