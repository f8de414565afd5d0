/** Axes in a corner (x red, y green, z blue) of the active view; a press on an end looks along it. */
const GIZMO_REACH = 30; // from the center to the ends, in units of its box
const SVG = new DOMParser().parseFromString("<svg></svg>", "text/html").body.firstChild.namespaceURI; // a namespace, not a request

class Gizmo {
  /** `look(axis)` looks along "+x" ... "-z". */
  constructor(overlay, look) {
    this.element = document.createElementNS(SVG, "svg");
    this.element.setAttribute("class", "gizmo");
    this.element.setAttribute("viewBox", "-42 -42 84 84");
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", "Axes: press an end to look along it");
    this.ends = ["x", "y", "z"].flatMap((name) => [1, -1].map((sign) => this.makeEnd(name, sign, look)));
    overlay.append(this.element);
  }

  /** A press on +x looks at it, along -x. */
  makeEnd(name, sign, look) {
    const make = (kind, parent) => parent.appendChild(document.createElementNS(SVG, kind));
    const group = make("g", this.element);
    const axis = `${sign > 0 ? "-" : "+"}${name}`;
    group.setAttribute("class", `axis-${name}${sign > 0 ? "" : " behind"}`);
    group.dataset.axis = axis;
    make("title", group).textContent = `Look along ${axis[0] === "-" ? "\u2212" : "+"}${name}`;
    const line = sign > 0 ? make("line", group) : null;
    const circle = make("circle", group);
    circle.setAttribute("r", sign > 0 ? 9 : 6);
    const text = sign > 0 ? make("text", group) : null;
    if (text) text.textContent = name;
    group.addEventListener("click", () => look(axis));
    return { group, line, circle, text, direction: scale(AXES[name], sign) };
  }

  draw(camera) {
    const projected = this.ends.map((end) => ({ ...end, at: [0, 1, 2].map((k) => dot(column(camera.rotation, k), end.direction)) }));
    for (const { group, line, circle, text, at } of projected.sort((a, b) => b.at[2] - a.at[2])) {
      const [x, y] = [at[0] * GIZMO_REACH, at[1] * GIZMO_REACH];
      for (const [name, value] of [["cx", x], ["cy", y]]) circle.setAttribute(name, value.toFixed(2));
      if (line) for (const [name, value] of [["x2", x], ["y2", y]]) line.setAttribute(name, value.toFixed(2));
      if (text) for (const [name, value] of [["x", x], ["y", y]]) text.setAttribute(name, value.toFixed(2));
    }
    const order = projected.map(({ group }) => group); // nearer ones last, on top
    if (order.some((group, k) => this.element.children[k] !== group)) this.element.append(...order);
  }
}
