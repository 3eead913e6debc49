// The certificate row by row: value, tolerance, verdict, and where it is worst.

import { html, nothing, type TemplateResult } from 'lit';
import type { Certificate, Where } from 'hgp';
import type { App } from '../state/app';
import { make, save } from '../state/exports';
import { boxOf, quantile } from '../state/measure';
import type { Solved } from '../state/solved';
import { memoryText } from '../state/estimate';
import type { Controls } from './controls';
import { icon } from './icons';

interface Part {
  orientation?: { notPositive?: number[]; zero?: number; negative?: number };
  angles?: { worstVertex?: number; smallestAngle?: number };
  wrongCones?: { vertex: number }[];
  distortion?: Record<string, number>;
  seams?: { worstEdge?: number[]; charts?: number };
  handles?: unknown[];
  turnings?: unknown[];
  reasons?: { message: string; where?: Where[] }[];
}

const partsOf = (certificate: Certificate): Part[] => certificate.components as Part[];
const small = (x: number): string =>
  x === 0 ? '0' : x.toExponential(1).replace('e+0', '').replaceAll('-', '−');
const signed = (x: number): string => (x < 0 ? `−${(-x).toFixed(2)}` : x.toFixed(2));
const face = (id: number | undefined): Where[] =>
  id === undefined || id < 0 ? [] : [{ kind: 'triangle', id }];

interface Row {
  name: string;
  value: string;
  tolerance: string;
  isGood: boolean;
  where: Where[];
}

function rows(solved: Solved): Row[] {
  const { least, result } = solved;
  const c = result.certificate;
  const parts = partsOf(c);
  const wrongCones = parts.reduce((sum, part) => sum + (part.wrongCones?.length ?? 0), 0);
  const worst = parts[0]?.angles?.worstVertex ?? -1;
  const edge = parts.map(({ seams }) => seams?.worstEdge ?? []).find((ends) => ends.length === 2);
  const flipped = parts.flatMap(({ orientation }) => orientation?.notPositive ?? []);
  const smallest = parts[0]?.distortion?.smallestTriangle;
  const made: Row[] = [
    {
      name: 'Flipped triangles',
      value: `${c.flipped} of ${c.triangles}`,
      tolerance: 'exactly 0, exact sign',
      isGood: c.flipped === 0,
      where: flipped.length > 0 ? flipped.map((id) => face(id)[0]) : face(smallest),
    },
    {
      name: 'Smallest area',
      value: small(least.area),
      tolerance: `signed, above 0; the mean is ${small(least.mean)}`,
      isGood: c.flipped === 0,
      where: face(least.triangle),
    },
    {
      name: 'Regular vertices',
      value: `${c.wrongAngles - wrongCones} wrong`,
      tolerance: 'every angle sum is 360°',
      isGood: c.wrongAngles === wrongCones,
      where: worst < 0 ? [] : [{ kind: 'vertex', id: worst }],
    },
    {
      name: 'Cone angles',
      value: `${wrongCones} of ${solved.asked.cones.length} wrong`,
      tolerance: `off by ≤ ${small(c.maxConeDistance)} rad`,
      isGood: wrongCones === 0,
      where: parts
        .flatMap((part) => part.wrongCones ?? [])
        .map(({ vertex: id }) => ({ kind: 'vertex', id })),
    },
    {
      name: 'Seams',
      value: `${c.brokenSeams} broken of ${c.seamEdges}`,
      tolerance: `${small(c.maxSeamResidual)} ≤ ${small(c.seamTolerance)} of its length`,
      isGood: c.brokenSeams === 0,
      where: edge ? [{ kind: 'edge', id: edge[0], other: edge[1] }] : [],
    },
  ];
  if (c.exactSeams !== null && c.seamEdges > 0)
    made.push({
      name: 'Exact seams',
      value: `${c.exactSeams} of ${c.seamEdges}`,
      tolerance: 'bit for bit',
      isGood: c.exactSeams === c.seamEdges,
      where: [],
    });
  if (parts.some(({ turnings }) => (turnings?.length ?? 0) > 0)) {
    made.splice(2, 0, {
      name: 'Boundary turning',
      value: `${c.wrongTurnings} wrong`,
      tolerance: `off by ≤ ${small(c.maxTurningDistance)} rad`,
      isGood: c.wrongTurnings === 0,
      where: [],
    });
  }
  return made;
}

function verdict(app: App, solved: Solved): TemplateResult {
  const isStale = app.current !== solved;
  const title = solved.isCertified ? 'Certified' : 'Not certified';
  const text = solved.isCertified
    ? 'Every triangle keeps its orientation, every angle is the integer you asked, every seam fits.'
    : 'This map does not pass. You may look at it and download it as it is.';
  return html`<div class="verdict ${solved.isCertified ? 'good' : 'bad'} ${isStale ? 'stale' : ''}">
    ${icon(solved.isCertified ? 'check' : 'cross')}
    <div>
      <b id="verdict">${title}</b>
      <p>${isStale ? 'For the previous cones. ' : ''}${text}</p>
    </div>
  </div>`;
}

