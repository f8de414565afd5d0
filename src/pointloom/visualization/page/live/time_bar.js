/** Timeline in the bottom bar: track, playback, steps, speed. The page plays and sends each value to the program. */
const STEPS_A_SECOND = 10;

class TimelineControl extends Control {
  build() {
    this.element = make("div", { class: "time", role: "group", "aria-label": "Time" });
    this.element.dataset.control = this.id;
    this.back = iconButton("back", "One step back (left arrow)", () => this.step(-1));
    this.play = iconButton("play", "Play (space)", () => this.toggle());
    this.forth = iconButton("forth", "One step forward (right arrow)", () => this.step(1));
    this.track = make("input", { type: "range", id: this.field, min: 0, step: 1, "aria-label": "Time" });
    this.readout = make("output", { for: this.field });
    this.speed = make("select", { "aria-label": "Speed" });
    for (const [value, text] of [[0.25, "¼×"], [0.5, "½×"], [1, "1×"], [2, "2×"], [4, "4×"]]) this.speed.append(make("option", { value }, text));
    this.speed.value = "1";
    this.loop = make("input", { type: "checkbox", checked: true });
    this.element.append(this.back, this.play, this.forth, this.track, this.readout, this.speed, make("label", { class: "loop" }, this.loop, "loop"));
    this.track.addEventListener("input", () => {
      this.pause();
      this.go(Number(this.track.value));
    });
    this.playing = false;
  }

  setLabel(label) {
    this.element.setAttribute("aria-label", label || "Time");
    this.track.setAttribute("aria-label", label || "Time");
  }

  update(changes) {
    const { min = 0, max = 1, step, value, playing } = this.props;
    this.steps = new Steps(min, max, step);
    this.digits = digitsOf(step);
    this.track.max = this.steps.count;
    if (value !== undefined) this.show(value);
    if ("playing" in changes && Boolean(playing) !== this.playing) this.toggle();
    this.panel.onBarChanged();
  }

  show(value) {
    const { high } = this.steps;
    const number = this.steps.numberOf(value);
    this.track.value = number;
    this.track.style.setProperty("--share", number / this.steps.count);
    const isInteger = this.digits === 0 && this.steps.step === 1;
    this.readout.textContent = isInteger ? `${numberText(value)} / ${numberText(high)}` : numberText(value, this.digits);
    this.track.setAttribute("aria-valuetext", this.readout.textContent);
  }

  go(number) {
    const value = this.steps.valueOf(clamp(number, 0, this.steps.count));
    this.send(value);
    this.show(value);
  }

  step(by) {
    this.pause();
    this.go(this.steps.numberOf(this.props.value) + by);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.start();
  }

  start() {
    this.setPlaying(true);
    if (this.steps.numberOf(this.props.value) === this.steps.count) this.go(0);
    this.due = performance.now() + this.period();
    this.tick();
  }

  pause() {
    if (this.playing) this.setPlaying(false);
  }

  setPlaying(playing) {
    this.playing = playing;
    cancelAnimationFrame(this.waiting);
    this.play.replaceChildren(icon(playing ? "pause" : "play"));
    const name = playing ? "Pause" : "Play";
    this.play.title = `${name} (space)`;
    this.play.setAttribute("aria-label", name);
  }

  period() {
    return 1000 / ((this.props.fps ?? STEPS_A_SECOND) * Number(this.speed.value));
  }

  tick() {
    this.waiting = requestAnimationFrame(() => {
      if (!this.playing) return;
      const now = performance.now();
      if (now >= this.due && !this.panel.isBusy()) {
        this.due = Math.max(this.due + this.period(), now);
        const next = this.steps.numberOf(this.props.value) + 1;
        if (next <= this.steps.count) this.go(next);
        else if (this.loop.checked) this.go(0);
        else this.pause();
      }
      this.tick();
    });
  }

  remove() {
    this.pause();
    super.remove();
    this.panel.onBarChanged();
  }
}
