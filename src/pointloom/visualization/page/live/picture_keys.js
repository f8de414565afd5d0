/** Color bars and legends at the edge of the image; the scene leaves space for them. */
class ColorbarControl extends Control {
  build() {
    this.element = make("figure", { class: "colorbar" });
    this.element.dataset.control = this.id;
    this.caption = make("figcaption");
    this.bars = ["upright", "level"].map((way) => make("canvas", { class: way, "aria-hidden": "true" }));
    this.marks = make("ol");
    this.element.append(this.caption, make("div", { class: "scale" }, ...this.bars, this.marks));
  }

  setLabel() {}

  update(changes) {
    const { title, label, ticks = [], colors } = this.props;
    this.caption.textContent = title ?? label ?? "";
    if ("ticks" in changes) {
      this.marks.replaceChildren(
        ...ticks.map(([share, text]) => {
          const mark = make("li", {}, make("span", {}, text));
          mark.style.setProperty("--share", clamp(share, 0, 1));
          return mark;
        }),
      );
    }
    if ("colors" in changes && colors?.data) this.paint(colors);
    this.panel.onKeysChanged();
  }

  /** The highest value is at the top, or at the right if the image is narrow. */
  paint({ data, rows }) {
    const [upright, level] = this.bars;
    [upright.width, upright.height, level.width, level.height] = [1, rows, rows, 1];
    const [down, across] = this.bars.map((bar) => bar.getContext("2d"));
    for (let row = 0; row < rows; row++) {
      down.fillStyle = across.fillStyle = cssColor(data.subarray(3 * row, 3 * row + 3));
      down.fillRect(0, rows - 1 - row, 1, 1);
      across.fillRect(row, 0, 1, 1);
    }
  }

  remove() {
    super.remove();
    this.panel.onKeysChanged();
  }
}

class LegendControl extends Control {
  build() {
    this.element = make("figure", { class: "legend" });
    this.element.dataset.control = this.id;
    this.caption = make("figcaption");
    this.list = make("ul", { tabindex: 0, "aria-label": "Legend" });
    this.element.append(this.caption, this.list);
  }

  setLabel() {}

  update(changes) {
    const { title, label, entries } = this.props;
    this.caption.textContent = title ?? label ?? "";
    this.caption.hidden = this.caption.textContent === "";
    if ("entries" in changes) {
      this.list.replaceChildren(
        ...entries.map(([name, color, text]) => {
          const swatch = make("i");
          swatch.style.background = cssColor(color);
          return make("li", { title: text ? `${name}: ${text}` : name }, swatch, make("span", { class: "label" }, name), make("span", { class: "dim" }, text ?? ""));
        }),
      );
    }
    this.panel.onKeysChanged();
  }

  remove() {
    super.remove();
    this.panel.onKeysChanged();
  }
}
