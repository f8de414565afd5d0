/**
 * Placement of the panel: docked at the right, folded or resized; on a phone a sheet at the bottom. It never covers the
 * image.
 */
const WIDTHS = { min: 240, max: 640, initial: 320 }; // [px]
const PULLED = 8; // [px] beyond which a press on the sheet's grip is a drag
const SHEET_LEAST = 52; // [px] of the closed sheet: its grip
const PICTURE_LEAST = 160; // [px] of the image above an open sheet
const STEP_OF_WIDTH = 16;

class Frame {
  constructor({ body, side, edge, grip, toggled }) {
    Object.assign(this, { body, side, edge, grip, toggled });
    this.phone = matchMedia("(max-width: 640px)");
    this.width = clamp(Number(memory.get("width")) || WIDTHS.initial, WIDTHS.min, WIDTHS.max);
    this.isOpen = memory.get("panel") !== "folded";
    this.isPulled = false;
    this.listenToEdge();
    this.listenToGrip();
    this.phone.addEventListener("change", () => this.apply());
    this.apply();
  }

  get isShown() {
    return this.phone.matches ? this.isPulled : this.isOpen;
  }

  toggle() {
    if (this.phone.matches) return this.pull(!this.isPulled);
    this.isOpen = !this.isOpen;
    memory.set("panel", this.isOpen ? "open" : "folded");
    this.apply();
  }

  apply() {
    const phone = this.phone.matches;
    this.body.classList.toggle("folded", !phone && !this.isOpen);
    this.body.style.setProperty("--panel", `${this.width}px`);
    if (phone) this.pull(this.isPulled);
    else this.side.inert = !this.isOpen;
    this.edge.setAttribute("aria-valuenow", this.width);
    this.toggled(this.isShown);
  }

  listenToEdge() {
    const { edge } = this;
    edge.setAttribute("aria-valuemin", WIDTHS.min);
    edge.setAttribute("aria-valuemax", WIDTHS.max);
    edge.addEventListener("pointerdown", (event) => {
      edge.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    edge.addEventListener("pointermove", (event) => {
      if (edge.hasPointerCapture(event.pointerId)) this.setWidth(innerWidth - event.clientX);
    });
    edge.addEventListener("dblclick", () => this.setWidth(WIDTHS.initial));
    edge.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: STEP_OF_WIDTH, ArrowRight: -STEP_OF_WIDTH }[event.key];
      if (!by) return;
      event.preventDefault();
      this.setWidth(this.width + by);
    });
  }

  setWidth(width) {
    this.width = Math.round(clamp(width, WIDTHS.min, Math.min(WIDTHS.max, innerWidth - 240)));
    memory.set("width", this.width);
    this.apply();
  }

  listenToGrip() {
    const { grip } = this;
    let start = null;
    grip.addEventListener("pointerdown", (event) => {
      grip.setPointerCapture(event.pointerId);
      start = { y: event.clientY, height: this.side.getBoundingClientRect().height, drags: false };
    });
    grip.addEventListener("pointermove", (event) => {
      if (!start) return;
      const by = start.y - event.clientY;
      if (Math.abs(by) > PULLED) start.drags = true;
      if (start.drags) this.setSheet(start.height + by);
    });
    for (const kind of ["pointerup", "pointercancel"]) {
      grip.addEventListener(kind, () => {
        if (start?.drags) {
          const height = this.side.getBoundingClientRect().height;
          this.dragged = true;
          this.pull(height > SHEET_LEAST + 48, height);
        }
        start = null;
      });
    }
    grip.addEventListener("click", () => {
      if (!this.dragged) this.pull(!this.isPulled);
      this.dragged = false;
    });
    grip.addEventListener("keydown", () => (this.dragged = false));
  }

  /** Opens the sheet to just over half of the window or its last height, or closes it. */
  pull(open, height = 0.55 * innerHeight) {
    this.isPulled = open;
    this.body.classList.toggle("pulled", open);
    this.grip.setAttribute("aria-expanded", open);
    this.setSheet(open ? height : SHEET_LEAST);
    this.side.inert = false;
    this.toggled(open);
  }

  setSheet(height) {
    this.body.style.setProperty("--sheet", `${Math.round(clamp(height, SHEET_LEAST, Math.max(SHEET_LEAST, innerHeight - PICTURE_LEAST)))}px`);
  }
}
