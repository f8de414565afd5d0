/** Number fields and sliders with one or two thumbs. */

/** A number field; reports numbers within its limits. */
class NumberField {
  constructor(label, changed, id = null) {
    this.input = make("input", { type: "number", inputmode: "decimal", step: "any", class: "number", id, "aria-label": label });
    this.changed = changed;
    this.value = 0;
    this.limits = [-Infinity, Infinity];
    this.step = null;
    this.precision = null;
    this.input.addEventListener("change", () => this.commit());
    this.input.addEventListener("keydown", (event) => this.onKey(event));
  }

  /** Keeps unfinished input. */
  show(value) {
    this.value = value;
    if (!this.isTyping()) this.input.value = numberText(value, this.precision);
  }

  isTyping() {
    return document.activeElement === this.input && this.typed === true;
  }

  onKey(event) {
    if (event.key === "Enter") return this.commit();
    if (event.key === "Escape") {
      this.typed = false;
      this.show(this.value);
      return;
    }
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") {
      this.typed = true;
      return;
    }
    event.preventDefault(); // the browser would count whole steps from a limit and lose digits
    const start = Number.isFinite(this.input.valueAsNumber) ? this.input.valueAsNumber : this.value;
    const step = this.step ?? 10 ** Math.floor(Math.log10(Math.max(Math.abs(start), 1e-9)) - 1);
    this.applyValue(start + (event.key === "ArrowUp" ? 1 : -1) * step * (event.shiftKey ? 10 : 1));
  }

  commit() {
    this.typed = false;
    const value = this.input.valueAsNumber;
    if (!Number.isFinite(value)) return this.show(this.value);
    const shown = Number(numberText(this.value, this.precision));
    if (value !== shown) this.applyValue(value);
  }

  applyValue(value) {
    this.value = clamp(Number(value.toPrecision(12)), ...this.limits);
    this.typed = false;
    this.show(this.value);
    this.changed(this.value);
  }
}

/** Values from `low` to `high` in steps as integers of a range element; the last one is `high` itself. */
class Steps {
  constructor(low, high, step) {
    Object.assign(this, { low, high, step: step > 0 ? step : (high - low) / 200 || 1 });
    this.count = Math.max(1, Math.ceil((high - low) / this.step - 1e-9));
  }

  numberOf(value) {
    if (value >= this.high) return this.count;
    return clamp(Math.round((value - this.low) / this.step), 0, this.count);
  }

  valueOf(number) {
    return number >= this.count ? this.high : Number((this.low + number * this.step).toPrecision(12));
  }
}

class NumberControl extends Control {
  build() {
    this.number = new NumberField(null, (value) => this.send(value), this.field);
    this.element.append(this.name, this.number.input);
  }

  update() {
    const { min, max, step, precision, value } = this.props;
    const { number } = this;
    number.limits = [min ?? -Infinity, max ?? Infinity];
    number.step = step ?? null;
    number.precision = precision ?? null;
    if (value !== undefined) number.show(value);
  }
}

class SliderControl extends Control {
  build() {
    this.track = make("input", { type: "range", id: this.field, min: 0, step: 1 });
    this.number = new NumberField("value", (value) => this.change(value));
    this.track.addEventListener("input", () => this.change(this.steps.valueOf(Number(this.track.value))));
    this.element.append(this.name, this.number.input, this.track);
  }

  change(value) {
    this.send(value);
    this.show(value);
  }

  setLabel(label) {
    super.setLabel(label);
    this.number.input.setAttribute("aria-label", `${label}, as a number`);
  }

  update() {
    const { min = 0, max = 1, step, value, precision } = this.props;
    this.steps = new Steps(min, max, step);
    this.track.max = this.steps.count;
    this.number.limits = [min, max];
    this.number.step = this.steps.step;
    this.number.precision = precision ?? digitsOf(step);
    if (value !== undefined) this.show(value);
  }

  show(value) {
    this.number.show(value);
    const number = this.steps.numberOf(value);
    this.track.value = number;
    this.track.style.setProperty("--share", number / this.steps.count);
    this.track.setAttribute("aria-valuetext", this.number.input.value);
  }
}

/** Two thumbs on one track with number fields; the thumbs cannot pass each other. */
class TwoThumbs {
  constructor(changed) {
    this.changed = changed;
    this.tracks = ["low", "high"].map((end, which) => this.makeTrack(end, which));
    this.fields = ["low", "high"].map((end, which) => new NumberField(end, (value) => this.move(which, value)));
    this.fill = make("div", { class: "fill" });
    this.element = make("div", { class: "two-thumbs" }, make("div", { class: "rail" }), this.fill, ...this.tracks);
    this.numbers = make("div", { class: "ends" }, this.fields[0].input, make("span", { class: "dim" }, "–"), this.fields[1].input);
  }

  makeTrack(end, which) {
    const track = make("input", { type: "range", min: 0, step: 1, class: end });
    track.addEventListener("input", () => this.move(which, this.steps.valueOf(Number(track.value))));
    return track;
  }

  setLabel(label) {
    ["low", "high"].forEach((end, which) => {
      this.tracks[which].setAttribute("aria-label", `${label}, ${end}`);
      this.fields[which].input.setAttribute("aria-label", `${label}, ${end}, as a number`);
    });
  }

  setRange(low, high, step, precision) {
    this.steps = new Steps(low, high, step);
    for (const which of [0, 1]) {
      this.tracks[which].max = this.steps.count;
      Object.assign(this.fields[which], { limits: [low, high], step: this.steps.step, precision: precision ?? null });
    }
  }

  move(which, value) {
    const [low, high] = this.value;
    const next = which === 0 ? [Math.min(value, high), high] : [low, Math.max(value, low)];
    this.show(next);
    this.changed(next);
  }

  show(value) {
    this.value = value;
    const shares = value.map((end, which) => {
      const number = this.steps.numberOf(end);
      this.tracks[which].value = number;
      this.fields[which].show(end);
      this.tracks[which].setAttribute("aria-valuetext", this.fields[which].input.value);
      return number / this.steps.count;
    });
    // if both are at the right end, only the lower one can move: it is on top
    this.tracks[0].style.zIndex = shares[0] > 0.5 ? 2 : 1;
    this.tracks[1].style.zIndex = shares[0] > 0.5 ? 1 : 2;
    this.fill.style.left = `${100 * shares[0]}%`;
    this.fill.style.right = `${100 * (1 - shares[1])}%`;
  }
}

class RangeControl extends Control {
  build() {
    this.thumbs = new TwoThumbs((value) => this.send(value));
    this.element.append(this.name, this.thumbs.numbers, this.thumbs.element);
  }

  setLabel(label) {
    this.name.textContent = label;
    this.thumbs.setLabel(label || "range");
  }

  update() {
    const { min = 0, max = 1, step, value, precision } = this.props;
    this.thumbs.setRange(min, max, step, precision ?? digitsOf(step));
    if (value) this.thumbs.show(value);
  }
}
