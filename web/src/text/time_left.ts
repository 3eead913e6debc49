// Estimates the remaining time of a run, but only once a stage has ended at about the time predicted at
// its middle; the estimate never increases.

const trust = 0.3; // relative error up to which predictions are trusted
const shortest = 1.5; // seconds: shorter stages say nothing about prediction

interface Stage {
  name: string;
  begin: number;
  /** Predicted duration, made when half of the stage was done. */
  predicted?: number;
}

export class TimeLeft {
  #stage?: Stage;
  #isTrusted = false;
  #end = Infinity; // the end time last shown

  /** `whole`: fraction of the whole run that is done; times in seconds. Undefined if there is no estimate. */
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
      // The stage takes longer than predicted: no further estimates.
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