function certificateRow(
  { name, value, tolerance, isGood, where }: Row,
  ui: Controls,
): TemplateResult {
  return html`<tr class=${isGood ? '' : 'bad'}>
    <th scope="row">${name}<small>${tolerance}</small></th>
    <td>
      ${value}
      ${
        where.length > 0
          ? html`<button
              type="button"
              class="link"
              aria-label="Show worst: ${name}"
              @click=${() => ui.showPlaces(where)}
            >
              Show worst
            </button>`
          : nothing
      }
    </td>
    <td class="passed">
      ${icon(isGood ? 'check' : 'cross')}<span class="unseen">${isGood ? 'passed' : 'failed'}</span>
    </td>
  </tr>`;
}

function certificateTable(solved: Solved, ui: Controls): TemplateResult {
  return html`<table id="certificate">
    <thead class="unseen">
      <tr>
        <th scope="col">Check</th>
        <th scope="col">Value</th>
        <th scope="col">Passed</th>
      </tr>
    </thead>
    <tbody>
      ${rows(solved).map((row) => certificateRow(row, ui))}
      ${certificateRow(
        {
          name: 'Preview is the file',
          value: solved.isSameAsFile ? 'same map' : 'differs',
          tolerance: `read back from ${(solved.written.bytes.length / 1024).toFixed(0)} KB`,
          isGood: solved.isSameAsFile,
          where: [],
        },
        ui,
      )}
    </tbody>
  </table>`;
}

/** On the surface, in the units of the file. */
function seamLength({ seams, result: { positions: p, uvToVertex } }: Solved): number {
  return seams.reduce((sum, { a }) => {
    const [v, w] = a.map((end) => 3 * uvToVertex[end]);
    return sum + Math.hypot(p[w] - p[v], p[w + 1] - p[v + 1], p[w + 2] - p[v + 2]);
  }, 0);
}

function overlapLine({ overlaps }: Solved, ui: Controls): TemplateResult {
  const { pairs, triangles, isMore } = overlaps;
  const number = `${isMore ? 'over ' : ''}${pairs}`;
  return html`<p class="row note" id="overlaps">
    ${
      pairs === 0
        ? 'Overlaps: 0 pairs of triangles. The flat map lies nowhere on top of itself.'
        : html`Overlaps: ${number} pairs of triangles lie on top of each other in the flat map. That
            is allowed: neighbours never do, distant parts may.
            <button
              type="button"
              class="small"
              @click=${() => ui.showPlaces(triangles.map((id) => ({ kind: 'triangle', id })))}
            >
              Show
            </button>`
    }
  </p>`;
}

function statistics(solved: Solved): [string, string][] {
  const { distortion, result } = solved;
  const { report, certificate } = result;
  const box = boxOf(result.uv);
  const rounds = report.components.flatMap(
    (one) => (one.rounds as { iterations: number; laplacianEnergy?: number }[]) ?? [],
  );
  const energy = rounds.at(-1)?.laplacianEnergy;
  const log = [0, 0.05, 0.95, 1].map((part) => signed(quantile(distortion.area, part)));
  const [{ distortion: mu }] = partsOf(certificate);
  return [
    ...(mu
      ? [
          [
            'μ, mean · 95 % · most',
            [mu.meanMu, mu.p95Mu, mu.maxMu].map((x) => x.toFixed(3)).join(' · '),
          ] as [string, string],
        ]
      : []),
    [
      'Stretch σ₁/σ₂, 50 · 95 %',
      [0.5, 0.95].map((x) => quantile(distortion.conformal, x).toFixed(2)).join(' · '),
    ],
    ['log₂ area, 5 · 95 %', `${log[1]} · ${log[2]}`],
    ['log₂ area, least · most', `${log[0]} · ${log[3]}`],
    ['Map, width × height', `${box.width.toPrecision(3)} × ${box.height.toPrecision(3)}`],
    ['Seam length', seamLength(solved).toPrecision(3)],
    ...(energy === undefined ? [] : [['Energy ‖Lz‖²', small(energy)] as [string, string]]),
    [
      'Rounds · iterations',
      `${rounds.length} · ${rounds.reduce((sum, { iterations }) => sum + iterations, 0)}`,
    ],
    ['Stored as', certificate.precision],
    ['Time', `${report.seconds.toFixed(2)} s`],
    ['Memory at most', memoryText(result.memory)],
  ];
}

export function result(app: App, ui: Controls): TemplateResult {
  const solved = app.shown!;
  const reasons = partsOf(solved.result.certificate).flatMap(({ reasons: list }) => list ?? []);
  return html`<details open id="panel-result" class=${app.current === solved ? '' : 'stale'}>
    <summary>Result</summary>
    ${verdict(app, solved)} ${certificateTable(solved, ui)}
    ${
      solved.isCertified
        ? nothing
        : reasons.map(
            ({ message, where = [] }) =>
              html`<p class="note bad">
                ${message}
                ${where.length > 0 ? html`<button type="button" class="small" @click=${() => ui.showPlaces(where)}>Show</button>` : nothing}
              </p>`,
          )
    }
    <dl class="facts">
      ${statistics(solved).map(
        ([name, value]) =>
          html`<div>
            <dt>${name}</dt>
            <dd>${value}</dd>
          </div>`,
      )}
    </dl>
    ${overlapLine(solved, ui)}
    <p class="row">
      <button
        type="button"
        class="small"
        id="save-report"
        @click=${() => save(make(app, solved, 'report'))}
      >
        Save report
      </button>
    </p>
    ${[...solved.notes, ...solved.result.report.notes].map((note) => html`<p class="note">${note}</p>`)}
  </details>`;
}
