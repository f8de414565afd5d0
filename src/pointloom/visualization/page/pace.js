/**
 * Frame scheduling: if the GPU is too slow, every second, fourth, ... point is drawn during motion, and all of them at
 * rest. A frame starts after the previous one is finished.
 */
const SLOW = 40; // [ms] per frame during motion
const REST = 150; // [ms] without a change after which everything is drawn
const MAX_LEFT_OUT = 16; // limit of `Geometry.thin`

class Pace {
  /** `draw(every)` draws one in `every` points; `finished()` resolves once the GPU is done. */
  constructor(draw, finished) {
    Object.assign(this, { draw, finished, settled: false, resting: [] });
    this.every = 1;
    this.requested = false;
    this.waiting = false;
    this.timer = null;
    this.count = 0;
  }

  /** Draws soon: thinned if needed, and complete after a rest. */
  request() {
    if (this.requested && this.waiting) return; // the pending frame shows this, too
    this.setSettled(false);
    this.requested = true;
    clearTimeout(this.timer);
    if (!this.waiting) {
      this.waiting = true;
      requestAnimationFrame(() => this.next(this.every));
    }
  }

  /** Draws completely at once: a resized canvas is empty. */
  now() {
    this.setSettled(false);
    this.next(1);
  }

  async next(every) {
    this.waiting = true;
    this.requested = false;
    clearTimeout(this.timer);
    const start = performance.now();
    try {
      this.draw(every);
    } catch (error) {
      console.error(error); // the next frame may be fast enough and must be requested
    }
    await this.finished();
    this.count += 1;
    if (this.count > 2) this.note(performance.now() - start, every); // the first frames compile programs and upload buffers
    this.waiting = false;
    if (this.requested) this.request();
    else if (every > 1) this.timer = setTimeout(() => this.next(1), REST);
    else this.setSettled(true);
  }

  /** Adapts the thinning to the duration of a frame. */
  note(milliseconds, every) {
    const fitting = every * 2 ** Math.ceil(Math.log2(milliseconds / SLOW));
    if (fitting > this.every) this.every = Math.min(fitting, MAX_LEFT_OUT);
    else if (every === this.every && milliseconds < SLOW / 4) this.every = Math.max(1, every / 2);
  }

  /** Resolves once a complete image of all requests is drawn. */
  atRest() {
    return this.settled ? Promise.resolve() : new Promise((resolve) => this.resting.push(resolve));
  }

  setSettled(settled) {
    this.settled = settled;
    if (settled) for (const resolve of this.resting.splice(0)) resolve();
  }
}
