/** Elements, icons and number formatting. Text is only ever inserted as text. */
const byId = (id) => document.getElementById(id);

/** An element with attributes; strings become text. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

const SVG_NAMES = "http://www.w3.org/2000/svg";

/** Outlines on a grid of 20, drawn with strokes. */
const ICONS = {
  fit: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7.5 10a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0",
  orthographic: "M3 6h9v9H3zM3 6l4-3h9l-4 3M16 3v9l-4 3",
  perspective: "M3 5l9-1v13l-9-3zM12 4l5 2v8l-5 3",
  axes: "M9 11V3M6.5 5.5L9 3l2.5 2.5M9 11l7 4M13.3 15.8l2.7-.8-.8-2.8M9 11l-6 4M5.7 15.8L3 15l.8-2.8",
  split: "M3 4h14v12H3zM10 4v12M3 10h14",
  light: "M10 6.5a3.5 3.5 0 1 0 0 7a3.5 3.5 0 1 0 0-7M10 2v1.5M10 16.5V18M2 10h1.5M16.5 10H18M4.3 4.3l1.1 1.1M14.6 14.6l1.1 1.1M15.7 4.3l-1.1 1.1M5.4 14.6l-1.1 1.1",
  mesh: "M3 15L10 3l7 12zM6.5 9h7M10 15l-3.5-6M10 15l3.5-6",
  search: "M8.5 3.5a5 5 0 1 0 0 10a5 5 0 1 0 0-10M12.2 12.2L17 17",
  help: "M7 7.2c0-1.8 1.3-3 3-3s3 1.1 3 2.8c0 2.3-3 2.4-3 4.8M10 15.3v.4",
  theme: "M16.5 11.8A7 7 0 1 1 8.2 3.5a5.6 5.6 0 0 0 8.3 8.3z",
  camera: "M3 6h3l1.5-2h5L14 6h3v10H3zM10 8a2.8 2.8 0 1 0 0 5.6a2.8 2.8 0 1 0 0-5.6",
  panel: "M3 4h14v12H3zM12.5 4v12",
  close: "M5 5l10 10M15 5L5 15",
  play: "M6 4l10 6-10 6z",
  pause: "M7 4v12M13 4v12",
  back: "M5 4v12M15 4v12l-7-6z",
  forth: "M15 4v12M5 4v12l7-6z",
  folder: "M7 5l5 5-5 5",
  upload: "M10 13V4M6.5 7.5L10 4l3.5 3.5M4 13v3h12v-3",
  more: "M5 10h.01M10 10h.01M15 10h.01",
};

function icon(name) {
  const svg = document.createElementNS(SVG_NAMES, "svg");
  const path = document.createElementNS(SVG_NAMES, "path");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("class", "glyph");
  svg.setAttribute("aria-hidden", "true");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}

/** An icon button with an accessible name and tooltip. */
function iconButton(name, label, run, attributes = {}) {
  const button = make("button", { type: "button", class: "icon", title: label, "aria-label": label, ...attributes }, icon(name));
  button.addEventListener("click", run);
  return button;
}

function cssColor([r, g, b]) {
  return `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;
}

/** Formats a number with `precision` decimals, or 6 significant digits. */
function numberText(value, precision = null) {
  if (!Number.isFinite(value)) return "";
  if (precision !== null && precision !== undefined) return value.toFixed(clamp(precision, 0, 12));
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(4).replace(/\.?0+e/, "e");
  return String(Number(value.toPrecision(6)));
}

/** Decimals that distinguish steps of this size. */
function digitsOf(step) {
  if (!(step > 0)) return null;
  for (let digits = 0; digits < 9; digits++) {
    if (Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) < 1e-6 * 10 ** digits * step) return digits;
  }
  return null;
}

function countText(count) {
  return count.toLocaleString("en");
}

/** Calls a function once before the next frame, also in a hidden page. */
function onceAPicture(run) {
  let waiting = false;
  const go = () => {
    if (!waiting) return;
    waiting = false;
    run();
  };
  return () => {
    if (waiting) return;
    waiting = true;
    if (document.hidden) setTimeout(go, 30);
    else requestAnimationFrame(go);
  };
}

/** Stored settings; empty if storage is not allowed. */
const memory = {
  get(name) {
    try {
      return localStorage.getItem(`pointloom.${name}`);
    } catch {
      return null;
    }
  },
  set(name, value) {
    try {
      localStorage.setItem(`pointloom.${name}`, value);
    } catch {
      // a page in a sandboxed frame without an origin: nothing is stored
    }
  },
};

function saveAs(blob, name) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
