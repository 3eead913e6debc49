// Notes of the solver as the page shows them: it has buttons where the command line has options.

const rules: [pattern: RegExp, text: string][] = [
  [
    /; --weld exact would join (\d+) components into (\d+)/,
    '; joining these makes $2 of $1 components',
  ],
  [/; --weld ([\d.e+-]+) closes it/, '; joining vertices closer than $1 closes it'],
  [/ \(--weld none keeps them apart\)/, ''],
  [/ --improve isometric \(improve\) lowers it/, ' “Less distortion” under Solve lowers it'],
  [/: try --cones-for few/, ': move the slider to Fewer'],
  [/those of --cones-for few are used/, 'fewer cones are used'],
  [/ --refine \(refine: true\) splits edges/, ' On the command line, --refine splits edges'],
  [/split edges there \(--refine\)/, 'split edges there (on the command line: --refine)'],
];

export const noteForPage = (note: string): string =>
  rules.reduce((text, [pattern, to]) => text.replace(pattern, to), note);

/** How close vertices are to be joined according to a note: 0 for equal positions; undefined where none says so. */
export function weldIn(notes: readonly string[]): number | undefined {
  const found = notes.flatMap((note) => /; --weld (exact|[\d.e+-]+) /.exec(note)?.[1] ?? []);
  if (found.length === 0) return undefined;
  return Math.max(...found.map((one) => (one === 'exact' ? 0 : Number(one))));
}
