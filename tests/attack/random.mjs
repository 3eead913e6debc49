// Pseudorandom numbers from a seed, the same everywhere.

/** mulberry32, by Tommy Ettinger (public domain). */
export class Random {
  constructor(seed) {
    this.state = seed >>> 0;
  }
  /** In [0, 1). */
  unit() {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  }
  between(low, high) {
    return low + (high - low) * this.unit();
  }
  /** An integer in low, …, high. */
  integer(low, high) {
    return low + Math.floor(this.unit() * (high - low + 1));
  }
  chance(share) {
    return this.unit() < share;
  }
  pick(list) {
    return list[this.integer(0, list.length - 1)];
  }
}
