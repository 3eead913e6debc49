/** An OBJ of a round, bumpy disk: n rings, 6n² triangles. */
export function bumpyDisk(n) {
  const lines = ['# a bumpy disk'];
  const vertex = (ring, k) => (ring === 0 ? 1 : 2 + 3 * ring * (ring - 1) + (k % (6 * ring)));
  for (let ring = 0; ring <= n; ring++) {
    for (let k = 0; k < Math.max(1, 6 * ring); k++) {
      const angle = (2 * Math.PI * k) / Math.max(1, 6 * ring);
      const r = ring / n;
      const [x, y] = [r * Math.cos(angle), r * Math.sin(angle)];
      const z = 0.25 * Math.sin(4 * x) * Math.cos(3 * y + 0.5);
      lines.push(`v ${x} ${z} ${-y}`);
    }
  }
  for (let ring = 1; ring <= n; ring++) {
    for (let side = 0; side < 6; side++) {
      for (let k = 0; k < ring; k++) {
        const outer = side * ring + k;
        const inner = side * (ring - 1) + k;
        const a = vertex(ring, outer);
        const b = vertex(ring, outer + 1);
        const c = vertex(ring - 1, inner);
        lines.push(`f ${a} ${b} ${c}`);
        if (k < ring - 1) lines.push(`f ${c} ${b} ${vertex(ring - 1, inner + 1)}`);
      }
    }
  }
  return `${lines.join('\n')}\n`;
}
