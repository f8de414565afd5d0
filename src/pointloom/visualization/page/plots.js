/** A curve for each plotted value with the current frame marked; a click selects a frame. */
const INSET = { left: 6, right: 6, top: 16, bottom: 16 };

class Plots {
  constructor(element, series, count, go) {
    this.count = count;
    this.plots = series.map(({ name, values }) => {
      const figure = document.createElement("figure");
      const caption = document.createElement("figcaption");
      const title = document.createElement("span");
      const value = document.createElement("output");
      const canvas = document.createElement("canvas");
      title.textContent = name;
      canvas.setAttribute("role", "img");
      caption.append(title, value);
      figure.append(caption, canvas);
      element.append(figure);
      const known = values.filter((one) => one !== null);
      const plot = { name, values, value, canvas, low: Math.min(...known), high: Math.max(...known) };
      canvas.addEventListener("pointerdown", (event) => go(this.frameAt(plot, event)));
      canvas.addEventListener("pointermove", (event) => event.buttons & 1 && go(this.frameAt(plot, event)));
      return plot;
    });
  }

  frameAt({ canvas }, event) {
    const box = canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - INSET.left) / (box.width - INSET.left - INSET.right);
    return Math.round(clamp(share, 0, 1) * (this.count - 1));
  }

  show(frame) {
    for (const plot of this.plots) {
      plot.value.textContent = plot.values[frame] === null ? "–" : shortNumber(plot.values[frame]);
      plot.canvas.setAttribute("aria-label", `${plot.name}: ${plot.value.textContent} in frame ${frame + 1}`);
      this.draw(plot, frame);
    }
  }

  draw({ canvas, values, low, high }, frame) {
    const density = window.devicePixelRatio || 1;
    const { width, height } = canvas.getBoundingClientRect();
    if (width === 0) return;
    canvas.width = Math.round(width * density);
    canvas.height = Math.round(height * density);
    const pen = canvas.getContext("2d");
    pen.scale(density, density);
    const color = getComputedStyle(canvas);
    const [ink, mark, curve, edge] = ["--dim", "--mark", "--curve", "--edge"].map((name) => color.getPropertyValue(name));
    const x = (k) => INSET.left + ((width - INSET.left - INSET.right) * k) / Math.max(this.count - 1, 1);
    const y = (value) => height - INSET.bottom - (height - INSET.top - INSET.bottom) * (high > low ? (value - low) / (high - low) : 0.5);
    pen.strokeStyle = edge;
    pen.strokeRect(INSET.left - 0.5, INSET.top - 3.5, width - INSET.left - INSET.right + 1, height - INSET.top - INSET.bottom + 7);
    pen.fillStyle = ink;
    pen.font = "11px system-ui, sans-serif";
    if (Number.isFinite(low)) {
      pen.fillText(shortNumber(high), INSET.left, 10);
      pen.fillText(shortNumber(low), INSET.left, height - 2);
    }
    pen.strokeStyle = mark;
    pen.beginPath();
    const middle = (Math.floor(x(frame) * density) + 0.5) / density; // centered on a pixel column, otherwise blurred
    pen.moveTo(middle, INSET.top - 3);
    pen.lineTo(middle, height - INSET.bottom + 3);
    pen.stroke();
    this.drawCurve(pen, values, x, y, curve);
    if (values[frame] !== null) {
      pen.fillStyle = mark;
      pen.beginPath();
      pen.arc(x(frame), y(values[frame]), 3.5, 0, 2 * Math.PI);
      pen.fill();
    }
  }

  /** A line with gaps for missing values; single values are dots. */
  drawCurve(pen, values, x, y, color) {
    pen.strokeStyle = pen.fillStyle = color;
    pen.lineWidth = 1.5;
    pen.lineJoin = "round";
    pen.beginPath();
    values.forEach((value, k) => {
      if (value === null) return;
      const alone = (values[k - 1] ?? null) === null && (values[k + 1] ?? null) === null;
      if (alone) pen.fillRect(x(k) - 1.5, y(value) - 1.5, 3, 3);
      else if ((values[k - 1] ?? null) === null) pen.moveTo(x(k), y(value));
      else pen.lineTo(x(k), y(value));
    });
    pen.stroke();
  }
}

function shortNumber(value) {
  const size = Math.abs(value);
  if (value !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(3);
  return String(Number(value.toPrecision(5)));
}
