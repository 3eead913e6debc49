// Exact arithmetic on the numbers that a file holds: every finite double is an integer times a power of
// two, so sums, products and orders of coordinates are decided in integers.

const bytes = new DataView(new ArrayBuffer(8));

/** A finite double as [integer, exponent]: x = integer · 2^exponent. */
function parts(x) {
  bytes.setFloat64(0, x);
  const bits = bytes.getBigUint64(0);
  const biased = Number((bits >> 52n) & 0x7ffn);
  if (biased === 0x7ff) throw new RangeError(`${x} is not finite`);
  const fraction = bits & 0xfffffffffffffn;
  const magnitude = biased === 0 ? fraction : fraction | 0x10000000000000n;
  return [bits >> 63n ? -magnitude : magnitude, Math.max(biased, 1) - 1075];
}

/** Points of doubles as points of integers, all in one unit 2^`unit`. */
export function integerPoints(points) {
  const split = points.map((p) => p.map(parts));
  let unit = Infinity;
  for (const p of split) for (const [m, e] of p) if (m !== 0n) unit = Math.min(unit, e);
  if (unit === Infinity) unit = 0;
  const whole = ([m, e]) => (m === 0n ? 0n : m << BigInt(e - unit));
  return { unit, points: split.map((p) => p.map(whole)) };
}

export const minus = ([a, b], [c, d]) => [a - c, b - d];
export const cross = ([a, b], [c, d]) => a * d - b * c;
export const square = ([a, b]) => a * a + b * b;
/** conj(a) · b: its argument is the angle from a to b. */
export const between = ([a, b], [c, d]) => [a * c + b * d, a * d - b * c];
export const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
export const sign = (x) => (x > 0n) - (x < 0n);

const bitLength = (x) => (x < 0n ? -x : x).toString(16).length * 4;

/** a / b as a double, to 60 bits, whatever their size. */
export function ratio(a, b) {
  if (a === 0n) return 0;
  const shift = bitLength(b) - bitLength(a) + 64;
  const quotient = shift >= 0 ? (a << BigInt(shift)) / b : a / (b << BigInt(-shift));
  // In two steps: 2^−shift alone may underflow.
  const half = Math.trunc(shift / 2);
  return Number(quotient) * 2 ** -half * 2 ** (half - shift);
}

/** x · 2^exponent as a double. */
export const toNumber = (x, exponent) =>
  exponent >= 0 ? ratio(x << BigInt(exponent), 1n) : ratio(x, 1n << BigInt(-exponent));

function root(x) {
  if (x < 2n) return x;
  let r = 1n << BigInt(Math.ceil(x.toString(2).length / 2));
  for (;;) {
    const next = (r + x / r) >> 1n;
    if (next >= r) return r;
    r = next;
  }
}

/** Fractional bits of the rotations below. */
export const bits = 320n;
const one = 1n << bits;
const rootOf = (n) => root(n << (2n * bits));

/** cos and sin of 2π/q, times 2^bits; exact for q = 1, 2, 4. */
const first = {
  1: () => [one, 0n],
  2: () => [-one, 0n],
  3: () => [-one / 2n, rootOf(3n) / 2n],
  4: () => [0n, one],
  5: () => {
    const c = (rootOf(5n) - one) / 4n;
    return [c, root(one * one - c * c)];
  },
  6: () => [one / 2n, rootOf(3n) / 2n],
  8: () => [rootOf(2n) / 2n, rootOf(2n) / 2n],
};
export const orders = Object.keys(first).map(Number);

const known = new Map();
/** e^{2πir/q} for r = 0, …, q − 1, times 2^bits. */
export function rotations(q) {
  if (!known.has(q)) {
    const step = first[q]();
    const all = [[one, 0n]];
    while (all.length < q)
      all.push(times(all.at(-1), step).map((x) => (q === 2 || q === 4 ? x / one : x >> bits)));
    known.set(q, all);
  }
  return known.get(q);
}

/** Lower or upper half plane: arguments in [0, π) and [π, 2π). */
const half = ([x, y]) => (y > 0n || (y === 0n && x > 0n) ? 0 : 1);

/** Is the argument of `a`, in [0, 2π), smaller than that of `b`? */
function isBefore(a, b) {
  return half(a) === half(b) ? cross(a, b) > 0n : half(a) < half(b);
}

/** A sum of angles in [0, π]: whole turns, and the rest as a direction with argument in [0, 2π). */
export class AngleSum {
  turns = 0;
  rest = [1n, 0n];

  /** Adds the angle from a to b, which must be to the left of a. */
  add(a, b) {
    const sum = times(this.rest, between(a, b));
    if (isBefore(sum, this.rest)) this.turns += 1;
    this.rest = sum;
  }
}

/** The argument of an exact direction as a double, in (−π, π]. */
export function argument([x, y]) {
  const size = Math.max(bitLength(x), bitLength(y));
  const shift = BigInt(Math.max(0, size - 512));
  const [a, b] = [x >> shift, y >> shift];
  if (a === 0n && b === 0n) return 0;
  const scale = 1n << BigInt(Math.max(bitLength(a), bitLength(b)));
  return Math.atan2(ratio(b, scale), ratio(a, scale));
}

/**
 * The distance of an angle, `turns` whole turns and the argument of `rest`, from the nearest multiple
 * of 2π/q: { n, distance }. The rest is turned back exactly before its argument is taken.
 */
export function nearest(turns, rest, q) {
  const raw = argument(rest);
  const inTurn = Math.round(((raw < 0 ? raw + 2 * Math.PI : raw) * q) / (2 * Math.PI));
  const [c, s] = rotations(q)[inTurn % q];
  return { n: turns * q + inTurn, distance: Math.abs(argument(times(rest, [c, -s]))) };
}
