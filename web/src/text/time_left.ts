// How long a run still takes, where that can be said honestly: not before one stage has ended about
// when half of it had promised, and never more than was said before.

const trust = 0.3; // how far a prediction may be off to be believed
const shortest = 1.5; // seconds: shorter stages say nothing about prediction

interface Stage {
  name: string;
  begin: number;
  /** Predicted length, made when half of it was done. */
  predicted?: number;
}

export class TimeLeft {
  #stage?: Stage;
  #isTrusted = false;
  #end = Infinity; // what was said

  /** `whole`: the part of all work that is done; times in seconds. Nothing where nothing can be said. */
  update(
    stage: string,
    fraction: number,
    whole: number,
    begin: number,
    now: number,
  ): number | undefined {
    if (this.#stage?.name !== stage) {
      this.#compare(now);
      this.#stage = { name: stage, begin: now };
    }
    const spent = now - this.#stage.begin;
    if (fraction >= 0.5 && this.#stage.predicted === undefined) {
      this.#stage.predicted = spent / fraction;
    }
    if (!this.#isTrusted || whole <= 0) return undefined;
    const end = begin + (now - begin) / whole;
    if (end > this.#end + 1) {
      // It takes longer than was said: nothing more is promised.
      this.#isTrusted = false;
      return undefined;
    }
    this.#end = Math.min(this.#end, end);
    return Math.max(0, this.#end - now);
  }

  #compare(now: number): void {
    if (!this.#stage) return;
    const { begin, predicted } = this.#stage;
    const took = now - begin;
    if (predicted === undefined || took < shortest) return;
    this.#isTrusted = Math.abs(predicted - took) <= trust * took;
  }
}
