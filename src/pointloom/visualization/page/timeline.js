/**
 * Displayed frame and playback. A frame is shown once all of it is on the GPU; the newest request wins.
 * `prepare` sends the data of a frame, `shown` is called for each frame and at start and end of playback, `drawn` tells
 * whether the image is complete.
 */
class Timeline {
  constructor({ frames, fps }, { prepare, shown, drawn, failed }) {
    Object.assign(this, { frames, fps, prepare, onShown: shown, drawn, failed });
    this.frame = -1;
    this.wanted = 0;
    this.busy = false;
    this.playing = false;
    this.speed = 1;
    this.loop = true;
  }

  get last() {
    return this.frames.length - 1;
  }

  /** Resolves once the last requested frame is shown. */
  go(frame) {
    this.wanted = clamp(frame, 0, this.last);
    if (!this.busy) this.going = this.move();
    return this.going;
  }

  async move() {
    this.busy = true;
    try {
      while (this.frame !== this.wanted) {
        const next = this.wanted;
        await this.prepare(this.frames[next].shown);
        this.frame = next;
        this.onShown(next);
        if (this.playing && next < this.last) await this.prepare(this.frames[next + 1].shown); // while this one is displayed
      }
    } catch (error) {
      this.pause();
      this.failed(error);
    } finally {
      this.busy = false;
    }
  }

  step(by) {
    this.pause();
    return this.go(this.wanted + by);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.last < 1 || this.frame < 0) return;
    this.playing = true;
    if (this.wanted === this.last) this.go(0);
    this.due = performance.now() + 1000 / (this.fps * this.speed);
    requestAnimationFrame(() => this.tick());
    this.onShown(this.frame);
  }

  pause() {
    this.playing = false;
    if (this.frame >= 0) this.onShown(this.frame);
  }

  /** Shows every frame on slow machines, too: no step of an algorithm is skipped. */
  tick() {
    if (!this.playing) return;
    const now = performance.now();
    if (now >= this.due && !this.busy && this.drawn()) {
      const period = 1000 / (this.fps * this.speed);
      this.due = Math.max(this.due + period, now);
      if (this.frame < this.last) this.go(this.frame + 1);
      else if (this.loop) this.go(0);
      else this.pause();
    }
    requestAnimationFrame(() => this.tick());
  }
}
