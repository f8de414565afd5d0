/** A bar of a round length: exact in orthographic views, else at the depth of the pivot. */
const SHORTEST_BAR = 90; // [CSS px]; the next round length is at most 2.5 times as long
const METRES = [[1000, "km"], [1, "m"], [0.01, "cm"], [0.001, "mm"], [1e-6, "\u00b5m"]];

class ScaleBar {
  constructor(overlay) {
    this.element = document.createElement("div");
    this.element.className = "scale-bar";
    this.element.hidden = true;
    this.bar = document.createElement("i");
    this.label = document.createElement("span");
    this.element.append(this.label, this.bar);
    overlay.append(this.element);
    this.unit = null;
  }

  /** `unit` null hides the bar. */
  draw(camera, unit) {
    this.unit = unit;
    this.element.hidden = unit === null;
    if (unit === null) return;
    const pixels = camera.pixels().fx / camera.pivotDepth(); // of one unit
    const length = roundUp(SHORTEST_BAR / pixels);
    Object.assign(this, { length, pixels: length * pixels });
    this.bar.style.width = `${this.pixels.toFixed(1)}px`;
    this.label.textContent = lengthInWords(length, unit);
    this.element.title = camera.orthographic ? "" : "At the depth of the rotation center";
  }

  paint(context, canvas, density) {
    if (this.unit === null) return;
    const [box, other] = [this.element.getBoundingClientRect(), canvas.getBoundingClientRect()];
    const [left, bottom] = [box.left - other.left, box.bottom - other.top];
    context.setTransform(density, 0, 0, density, 0, 0);
    const color = getComputedStyle(this.element).color;
    Object.assign(context, { strokeStyle: color, fillStyle: color, lineWidth: 2, font: LABEL_FONT, textAlign: "center" });
    context.beginPath();
    for (const [x, y] of [[0, -7], [0, -1], [this.pixels, -1], [this.pixels, -7]]) context.lineTo(left + x, bottom + y);
    context.stroke();
    context.fillText(this.label.textContent, left + this.pixels / 2, bottom - 9);
  }
}

/** The smallest of 1, 2 and 5 times a power of 10 that is at least a value. */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((digit) => digit * power).find((one) => one >= value * (1 - 1e-9)) ?? 10 * power;
}

/** "20 cm" for meters, "20 ft" for other units. */
function lengthInWords(length, unit) {
  const [by, name] = unit === "m" ? METRES.find(([size]) => length >= size * (1 - 1e-9)) ?? METRES.at(-1) : [1, unit];
  const number = Number((length / by).toPrecision(6));
  const text = number >= 1e6 || number < 1e-4 ? number.toExponential(0) : number.toLocaleString("en");
  return `${text} ${name}`.trim();
}
