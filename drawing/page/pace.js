/**
 * When to draw, and how much. Where the card does not keep up, every second, fourth, ... point is drawn while
 * something moves, and all of them once it rests; a picture is begun after the one before is done.
 */
const SLOW = 40; // milliseconds a picture may take while something moves
const REST = 150; // milliseconds without a change after which all is drawn
const MOST_LEFT_OUT = 16; // as `Geometry.thin` allows

class Pace {
  /** `draw(every)` draws one in `every` points; `finished()` resolves once the card is done. */
  constructor(draw, finished) {
    Object.assign(this, { draw, finished, settled: false, resting: [] });
    this.every = 1;
    this.asked = false;
    this.waiting = false;
    this.timer = null;
    this.count = 0;
  }

  /** Draws soon: thinned where it must be, and whole when nothing more is asked for a moment. */
  ask() {
    if (this.asked && this.waiting) return; // a picture is to come, and it shows this too
    this.tell(false);
    this.asked = true;
    clearTimeout(this.timer);
    if (!this.waiting) {
      this.waiting = true;
      requestAnimationFrame(() => this.next(this.every));
    }
  }

  /** Draws now and whole: a canvas that was resized is empty. */
  now() {
    this.tell(false);
    this.next(1);
  }

  async next(every) {
    this.waiting = true;
    this.asked = false;
    clearTimeout(this.timer);
    const start = performance.now();
    try {
      this.draw(every);
    } catch (error) {
      console.error(error); // the next picture may be well, and has to be asked for
    }
    await this.finished();
    this.count += 1;
    if (this.count > 2) this.note(performance.now() - start, every); // the first compile programs and take buffers in
    this.waiting = false;
    if (this.asked) this.ask();
    else if (every > 1) this.timer = setTimeout(() => this.next(1), REST);
    else this.tell(true);
  }

  /** Learns how many points to leave out from how long it took to draw one in `every`. */
  note(milliseconds, every) {
    const fitting = every * 2 ** Math.ceil(Math.log2(milliseconds / SLOW));
    if (fitting > this.every) this.every = Math.min(fitting, MOST_LEFT_OUT);
    else if (every === this.every && milliseconds < SLOW / 4) this.every = Math.max(1, every / 2);
  }

  /** Resolves once the picture with all that was asked for is drawn whole. */
  atRest() {
    return this.settled ? Promise.resolve() : new Promise((resolve) => this.resting.push(resolve));
  }

  tell(settled) {
    this.settled = settled;
    if (settled) for (const resolve of this.resting.splice(0)) resolve();
  }
}
