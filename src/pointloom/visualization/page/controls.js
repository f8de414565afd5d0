/** Mouse, pen, touch and wheel control of the camera; a press without motion is a click. */
const ANGLE_PER_PIXEL = 0.006; // [rad]
const ZOOM = 0.0015; // of the logarithm of the distance, per pixel of the wheel
const STILL = { mouse: 3, pen: 6, touch: 9 }; // [CSS px] within which a press is no drag

class Controls {
  /** `move(name, ...values)` moves the active view, `use(x, y)` activates one; `click` and `doubleClick` are callbacks. */
  constructor(element, { move, use, click, doubleClick }) {
    Object.assign(this, { element, moveView: move, use, click, doubleClick });
    element.style.touchAction = "none"; // touch moves the camera, not the page
    this.pointers = new Map();
    const listen = (kind, run) => element.addEventListener(kind, run, { passive: false });
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event));
    listen("pointercancel", (event) => this.pointers.delete(event.pointerId));
    listen("wheel", (event) => this.wheel(event));
    listen("dblclick", (event) => this.doubleClick(...this.positionOf(event)));
    listen("contextmenu", (event) => event.preventDefault());
  }

  positionOf(event) {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event) {
    this.element.focus({ preventScroll: true });
    try {
      this.element.setPointerCapture(event.pointerId);
    } catch {
      // synthetic or ended pointers cannot be captured: they still move the camera
    }
    const position = this.positionOf(event);
    if (this.pointers.size === 0) this.use(...position);
    const pans = event.button === 2 || event.button === 1 || event.shiftKey;
    this.pointers.set(event.pointerId, { position, start: position, pans, drags: false });
    if (this.pointers.size > 1) for (const pointer of this.pointers.values()) pointer.drags = true;
  }

  move(event) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) return;
    const position = this.positionOf(event);
    const moved = Math.hypot(position[0] - pointer.start[0], position[1] - pointer.start[1]);
    if (!pointer.drags && moved <= (STILL[event.pointerType] ?? STILL.mouse)) return;
    pointer.drags = true;
    const before = pointer.position;
    pointer.position = position;
    const [dx, dy] = [position[0] - before[0], position[1] - before[1]];
    if (this.pointers.size === 2) this.pinch(pointer, before);
    else if (pointer.pans) this.moveView("pan", dx, dy);
    else this.moveView("orbit", dx * ANGLE_PER_PIXEL, dy * ANGLE_PER_PIXEL);
  }

  up(event) {
    const pointer = this.pointers.get(event.pointerId);
    this.pointers.delete(event.pointerId);
    if (pointer && !pointer.drags && event.button === 0) this.click(...pointer.start);
  }

  /** Two fingers: their center translates, their distance zooms. */
  pinch(pointer, before) {
    const [other] = [...this.pointers.values()].filter((one) => one !== pointer).map((one) => one.position);
    const apart = (position) => Math.max(Math.hypot(position[0] - other[0], position[1] - other[1]), 1);
    const middle = [(pointer.position[0] + other[0]) / 2, (pointer.position[1] + other[1]) / 2];
    this.moveView("pan", (pointer.position[0] - before[0]) / 2, (pointer.position[1] - before[1]) / 2);
    this.moveView("zoom", apart(before) / apart(pointer.position), ...middle);
  }

  wheel(event) {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
    const position = this.positionOf(event);
    this.use(...position);
    this.moveView("zoom", Math.exp(clamp(pixels, -400, 400) * ZOOM), ...position);
  }
}
