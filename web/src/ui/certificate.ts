// The certificate as rows of words and numbers.

import { html, render } from 'lit';
import type { Result } from 'hgp';

export function showCertificate(place: HTMLElement, { certificate, report }: Result): void {
  const rows: [string, string][] = [
    ['Triangles', String(certificate.triangles)],
    ['Flipped', String(certificate.flipped)],
    ['Wrong angle sums', String(certificate.wrongAngles)],
    ['Broken seams', String(certificate.brokenSeams)],
    ['Time', `${report.seconds.toFixed(2)} s`],
  ];
  const verdict = certificate.certified ? 'certified' : 'not certified';
  render(
    html`
      <dt>Map</dt>
      <dd class=${certificate.certified ? 'good' : 'bad'}>${verdict}</dd>
      ${rows.map(
        ([label, value]) =>
          html`<dt>${label}</dt>
            <dd>${value}</dd>`,
      )}
    `,
    place,
  );
  place.hidden = false;
}
